#include "experiments/surface_pictures.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

#include "schemes/evaluate/grid_ringing.h"

namespace subdiv {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

std::string decimal(double x, int digits) { return to_decimal(Rational::from_double(x), digits); }

Vector2d place(const Placement& placement, const Vector3d& p) {
  return placement.centre + placement.scale * placement.view.project(p);
}

Vector3d middle(const SpaceQuad& quad) {
  return (quad.corners[0] + quad.corners[1] + quad.corners[2] + quad.corners[3]) / 4;
}

/// Twice the area vector of a quad.
Vector3d normal(const SpaceQuad& quad) {
  return (quad.corners[2] - quad.corners[0]).cross(quad.corners[3] - quad.corners[1]);
}

unsigned dimmed(unsigned colour, double light) {
  unsigned result = 0;
  for (const unsigned shift : {16U, 8U, 0U}) {
    const unsigned part = (colour >> shift) & 0xFFU;
    result |= static_cast<unsigned>(std::lround(part * light)) << shift;
  }
  return result;
}

/// From above, the left and the front.
double lit(const View& view, const Vector3d& facing) {
  const Vector3d light = (-0.4 * view.right + 0.7 * view.up + 0.6 * view.towards).normalized();
  constexpr double ambient = 0.35;
  const double length = facing.norm();
  return length == 0 ? ambient : ambient + (1 - ambient) * std::max(0.0, facing.dot(light) / length);
}

Eigen::AlignedBox2d extent_of(const Series& series) {
  Eigen::AlignedBox2d box;
  for (const std::vector<std::string>& row : series.rows) {
    if (!row[0].empty())
      box.extend(Vector2d(Rational::parse(row[0]).to_double(), Rational::parse(row[1]).to_double()));
  }
  return box;
}

}  // namespace

std::vector<SpaceQuad> space_quads(const DoubleGrid& grid, const Scheme<double>& scheme, int depth) {
  const Refinement<double> both{scheme, depth};
  const SurfaceSize size = surface_size(grid, both, both);
  std::vector<SpaceQuad> quads;
  quads_evaluated_once(grid, both, both, [&](const Quad<Vector3d>& quad) {
    const auto& c = quad.corners;
    quads.push_back({{*c[0], *c[1], *c[2], *c[3]}, quads.size() / size.quads, quads.size() % size.quads});
  });
  return quads;
}

Series polygons(std::string name) { return {std::move(name), {"x", "y", "colour"}, {}}; }

void add_quads(Series& series, std::vector<SpaceQuad> quads, bool closed, const Placement& placement,
               Paint paint, unsigned colour) {
  const View& view = placement.view;
  const double volume = std::accumulate(quads.begin(), quads.end(), 0.0, [](double sum, const SpaceQuad& q) {
    return sum + middle(q).dot(normal(q));
  });
  const double outwards = volume < 0 ? -1 : 1;
  if (closed) std::erase_if(quads, [&](const SpaceQuad& q) { return outwards * view.depth(normal(q)) <= 0; });
  std::stable_sort(quads.begin(), quads.end(), [&](const SpaceQuad& a, const SpaceQuad& b) {
    return view.depth(middle(a)) < view.depth(middle(b));
  });
  for (const SpaceQuad& quad : quads) {
    const Vector3d n = normal(quad);
    constexpr double dark_square = 0.7;
    const double square = paint == Paint::chequered && (quad.along + quad.across) % 2 == 1 ? dark_square : 1;
    const double light = paint == Paint::flat ? 1 : square * lit(view, view.depth(n) < 0 ? Vector3d(-n) : n);
    const std::string shade = std::to_string(dimmed(colour, light));
    for (const Vector3d& corner : quad.corners) {
      const Vector2d p = place(placement, corner);
      series.rows.push_back({decimal(p.x(), 1), decimal(p.y(), 1), shade});
    }
    series.rows.push_back({"", "", ""});
  }
}

Curve filled(const Series& series) {
  return {series.name, "x", "y", "", "filledcurves closed fs solid noborder lc rgb variable", {"colour"}};
}

Series polylines(std::string name) { return {std::move(name), {"x", "y", "px", "py", "pz"}, {}}; }

void add_line(Series& series, const std::vector<Vector3d>& points, bool closed, const Placement& placement) {
  constexpr int digits = 6;
  for (std::size_t i = 0; i < points.size() + (closed ? 1 : 0); ++i) {
    const Vector3d& point = points[i % points.size()];
    const Vector2d p = place(placement, point);
    series.rows.push_back({decimal(p.x(), 1), decimal(p.y(), 1), decimal(point.x(), digits),
                           decimal(point.y(), digits), decimal(point.z(), digits)});
  }
  series.rows.push_back({"", "", "", "", ""});
}

Curve drawn(const Series& series, std::string label, std::string style) {
  return {series.name, "x", "y", std::move(label), std::move(style), {}};
}

FigureText caption_below(const Series& series, std::string text, double gap) {
  const Eigen::AlignedBox2d box = extent_of(series);
  return {std::move(text), box.center().x(), box.min().y() - gap};
}

FigureText caption_above(const Series& series, std::string text, double gap) {
  const Eigen::AlignedBox2d box = extent_of(series);
  return {std::move(text), box.center().x(), box.max().y() + gap};
}

Figure bare_figure(std::string name, std::string title, std::vector<Curve> curves,
                   std::vector<FigureText> texts, std::vector<std::string> claims) {
  return {std::move(name),   std::move(title), "",  "", std::move(curves), "",
          std::move(claims), std::move(texts), true};
}

}  // namespace subdiv
