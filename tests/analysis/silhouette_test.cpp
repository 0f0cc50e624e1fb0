#include "analysis/silhouette.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace subdiv {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Picture = std::vector<PictureTriangle>;

/// A regular polygon as a fan of triangles.
Picture disc(double x, double y, double radius, int sides) {
  const auto corner = [&](int i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    return Vector2d(x + radius * std::cos(angle), y + radius * std::sin(angle));
  };
  Picture picture;
  for (int i = 0; i < sides; ++i) picture.push_back({Vector2d(x, y), corner(i), corner(i + 1)});
  return picture;
}

bool covers(const Picture& picture, const Vector2d& p) {
  for (const PictureTriangle& t : picture) {
    int left = 0;
    int right = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector2d edge = t[(k + 1) % 3] - t[k];
      const Vector2d to = p - t[k];
      (edge.x() * to.y() - edge.y() * to.x() > 0 ? left : right)++;
    }
    if (left == 0 || right == 0) return true;
  }
  return false;
}

/// The second route: share of the cells of a grid of points covered by one picture alone.
double difference_by_points(const Picture& a, const Picture& b, double half, int n) {
  int count = 0;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      const Vector2d p(half * ((2 * i + 1.0) / n - 1), half * ((2 * k + 1.0) / n - 1));
      count += covers(a, p) != covers(b, p) ? 1 : 0;
    }
  }
  return count * std::pow(2 * half / n, 2);
}

TEST(Silhouette, SquaresInClosedForm) {
  const Picture unit{{Vector2d(0, 0), Vector2d(1, 0), Vector2d(1, 1)},
                     {Vector2d(0, 0), Vector2d(1, 1), Vector2d(0, 1)}};
  Picture moved = unit;
  for (auto& t : moved)
    for (auto& p : t) p += Vector2d(0.25, 0.5);
  const PictureAreas areas = compare_pictures(unit, moved, 600);
  EXPECT_NEAR(areas.first, 1, 1e-12);
  EXPECT_NEAR(areas.second, 1, 1e-12);
  EXPECT_NEAR(areas.difference, 2 - 2 * 0.75 * 0.5, 1e-12);  // the ends fall between lines
  EXPECT_EQ(compare_pictures(unit, unit, 7).difference, 0);
}

TEST(Silhouette, OverlapsCountOnce) {
  Picture twice = disc(0, 0, 1, 60);
  const Picture again = disc(0.3, 0, 0.5, 20);
  twice.insert(twice.end(), again.begin(), again.end());
  const double polygon = 30 * std::sin(2 * std::numbers::pi / 60);
  EXPECT_NEAR(compare_pictures(twice, disc(0, 0, 1, 60), 10000).first, polygon, 1e-6);
  EXPECT_NEAR(compare_pictures(twice, disc(0, 0, 1, 60), 1000).difference, 0, 1e-12);
}

TEST(Silhouette, AgreesWithAGridOfPoints) {
  const Picture a = disc(0.1, 0.2, 1, 5);
  const Picture b = disc(-0.1, 0.1, 0.9, 7);
  const double fine = compare_pictures(a, b, 4000).difference;
  EXPECT_NEAR(difference_by_points(a, b, 1.5, 1000), fine, 1e-2);  // half a cell along the outlines
  EXPECT_NEAR(compare_pictures(a, b, 500).difference, fine, 1e-4);
}

TEST(Silhouette, NothingCoversNothing) {
  EXPECT_EQ(compare_pictures({}, {}, 10).difference, 0);
  const Picture flat{{Vector2d(0, 1), Vector2d(1, 1), Vector2d(2, 1)}};
  EXPECT_EQ(compare_pictures(flat, {}, 10).first, 0);
  const Picture square = disc(0, 0, 1, 4);
  EXPECT_NEAR(compare_pictures(square, {}, 100).difference, 2, 1e-9);
  EXPECT_THROW((void)compare_pictures(square, {}, 0), std::invalid_argument);
}

TEST(Silhouette, ViewsAreOrthonormalWithZUpright) {
  const View view = view_from(Vector3d(1, -2, 1.5));
  EXPECT_NEAR(view.right.dot(view.up), 0, 1e-15);
  EXPECT_NEAR(view.right.cross(view.up).dot(view.towards), 1, 1e-15);
  EXPECT_EQ(view.right.z(), 0);
  EXPECT_GT(view.up.z(), 0);
  const View front = view_from(Vector3d(0, -1, 0));
  EXPECT_NEAR((front.project(Vector3d(2, 7, 3)) - Vector2d(2, 3)).norm(), 0, 1e-15);
  EXPECT_THROW((void)view_from(Vector3d(0, 0, 2)), std::invalid_argument);
}

TEST(Silhouette, AQuadIsTwoTriangles) {
  Picture picture;
  append_quad(picture, view_from(Vector3d(0, -1, 0)), Vector3d(0, 0, 0), Vector3d(2, 5, 0), Vector3d(2, 1, 1),
              Vector3d(0, 0, 1));
  EXPECT_EQ(picture.size(), 2U);
  EXPECT_NEAR(compare_pictures(picture, {}, 64).first, 2, 1e-12);
}

}  // namespace
}  // namespace subdiv
