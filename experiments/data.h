#pragma once

#include <string>
#include <utility>
#include <vector>

#include "schemes/algebra/rational.h"

namespace subdiv {

/// A polygon committed in experiments/data: columns x and y, exact numbers. Throws InputError that names the
/// file, and the line where one is not a pair of numbers.
[[nodiscard]] std::vector<std::pair<Rational, Rational>> polygon_from_data(const std::string& file_name);

}  // namespace subdiv
