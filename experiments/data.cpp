#include "experiments/data.h"

#include <filesystem>
#include <stdexcept>

#include "experiments/report/csv.h"
#include "experiments/report/files.h"
#include "schemes/input_error.h"

namespace subdiv {

std::vector<std::pair<Rational, Rational>> polygon_from_data(const std::string& file_name) {
  const std::filesystem::path path = std::filesystem::path(SUBDIVLAB_DATA_DIR) / file_name;
  const CsvRows rows = from_csv(read_file(path));
  std::vector<std::pair<Rational, Rational>> polygon;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    try {
      if (rows[i].size() != 2)
        throw std::invalid_argument("it has " + std::to_string(rows[i].size()) + " columns");
      polygon.emplace_back(Rational::parse(rows[i][0]), Rational::parse(rows[i][1]));
    } catch (const std::invalid_argument& error) {
      throw InputError(path.string() + ":" + std::to_string(i + 1) + ": not a point: " + error.what() +
                       "; a line holds two numbers, x,y");
    }
  }
  return polygon;
}

}  // namespace subdiv
