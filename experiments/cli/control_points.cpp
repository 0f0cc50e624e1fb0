#include "experiments/cli/control_points.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "analysis/open_polygon.h"
#include "schemes/input_error.h"
#include "schemes/text.h"

namespace subdiv::cli {

SchemeDescription evaluated_scheme(const std::string& text) {
  SchemeDescription scheme = parse_scheme(text);
  if (!scheme.free_parameters.empty()) {
    throw InputError(in_quotes(text) + ": " + joined(scheme.free_parameters, "and") +
                     (scheme.free_parameters.size() == 1 ? " has" : " have") +
                     " no value; curves are evaluated for numbers, such as jspline:s=1/2");
  }
  return scheme;
}

void require_measurable(const CoordinateArrays<double>& coordinates, const std::string& where) {
  constexpr double largest = 1e150;
  for (const std::vector<double>& c : coordinates.coordinates) {
    const auto beyond = std::ranges::find_if(c, [](double x) { return !(std::abs(x) <= largest); });
    if (beyond == c.end()) continue;
    throw InputError(fmt::format(
        "{}: point {} has the coordinate {}; products of coordinates beyond 1e150 leave the range "
        "of doubles: scale the points",
        where, beyond - c.begin() + 1, *beyond));
  }
}

OpenEnd open_end(const std::string& name) {
  return name == "clamped" ? OpenEnd::clamped : OpenEnd::reflected;
}

CoordinateArrays<double> control_curve(const PointList<double>& points, const std::string& open,
                                       const SchemeDescription& scheme) {
  if (points.closed.has_value() && *points.closed != open.empty()) {
    throw InputError(*points.closed ? "--open: the line element of the file is closed; leave the option out"
                                    : "the line element of the file is open: say how the curve ends, with "
                                      "--open clamped or --open reflected");
  }
  if (open.empty()) return {{points.size(), true, 0, 0}, points.coordinates};
  const EndWeights<double> weights = end_weights_in_double(scheme, open_end(open));
  CoordinateArrays<double> result;
  for (const std::vector<double>& coordinate : points.coordinates) {
    ControlPolygon<double> polygon = with_ends(coordinate, weights);
    result.topology = polygon.topology;
    result.coordinates.push_back(std::move(polygon.points));
  }
  return result;
}

Scheme<double> scheme_in_double(const SchemeDescription& scheme) {
  return map_coefficients(interval_scheme(scheme),
                          [](const Interval& x) { return x.midpoint().to_double(); });
}

}  // namespace subdiv::cli
