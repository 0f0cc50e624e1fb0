#include "experiments/surfaces.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "analysis/open_grid.h"
#include "analysis/quad_topology.h"
#include "experiments/grid_data.h"
#include "experiments/report/figure_style.h"
#include "experiments/surface_popping.h"
#include "schemes/evaluate/geomorph.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

const std::string two_rings =
    "The construction of js-report 13: a motion ring a row of control points, and two display rings driven "
    "by "
    "two consecutive points of every motion ring. ";
const std::string counted = "Counted on the rings while they run. ";
const std::string topology = "Vertices, edges and quads counted from the indices of the quads put out, ";
const std::string family =
    "Family: 40 rough tori of integer control points (4 to 7 rows and columns, radii 20 and 8, each "
    "coordinate moved by -3 .. 3) from random directions; 64-bit Mersenne twister, seed 2026. Disparity: the "
    "area that only one of the pictures of two consecutive levels covers, as a share of the area of the "
    "earlier one, in orthographic projection, quads as two triangles, 400 lines. ";

const std::array table{
    ClaimHead{
        "ringing.footprint.surface", "js-report", "14 (12, 13)",
        "5(n+2) points per level of subdivision of a surface defined by a control polygon with n rows of "
        "control points",
        ClaimKind::exact,
        two_rings +
            "Points that all rings keep at each level, n = 3 .. 12 rows of a torus, J_s at s = "
            "0, 3/8, 1/2, 3/2 and {J_{-33/26}, *J_{3/2}}. " +
            counted},
    finding("ringing.footprint.surface.once", "js-report 13",
            "Points that the rings keep at each level when every transversal curve is evaluated once. " +
                counted),
    finding(
        "ringing.footprint.surface.borders", "js-report 13",
        "Rows of an open transversal direction: the points added at its ends (js-report 11) are computed "
        "from the current points of the n given rows in each frame, or beforehand as four further rows. Do "
        "both give the same surface, and how many points do the rings keep at each level? " +
            counted),
    ClaimHead{"ringing.no-redundancy.surface", "js-report", "12 (13)",
              "without having to perform any redundant computation", ClaimKind::exact,
              two_rings +
                  "Evaluations of transversal curves against transversal curves; grid "
                  "surface-torus.csv, *J_{3/2}, 5 steps in both directions. " +
                  counted},
    finding(
        "ringing.no-redundancy.surface.once", "js-report 13",
        "The same quads with one display ring and the points of the curve before kept: evaluations of "
        "transversal curves against transversal curves, and the memory that it takes, on the same grid. " +
            counted),
    finding(
        "ringing.same-surface", "js-report 13",
        "Do the papers' construction, the one that evaluates each curve once and the stream of vertices "
        "and quads give the quads of the tensor product, refined level by level, all rows first and then "
        "all columns? Over the rationals, on the grids of the figures, closed and with clamped ends, 0 to "
        "2 steps in each direction."),
    ClaimHead{"ringing.rings", "js-report", "13, caption of figure 15 (jsplines 10, figure 11)",
              "5, 6 and 8 rings of 5 points each", ClaimKind::exact,
              two_rings +
                  "Rings a level for control meshes of 3, 4 and 6 rows (surface-rows-3.csv, "
                  "surface-torus.csv, surface-rows-6.csv), *J_{3/2}. " +
                  counted},
    ClaimHead{"ringing.minimum-input.torus", "js-report", "14",
              "a genus-one (torus-like) surface may be defined by a 3\u00d73 control grid", ClaimKind::exact,
              topology + "0 to 4 steps: a connected oriented surface without border, V - E + F = 0?"},
    ClaimHead{"ringing.borders.cylinder", "js-report", "14",
              "surface patches with two borders (cylinder-topology)", ClaimKind::exact,
              topology + "one direction closed, the other with clamped ends; either way round, 0 to 4 steps: "
                         "a connected oriented surface with two border loops, V - E + F = 0?"},
    ClaimHead{"ringing.borders.disk", "js-report", "14", "one border (rectangle with disk-topology)",
              ClaimKind::exact,
              topology + "both directions with clamped ends, 0 to 4 steps: a connected oriented surface with "
                         "one border loop, V - E + F = 1?"},
    ClaimHead{
        "popping.geomorph", "jsplines", "11",
        "The effect may be diminished by using a geomorph that linearly blends over time between the "
        "results of applying J0,1 and applying another Js step to the previous level",
        ClaimKind::exact,
        "Is the first picture of the geomorph the polygon before, the last one the polygon after, and "
        "the largest jump of a point between two of F + 1 pictures exactly 1/F of the largest one "
        "without geomorph? Over the rationals: rows of the grids of the figures as closed space curves, "
        "s = 0, 3/8, 1, 3/2, levels 1 to 3, F = 8."},
    finding("popping.geomorph.surface", "jsplines 11",
            "The same for surfaces, whose coarse quads are drawn as bilinear patches: grid "
            "surface-torus.csv, *J_{3/8} and *J_1, levels 1 and 2, F = 4."),
    finding(
        "popping.geomorph.triangles", "jsplines 11",
        "What a geomorph leaves of the pop when quads are drawn as two triangles: square of the largest "
        "distance between a quad's bilinear centre (A+B+C+D)/4, where the geomorph begins, and the middle "
        "(A+C)/2 of the diagonal that was drawn. Control grid surface-torus.csv."),
    ClaimHead{"popping.silhouettes", "jsplines", "11, figure 16 (js-report 9, figure 11)",
              "silhouette disparities for J0 (left with the lighter image painted on top), J3/8 (center with "
              "lighter on top), and J1 (right with darker on top)",
              ClaimKind::tendency,
              family + "Share of the family on which J_{3/8} has a smaller disparity between levels 1 and 2 "
                       "than both J_0 and J_1."},
    ClaimHead{"popping.silhouettes.s", "jsplines", "11", "*J0.375 works well", ClaimKind::tendency,
              family + "The multiple of 1/8 from 0 to 3/2 with the least mean disparity between levels 1 and "
                       "2."},
};

using DoublePoint = Eigen::Vector3d;
using SpaceGrid = ControlGrid<SpacePoint>;

const std::array<std::string, 4> grid_files{"surface-torus.csv", "surface-rows-3.csv", "surface-rows-6.csv",
                                            "surface-borders.csv"};
const Rational three_halves(3, 2);

Scheme<Rational> j(const Rational& s) { return stationary("J", jspline(s)); }
const auto ignore = [](const auto&) {};

Claim statement(const std::string& id, bool holds, std::string found, std::string note = "") {
  return settle_statement(head(table, id), holds, std::move(found), std::move(note));
}

Refinement<double> steps(const Scheme<Rational>& scheme, int depth) {
  return {map_coefficients(scheme, [](const Rational& x) { return x.to_double(); }), depth};
}

/// A torus of n rows whose points do not matter.
ControlGrid<double> blank_torus(std::size_t rows, std::size_t columns) {
  return control_grid({rows, true, 0, 0}, {columns, true, 0, 0}, std::vector<double>(rows * columns, 0));
}

void add_footprint(Results& results) {
  constexpr std::size_t most_rows = 12;
  constexpr int depth = 3;
  const std::vector<Scheme<Rational>> schemes{j(Rational(0)), j(Rational(3, 8)), j(Rational(1, 2)),
                                              j(three_halves), mixed(j(Rational(-33, 26)), j(three_halves))};
  bool two = true;
  bool one = true;
  for (const Scheme<Rational>& scheme : schemes) {
    const Refinement<double> both = steps(scheme, depth);
    for (std::size_t n = 3; n <= most_rows; ++n) {
      const auto grid = blank_torus(n, 4);
      two = two && quads_by_two_rings(grid, both, both, ignore).points_a_level() == 5 * (n + 2);
      one = one && stream_surface(grid, both, both, ignore, ignore).points_a_level() == 5 * (n + 1) &&
            quads_evaluated_once(grid, both, both, ignore).points_a_level() == 5 * (n + 1);
    }
  }
  const Refinement<double> cubic = steps(j(Rational(1)), depth);
  const SurfaceWork least = quads_by_two_rings(blank_torus(4, 4), cubic, cubic, ignore);
  results.claims.push_back(statement(
      "ringing.footprint.surface", two, "5(n+2)",
      fmt::format(
          "J_1 alone, whose odd points have two parents, needs no more than 3 points a ring: {} instead "
          "of 30 for 4 rows. Beside the rings two control polygons of n points are held, whatever the "
          "number of levels.",
          least.points_a_level())));
  results.claims.push_back(statement(
      "ringing.footprint.surface.once", one, "5(n+1)",
      "As a stream of vertices and quads by index nothing else is kept but one control polygon of n "
      "points. Whoever wants the corners of each quad keeps the points of the curve before, too, and "
      "of the first one when trajectories are closed."));
}

/// Adjusted in each frame, and as rows of their own.
void add_footprint_of_borders(Results& results) {
  const Scheme<Rational> scheme = j(Rational(1, 2));
  const Refinement<Rational> both{scheme, 2};
  const EndWeights<Rational> weights = end_weights(scheme, OpenEnd::clamped);
  const SpaceGrid given = grid_from_data("surface-rows-6.csv");
  std::vector<SpacePoint> expected;
  const SurfaceWork rows = quads_by_two_rings(open_across(given, weights), both, both, ignore);
  stream_surface(
      open_across(given, weights), both, both, [&](const SpacePoint& p) { expected.push_back(p); }, ignore);
  MovingPolygon<Rational, SpacePoint> motion(scheme, given, both.depth);
  std::vector<SpacePoint> adjusted;
  std::size_t kept = 0;
  for (; !motion.done(); motion.advance()) {
    const auto transversal = with_ends(motion.polygon().points, weights);
    Ringing<Rational, SpacePoint> curve(scheme, transversal, both.depth);
    kept = motion.points_per_level() + 2 * curve.points_per_level();
    for (const SpacePoint& p : curve) adjusted.push_back(p);
  }
  const std::size_t n = given.rows.points;
  results.claims.push_back(statement(
      "ringing.footprint.surface.borders",
      adjusted == expected && kept == 5 * (n + 2) && rows.points_a_level() == 5 * (n + 6),
      "5(n+2) adjusted in each frame, 5(n+6) as further rows",
      "The added points are linear in the given ones, so that both surfaces are the same; the printed count "
      "holds when display rings adjust their own ends. Ends along the trajectories cost nothing."));
}

void add_redundancy(Results& results) {
  constexpr int depth = 5;
  const Refinement<double> both = steps(j(three_halves), depth);
  const auto grid = map_points(grid_from_data("surface-torus.csv"), rounded);
  const SurfaceSize size = surface_size(grid, both, both);
  const SurfaceWork two = quads_by_two_rings(grid, both, both, ignore);
  const SurfaceWork once = quads_evaluated_once(grid, both, both, ignore);
  const SurfaceWork stream = stream_surface(grid, both, both, ignore, ignore);
  std::size_t per_curve = 0;
  std::size_t per_row = 0;
  for (int k = 1; k <= depth; ++k) {
    per_curve += refined_points(grid.rows, 2, k);
    per_row += refined_points(grid.columns(), 2, k);
  }
  results.claims.push_back(statement(
      "ringing.no-redundancy.surface", two.curves == size.along,
      fmt::format("{} evaluations of {} transversal curves", two.curves, size.along),
      fmt::format("Every transversal curve bounds two strips and is evaluated for both: the display rings "
                  "compute {} points where {} are enough. A closed ring also computes some points anew where "
                  "it begins: {} instead of {} points a transversal curve, {} instead of {} a trajectory.",
                  two.computed_across, once.computed_across, once.computed_across / size.along, per_curve,
                  stream.computed_along / grid.rows.points, per_row)));
  results.claims.push_back(statement(
      "ringing.no-redundancy.surface.once", once.curves == size.along && stream.curves == size.along,
      fmt::format("{} evaluations of {} transversal curves", once.curves, size.along),
      fmt::format("It keeps {} points of refined curves: {} of the curve before and as many of the first, to "
                  "close the surface. As a stream of vertices and quads by index it keeps none of them.",
                  once.curve_points, size.across)));
}

/// The grid closed and open in every combination.
std::vector<SpaceGrid> with_and_without_borders(const SpaceGrid& grid, const EndWeights<Rational>& weights) {
  const SpaceGrid along = open_along(grid, weights);
  return {grid, along, open_across(grid, weights), open_across(along, weights)};
}

using Corners = std::array<SpacePoint, 4>;

bool all_constructions_agree(const SpaceGrid& grid, const Refinement<Rational>& along,
                             const Refinement<Rational>& across) {
  std::vector<Corners> two;
  const auto copied = [](const Quad<SpacePoint>& quad) {
    const auto& c = quad.corners;
    return Corners{*c[0], *c[1], *c[2], *c[3]};
  };
  quads_by_two_rings(grid, along, across, [&](const Quad<SpacePoint>& quad) { two.push_back(copied(quad)); });
  bool same = true;
  std::size_t i = 0;
  quads_evaluated_once(grid, along, across,
                       [&](const Quad<SpacePoint>& quad) { same = same && copied(quad) == two.at(i++); });
  same = same && i == two.size();
  std::vector<SpacePoint> vertices;
  std::vector<std::array<std::size_t, 4>> quads;
  stream_surface(
      grid, along, across, [&](const SpacePoint& p) { vertices.push_back(p); },
      [&](const auto& quad) { quads.push_back(quad); });
  const SpaceGrid levels = refine_grid_level_by_level(grid, along, across);
  const SurfaceSize size = surface_size(grid, along, across);
  for (std::size_t v = 0; v < vertices.size(); ++v)
    same = same && vertices[v] == levels.at(static_cast<long long>(v % size.across),
                                            static_cast<long long>(v / size.across));
  same = same && quads.size() == two.size() && vertices.size() == size.along * size.across;
  for (std::size_t q = 0; same && q < quads.size(); ++q) {
    for (std::size_t c = 0; c < 4; ++c) same = same && vertices.at(quads[q][c]) == two[q][c];
  }
  return same;
}

void add_same_surface(Results& results) {
  constexpr int most = 2;
  bool same = true;
  int surfaces = 0;
  for (const Rational& s : {Rational(1, 2), three_halves}) {
    const EndWeights<Rational> weights = end_weights(j(s), OpenEnd::clamped);
    for (const std::string& file : grid_files) {
      for (const SpaceGrid& grid : with_and_without_borders(grid_from_data(file), weights)) {
        for (int depth = 0; depth <= most; ++depth) {
          const Refinement<Rational> along{j(s), depth};
          const Refinement<Rational> across{mixed(j(Rational(-33, 26)), j(s)), most - depth};
          same = same && all_constructions_agree(grid, along, across);
          ++surfaces;
        }
      }
    }
  }
  results.claims.push_back(statement("ringing.same-surface", same, "true",
                                     fmt::format("{} surfaces, all quads compared.", surfaces)));
}

void add_rings(Results& results) {
  const Refinement<double> both = steps(j(three_halves), 2);
  std::string found;
  for (const char* file : {"surface-rows-3.csv", "surface-torus.csv", "surface-rows-6.csv"}) {
    const auto grid = map_points(grid_from_data(file), rounded);
    const SurfaceWork work = quads_by_two_rings(grid, both, both, ignore);
    found += fmt::format("{}{} of {}", found.empty() ? "" : ", ", work.rings(),
                         work.points_a_level() / work.rings());
  }
  results.claims.push_back(statement("ringing.rings", found == "5 of 5, 6 of 5, 8 of 5", found,
                                     "Rings a level: a ring a row and two more, n + 2 for n rows."));
}

/// Whether all refinements of these grids have the topology wished, and the counts of the last one as text.
std::pair<bool, std::string> topology_of(const std::vector<SpaceGrid>& grids, std::size_t borders,
                                         long long euler) {
  constexpr int most = 4;
  bool holds = true;
  std::string text;
  for (const SpaceGrid& exact_grid : grids) {
    const auto grid = map_points(exact_grid, rounded);
    for (int depth = 0; depth <= most; ++depth) {
      const Refinement<double> both = steps(j(three_halves), depth);
      std::size_t vertices = 0;
      std::vector<std::array<std::size_t, 4>> quads;
      stream_surface(
          grid, both, both, [&](const DoublePoint&) { ++vertices; },
          [&](const auto& quad) { quads.push_back(quad); });
      const QuadTopology t = quad_topology(vertices, quads);
      holds = holds && t.manifold && t.oriented && t.components == 1 && t.borders == borders &&
              t.euler_characteristic() == euler;
      text = fmt::format("{} - {} + {} = {}, {} borders", t.vertices, t.edges, t.quads,
                         t.euler_characteristic(), t.borders);
    }
  }
  return {holds, text};
}

void add_topology(Results& results) {
  const auto grids = with_and_without_borders(grid_from_data("surface-rows-3.csv"),
                                              end_weights(j(three_halves), OpenEnd::clamped));
  const auto [torus, torus_text] = topology_of({grids[0]}, 0, 0);
  const auto [cylinder, cylinder_text] = topology_of({grids[1], grids[2]}, 2, 0);
  const auto [disk, disk_text] = topology_of({grids[3]}, 1, 1);
  results.claims.push_back(statement("ringing.minimum-input.torus", torus, torus_text,
                                     "V - E + F after 4 steps; genus 1. Grid surface-rows-3.csv."));
  results.claims.push_back(
      statement("ringing.borders.cylinder", cylinder, cylinder_text, "V - E + F after 4 steps."));
  results.claims.push_back(statement("ringing.borders.disk", disk, disk_text, "V - E + F after 4 steps."));
}

Rational squared_distance(const SpacePoint& a, const SpacePoint& b) {
  Rational sum;
  for (int k = 0; k < 3; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

Rational largest_jump(const std::vector<SpacePoint>& before, const std::vector<SpacePoint>& after) {
  Rational largest;
  for (std::size_t i = 0; i < before.size(); ++i)
    largest = std::max(largest, squared_distance(before[i], after[i]));
  return largest;
}

/// The squared jump without geomorph, and whether the geomorph's pictures begin and end as they should and
/// jump by 1/F of it each.
struct Morph {
  Rational jump;
  bool holds = false;
};

/// `picture` gives the points of the geomorph at time t, `flat` those of the level before, `fine` the next.
template <class Picture>
Morph examine(const Picture& picture, const std::vector<SpacePoint>& flat,
              const std::vector<SpacePoint>& fine, int pictures) {
  Morph morph{largest_jump(flat, fine), picture(Rational(0)) == flat && picture(Rational(1)) == fine};
  std::vector<SpacePoint> last = flat;
  for (int f = 1; f <= pictures; ++f) {
    std::vector<SpacePoint> next = picture(Rational(f, pictures));
    morph.holds = morph.holds && largest_jump(last, next) * Rational(pictures * pictures) == morph.jump;
    last = std::move(next);
  }
  return morph;
}

/// A closed polygon with its mid-points.
std::vector<SpacePoint> with_mid_points(const std::vector<SpacePoint>& points) {
  std::vector<SpacePoint> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    result.push_back(points[i]);
    result.emplace_back(Rational(1, 2) * (points[i] + points[(i + 1) % points.size()]));
  }
  return result;
}

void add_geomorph_of_curves(Results& results) {
  constexpr int pictures = 8;
  constexpr int levels = 3;
  bool holds = true;
  int curves = 0;
  for (const std::string& file : grid_files) {
    const SpaceGrid grid = grid_from_data(file);
    for (const ControlPolygon<SpacePoint>& row : grid.lines) {
      for (const Rational& s : {Rational(0), Rational(3, 8), Rational(1), three_halves}) {
        for (int depth = 1; depth <= levels; ++depth) {
          const auto picture = [&](const Rational& t) {
            std::vector<SpacePoint> points;
            Ringing<Rational, SpacePoint> rings(geomorph(j(s), depth, t), row, depth);
            for (const SpacePoint& p : rings) points.push_back(p);
            return points;
          };
          const auto before = refine_level_by_level(j(s), row, depth - 1);
          const auto after = refine_level_by_level(j(s), row, depth);
          holds = holds && examine(picture, with_mid_points(before.points), after.points, pictures).holds;
          ++curves;
        }
      }
    }
  }
  results.claims.push_back(
      statement("popping.geomorph", holds, "true",
                fmt::format("{} geomorphs. The blend of one step is itself a step, J_{{t s, 1-t+t s}}: any "
                            "evaluator draws the pictures in between.",
                            curves)));
}

/// The level before with the mid-points of its edges and the centres of its bilinear quads.
std::vector<SpacePoint> with_bilinear_points(const SpaceGrid& grid) {
  const auto rows = static_cast<long long>(grid.rows.points);
  const auto columns = static_cast<long long>(grid.columns().points);
  std::vector<SpacePoint> result;
  for (long long t = 0; t < 2 * columns; ++t) {
    for (long long v = 0; v < 2 * rows; ++v) {
      const SpacePoint low = grid.at(v / 2, t / 2) + grid.at((v + 1) / 2, t / 2);
      const SpacePoint high = grid.at(v / 2, (t + 1) / 2) + grid.at((v + 1) / 2, (t + 1) / 2);
      result.emplace_back(Rational(1, 4) * (low + high));
    }
  }
  return result;
}

void add_geomorph_of_surfaces(Results& results) {
  constexpr int pictures = 4;
  constexpr int levels = 2;
  constexpr int digits = 10;
  const SpaceGrid grid = grid_from_data("surface-torus.csv");
  bool holds = true;
  Series series{"surface-geomorph", {"level", "s", "square_of_largest_jump", "square_with_geomorph"}, {}};
  for (const Rational& s : {Rational(0), Rational(3, 8), Rational(1), three_halves}) {
    for (int depth = 1; depth <= levels; ++depth) {
      const Refinement<Rational> both{j(s), depth};
      const Refinement<Rational> before{j(s), depth - 1};
      const auto picture = [&](const Rational& t) {
        std::vector<SpacePoint> points;
        stream_geomorph(grid, both, both, t, [&](const SpacePoint& p) { points.push_back(p); });
        return points;
      };
      const std::vector<SpacePoint> flat =
          with_bilinear_points(refine_grid_level_by_level(grid, before, before));
      std::vector<SpacePoint> fine;
      stream_surface(grid, both, both, [&](const SpacePoint& p) { fine.push_back(p); }, ignore);
      const Morph morph = examine(picture, flat, fine, pictures);
      holds = holds && morph.holds;
      series.rows.push_back({std::to_string(depth), to_decimal(s, 3), to_significant(morph.jump, digits),
                             to_significant(morph.jump / Rational(pictures * pictures), digits)});
    }
  }
  results.series.push_back(std::move(series));
  results.claims.push_back(statement(
      "popping.geomorph.surface", holds, "true",
      "The results of both steps are blended: a blend of the step in each direction begins and ends alike, "
      "but its points run on parabolas."));

  Rational left;
  const auto rows = static_cast<long long>(grid.rows.points);
  const auto columns = static_cast<long long>(grid.columns().points);
  for (long long t = 0; t < columns; ++t) {
    for (long long v = 0; v < rows; ++v) {
      const SpacePoint diagonal = grid.at(v, t) + grid.at(v + 1, t + 1);
      const SpacePoint other = grid.at(v, t + 1) + grid.at(v + 1, t);
      left = std::max(left, squared_distance(Rational(1, 4) * diagonal, Rational(1, 4) * other));
    }
  }
  results.claims.push_back(
      settle(head(table, "popping.geomorph.triangles"), exact(left),
             "A geomorph hides the whole pop only of quads that are plane or drawn as bilinear patches; "
             "otherwise the picture before should be drawn with the four triangles around each centre. On "
             "this grid the pop of *J_{3/8} itself is not much larger: its square is in the series "
             "surface-geomorph."));
}

void add_silhouettes(Results& results) {
  constexpr int count = 40;
  constexpr int lines = 400;
  constexpr int levels = 3;
  constexpr int values = 13;  // multiples of 1/8 from 0 to 3/2
  constexpr int three_eighths = 3;
  constexpr int one = 8;
  constexpr std::uint64_t seed = 2026;
  constexpr int claimed = 2;  // the level of the claims
  const std::vector<ViewedGrid> surfaces = rough_tori(seed, count);
  std::array<std::array<double, values>, levels> sums{};
  std::array<int, levels> smallest{};
  for (const ViewedGrid& surface : surfaces) {
    const View view = view_from(surface.direction);
    std::array<std::array<double, values>, levels> disparity{};
    for (int i = 0; i < values; ++i) {
      const Scheme<double> scheme = stationary("J", jspline(i / 8.0));
      std::vector<PictureTriangle> before = picture_of(surface.grid, scheme, 0, view);
      for (std::size_t k = 0; k < levels; ++k) {
        std::vector<PictureTriangle> after = picture_of(surface.grid, scheme, static_cast<int>(k) + 1, view);
        const PictureAreas areas = compare_pictures(before, after, lines);
        const auto at = static_cast<std::size_t>(i);
        disparity[k][at] = areas.difference / areas.first;
        sums[k][at] += disparity[k][at];
        before = std::move(after);
      }
    }
    for (std::size_t k = 0; k < levels; ++k) {
      const auto& d = disparity[k];
      smallest[k] += d[three_eighths] < d[0] && d[three_eighths] < d[one] ? 1 : 0;
    }
  }
  Series series{"surface-silhouette-disparity", {"s", "level_1", "level_2", "level_3"}, {}};
  constexpr int digits = 6;
  for (std::size_t i = 0; i < values; ++i) {
    series.rows.push_back({to_decimal(Rational(static_cast<int>(i), 8), 3)});
    for (const auto& level : sums)
      series.rows.back().push_back(to_significant(Rational::from_double(level[i] / count), digits));
  }
  const auto best = [&](std::size_t k) {
    return Rational(static_cast<int>(std::ranges::min_element(sums[k]) - sums[k].begin()), 8);
  };
  const auto agrees = [](bool holds) { return holds ? Verdict::consistent : Verdict::inconsistent; };
  const double share = static_cast<double>(smallest[claimed - 1]) / count;
  constexpr int believed = 3;
  results.claims.push_back(settle_as(
      head(table, "popping.silhouettes"), agrees(2 * smallest[claimed - 1] > count),
      approximate(share, believed, "line by line"),
      fmt::format("{} of {} surfaces; {} between levels 0 and 1, {} between levels 2 and 3. The surface of "
                  "the papers' figures is lost.",
                  smallest[1], count, smallest[0], smallest[2])));
  results.claims.push_back(
      settle_as(head(table, "popping.silhouettes.s"), agrees(best(claimed - 1) == Rational(three_eighths, 8)),
                approximate(best(claimed - 1).to_double(), believed, "line by line"),
                fmt::format("Between levels 0 and 1 it is {}, between levels 2 and 3 {}.",
                            best(0).to_string(), best(2).to_string())));
  results.series.push_back(std::move(series));
  results.figures.push_back(
      {"surface-silhouette-disparity",
       "Popping of silhouettes between levels: mean over 40 rough tori",
       "parameter s",
       "changed share of the picture",
       {{"surface-silhouette-disparity", "s", "level_1", "levels 0 and 1", style::marked(0)},
        {"surface-silhouette-disparity", "s", "level_2", "levels 1 and 2", style::marked(1)},
        {"surface-silhouette-disparity", "s", "level_3", "levels 2 and 3", style::marked(2)}},
       style::log_y,
       {"popping.silhouettes", "popping.silhouettes.s"}});
}

/// What a geomorph makes of the pop of silhouettes: between levels 1 and 2, by the number of its pictures.
void add_geomorph_of_silhouettes(Results& results) {
  constexpr int depth = 2;
  constexpr int most = 16;
  constexpr int lines = 1000;
  constexpr int digits = 6;
  const auto grid = map_points(grid_from_data("surface-torus.csv"), rounded);
  const View view = view_from({2, -5, 4});
  Series series{"surface-geomorph-silhouettes", {"pictures", "four_point", "three_eighths", "cubic"}, {}};
  for (int pictures = 1; pictures <= most; pictures *= 2) {
    series.rows.push_back({std::to_string(pictures)});
    for (const double s : {0.0, 0.375, 1.0}) {
      const double change = largest_change(grid, stationary("J", jspline(s)), depth, pictures, view, lines);
      series.rows.back().push_back(to_significant(Rational::from_double(change), digits));
    }
  }
  results.series.push_back(std::move(series));
  const std::string name = "surface-geomorph-silhouettes";
  results.figures.push_back(
      {name,
       "Silhouettes of a torus from level 1 to 2: largest change from picture to picture",
       "pictures of the geomorph (1: none)",
       "changed share of the picture",
       {{name, "pictures", "four_point", "J_0", style::marked(0)},
        {name, "pictures", "three_eighths", "J_{3/8}", style::marked(1)},
        {name, "pictures", "cubic", "J_1", style::marked(2)}},
       "set logscale xy 2; set xrange [0.9:18]; set format y '2^{/*1.1 %L}'",
       {"popping.geomorph.surface"}});
}

}  // namespace

std::span<const ClaimHead> surface_heads() { return table; }

Results run_surfaces() {
  Results results;
  add_footprint(results);
  add_footprint_of_borders(results);
  add_redundancy(results);
  add_same_surface(results);
  add_rings(results);
  add_topology(results);
  add_geomorph_of_curves(results);
  add_geomorph_of_surfaces(results);
  add_silhouettes(results);
  add_geomorph_of_silhouettes(results);
  add_surface_figures(results);
  return results;
}

}  // namespace subdiv
