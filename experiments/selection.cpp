#include "experiments/selection.h"

#include <algorithm>
#include <cstddef>

#include "schemes/input_error.h"
#include "schemes/text.h"

namespace subdiv {
namespace {

/// Ids that a user may have meant: those that contain the pattern's letters, else the nearest by spelling.
std::string near_names(const std::string& pattern, std::span<const Experiment> experiments) {
  std::string letters;
  std::copy_if(pattern.begin(), pattern.end(), std::back_inserter(letters),
               [](char c) { return c != '*' && c != '?'; });
  std::vector<std::string> ids;
  for (const Experiment& experiment : experiments) {
    for (const ClaimHead& head : experiment.heads()) ids.push_back(head.id);
  }
  constexpr std::size_t most = 6;
  std::vector<std::string> near;
  for (const std::string& id : ids) {
    if (!letters.empty() && near.size() < most && id.find(letters) != std::string::npos) near.push_back(id);
  }
  if (near.empty()) {
    if (const std::string best = nearest(letters, ids); !best.empty()) near.push_back(best);
  }
  return near.empty() ? "'subdivlab list claims' names them" : "near it: " + joined(near, "and");
}

}  // namespace

bool matches(std::string_view pattern, std::string_view text) {
  std::size_t p = 0;
  std::size_t star = std::string_view::npos;  // the last '*' met, and where the text stood there
  std::size_t resume = 0;
  for (std::size_t t = 0; t < text.size();) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      resume = t;
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == text[t])) {
      ++p;
      ++t;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      t = ++resume;
    } else {
      return false;
    }
  }
  return pattern.substr(p).find_first_not_of('*') == std::string_view::npos;
}

Selection select(std::span<const Experiment> experiments, std::span<const std::string> patterns) {
  Selection result;
  result.everything = patterns.empty();
  std::vector<bool> used(patterns.size(), false);
  for (const Experiment& experiment : experiments) {
    const std::size_t before = result.ids.size();
    for (const ClaimHead& head : experiment.heads()) {
      bool chosen = patterns.empty();
      for (std::size_t i = 0; i < patterns.size(); ++i) {
        if (!matches(patterns[i], head.id)) continue;
        used[i] = true;
        chosen = true;
      }
      if (chosen) result.ids.insert(head.id);
    }
    if (result.everything || result.ids.size() > before) result.experiments.push_back(&experiment);
  }
  for (std::size_t i = 0; i < patterns.size(); ++i) {
    if (used[i]) continue;
    throw InputError("no claim matches '" + patterns[i] + "'; " + near_names(patterns[i], experiments));
  }
  return result;
}

}  // namespace subdiv
