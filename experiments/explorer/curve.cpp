#include "experiments/explorer/curve.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include <Eigen/LU>

#include "analysis/area_mask.h"
#include "analysis/limit_mask.h"
#include "analysis/polyloop/local_geometry.h"
#include "schemes/evaluate/ringing.h"
#include "schemes/jspline.h"

namespace subdiv::explorer {
namespace {

constexpr std::size_t fewest_points = 3;
constexpr std::size_t most_given = 256;

double number(const std::string& text) {
  const double value = Rational::parse(text).to_double();
  constexpr double largest = 1e9;
  if (!(std::abs(value) <= largest)) throw std::invalid_argument(text + " is beyond 1e9");
  return value;
}

void require_drawable(const Request& request) {
  const std::size_t n = request.points[0].size();
  if (request.steps.empty()) throw std::invalid_argument("a curve needs at least one step");
  if (n < fewest_points) {
    throw std::invalid_argument("a curve needs at least 3 points, there are " + std::to_string(n));
  }
  if (n > most_given)
    throw std::invalid_argument("at most 256 points are drawn, there are " + std::to_string(n));
  if (!request.closed && request.retrofit)
    throw std::invalid_argument("only closed curves can be retrofitted");
  constexpr int deepest = 10;
  if (request.levels < 0 || request.levels > deepest)
    throw std::invalid_argument("levels are 0 .. 10, not " + std::to_string(request.levels));
}

/// The direct solution of L P = C (js-report 5), L the circulant matrix of the limit mask.
std::vector<std::vector<double>> retrofitted(const std::vector<Step>& steps,
                                             const std::vector<std::vector<double>>& points) {
  const Laurent<Rational> mask = vertex_limit_mask(exact_scheme(steps));
  const auto n = static_cast<Eigen::Index>(points[0].size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (int j = mask.first(); j <= mask.last(); ++j) {
      matrix(i, residue(static_cast<int>(i) + j, static_cast<int>(n))) += mask[j].to_double();
    }
  }
  const Eigen::FullPivLU<Eigen::MatrixXd> factors(matrix);
  constexpr double least = 1e-9;
  const Eigen::VectorXd pivots = factors.matrixLU().diagonal().cwiseAbs();
  if (pivots.minCoeff() <= least * pivots.maxCoeff()) {
    throw std::domain_error("these points cannot be retrofitted: the system for " + std::to_string(n) +
                            " points is singular, or nearly so");
  }
  std::vector<std::vector<double>> result;
  for (const std::vector<double>& c : points) {
    const Eigen::VectorXd solution = factors.solve(Eigen::Map<const Eigen::VectorXd>(c.data(), n));
    result.emplace_back(solution.data(), solution.data() + n);
  }
  return result;
}

/// A polygon with reflected points at both ends, or a closed one.
ControlPolygon<double> control(const std::vector<double>& c, bool closed, int added) {
  if (closed) return closed_polygon(c);
  std::vector<double> all;
  const std::size_t n = c.size();
  const auto count = static_cast<std::size_t>(added);
  for (std::size_t k = count; k > 0; --k) all.push_back(2 * c[0] - c[k]);
  all.insert(all.end(), c.begin(), c.end());
  for (std::size_t k = 1; k <= count; ++k) all.push_back(2 * c[n - 1] - c[n - 1 - k]);
  return open_polygon(std::move(all), count, count);
}

/// The area that the mask gives to a closed polygon's limit curve.
double area_by(const Laurent<double>& mask, const Polyline& polygon) {
  std::vector<std::pair<double, double>> points;
  for (std::size_t i = 0; i < polygon.coordinates[0].size();
       ++i) {  // seen from the first, which loses no digits
    points.emplace_back(polygon.coordinates[0][i] - polygon.coordinates[0][0],
                        polygon.coordinates[1][i] - polygon.coordinates[1][0]);
  }
  return area<double>(mask, points);
}

std::vector<double> curvatures(const Polyline& curve) {
  std::vector<double> result;
  for (const VertexGeometry& at : vertex_geometry(curve)) result.push_back(at.circle_curvature);
  if (!curve.topology.closed && !result.empty()) {  // none at the ends
    result.insert(result.begin(), 0);
    result.push_back(0);
  }
  return result;
}

}  // namespace

Request parse_request(std::string_view text) {
  Request request;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string kind;
    std::string first;
    std::string second;
    words >> kind >> first >> second;
    if (kind == "step") {
      request.steps.push_back({Rational::parse(first), Rational::parse(second)});
    } else if (kind == "levels") {
      request.levels = static_cast<int>(number(first));
    } else if (kind == "open") {
      request.closed = false;
    } else if (kind == "retrofit") {
      request.retrofit = true;
    } else if (kind == "point") {
      request.points[0].push_back(number(first));
      request.points[1].push_back(number(second));
    } else if (!kind.empty()) {
      throw std::invalid_argument("'" + line + "' is no part of a curve");
    }
  }
  require_drawable(request);
  return request;
}

Scheme<Rational> exact_scheme(const std::vector<Step>& steps) {
  Scheme<Rational> scheme{"J", {}};
  for (const Step& step : steps) scheme.steps.push_back(jspline(step.a, step.b));
  return scheme;
}

Scheme<double> double_scheme(const std::vector<Step>& steps) {
  return map_coefficients(exact_scheme(steps), [](const Rational& x) { return x.to_double(); });
}

Curve evaluate(const Request& request, bool with_limit_area) {
  const Scheme<double> scheme = double_scheme(request.steps);
  const auto& points = request.retrofit ? retrofitted(request.steps, request.points) : request.points;
  Curve result;
  result.polygon = make_polyline(points, request.closed);
  result.curve.topology.closed = request.closed;
  for (const std::vector<double>& c : points) {
    const ControlPolygon<double> controls = control(c, request.closed, vertex_reach(scheme).last);
    std::vector<double> values;
    Ringing<double, double> rings(scheme, controls, request.levels);
    for (const double& x : rings) values.push_back(x);
    result.curve.topology.points = values.size();
    result.curve.coordinates.push_back(std::move(values));
  }
  result.length = length(result.curve);
  result.curvature = curvatures(result.curve);
  result.jerk = normal_jerks(result.curve);
  for (double& jerk : result.jerk) jerk = std::ldexp(jerk, 3 * request.levels);
  result.jerk_of_level = normal_jerk(result.curve);
  if (!request.closed) return result;
  result.polygon_area = signed_area(make_polyline(request.points, true));
  result.area = signed_area(result.curve);
  if (with_limit_area) {
    try {
      const Laurent<double> mask = map_coefficients(area_mask(exact_scheme(request.steps)),
                                                    [](const Rational& x) { return x.to_double(); });
      result.limit_area = area_by(mask, result.polygon);
    } catch (const std::domain_error&) {
      result.limit_area = std::nullopt;  // no area mask: the limits are not smooth enough
    }
  }
  return result;
}

}  // namespace subdiv::explorer
