#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/experiment.h"

namespace subdiv::test {

/// The claim with this id; std::out_of_range when there is none.
inline const Claim& find_claim(const std::vector<Claim>& claims, const std::string& id) {
  const auto found = std::ranges::find_if(claims, [&](const Claim& c) { return c.head.id == id; });
  if (found == claims.end()) throw std::out_of_range("no claim " + id);
  return *found;
}

/// The midpoint of a claim's enclosure.
inline double value_of(const std::vector<Claim>& claims, const std::string& id) {
  const Claim& claim = find_claim(claims, id);
  return ((claim.lower.value() + claim.upper.value()) / Rational(2)).to_double();
}

/// The series with this name; std::out_of_range when there is none.
inline const Series& find_series(const Results& results, const std::string& name) {
  const auto found = std::ranges::find(results.series, name, &Series::name);
  if (found == results.series.end()) throw std::out_of_range("no series " + name);
  return *found;
}

}  // namespace subdiv::test
