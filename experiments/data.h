#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "schemes/algebra/rational.h"

namespace subdiv {

/// The folder of the program's data files: the environment's SUBDIVLAB_DATA, or where it lies relative to the
/// running program, in PREFIX/share/subdivlab/data of an installation or share/subdivlab/data of a build
/// tree. Throws InputError that names what was looked for.
[[nodiscard]] std::filesystem::path data_folder();

/// A polygon committed in experiments/data: columns x and y, exact numbers. Throws InputError that names the
/// file, and the line where one is not a pair of numbers.
[[nodiscard]] std::vector<std::pair<Rational, Rational>> polygon_from_data(const std::string& file_name);

}  // namespace subdiv
