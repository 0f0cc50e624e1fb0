#include "experiments/polyloop_curves.h"

#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "analysis/hausdorff_distance.h"
#include "analysis/polyloop/local_geometry.h"
#include "experiments/polyloop_shapes.h"
#include "schemes/bspline.h"
#include "schemes/evaluate/level_by_level.h"
#include "schemes/four_point.h"
#include "schemes/jspline.h"
#include "tests/experiments/find_claim.h"

namespace subdiv {
namespace {

using test::find_claim;
using test::find_series;
using test::value_of;

const Results& local() {
  static const Results results = run_polyloop_local();
  return results;
}
const Results& curves() {
  static const Results results = run_polyloop_curves();
  return results;
}
const Results& figures() {
  static const Results results = run_polyloop_figures();
  return results;
}

/// Refined as the chapter writes it, {refine; tuck(1/2); tuck(-s/8)} with the old parameter s.
struct Loop {
  std::vector<double> x;
  std::vector<double> y;

  [[nodiscard]] std::size_t size() const { return x.size(); }
  [[nodiscard]] std::size_t next(std::size_t i) const { return (i + 1) % size(); }
  [[nodiscard]] std::size_t previous(std::size_t i) const { return (i + size() - 1) % size(); }
};

Loop loop_of(const PlanePolygon& polygon) {
  Loop loop;
  for (const auto& [x, y] : polygon) {
    loop.x.push_back(x.to_double());
    loop.y.push_back(y.to_double());
  }
  return loop;
}

std::vector<double> with_middles(const std::vector<double>& v) {
  std::vector<double> result;
  for (std::size_t i = 0; i < v.size(); ++i) {
    result.push_back(v[i]);
    result.push_back((v[i] + v[(i + 1) % v.size()]) / 2);
  }
  return result;
}

std::vector<double> tucked(const std::vector<double>& v, double t) {
  std::vector<double> result;
  const std::size_t n = v.size();
  for (std::size_t i = 0; i < n; ++i)
    result.push_back(v[i] + t * ((v[(i + n - 1) % n] + v[(i + 1) % n]) / 2 - v[i]));
  return result;
}

Loop refined_by(Loop loop, const std::vector<double>& old_parameters) {
  for (const double s : old_parameters) {
    loop.x = tucked(tucked(with_middles(loop.x), 0.5), -s / 8);
    loop.y = tucked(tucked(with_middles(loop.y), 0.5), -s / 8);
  }
  return loop;
}
std::vector<double> times(int levels, double s) {
  return std::vector<double>(static_cast<std::size_t>(levels), s);
}
const std::vector<double> jm{2, 0, -2, -2, -2};
const std::vector<double> family{0, 2, 4, 5, 6, 8};

struct Jerk {
  double largest = 0;
  double mean = 0;
};

Jerk jerk_of(const Loop& p) {
  Jerk result;
  for (std::size_t b = 0; b < p.size(); ++b) {
    const std::size_t a = p.previous(b);
    const std::size_t c = p.next(b);
    const std::size_t d = p.next(c);
    const double jx = -p.x[a] + 3 * p.x[b] - 3 * p.x[c] + p.x[d];
    const double jy = -p.y[a] + 3 * p.y[b] - 3 * p.y[c] + p.y[d];
    const double ex = p.x[c] - p.x[b];
    const double ey = p.y[c] - p.y[b];
    const double normal = std::abs(ex * jy - ey * jx) / std::hypot(ex, ey);
    result.largest = std::max(result.largest, normal);
    result.mean += normal / static_cast<double>(p.size());
  }
  return result;
}

double area_of(const Loop& p) {
  double twice = 0;
  for (std::size_t i = 0; i < p.size(); ++i) twice += p.x[i] * p.y[p.next(i)] - p.y[i] * p.x[p.next(i)];
  return twice / 2;
}

int count(const std::function<bool(const Loop&)>& holds) {
  int result = 0;
  for (const PlanePolygon& polygon : simple_polygons()) result += holds(loop_of(polygon)) ? 1 : 0;
  return result;
}

TEST(PolyloopCurves, EveryHeadIsSettledOnce) {
  for (const auto& [heads, results] :
       {std::pair{polyloop_local_heads(), &local()}, std::pair{polyloop_curve_heads(), &curves()},
        std::pair{polyloop_figure_heads(), &figures()}}) {
    EXPECT_EQ(heads.size(), results->claims.size());
    for (const ClaimHead& head : heads)
      EXPECT_NO_THROW(static_cast<void>(find_claim(results->claims, head.id)));
  }
}

TEST(PolyloopCurves, SchemesAreTheChaptersSequences) {
  const PlanePolygon& polygon = stored_polyloop("non-convex");
  for (const auto& [name, steps] :
       {std::pair{"J5", times(5, 5)}, std::pair{"J0", times(5, 0)}, std::pair{"Jm", jm}}) {
    const Polyline fine = refined(polyloop_curve(name), polygon);
    const Loop expected = refined_by(loop_of(polygon), steps);
    ASSERT_EQ(fine.coordinates[0].size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_NEAR(fine.coordinates[0][i], expected.x[i], 1e-13);
      EXPECT_NEAR(fine.coordinates[1][i], expected.y[i], 1e-13);
    }
  }
}

TEST(PolyloopCurves, LevelFiveIsExactInDoubles) {
  const PlanePolygon& polygon = simple_polygons()[1];
  for (const PolyloopCurve& curve : polyloop_curves()) {
    std::vector<Rational> x;
    for (const auto& point : polygon) x.push_back(point.first);
    const auto exact = refine_level_by_level(curve.scheme, closed_polygon(x), measured_level);
    const Polyline rounded = refined(curve.scheme, polygon);
    for (std::size_t i = 0; i < exact.points.size(); ++i)
      ASSERT_EQ(Rational::from_double(rounded.coordinates[0][i]), exact.points[i]) << curve.name << " " << i;
  }
}

TEST(PolyloopCurves, StoredPolygonsAreAsDescribed) {
  const PlanePolygon& star = stored_polyloop("star");
  for (int i = 0; i < 10; ++i) {
    const double angle = std::numbers::pi / 2 + std::numbers::pi * i / 5;
    const double radius = i % 2 == 0 ? 100 : 40;
    EXPECT_EQ(star[static_cast<std::size_t>(i)].first,
              Rational(static_cast<int>(std::lround(radius * std::cos(angle)))));
    EXPECT_EQ(star[static_cast<std::size_t>(i)].second,
              Rational(static_cast<int>(std::lround(radius * std::sin(angle)))));
  }
  EXPECT_EQ(area_of(loop_of(stored_polyloop("non-convex"))), 26);  // 6 x 6 less 6, less 2 x 2
  EXPECT_EQ(area_of(loop_of(stored_polyloop("crossing"))), -10);
}

TEST(PolyloopCurves, JerksBySequences) {
  const auto largest = [](const Loop& loop, const std::vector<double>& steps) {
    return jerk_of(refined_by(loop, steps)).largest;
  };
  EXPECT_EQ(value_of(curves().claims, "polyloops.jerk.j0") * 200,
            count([&](const Loop& p) { return 20 * largest(p, times(5, 0)) < largest(p, times(5, 8)); }));
  EXPECT_EQ(value_of(curves().claims, "polyloops.jm.jerk") * 200,
            count([&](const Loop& p) { return 10 * largest(p, jm) < largest(p, times(5, 8)); }));
  EXPECT_EQ(value_of(curves().claims, "polyloops.jm.jerk.least") * 200,
            count([&](const Loop& p) { return largest(p, jm) < largest(p, times(5, 0)); }));
  EXPECT_EQ(value_of(curves().claims, "polyloops.jm.jerk.reversed") * 200, count([&](const Loop& p) {
              const double reversed = largest(p, {-2, -2, -2, 0, 2});
              return reversed < largest(p, jm) && reversed < largest(p, times(5, 0));
            }));
  EXPECT_EQ(value_of(curves().claims, "polyloops.jerk.j8") * 200, count([&](const Loop& p) {
              const auto ratio = [&](double s) {
                const Jerk of = jerk_of(refined_by(p, times(5, s)));
                return of.largest / of.mean;
              };
              bool most = ratio(8) > 2;
              for (const double s : family) most = most && (s == 8 || ratio(s) < ratio(8));
              return most;
            }));
}

TEST(PolyloopCurves, AreasByRefinement) {
  constexpr int fine = 8;
  const auto ratio = [](const Loop& p, const std::vector<double>& steps) {
    return area_of(refined_by(p, steps)) / area_of(p);
  };
  EXPECT_EQ(value_of(curves().claims, "polyloops.j4.area") * 200,
            count([&](const Loop& p) { return std::abs(ratio(p, times(fine, 4)) - 1) < 0.05; }));
  EXPECT_EQ(value_of(curves().claims, "polyloops.j4.area.least") * 200, count([&](const Loop& p) {
              const double own = std::abs(ratio(p, times(fine, 4)) - 1);
              bool least = true;
              for (const double s : family)
                least = least && (s == 4 || own < std::abs(ratio(p, times(fine, s)) - 1));
              return least;
            }));
  EXPECT_EQ(value_of(curves().claims, "polyloops.jm.between") * 200, count([&](const Loop& p) {
              std::vector<double> steps = jm;
              steps.resize(fine, -2);
              const double between = ratio(p, steps);
              const auto [low, high] = std::minmax({ratio(p, times(fine, 0)), ratio(p, times(fine, 8))});
              return low < between && between < high;
            }));
}

double to_segment(double px, double py, double ax, double ay, double bx, double by) {
  const double dx = bx - ax;
  const double dy = by - ay;
  const double square = dx * dx + dy * dy;
  const double t = square > 0 ? std::clamp(((px - ax) * dx + (py - ay) * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(px - ax - t * dx, py - ay - t * dy);
}

/// The largest distance of sampled points of `from` from `to`.
double sampled_distance(const Loop& from, const Loop& to, int samples) {
  double largest = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    for (int k = 0; k < samples; ++k) {
      const double t = static_cast<double>(k) / samples;
      const double x = from.x[i] + t * (from.x[from.next(i)] - from.x[i]);
      const double y = from.y[i] + t * (from.y[from.next(i)] - from.y[i]);
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t j = 0; j < to.size(); ++j) {
        least = std::min(least, to_segment(x, y, to.x[j], to.y[j], to.x[to.next(j)], to.y[to.next(j)]));
      }
      largest = std::max(largest, least);
    }
  }
  return largest;
}

TEST(PolyloopCurves, DistancesBySampling) {
  int nearer = 0;
  int nearest = 0;
  for (const PlanePolygon& polygon : simple_polygons()) {
    const Loop p = loop_of(polygon);
    std::vector<double> distance;
    for (const double s : family) {
      const Loop fine = refined_by(p, times(5, s));
      distance.push_back(std::max(sampled_distance(p, fine, 16), sampled_distance(fine, p, 1)));
    }
    nearer += distance[3] < distance[2] ? 1 : 0;
    nearest += std::ranges::min_element(distance) - distance.begin() == 3 ? 1 : 0;
  }
  EXPECT_EQ(value_of(curves().claims, "polyloops.j5.hausdorff") * 200, nearer);
  EXPECT_NEAR(value_of(curves().claims, "polyloops.j5.others") * 200, nearest, 2);
}

TEST(PolyloopCurves, BestOnTheSquareBySearch) {
  const Loop square = loop_of(stored_polyloop("square"));
  const auto distance = [&](double s, int levels = 8) {
    const Loop fine = refined_by(square, times(levels, s));
    return std::max(sampled_distance(square, fine, 4), sampled_distance(fine, square, 1));
  };
  const double best = value_of(curves().claims, "polyloops.j5.square.best");
  for (const double off : {0.01, 0.05, 0.2, 1.0, 2.0}) {
    EXPECT_LT(distance(best), distance(best - off));
    EXPECT_LT(distance(best), distance(best + off));
  }
  EXPECT_LT(distance(6), distance(5));
  for (const double s : {4.0, 5.0, 6.0})  // the note of polyloops.j5.square
    EXPECT_NEAR(distance(s), distance(s, 5), 0.0011);
  EXPECT_EQ(find_claim(curves().claims, "polyloops.j5.square").verdict, Verdict::inconsistent);
}

TEST(PolyloopCurves, StatementsAndTheirVerdicts) {
  EXPECT_EQ(find_claim(local().claims, "polyloops.radius.height").verdict, Verdict::refuted);
  EXPECT_EQ(find_claim(local().claims, "polyloops.radius.height.modulus").verdict, Verdict::established);
  EXPECT_EQ(find_claim(local().claims, "polyloops.velocity.average").verdict, Verdict::reproduced);
  EXPECT_EQ(find_claim(curves().claims, "polyloops.j5.compromise").verdict, Verdict::reproduced);
  const Claim& smooth = find_claim(curves().claims, "polyloops.j8.smooth");
  EXPECT_EQ(smooth.verdict, Verdict::reproduced);
  EXPECT_EQ(smooth.exact, "C1");  // Dubuc 1986: C1, and not C2
}

TEST(PolyloopCurves, J2PassesBesideTheMiddlesOfEdges) {
  const Loop fine = refined_by(loop_of(stored_polyloop("square")), times(12, 2));
  const double beyond = *std::ranges::max_element(fine.x) - 5;
  EXPECT_NEAR(beyond / 5, value_of(curves().claims, "polyloops.j2.osculates.square"), 1e-7);
  EXPECT_EQ(find_claim(curves().claims, "polyloops.j2.osculates").verdict, Verdict::refuted);
}

TEST(PolyloopCurves, PoppingBySequences) {
  int least = 0;
  for (const PlanePolygon& polygon : simple_polygons()) {
    std::vector<std::vector<double>> moved(4);
    for (const double s : family) {
      Loop coarse = loop_of(polygon);
      for (std::size_t level = 0; level < 4; ++level) {
        const Loop fine = refined_by(coarse, {s});
        const std::vector<double> x = with_middles(coarse.x);
        const std::vector<double> y = with_middles(coarse.y);
        double largest = 0;
        for (std::size_t i = 0; i < fine.size(); ++i)
          largest = std::max(largest, std::hypot(fine.x[i] - x[i], fine.y[i] - y[i]));
        moved[level].push_back(largest);
        coarse = fine;
      }
    }
    for (const std::vector<double>& at : moved)
      least += std::ranges::min_element(at) - at.begin() == 3 ? 1 : 0;
  }
  EXPECT_NEAR(value_of(curves().claims, "polyloops.j5.popping") * 800, least, 1);
}

/// Values and derivatives of the quintic B-spline at the integers -2 .. 2, from tables of splines.
TEST(PolyloopLocal, BetterRadiiBySplinesInDoubles) {
  int acute = 0;
  int better = 0;
  for (const PlanePolygon& polygon : simple_polygons()) {
    const Loop target = loop_of(polygon);
    const std::size_t n = target.size();
    const auto applied = [&](const std::vector<double>& v, const std::array<double, 5>& weights) {
      std::vector<double> result(n, 0);
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k < 5; ++k) result[i] += weights[k] * v[(i + 2 * n + k - 2) % n];
      }
      return result;
    };
    Loop controls = target;
    for (int step = 0; step < 2000; ++step) {
      for (auto [v, goal] : {std::pair{&controls.x, &target.x}, std::pair{&controls.y, &target.y}}) {
        const std::vector<double> now =
            applied(*v, {1 / 120.0, 26 / 120.0, 66 / 120.0, 26 / 120.0, 1 / 120.0});
        for (std::size_t i = 0; i < n; ++i) (*v)[i] += (*goal)[i] - now[i];
      }
    }
    const std::array<double, 5> first{-1 / 24.0, -10 / 24.0, 0, 10 / 24.0, 1 / 24.0};
    const std::array<double, 5> second{1 / 6.0, 1 / 3.0, -1, 1 / 3.0, 1 / 6.0};
    const Loop velocity{applied(controls.x, first), applied(controls.y, first)};
    const Loop acceleration{applied(controls.x, second), applied(controls.y, second)};
    const auto at = vertex_geometry(in_double(polygon));
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t a = target.previous(i);
      const std::size_t c = target.next(i);
      const double dot = (target.x[a] - target.x[i]) * (target.x[c] - target.x[i]) +
                         (target.y[a] - target.y[i]) * (target.y[c] - target.y[i]);
      if (dot <= 0) continue;
      ++acute;
      const double truly = (velocity.x[i] * acceleration.y[i] - velocity.y[i] * acceleration.x[i]) /
                           std::pow(std::hypot(velocity.x[i], velocity.y[i]), 3);
      better += std::abs(at[i].parabola_curvature - truly) < std::abs(at[i].circle_curvature - truly) ? 1 : 0;
    }
  }
  EXPECT_NEAR(value_of(local().claims, "polyloops.radius.better"), static_cast<double>(better) / acute,
              1e-12);
}

TEST(PolyloopLocal, LeadingErrorsOfCurvaturesByNumbers) {
  const auto errors = [](const std::function<std::pair<double, double>(double)>& point, double k, double h) {
    std::vector<std::vector<double>> p(2);
    for (const double s : {-h, 0.0, h}) {
      p[0].push_back(point(s).first);
      p[1].push_back(point(s).second);
    }
    const VertexGeometry at = vertex_geometry(make_polyline(p, false)).front();
    return std::pair{(at.circle_curvature - k) / (h * h), (at.parabola_curvature - k) / (h * h)};
  };
  const auto [none, quarter] = errors([](double s) { return std::pair{std::cos(s), std::sin(s)}; }, 1, 1e-2);
  EXPECT_NEAR(none, 0, 1e-6);        // k'' / 12
  EXPECT_NEAR(quarter, 0.25, 1e-4);  // k^3 / 4
  // The logarithmic spiral e^t (cos t, sin t) has arc length sqrt(2) e^t and curvature 1 over it: k'' = 2
  // k^3.
  const double k = 1 / std::numbers::sqrt2;
  const auto spiral = [](double s) {
    const double r = 1 + s / std::numbers::sqrt2;
    return std::pair{r * std::cos(std::log(r)), r * std::sin(std::log(r))};
  };
  const auto [circle, parabola] = errors(spiral, k, 1e-2);
  EXPECT_NEAR(circle, k * k * k / 6, 1e-4);
  EXPECT_NEAR(parabola, 5 * k * k * k / 12, 1e-4);
  EXPECT_EQ(find_claim(local().claims, "polyloops.radius.circle.order").exact, "h^2 (k2/12)");
  EXPECT_EQ(find_claim(local().claims, "polyloops.radius.parabola.order").exact, "h^2 ((3*k^3 + k2)/12)");
}

TEST(PolyloopLocal, FigureNumbersByDoubles) {
  const auto error = [](double h) {
    const auto cube = [](double t) { return t * t * t; };
    const VertexGeometry at =
        vertex_geometry(
            make_polyline({{0.5 - h, 0.5, 0.5 + h}, {cube(0.5 - h), 0.125, cube(0.5 + h)}}, false))
            .front();
    return std::pow(at.circle_curvature, 2) - 9 / std::pow(25.0 / 16, 3);
  };
  EXPECT_NEAR(value_of(local().claims, "figure.polyloops.curvature"), error(1.0 / 64) / error(1.0 / 128),
              1e-8);
  const VertexGeometry at = vertex_geometry(make_polyline({{-3, 0, 3}, {-4, 0, -4}}, false)).front();
  EXPECT_NEAR(value_of(local().claims, "figure.polyloops.acute"), at.circle_radius() / at.parabola_radius(),
              1e-14);
}

TEST(PolyloopFigures, NumbersBySequences) {
  const Loop shape = loop_of(stored_polyloop("non-convex"));
  const auto largest = [&](const std::vector<double>& steps) {
    return jerk_of(refined_by(shape, steps)).largest;
  };
  const double most = largest(times(4, 8));
  EXPECT_NEAR(value_of(figures().claims, "figure.polyloops.jerk"), std::pow(largest(times(4, 0)) / most, 2),
              1e-12);
  EXPECT_NEAR(value_of(figures().claims, "figure.polyloops.jerk.jm"),
              std::pow(largest({2, 0, -2, -2}) / most, 2), 1e-12);
  EXPECT_NEAR(value_of(figures().claims, "figure.polyloops.j4-j5"),
              area_of(refined_by(shape, times(5, 5))) / area_of(refined_by(shape, times(5, 4))), 1e-12);
  const Loop star = loop_of(stored_polyloop("star"));
  EXPECT_NEAR(value_of(figures().claims, "figure.polyloops.row"),
              area_of(refined_by(star, jm)) / area_of(star), 1e-12);
  const Loop crossing = loop_of(stored_polyloop("crossing"));
  EXPECT_NEAR(value_of(figures().claims, "figure.polyloops.superposed"),
              area_of(refined_by(crossing, times(5, 8))) / area_of(refined_by(crossing, times(5, 0))), 1e-11);
}

/// Areas by the masks of B-splines and of the four-point scheme, level by level.
TEST(PolyloopFigures, ConstructionsByMasks) {
  const Results results = run_polyloop_construction();
  ASSERT_EQ(results.claims.size(), polyloop_construction_heads().size());
  const auto ratio = [](const Mask<double>& mask, int levels) {
    const Polyline square = in_double(stored_polyloop("square"));
    return signed_area(refine(stationary("", mask), square, levels)) / signed_area(square);
  };
  EXPECT_NEAR(value_of(results.claims, "figure.polyloops.construction.quadratic"),
              ratio(bspline<double>(2), 4), 1e-14);
  EXPECT_NEAR(value_of(results.claims, "figure.polyloops.construction.cubic"), ratio(bspline<double>(3), 3),
              1e-14);
  EXPECT_NEAR(value_of(results.claims, "figure.polyloops.construction.four-point"),
              ratio(four_point(1.0 / 16), 2), 1e-14);
}

/// The curves of the star as drawn: the key's columns hold the closed polygon of level 5.
TEST(PolyloopFigures, SeriesHoldTheCurves) {
  const Series& row = find_series(figures(), "polyloop-row");
  EXPECT_EQ(row.columns.size(), 2 * (1 + 2 * 7));
  EXPECT_EQ(row.rows.size(), 10U * 32 + 1);
  EXPECT_EQ(find_series(curves(), "polyloop-measures").rows.size(), 4U * 7);
}

}  // namespace
}  // namespace subdiv
