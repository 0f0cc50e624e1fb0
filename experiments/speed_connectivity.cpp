#include "experiments/speed_connectivity.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>

#include "schemes/adjustable_speed/sector_net.h"
#include "schemes/mesh/catmull_clark.h"
#include "schemes/mesh/fan.h"

namespace subdiv {
namespace {

constexpr int refined_rings = 3;

/// The three rings of the split net in the order of fan_topology.
std::vector<int> split_places(const MeshTopology& net, const MeshTopology& split) {
  std::vector<int> result;
  for_each_outgoing(net, 0, [&](int h) {
    if (net.target(h) != 1) return;  // the first spoke of sector 0
    const int edge_point = net.vertices() + net.edge(h);
    for_each_outgoing(split, 0, [&](int spoke) {
      if (split.target(spoke) == edge_point)
        result = fan_vertices(split, spoke, refined_rings).value_or(std::vector<int>{});
    });
  });
  return result;
}

/// Whether the faces among these vertices are those of the fan that they number.
bool is_fan_within(const MeshTopology& split, const std::vector<int>& around) {
  std::map<int, int> place;
  for (std::size_t k = 0; k < around.size(); ++k) place.emplace(around[k], static_cast<int>(k));
  const MeshTopology fan = fan_topology(4, split.valence(0), refined_rings);
  if (place.size() != static_cast<std::size_t>(fan.vertices())) return false;
  const auto faces = [](const MeshTopology& mesh, const auto& number) {
    std::set<std::array<int, 4>> result;
    for (int f = 0; f < mesh.faces(); ++f) {
      std::array<int, 4> corners{};
      for (int c = 0; c < 4; ++c)
        corners.at(static_cast<std::size_t>(c)) = number(mesh.origin(mesh.first(f) + c));
      if (std::ranges::min(corners) < 0) continue;
      std::ranges::rotate(corners, std::ranges::min_element(corners));
      result.insert(corners);
    }
    return result;
  };
  return faces(fan, [](int v) { return v; }) == faces(split, [&](int v) {
           const auto found = place.find(v);
           return found == place.end() ? -1 : found->second;
         });
}

/// The control points that the new point of this number in the split net reads.
std::set<int> read_by_catmull_clark(const MeshTopology& net, int point) {
  const MeshScheme<Rational> scheme = catmull_clark<Rational>();
  const int edge = point - net.vertices();
  const Stencil<Rational> stencil = edge < 0             ? scheme.vertex_rule(net, point)
                                    : edge < net.edges() ? scheme.edge_rule(net, net.half_edge(edge))
                                                         : scheme.face_rule(net, edge - net.edges());
  std::set<int> result;
  for (const auto& [vertex, weight] : stencil.terms()) {
    if (weight.sign() != 0) result.insert(vertex);
  }
  return result;
}

std::set<int> reads(const SectorStencil<RationalFunction>& rule, int valence, int sector) {
  std::set<int> result;
  if (!rule.centre.is_zero()) result.insert(0);
  constexpr int places = static_cast<int>(SectorNet<RationalFunction>::places);
  for (const auto& term : rule.terms)
    result.insert(1 + (sector + term.sector + valence) % valence * places + term.place);
  return result;
}

/// The vertex's own rule: itself, its edge neighbours and the (1, 1).
std::set<int> vertex_reads(int valence) {
  std::set<int> result{0};
  constexpr int places = static_cast<int>(SectorNet<RationalFunction>::places);
  for (int sector = 0; sector < valence; ++sector) {
    result.insert(1 + sector * places + sector_place(1, 0).place);
    result.insert(1 + sector * places + sector_place(1, 1).place);
  }
  return result;
}

}  // namespace

bool mimics_catmull_clark(int valence, const std::vector<SectorStencil<RationalFunction>>& rules) {
  const MeshTopology net = fan_topology(4, valence, 2);
  const MeshTopology split = split_into_quads(net);
  const std::vector<int> around = split_places(net, split);
  if (!is_fan_within(split, around)) return false;
  const std::vector<FanPlace> places = sector_places(4, refined_rings);
  bool same = read_by_catmull_clark(net, 0) == vertex_reads(valence);
  auto point = around.begin();  // past the vertex: sector by sector, place by place
  for (int sector = 0; sector < valence; ++sector) {
    for (std::size_t p = 0; p < places.size(); ++p) {
      const int number = *++point;
      const int odd = places[p].a % 2 + places[p].b % 2;  // 0 at vertices, 1 on edges, 2 in faces
      const int kind = number < net.vertices() ? 0 : number < net.vertices() + net.edges() ? 1 : 2;
      same = same && kind == odd &&
             std::ranges::includes(read_by_catmull_clark(net, number), reads(rules[p], valence, sector));
    }
  }
  return same;
}

}  // namespace subdiv
