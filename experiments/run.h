#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "experiments/experiment.h"

namespace subdiv {

/// What became of one experiment: its results with the claims in the order of its table, or why it broke.
struct Outcome {
  const Experiment* experiment = nullptr;
  Results results;
  std::string error;  // empty when it ran to its end

  [[nodiscard]] bool broke() const { return !error.empty(); }
};

/// Runs experiments on `jobs` threads (at least one); outcomes stand in the given order, whatever the threads
/// do. An experiment that throws, or does not settle each head of its table exactly once, or returns series
/// and figures with names that are no file names, broke. `finished` is called after each one, from one thread
/// at a time.
[[nodiscard]] std::vector<Outcome> run(std::span<const Experiment* const> experiments, int jobs,
                                       const std::function<void(const Experiment&)>& finished = {});

}  // namespace subdiv
