#include "experiments/surface_popping.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "schemes/evaluate/geomorph.h"

namespace subdiv {

namespace {

void keep_counter_clockwise(std::vector<PictureTriangle>& picture) {
  std::erase_if(picture, [](const PictureTriangle& t) {
    const Eigen::Vector2d u = t[1] - t[0];
    const Eigen::Vector2d v = t[2] - t[0];
    return u.x() * v.y() - u.y() * v.x() <= 0;
  });
}

}  // namespace

std::vector<PictureTriangle> picture_of(const DoubleGrid& grid, const Scheme<double>& scheme, int depth,
                                        const View& view) {
  std::vector<PictureTriangle> picture;
  const Refinement<double> both{scheme, depth};
  quads_evaluated_once(grid, both, both, [&](const Quad<Eigen::Vector3d>& quad) {
    const auto& c = quad.corners;
    append_quad(picture, view, *c[0], *c[1], *c[2], *c[3]);
  });
  keep_counter_clockwise(picture);
  return picture;
}

std::vector<PictureTriangle> picture_of_geomorph(const DoubleGrid& grid, const Scheme<double>& scheme,
                                                 int depth, double t, const View& view) {
  const Refinement<double> both{scheme, depth};
  const SurfaceSize size = surface_size(grid, both, both);
  std::vector<Eigen::Vector3d> vertices;
  stream_geomorph(grid, both, both, t, [&](const Eigen::Vector3d& p) { vertices.push_back(p); });
  std::vector<PictureTriangle> picture;
  for (std::size_t i = 0; i < size.strips; ++i) {
    for (std::size_t v = 0; v < size.quads; ++v) {
      const auto c = size.corners(i, v);
      append_quad(picture, view, vertices[c[0]], vertices[c[1]], vertices[c[2]], vertices[c[3]]);
    }
  }
  keep_counter_clockwise(picture);
  return picture;
}

double largest_change(const DoubleGrid& grid, const Scheme<double>& scheme, int depth, int pictures,
                      const View& view, int lines) {
  std::vector<PictureTriangle> last = picture_of_geomorph(grid, scheme, depth, 0, view);
  const double whole = compare_pictures(last, {}, lines).first;
  double largest = 0;
  for (int f = 1; f <= pictures; ++f) {
    std::vector<PictureTriangle> next =
        picture_of_geomorph(grid, scheme, depth, static_cast<double>(f) / pictures, view);
    largest = std::max(largest, compare_pictures(last, next, lines).difference);
    last = std::move(next);
  }
  return largest / whole;
}

double silhouette_disparity(const DoubleGrid& grid, const Scheme<double>& scheme, int depth, const View& view,
                            int lines) {
  const PictureAreas areas = compare_pictures(picture_of(grid, scheme, depth - 1, view),
                                              picture_of(grid, scheme, depth, view), lines);
  return areas.difference / areas.first;
}

std::vector<ViewedGrid> rough_tori(std::uint64_t seed, int count) {
  constexpr int fewest = 4;
  constexpr int most = 7;
  constexpr double around = 20;
  constexpr double tube = 8;
  constexpr int move = 3;
  constexpr int far = 9;
  std::mt19937_64 random(seed);
  const auto draw = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<std::uint64_t>(high - low + 1));
  };
  std::vector<ViewedGrid> result;
  for (int g = 0; g < count; ++g) {
    const int rows = draw(fewest, most);
    const int columns = draw(fewest, most);
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < rows; ++i) {
      for (int j = 0; j < columns; ++j) {
        const double u = 2 * std::numbers::pi * i / rows;
        const double v = 2 * std::numbers::pi * j / columns;
        const double radius = around + tube * std::cos(u);
        Eigen::Vector3d p(std::round(radius * std::cos(v)), std::round(radius * std::sin(v)),
                          std::round(tube * std::sin(u)));
        for (int k = 0; k < 3; ++k) p[k] += draw(-move, move);
        points.push_back(p);
      }
    }
    Eigen::Vector3d direction(0, 0, 0);
    while (direction.x() == 0 && direction.y() == 0) {
      for (int k = 0; k < 3; ++k) direction[k] = draw(-far, far);
    }
    const Topology closed_rows{static_cast<std::size_t>(rows), true, 0, 0};
    const Topology closed_columns{static_cast<std::size_t>(columns), true, 0, 0};
    result.push_back({control_grid(closed_rows, closed_columns, std::move(points)), direction});
  }
  return result;
}

}  // namespace subdiv
