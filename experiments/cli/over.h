#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "schemes/algebra/rational.h"

namespace subdiv::cli {

struct ParameterRange {
  std::string name;
  Rational lower;
  Rational upper;
};

/// Whether a range may be a single value, s=1..1.
enum class RangeEnds { differ, may_coincide };

/// Reads the option --over, "s=LO..HI[,t=LO..HI]": the ranges in the order of the scheme's free parameters,
/// each given exactly once. InputError says what is wrong, and calls the option by its name.
[[nodiscard]] std::vector<ParameterRange> parse_over(std::string_view text,
                                                     const std::vector<std::string>& free_parameters,
                                                     RangeEnds ends, const std::string& option = "--over");

}  // namespace subdiv::cli
