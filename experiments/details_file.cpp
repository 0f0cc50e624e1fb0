#include "experiments/details_file.h"

#include <cmath>
#include <string>

#include "experiments/polygon_file.h"
#include "schemes/algebra/rational.h"
#include "schemes/input_error.h"

namespace subdiv {
namespace {

constexpr double most = 4e18;  // fits long long

/// A whole number from 0 on, or -1.
long long whole(double x) {
  return x >= 0 && x < most && std::floor(x) == x ? static_cast<long long>(x) : -1;
}
long long whole(const Rational& x) {
  const double value = x.to_double();
  return whole(value) >= 0 && Rational::from_double(value) == x ? whole(value) : -1;
}

}  // namespace

template <class T>
std::vector<DetailRecord<T>> read_details(const std::filesystem::path& path, std::size_t dimension) {
  if (path.extension() != ".csv")
    throw InputError(path.string() + ": details are read from .csv files, lines level,index,dx,dy");
  const PointList<T> list = read_points<T>(path);
  if (list.dimension() != dimension + 2) {
    throw InputError(path.string() + ": lines of " + std::to_string(list.dimension()) +
                     " numbers; expected " + std::to_string(dimension + 2) +
                     ": level, index and a displacement of " + std::to_string(dimension));
  }
  std::vector<DetailRecord<T>> details(list.size());
  constexpr long long deepest = 62;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const long long level = whole(list.coordinates[0][i]);
    const long long index = whole(list.coordinates[1][i]);
    if (level < 0 || level > deepest || index < 0) {
      throw InputError(path.string() + ": detail " + std::to_string(i + 1) +
                       ": the level and the index are whole numbers from 0 on");
    }
    details[i] = {static_cast<int>(level), index, {}};
    for (std::size_t c = 0; c < dimension; ++c) details[i].displacement.push_back(list.coordinates[c + 2][i]);
  }
  return details;
}

template std::vector<DetailRecord<double>> read_details<double>(const std::filesystem::path&, std::size_t);
template std::vector<DetailRecord<Rational>> read_details<Rational>(const std::filesystem::path&,
                                                                    std::size_t);

}  // namespace subdiv
