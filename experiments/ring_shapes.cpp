#include "experiments/ring_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <Eigen/Geometry>

#include "schemes/evaluate/bezier_patch.h"
#include "schemes/mesh/fan.h"

namespace subdiv {
namespace {

using Eigen::Vector3d;

Vector3d vector_of(const Point3& p) { return {p[0], p[1], p[2]}; }

double mean_curvature(const BezierPatch<Point3>& patch, double u, double v) {
  const PatchJet jet = patch_jet(patch, u, v);
  const Vector3d du = vector_of(jet.u);
  const Vector3d dv = vector_of(jet.v);
  const Vector3d normal = du.cross(dv).normalized();
  const double e = du.dot(du);
  const double f = du.dot(dv);
  const double g = dv.dot(dv);
  return (e * vector_of(jet.vv).dot(normal) - 2 * f * vector_of(jet.uv).dot(normal) +
          g * vector_of(jet.uu).dot(normal)) /
         (2 * (e * g - f * f));
}

}  // namespace

RingSurface RingModel::surface(const std::vector<Rational>& speeds, bool fill) const {
  return ring_surface(mesh, points, SpeedSchedule(std::vector<Algebraic>(speeds.begin(), speeds.end())),
                      {.regular_faces = true, .fill = fill});
}

std::vector<RingModel> convex_nets(unsigned seed, int count) {
  constexpr std::array valences{3, 5, 6, 7, 8};
  constexpr int rings = 3;
  constexpr double scale = 100;
  constexpr double thousandth = 1e-3;
  std::mt19937 random(seed);
  const auto draw = [&] { return static_cast<double>(random() % 101U); };
  const std::vector<FanPlace> places = sector_places(4, rings);
  std::vector<RingModel> result;
  for (int i = 0; i < count; ++i) {
    const int n = valences[static_cast<std::size_t>(i) % valences.size()];
    const double xx = 50 + draw();
    const double yy = 50 + draw();
    const double xy = (draw() - 50) / 2;
    RingModel model{fan_topology(4, n, rings), {{0, 0, 0}}};
    for (int k = 0; k < n; ++k) {
      const double first = 2 * std::numbers::pi * k / n;
      const double next = 2 * std::numbers::pi * (k + 1) / n;
      for (const FanPlace& p : places) {
        const double x = p.a * std::cos(first) + p.b * std::cos(next);
        const double y = p.a * std::sin(first) + p.b * std::sin(next);
        const double z = -(xx * x * x + 2 * xy * x * y + yy * y * y) * thousandth;
        model.points.push_back({std::round(scale * x), std::round(scale * y), std::round(scale * z)});
      }
    }
    result.push_back(std::move(model));
  }
  return result;
}

double curvature_spread(const RingSurface& surface) {
  constexpr int steps = 8;
  double least = std::numeric_limits<double>::infinity();
  double greatest = -least;
  const std::size_t caps = surface.groups() - 1;
  for (std::size_t p = surface.begin[1]; p < surface.begin[caps]; ++p) {
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; j <= steps; ++j) {
        const double h = mean_curvature(surface.patches[p], static_cast<double>(i) / steps,
                                        static_cast<double>(j) / steps);
        least = std::min(least, h);
        greatest = std::max(greatest, h);
      }
    }
  }
  return (greatest - least) * surface.holes.front().first_size;
}

Vector3d patch_normal(const BezierPatch<Point3>& patch, double u, double v) {
  const PatchJet jet = patch_jet(patch, u, v);
  return vector_of(jet.u).cross(vector_of(jet.v)).normalized();
}

double cap_fault(const RingSurface& surface) {
  constexpr int steps = 32;
  const std::size_t first = surface.begin[surface.groups() - 1];
  const std::size_t count = surface.patches.size() - first;
  double worst = 0;
  for (std::size_t sector = 0; sector < count; ++sector) {
    const BezierPatch<Point3>& own = surface.patches[first + sector];
    const BezierPatch<Point3>& next = surface.patches[first + (sector + 1) % count];
    for (int i = 0; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      const Vector3d a = patch_normal(own, 1, t);
      const Vector3d b = patch_normal(next, t, 1);
      worst = std::max(worst, std::atan2(a.cross(b).norm(), a.dot(b)));
    }
  }
  return worst * 180 / std::numbers::pi;
}

}  // namespace subdiv
