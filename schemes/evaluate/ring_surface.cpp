#include "schemes/evaluate/ring_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "schemes/adjustable_speed/limit_point.h"
#include "schemes/evaluate/nested_rings.h"
#include "schemes/input_error.h"
#include "schemes/mesh/fan.h"

namespace subdiv {
namespace {

constexpr int regular_valence = 4;
constexpr int least_valence = 3;
constexpr std::size_t patches_of_sector = 3;  // corner, next_side, first_side

bool is_extraordinary(const MeshTopology& mesh, int v) {
  return mesh.outgoing(v) >= 0 && !mesh.is_border(v) && mesh.valence(v) != regular_valence;
}

/// Faults that steps do not mend.
std::optional<RingFault> lasting_fault(const MeshTopology& mesh, int v) {
  if (mesh.outgoing(v) < 0) return std::nullopt;  // no faces, no surface
  if (mesh.is_border(v) && mesh.face_count(v) > 2) {
    return RingFault{v,
                     fmt::format("vertex {} is extraordinary at the border: {} faces meet there", v + 1,
                                 mesh.face_count(v)),
                     false,
                     "a border vertex has 2 faces, or 1 at a corner; no Catmull-Clark step changes that"};
  }
  if (!mesh.is_border(v) && mesh.valence(v) < least_valence) {
    return RingFault{v, fmt::format("vertex {} has valence {}", v + 1, mesh.valence(v)), false,
                     "rings need valence 3 or more; join the faces there"};
  }
  return std::nullopt;
}

std::string partner(const MeshTopology& mesh, int v) {
  if (mesh.is_border(v)) return fmt::format("vertex {} of the border", v + 1);
  return fmt::format("vertex {} of valence {}", v + 1, mesh.valence(v));
}

/// Does a face around v have another corner that is extraordinary or at the border?
std::optional<RingFault> crowded(const MeshTopology& mesh, int v) {
  std::optional<RingFault> fault;
  for_each_outgoing(mesh, v, [&](int spoke) {
    for (int h = mesh.next(spoke); h != spoke && !fault; h = mesh.next(h)) {
      const int other = mesh.origin(h);
      if (!mesh.is_border(other) && !is_extraordinary(mesh, other)) continue;
      fault = RingFault{v,
                        fmt::format("vertex {} of valence {} shares face {} with {}", v + 1, mesh.valence(v),
                                    mesh.face(h) + 1, partner(mesh, other)),
                        true, "a Catmull-Clark step puts two edges between them"};
    }
  });
  return fault;
}

Point3 mean(const Point3& a, const Point3& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

double distance(const Point3& a, const Point3& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double greatest_difference(const std::vector<Point3>& points, const Point3& from) {
  double result = 0;
  for (const Point3& p : points) {
    for (std::size_t d = 0; d < p.size(); ++d) result = std::max(result, std::abs(p[d] - from[d]));
  }
  return result;
}

/// Sums stay finite: those of patches, and those of rings that keep their digits.
void require_range(const MeshTopology& mesh, const std::vector<Point3>& points) {
  constexpr double most = 1e290;
  for (int v = 0; v < mesh.vertices(); ++v) {
    for (const double x : points[static_cast<std::size_t>(v)]) {
      if (mesh.outgoing(v) < 0 || std::abs(x) <= most) continue;
      throw InputError(
          fmt::format("vertex {}: coordinate {:.1e}: surfaces need coordinates up to {:.0e}; scale the mesh "
                      "down",
                      v + 1, x, most));
    }
  }
}

/// The Bezier points of the uniform bicubic spline, each made once: those inside a face belong to its
/// corners, those of an edge to its ends. Meaningful where the corners at hand are regular.
class UniformPatches {
 public:
  UniformPatches(const MeshTopology& mesh, const std::vector<Point3>& points)
      : mesh_(mesh),
        inner_(static_cast<std::size_t>(mesh.half_edges())),
        on_edge_(inner_.size()),
        after_(inner_.size()),
        at_vertex_(points.size()) {
    for (int h = 0; h < mesh.half_edges(); ++h) make_inner(h, points);
    for (int h = 0; h < mesh.half_edges(); ++h) make_edge(h, points);
    for (int v = 0; v < mesh.vertices(); ++v) make_vertex(v, points);
  }

  /// b_(0, 0) at the origin of `corner`, i along it.
  [[nodiscard]] BezierPatch<Point3> patch(int corner) const {
    const int right = mesh_.next(corner);
    const int far = mesh_.next(right);
    const int left = mesh_.next(far);
    const auto v = [&](int h) { return at_vertex_[static_cast<std::size_t>(mesh_.origin(h))]; };
    const auto e = [&](int h) { return on_edge_[static_cast<std::size_t>(h)]; };
    const auto a = [&](int h) { return after_[static_cast<std::size_t>(h)]; };
    const auto f = [&](int h) { return inner_[static_cast<std::size_t>(h)]; };
    return {v(corner), a(left),   e(left),  v(left),  //
            e(corner), f(corner), f(left),  a(far),   //
            a(corner), f(right),  f(far),   e(far),   //
            v(right),  e(right),  a(right), v(far)};
  }

 private:
  void make_inner(int h, const std::vector<Point3>& points) {
    const auto at = [&](int k) { return points[static_cast<std::size_t>(mesh_.origin(k))]; };
    const Point3 v = at(h);
    const Point3 right = at(mesh_.next(h));
    const Point3 far = at(mesh_.next(mesh_.next(h)));
    const Point3 left = at(mesh_.previous(h));
    for (std::size_t d = 0; d < v.size(); ++d)
      inner_[static_cast<std::size_t>(h)][d] = (4 * v[d] + 2 * (right[d] + left[d]) + far[d]) / 9;
  }
  /// The points of the edge of h, from the side that numbers the edge.
  void make_edge(int h, const std::vector<Point3>& points) {
    const auto slot = static_cast<std::size_t>(h);
    const auto next = static_cast<std::size_t>(mesh_.next(h));
    const int o = mesh_.opposite(h);
    if (o < 0) {  // the border is the cubic spline of its vertices
      const Point3& p = points[static_cast<std::size_t>(mesh_.origin(h))];
      const Point3& q = points[static_cast<std::size_t>(mesh_.target(h))];
      for (std::size_t d = 0; d < p.size(); ++d) {
        on_edge_[slot][d] = (2 * p[d] + q[d]) / 3;
        after_[slot][d] = (p[d] + 2 * q[d]) / 3;
      }
      return;
    }
    if (mesh_.half_edge(mesh_.edge(h)) != h) return;
    const auto across = static_cast<std::size_t>(o);
    on_edge_[slot] = mean(inner_[slot], inner_[static_cast<std::size_t>(mesh_.next(o))]);
    after_[slot] = mean(inner_[next], inner_[across]);
    on_edge_[across] = after_[slot];
    after_[across] = on_edge_[slot];
  }
  void make_vertex(int v, const std::vector<Point3>& points) {
    Point3& result = at_vertex_[static_cast<std::size_t>(v)];
    result = points[static_cast<std::size_t>(v)];
    if (mesh_.outgoing(v) < 0 || mesh_.face_count(v) == 1) return;
    if (mesh_.is_border(v)) {
      const int out = mesh_.outgoing(v);
      int last = out;  // the last half-edge that leaves v; the one before it comes in along the border
      while (mesh_.turn_left(last) >= 0) last = mesh_.turn_left(last);
      result = mean(on_edge_[static_cast<std::size_t>(out)],
                    after_[static_cast<std::size_t>(mesh_.previous(last))]);
      return;
    }
    Point3 sum{};
    for_each_outgoing(mesh_, v, [&](int h) {
      for (std::size_t d = 0; d < sum.size(); ++d) sum[d] += inner_[static_cast<std::size_t>(h)][d];
    });
    for (std::size_t d = 0; d < sum.size(); ++d) result[d] = sum[d] / mesh_.valence(v);
  }

  const MeshTopology& mesh_;
  std::vector<Point3> inner_;    // of each half-edge: next to its origin, inside its face
  std::vector<Point3> on_edge_;  // on it, next to its origin
  std::vector<Point3> after_;    // on it, next to its target
  std::vector<Point3> at_vertex_;
};

/// Makes the rings vertex by vertex; weights and bounds are made once a valence.
class RingMaker {
 public:
  RingMaker(const MeshTopology& mesh, const std::vector<Point3>& points, const SpeedSchedule& schedule,
            const UniformPatches& uniform)
      : mesh_(mesh), points_(points), schedule_(schedule), uniform_(uniform) {}

  /// Writes the patches of this vertex into the groups, sector after sector from `sector` on.
  void add(int vertex, std::size_t sector, RingSurface& surface) {
    const int spoke = mesh_.outgoing(vertex);
    const std::optional<std::vector<int>> around = fan_vertices(mesh_, spoke, 2);
    if (!around) throw InputError(fmt::format("vertex {}: its two rings are not complete", vertex + 1));
    std::vector<Point3> net;
    for (const int v : *around) net.push_back(points_[static_cast<std::size_t>(v)]);
    const double greatest = greatest_difference(net, Point3{});
    const double width = greatest_difference(net, net.front());
    const int n = mesh_.valence(vertex);
    const SectorNet<Point3> sectors(n, std::move(net));
    const Point3 limit = vertex_point(sectors, uniform_limit_weights<double>(n));
    std::vector<BezierPatch<Point3>> first;  // as the faces around see the n faces
    for_each_outgoing(mesh_, vertex,
                      [&](int h) { first.push_back(uniform_.patch(mesh_.next(mesh_.next(h)))); });
    NestedRings<Point3> rings;
    if (schedule_.size() > 0) {
      const auto& weights = of_valence(n).weights;
      rings = nested_rings<Point3, double>(
          sectors, schedule_.steps(), [&](std::size_t k) { return weights[k]; }, first);
    } else {
      rings.hole = first;
    }
    const RingHole hole{vertex, n, size(first, limit), size(rings.hole, limit)};
    if (schedule_.size() > 0) {
      const RoundingBound& bound = of_valence(n).rounding;
      require_digits(hole, bound, greatest, width);
      surface.rounding = std::max(surface.rounding, bound.of(greatest));
    }
    surface.holes.push_back(hole);
    for (std::size_t k = 0; k < rings.rings.size(); ++k) {
      std::size_t place = surface.begin[k + 1] + patches_of_sector * sector;
      for (const RingSector<Point3>& own : rings.rings[k]) {
        for (const auto* patch : {&own.corner, &own.next_side, &own.first_side})
          surface.patches[place++] = *patch;
      }
    }
    std::size_t place = surface.begin[schedule_.size() + 1] + sector;
    if (place >= surface.patches.size()) return;  // holes stay open
    for (BezierPatch<Point3>& patch : rings.hole) {
      patch[15] = limit;
      surface.patches[place++] = patch;
    }
  }

 private:
  struct OfValence {
    std::vector<VertexWeights<double>> weights;
    RoundingBound rounding;
  };
  const OfValence& of_valence(int n) {
    const auto found = of_valence_.find(n);
    if (found != of_valence_.end()) return found->second;
    return of_valence_.emplace(n, OfValence{schedule_.weights(n), schedule_.rounding(n)}).first->second;
  }
  static double size(const std::vector<BezierPatch<Point3>>& borders, const Point3& limit) {
    double result = 0;
    for (const BezierPatch<Point3>& b : borders)
      result = std::max({result, distance(b[0], limit), distance(b[3], limit)});
    return result;
  }
  /// Of the net, whose coordinates are up to `greatest` and up to `width` from the vertex's.
  void require_digits(const RingHole& hole, const RoundingBound& bound, double greatest, double width) const {
    constexpr double digits = 1e-3;
    const double least = std::min(hole.size, schedule_.least_width() * hole.first_size);
    const double rounding = bound.of(greatest);
    if (rounding <= digits * least || hole.first_size == 0) return;
    std::string remedy = "take fewer steps or speeds farther from 0 and 1";
    if (bound.relative * greatest <= digits * least) {
      remedy = fmt::format(
          "coordinates, up to {:.1e}, are so near the least positive number that digits are lost; scale the "
          "mesh up",
          greatest);
    } else if (bound.relative * width <= digits * least) {
      remedy = fmt::format(
          "coordinates are up to {:.1e}, but the faces around reach only {:.1e} from the vertex; move the "
          "mesh to the origin",
          greatest, width);
    }
    throw InputError(
        fmt::format("vertex {}: after these speeds the narrowest ring, or the hole, is {:.1e} wide, and "
                    "coordinates may be off by {:.1e}: fewer than three digits are left; {}",
                    hole.vertex + 1, least, rounding, remedy));
  }

  const MeshTopology& mesh_;
  const std::vector<Point3>& points_;
  const SpeedSchedule& schedule_;
  const UniformPatches& uniform_;
  std::map<int, OfValence> of_valence_;
};

/// The joint of a regular patch across h, the half-edge of a face in rings; `along` when its inner edges run
/// as h does.
std::optional<RingJoint> outer_joint(const MeshTopology& mesh, int h, bool along,
                                     const std::vector<int>& patch_of_face) {
  const int o = mesh.opposite(h);
  if (o < 0) return std::nullopt;
  const int patch = patch_of_face[static_cast<std::size_t>(mesh.face(o))];
  if (patch < 0) return std::nullopt;
  RingJoint joint;
  joint.outer = static_cast<std::size_t>(patch);
  constexpr std::array edges{PatchEdge::first_j, PatchEdge::last_i, PatchEdge::last_j, PatchEdge::first_i};
  const auto side = static_cast<std::size_t>(o - mesh.first(mesh.face(o)));
  joint.outer_edge = edges.at(side);
  const bool ascends = side < 2;  // as o runs
  joint.reversed = ascends == along;
  return joint;
}

/// Between the regular faces and the first ring, and between one ring and the next.
void add_joints(RingSurface& surface, const MeshTopology& mesh, const SpeedSchedule& schedule,
                const std::vector<int>& patch_of_face) {
  const auto add = [&](RingJoint joint, std::size_t corner, bool first_side, double sigma) {
    joint.inner = {corner, corner + (first_side ? 2U : 1U)};
    joint.inner_edge = first_side ? PatchEdge::first_i : PatchEdge::first_j;
    joint.split = joint.reversed ? 1 - sigma : sigma;
    if (joint.reversed) std::swap(joint.inner[0], joint.inner[1]);
    surface.joints.push_back(joint);
  };
  std::size_t sector = 0;  // of all rings around all vertices
  for (const RingHole& hole : surface.holes) {
    for_each_outgoing(mesh, hole.vertex, [&](int spoke) {
      const std::size_t place = patches_of_sector * sector++;
      for (std::size_t k = 0; k < schedule.size(); ++k) {
        const double sigma = schedule.steps()[k].rules.sigma;
        const std::size_t corner = surface.begin[k + 1] + place;
        for (const bool first_side : {true, false}) {
          if (k > 0) {
            const std::size_t outside = surface.begin[k] + place + (first_side ? 2U : 1U);
            add({outside, first_side ? PatchEdge::last_i : PatchEdge::last_j}, corner, first_side, sigma);
            continue;
          }
          // The half-edge into the far corner of the face, and the one out of it.
          const int into = mesh.next(spoke);
          const std::optional<RingJoint> joint =
              first_side ? outer_joint(mesh, into, false, patch_of_face)
                         : outer_joint(mesh, mesh.next(into), true, patch_of_face);
          if (joint) add(*joint, corner, first_side, sigma);
        }
      }
    });
  }
}

}  // namespace

std::optional<RingFault> find_ring_fault(const MeshTopology& mesh) {
  for (int v = 0; v < mesh.vertices(); ++v) {
    if (std::optional<RingFault> fault = lasting_fault(mesh, v)) return fault;
  }
  for (int f = 0; f < mesh.faces(); ++f) {
    if (mesh.degree(f) == regular_valence) continue;
    const int v = mesh.origin(mesh.first(f));
    return RingFault{v, fmt::format("face {} at vertex {} has {} corners", f + 1, v + 1, mesh.degree(f)),
                     true, "rings are for quads; a Catmull-Clark step makes quads of all faces"};
  }
  for (int v = 0; v < mesh.vertices(); ++v) {
    if (!is_extraordinary(mesh, v)) continue;
    if (std::optional<RingFault> fault = crowded(mesh, v)) return fault;
  }
  return std::nullopt;
}

RingSurface ring_surface(const MeshTopology& mesh, const std::vector<Point3>& points,
                         const SpeedSchedule& schedule, const RingSurfaceOptions& options) {
  if (const std::optional<RingFault> fault = find_ring_fault(mesh))
    throw InputError(fault->what + ": " + fault->remedy);
  require_range(mesh, points);
  // Which faces are in rings, and how many sectors there are.
  std::vector<bool> in_rings(static_cast<std::size_t>(mesh.faces()), false);
  std::vector<int> extraordinary;
  std::size_t sectors = 0;
  for (int v = 0; v < mesh.vertices(); ++v) {
    if (!is_extraordinary(mesh, v)) continue;
    extraordinary.push_back(v);
    for_each_outgoing(mesh, v, [&](int h) {
      in_rings[static_cast<std::size_t>(mesh.face(h))] = true;
      ++sectors;
    });
  }
  RingSurface surface;
  surface.begin.push_back(options.regular_faces ? in_rings.size() - sectors : 0);
  for (std::size_t k = 0; k < schedule.size(); ++k)
    surface.begin.push_back(surface.begin.back() + patches_of_sector * sectors);
  surface.begin.push_back(surface.begin.back() + (options.fill ? sectors : 0));
  surface.patches.resize(surface.begin.back());

  const UniformPatches uniform(mesh, points);
  std::vector<int> patch_of_face(in_rings.size(), -1);
  int patch = 0;
  for (int f = 0; options.regular_faces && f < mesh.faces(); ++f) {
    if (in_rings[static_cast<std::size_t>(f)]) continue;
    surface.patches[static_cast<std::size_t>(patch)] = uniform.patch(mesh.first(f));
    patch_of_face[static_cast<std::size_t>(f)] = patch++;
  }
  RingMaker maker(mesh, points, schedule, uniform);
  std::size_t sector = 0;
  for (const int v : extraordinary) {
    maker.add(v, sector, surface);
    sector += static_cast<std::size_t>(mesh.valence(v));
  }
  add_joints(surface, mesh, schedule, patch_of_face);
  return surface;
}

}  // namespace subdiv
