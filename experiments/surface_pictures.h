#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "experiments/experiment.h"
#include "experiments/report/figure_style.h"
#include "experiments/surface_popping.h"

namespace subdiv {

/// Where the picture of a surface stands in a figure: the origin of space at `centre`, `scale` units of the
/// figure to one of space.
struct Placement {
  View view;
  double scale = 1;
  Eigen::Vector2d centre{0, 0};
};

/// A quad of a surface in space, and its indices along and across.
struct SpaceQuad {
  std::array<Eigen::Vector3d, 4> corners;
  std::size_t along = 0;
  std::size_t across = 0;
};

/// All quads of the refined grid.
[[nodiscard]] std::vector<SpaceQuad> space_quads(const DoubleGrid& grid, const Scheme<double>& scheme,
                                                 int depth);

/// How quads are coloured: by the light that falls on them, in one colour, or in two that alternate.
enum class Paint { shaded, chequered, flat };

/// A series of polygons, to be drawn as filled ones one after the other: x and y in the figure and a colour,
/// red x 65536 + green x 256 + blue. Polygons end with an empty row.
[[nodiscard]] Series polygons(std::string name);
/// Adds a surface, its quads in order of their distance from the eye; of closed surfaces only the quads that
/// face it. `colour` is that of fully lit quads.
void add_quads(Series& series, std::vector<SpaceQuad> quads, bool closed, const Placement& placement,
               Paint paint, unsigned colour);
/// The gnuplot styles that draw such a series.
[[nodiscard]] Curve filled(const Series& series);

/// A series of polylines in space: x, y in the figure and the point, column names x y px py pz. Lines end
/// with an empty row.
[[nodiscard]] Series polylines(std::string name);
void add_line(Series& series, const std::vector<Eigen::Vector3d>& points, bool closed,
              const Placement& placement);
[[nodiscard]] Curve drawn(const Series& series, std::string label, std::string style);

/// A caption centred below (or above) what a series draws.
[[nodiscard]] FigureText caption_below(const Series& series, std::string text, double gap = 14);
[[nodiscard]] FigureText caption_above(const Series& series, std::string text, double gap = 14);

/// A picture: no axes, both directions in one scale. `claims` as in Figure.
[[nodiscard]] Figure bare_figure(std::string name, std::string title, std::vector<Curve> curves,
                                 std::vector<FigureText> texts, std::vector<std::string> claims);

}  // namespace subdiv
