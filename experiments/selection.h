#pragma once

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/experiment.h"

namespace subdiv {

/// Shell-style matching of the whole text: '*' stands for any characters, '?' for one.
[[nodiscard]] bool matches(std::string_view pattern, std::string_view text);

/// Claims chosen by patterns, and the experiments to run for them.
struct Selection {
  std::vector<const Experiment*> experiments;  // in the order of the registry
  std::set<std::string> ids;
  bool everything = false;  // no patterns were given
};

/// The claims of the experiments whose ids match one of the patterns; without patterns, all. A pattern that
/// matches nothing throws InputError with the ids that are nearest.
[[nodiscard]] Selection select(std::span<const Experiment> experiments,
                               std::span<const std::string> patterns);

}  // namespace subdiv
