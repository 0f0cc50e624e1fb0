#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "analysis/hausdorff_distance.h"
#include "experiments/polygon_curves.h"
#include "experiments/report/figure_style.h"
#include "experiments/simple_polygons.h"
#include "schemes/evaluate/level_by_level.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

constexpr std::size_t levels = 4;
template <class T>
using PerLevel = std::array<T, levels>;

const ClaimHead& head_of(const std::string& id) { return head(polygon_curve_heads(), id); }

std::array<std::vector<Rational>, 2> coordinates(const PlanePolygon& polygon) {
  std::array<std::vector<Rational>, 2> result;
  for (const auto& [x, y] : polygon) {
    result[0].push_back(x);
    result[1].push_back(y);
  }
  return result;
}

/// Squares of the offsets of the refined points from the middles of the parent's edges and its vertices.
void add_squares(const ControlPolygon<Rational>& parent, const ControlPolygon<Rational>& fine,
                 std::vector<Rational>& squares) {
  squares.resize(fine.points.size());
  for (std::size_t i = 0; i < fine.points.size(); ++i) {
    const auto j = static_cast<long long>(i / 2);
    const Rational linear = i % 2 == 0 ? parent.at(j) : (parent.at(j) + parent.at(j + 1)) * Rational(1, 2);
    const Rational offset = fine.points[i] - linear;
    squares[i] += offset * offset;
  }
}

/// The squared disparities of the first levels of *J_s.
PerLevel<Rational> squared_disparities(const PlanePolygon& polygon, const Rational& s) {
  const Mask<Rational> mask = jspline(s);
  auto values = coordinates(polygon);
  std::array<ControlPolygon<Rational>, 2> parents{closed_polygon(values[0]), closed_polygon(values[1])};
  PerLevel<Rational> result;
  for (Rational& largest : result) {
    std::vector<Rational> squares;
    for (ControlPolygon<Rational>& parent : parents) {
      ControlPolygon<Rational> fine = refine_once(mask, parent);
      add_squares(parent, fine, squares);
      parent = std::move(fine);
    }
    largest = *std::ranges::max_element(squares);
  }
  return result;
}

/// Of all polygons.
std::vector<PerLevel<Rational>> squared_disparities(const Rational& s) {
  std::vector<PerLevel<Rational>> result;
  for (const PlanePolygon& polygon : simple_polygons()) result.push_back(squared_disparities(polygon, s));
  return result;
}

/// At how many polygons the first of several is the smallest, level by level.
template <class T>
PerLevel<int> smallest(const std::vector<std::vector<PerLevel<T>>>& schemes) {
  PerLevel<int> count{};
  for (std::size_t i = 0; i < schemes.front().size(); ++i) {
    for (std::size_t k = 0; k < levels; ++k) {
      count[k] += std::all_of(schemes.begin() + 1, schemes.end(),
                              [&](const auto& other) { return schemes.front()[i][k] < other[i][k]; })
                      ? 1
                      : 0;
    }
  }
  return count;
}

Claim settle_levels(const std::string& id, const PerLevel<int>& count, Rigour rigour = Rigour::exact) {
  const auto polygons = static_cast<int>(simple_polygons().size());
  int sum = 0;
  std::string text;
  for (const int c : count) {
    sum += c;
    text += fmt::format("{}{}", text.empty() ? "" : ", ", c);
  }
  return settle_share(head_of(id), sum, polygons * static_cast<int>(levels),
                      fmt::format("At levels 1 to {}: {} of {} polygons.", levels, text, polygons), rigour);
}

/// Hausdorff distances of consecutive levels of all polygons, up to an error that no comparison notices.
std::vector<PerLevel<double>> hausdorff_disparities(double s) {
  constexpr double tolerance = 1e-7;
  std::vector<PerLevel<double>> result;
  for (const PlanePolygon& polygon : simple_polygons()) {
    const auto distances =
        disparities(stationary<double>("J", jspline(s)), in_double(polygon), levels, tolerance);
    PerLevel<double> row{};
    for (std::size_t k = 0; k < levels; ++k) row[k] = distances[k].hausdorff.upper;
    result.push_back(row);
  }
  return result;
}

/// The mean over all polygons of the disparity, in lengths of the polygon's mean edge.
PerLevel<double> mean_disparities(double s) {
  PerLevel<double> mean{};
  const double count = static_cast<double>(simple_polygons().size());
  for (const PlanePolygon& polygon : simple_polygons()) {
    Polyline parent = in_double(polygon);
    const double edge = length(parent) / static_cast<double>(polygon.size());
    for (double& value : mean) {
      Polyline fine = refine(stationary<double>("J", jspline(s)), parent, 1);
      value += largest_displacement(parent, fine, 2) / edge / count;
      parent = std::move(fine);
    }
  }
  return mean;
}

void add_figure(Results& results) {
  constexpr int steps = 50;
  constexpr int digits = 12;
  Series series{"popping-fixed", {"s"}, {}};
  Figure figure{"popping-fixed",
                "How far a new level of *J_s moves simple polygons (dashed: s = 3/8)",
                "parameter s",
                "mean distance (mean edges)",
                {},
                style::log_y + style::upright("0.375"),
                {"popping.fixed.", "popping.fixed"}};
  for (std::size_t k = 1; k <= levels; ++k) {
    const std::string name = fmt::format("level {}", k);
    series.columns.push_back(name);
    figure.curves.push_back({"popping-fixed", "s", name, name});
  }
  for (int i = 0; i <= steps; ++i) {
    const Rational s(i, steps);
    std::vector<std::string> row{to_significant(s, digits)};
    for (const double value : mean_disparities(s.to_double()))
      row.push_back(to_significant(Rational::from_double(value), digits));
    series.rows.push_back(std::move(row));
  }
  results.series.push_back(std::move(series));
  results.figures.push_back(std::move(figure));
}

}  // namespace

Results run_polygon_popping() {
  Results results;
  const auto fixed = squared_disparities(Rational(3, 8));
  results.claims.push_back(settle_levels(
      "popping.fixed",
      smallest<Rational>({fixed, squared_disparities(Rational(0)), squared_disparities(Rational(1))})));
  results.claims.push_back(settle_levels("popping.fixed.maillot-stam",
                                         smallest<Rational>({fixed, squared_disparities(Rational(3, 10))})));
  results.claims.push_back(settle_levels(
      "fit.linear.tendency.l1", smallest<Rational>({squared_disparities(Rational::parse("0.304763")),
                                                    squared_disparities(Rational::parse("0.152773"))})));
  results.claims.push_back(settle_levels(
      "popping.fixed.js-report",
      smallest<double>({hausdorff_disparities(0.375), hausdorff_disparities(0), hausdorff_disparities(1)}),
      Rigour::approximate));
  add_figure(results);
  return results;
}

}  // namespace subdiv
