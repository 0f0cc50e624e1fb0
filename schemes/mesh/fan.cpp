#include "schemes/mesh/fan.h"

#include <algorithm>
#include <cstddef>

#include "schemes/mesh/straight_walk.h"

namespace subdiv {
namespace {

constexpr int regular_quads = 4;
constexpr int regular_triangles = 6;

int ring_of(int sides, int a, int b) { return sides == 4 ? std::max(a, b) : a + b; }

/// Number of a place, at which the centre may stand as (0, 0) and a spoke of the next sector as (0, b).
class FanNumbers {
 public:
  FanNumbers(int sides, int valence, int rings) : sides_(sides), valence_(valence), rings_(rings) {
    places_ = sector_places(sides, rings);
    const auto side = static_cast<std::size_t>(rings) + 1;
    index_.assign(side * side, -1);
    for (std::size_t p = 0; p < places_.size(); ++p)
      index_[slot(places_[p].a, places_[p].b)] = static_cast<int>(p);
  }
  [[nodiscard]] int number(int sector, int a, int b) const {
    if (a == 0 && b == 0) return 0;
    if (a == 0) return number((sector + 1) % valence_, b, 0);
    return 1 + sector * static_cast<int>(places_.size()) + index_[slot(a, b)];
  }
  [[nodiscard]] int count() const { return 1 + valence_ * static_cast<int>(places_.size()); }
  [[nodiscard]] bool contains(int a, int b) const { return ring_of(sides_, a, b) <= rings_; }
  [[nodiscard]] const std::vector<FanPlace>& places() const { return places_; }

 private:
  [[nodiscard]] std::size_t slot(int a, int b) const {
    return static_cast<std::size_t>(a) * (static_cast<std::size_t>(rings_) + 1) + static_cast<std::size_t>(b);
  }
  int sides_;
  int valence_;
  int rings_;
  std::vector<FanPlace> places_;
  std::vector<int> index_;
};

}  // namespace

std::vector<FanPlace> sector_places(int sides, int rings) {
  std::vector<FanPlace> places;
  for (int ring = 1; ring <= rings; ++ring) {
    for (int b = 0; b <= rings; ++b) {  // up the outer side, then back along the top
      if (sides == 4 ? b <= ring : b < ring) places.push_back({0, sides == 4 ? ring : ring - b, b});
    }
    if (sides == 4) {
      for (int a = ring - 1; a >= 1; --a) places.push_back({0, a, ring});
    }
  }
  return places;
}

MeshTopology fan_topology(int sides, int valence, int rings) {
  const FanNumbers numbers(sides, valence, rings);
  PolygonFaces faces;
  faces.vertices = static_cast<std::size_t>(numbers.count());
  const auto add = [&](int sector, std::initializer_list<std::pair<int, int>> corners) {
    std::vector<long long> face;
    for (const auto& [a, b] : corners) {
      if (!numbers.contains(a, b)) return;
      face.push_back(numbers.number(sector, a, b));
    }
    faces.add_face(face);
  };
  for (int sector = 0; sector < valence; ++sector) {
    for (int a = 0; a < rings; ++a) {
      for (int b = 0; b < rings; ++b) {
        if (sides == 4) {
          add(sector, {{a, b}, {a + 1, b}, {a + 1, b + 1}, {a, b + 1}});
        } else {
          add(sector, {{a, b}, {a + 1, b}, {a, b + 1}});
          add(sector, {{a + 1, b}, {a + 1, b + 1}, {a, b + 1}});
        }
      }
    }
  }
  return MeshTopology(faces);
}

std::optional<std::vector<int>> fan_vertices(const MeshTopology& mesh, int spoke, int rings) {
  const int sides = mesh.sides();
  const int centre = mesh.origin(spoke);
  if ((sides != 3 && sides != 4) || mesh.is_border(centre)) return std::nullopt;
  const int regular = sides == 4 ? regular_quads : regular_triangles;
  const FanNumbers numbers(sides, mesh.valence(centre), rings);
  std::vector<int> result(static_cast<std::size_t>(numbers.count()), -1);
  bool regular_so_far = true;
  const auto set = [&](int sector, int a, int b, int vertex) {
    int& place = result[static_cast<std::size_t>(numbers.number(sector, a, b))];
    if (place < 0) place = vertex;
    const bool inner = ring_of(sides, a, b) < rings && (a > 0 || b > 0);
    if (place != vertex || (inner && (mesh.is_border(vertex) || mesh.valence(vertex) != regular)))
      regular_so_far = false;
  };
  const auto has_cell = [&](int a, int b) {
    return numbers.contains(a + 1, b) && numbers.contains(a, b + 1);
  };

  int first = spoke;
  for (int sector = 0; sector < mesh.valence(centre); ++sector, first = mesh.turn_left(first)) {
    int left = first;
    for (int b = 0; has_cell(0, b); ++b, left = cell_above(mesh, left)) {
      if (left < 0) return std::nullopt;
      int h = left;  // from (a, b) to (a + 1, b)
      for (int a = 0; has_cell(a, b); ++a, h = cell_to_the_right(mesh, h)) {
        if (h < 0) return std::nullopt;
        set(sector, a, b, mesh.origin(h));
        set(sector, a + 1, b, mesh.target(h));
        if (sides == 4) set(sector, a + 1, b + 1, mesh.target(mesh.next(h)));
        set(sector, a, b + 1, mesh.origin(mesh.previous(h)));
        if (!regular_so_far) return std::nullopt;
      }
    }
  }
  return result;
}

}  // namespace subdiv
