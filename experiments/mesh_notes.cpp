#include <array>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "analysis/mesh/exact_condition.h"
#include "analysis/mesh/mode_equation.h"
#include "analysis/mesh/spectral_condition.h"
#include "analysis/reif.h"
#include "experiments/lecture_note_parts.h"
#include "schemes/bspline.h"
#include "schemes/four_point.h"
#include "schemes/mesh/butterfly.h"
#include "schemes/mesh/fan.h"
#include "schemes/mesh/loop.h"

namespace subdiv::notes {
namespace {

const std::array table{
    ClaimHead{
        "notes.loop.local", "notes", "4, figure 7",
        "based on the immeditely neighboring points before subdivision", ClaimKind::exact,
        "Which points Loop's rules combine, at valences 3 .. 40: of an edge its two ends and the corners "
        "of its two triangles, of a vertex itself and the ends of its edges; their weights are positive "
        "and have the sum 1."},
    ClaimHead{
        "notes.loop.manifold.edges", "notes", "4", "each edge has exactly two incident trialgles",
        ClaimKind::exact,
        "In a closed fan mesh, the octahedron, every edge belongs to two triangles; three triangles that "
        "share an edge are refused as a mesh, at that edge."},
    ClaimHead{
        "notes.loop.manifold.fan", "notes", "4",
        "each vertex needs to have a closed fan of triangles around it", ClaimKind::exact,
        "Whether this has to be asked beside two triangles an edge: two tetrahedra that share a vertex."},
    ClaimHead{
        "notes.loop.manifold.boundary", "notes", "4",
        "A manifold mesh as described above cannot have boundary", ClaimKind::exact,
        "An edge of the boundary belongs to one triangle, not to two: the octahedron without one of its "
        "triangles has 3 such edges, and at their ends fans that are not closed."},
    ClaimHead{"notes.loop.manifold.necessary", "notes", "4",
              "In order for the computation to be possible, we need a manifold mesh", ClaimKind::exact,
              "Whether Loop's scheme is possible on the octahedron without one of its triangles."},
    ClaimHead{
        "notes.loop.manifold.solid", "notes", "4",
        "it is possible to obtain a nice manifold triangulation of a surface of any 3D solid",
        ClaimKind::exact,
        "Whether the surface of two cubes that share one edge, and nothing else, has such a triangulation: "
        "along that edge four sheets of the surface meet, so that any triangulation of it has edges with "
        "four triangles there. Checked with two triangles for each square."},
    ClaimHead{"notes.loop.valence-3.better", "notes", "4",
              "For vertices of degree 3, weights of 7/16 for the central vertex and 3/16 for the three "
              "neighboring ones work better",
              ClaimKind::exact,
              "At valence 3 with those weights and with 5/8 and 3/(8n) as at other valences: "
              "whether 1 > lambda > all other moduli, lambda double, in modes 1 and n - 1, which a tangent "
              "plane at the vertex asks for."},
    finding(
        "notes.loop.ridge", "notes 4, figure 7",
        "Loop's rules on the regular triangle lattice for data that depend on one lattice coordinate: the "
        "uniform cubic B-spline."),
    finding("notes.butterfly.ridge", "notes 5, figure 9",
            "The butterfly rules on the regular triangle lattice for data that depend on one lattice "
            "coordinate: the four-point scheme."),
    ClaimHead{"notes.butterfly.less-smooth", "notes", "5", "less smooth than the Loop subdivision surface",
              ClaimKind::exact,
              "Regular meshes: whether the butterfly's limits are C2, by Reif's condition for the curves of "
              "notes.butterfly.ridge, while Loop's are quartic box splines (notes.loop.edge, "
              "notes.loop.vertex), which are C2."},
};

const ClaimHead& claim(const std::string& id) { return head(table, id); }
Claim statement(const std::string& id, bool holds, const std::string& text, const std::string& note = "") {
  return settle_statement(claim(id), holds, text, note);
}

PolygonFaces triangles(std::size_t vertices, const std::vector<std::array<long long, 3>>& faces) {
  PolygonFaces result;
  result.vertices = vertices;
  for (const auto& face : faces) result.add_face(face);
  return result;
}

std::vector<std::array<long long, 3>> octahedron_faces() {
  std::vector<std::array<long long, 3>> faces;
  for (long long k = 0; k < 4; ++k) {
    faces.push_back({k, (k + 1) % 4, 4});
    faces.push_back({(k + 1) % 4, k, 5});
  }
  return faces;
}

/// How many triangles each edge belongs to, from the faces alone.
std::map<std::pair<long long, long long>, int> triangles_of_edges(const PolygonFaces& mesh) {
  std::map<std::pair<long long, long long>, int> count;
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 0; i < face.size(); ++i)
      ++count[std::minmax({face[i], face[(i + 1) % face.size()]})];
  }
  return count;
}

bool all_edges_have(const PolygonFaces& mesh, int triangles_each) {
  bool all = true;
  for (const auto& [edge, count] : triangles_of_edges(mesh)) all = all && count == triangles_each;
  return all;
}

void add_manifolds(Results& results) {
  const PolygonFaces octahedron = triangles(6, octahedron_faces());
  const PolygonFaces book = triangles(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  const std::optional<MeshFault> fault = find_fault(book);
  results.claims.push_back(statement(
      "notes.loop.manifold.edges",
      !find_fault(octahedron) && all_edges_have(octahedron, 2) && triangles_of_edges(book)[{0, 1}] == 3 &&
          fault,
      "true", fault ? "Refused: face " + std::to_string(fault->face + 1) + " " + fault->what + "." : ""));
  const PolygonFaces touching =
      triangles(7, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {3, 5, 4}, {3, 4, 6}, {4, 5, 6}, {5, 3, 6}});
  const std::optional<MeshFault> two_fans = find_fault(touching);
  results.claims.push_back(statement(
      "notes.loop.manifold.fan", all_edges_have(touching, 2) && two_fans, "true",
      two_fans ? "Every edge of the two tetrahedra belongs to two triangles, yet they are refused: face " +
                     std::to_string(two_fans->face + 1) + " " + two_fans->what + "."
               : ""));

  std::vector<std::array<long long, 3>> faces = octahedron_faces();
  faces.pop_back();
  const MeshTopology open(triangles(6, faces));
  int border_edges = 0;
  bool fans_open = true;
  for (int h = 0; h < open.half_edges(); ++h) {
    if (open.opposite(h) >= 0) continue;
    ++border_edges;
    fans_open = fans_open && open.face_count(open.origin(h)) < open.valence(open.origin(h));
  }
  results.claims.push_back(statement("notes.loop.manifold.boundary",
                                     border_edges == 3 && fans_open && !open.is_closed(),
                                     "true: 3 edges with one triangle"));
  // The rules of the whole scheme exist at each edge and vertex and have the sum 1.
  const MeshScheme<Rational> scheme = loop<Rational>();
  bool possible = true;
  for (int e = 0; e < open.edges(); ++e)
    possible = possible && scheme.edge_rule(open, open.half_edge(e)).sum() == Rational(1);
  for (int v = 0; v < open.vertices(); ++v)
    possible = possible && scheme.vertex_rule(open, v).sum() == Rational(1);
  results.claims.push_back(statement(
      "notes.loop.manifold.necessary", !possible, possible ? "false with rules for borders" : "true",
      "The rules of figure 7 alone ask for two triangles at each edge. With the cubic B-spline along the "
      "border (edges 1/2, 1/2; vertices 1/8, 6/8, 1/8) the scheme works on meshes with boundary, and the "
      "border follows a curve of its own. What is necessary is a fan, closed or not, at each vertex."));
}

using Corner = std::array<int, 3>;

/// The surface of unit cubes with these least corners, two triangles to a square, outside to the right hand's
/// thumb. Cubes share their common vertices, or have their own.
PolygonFaces cubes(const std::vector<Corner>& least, bool shared) {
  constexpr std::array<std::array<Corner, 4>, 6> squares{{{{{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0}}},
                                                          {{{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}},
                                                          {{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}},
                                                          {{{0, 1, 0}, {0, 1, 1}, {1, 1, 1}, {1, 1, 0}}},
                                                          {{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}},
                                                          {{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}}}};
  std::map<std::pair<std::size_t, Corner>, long long> numbers;
  std::vector<std::array<long long, 3>> faces;
  for (std::size_t k = 0; k < least.size(); ++k) {
    const auto number = [&](const Corner& corner) {
      const Corner place{least[k][0] + corner[0], least[k][1] + corner[1], least[k][2] + corner[2]};
      const auto next = static_cast<long long>(numbers.size());
      return numbers.try_emplace({shared ? 0 : k, place}, next).first->second;
    };
    for (const auto& [a, b, c, d] : squares) {
      faces.push_back({number(a), number(b), number(c)});
      faces.push_back({number(a), number(c), number(d)});
    }
  }
  return triangles(numbers.size(), faces);
}

void add_solids(Results& results) {
  const std::vector<Corner> two{{0, 0, 0}, {1, 1, 0}};
  const PolygonFaces apart = cubes(two, false);
  if (find_fault(apart) || !all_edges_have(apart, 2)) throw std::logic_error("two cubes are no manifold");
  const PolygonFaces joined = cubes(two, true);
  int of_four = 0;
  for (const auto& [edge, count] : triangles_of_edges(joined)) of_four += count == 4 ? 1 : 0;
  const std::optional<MeshFault> fault = find_fault(joined);
  results.claims.push_back(statement(
      "notes.loop.manifold.solid", !fault, fmt::format("{} edge with four triangles", of_four),
      fmt::format(
          "Two cubes that share an edge, and nothing else, have no such surface: four triangles meet at that "
          "edge "
          "(the triangulation is refused: face {} {}). Solids whose surface is a manifold have a manifold "
          "triangulation. This one's has it only with two copies of the common edge, one for each cube: the "
          "two "
          "meshes part there.",
          fault ? fault->face + 1 : 0, fault ? fault->what : "")));
}

void add_valence_3(Results& results) {
  const auto symbolic = loop<RationalFunction>();
  const Decision with =
      SpectralCondition(turning_modes(symbolic), invariant_mode(symbolic, 3), 3).decide(Rational(0));
  const Decision without = exact_condition(loop_without_exception<Rational>(), 3);
  results.claims.push_back(settle_statement(
      claim("notes.loop.valence-3.better"), with == Decision::yes && without == Decision::no,
      "holds with them, fails without",
      "Modes 1 and 2 have 3/8 + cos(2 pi/3)/4 = 1/4. So has mode 0 with 5/8 and 3/8 (trace 5/4, eigenvalue "
      "1), so that three directions shrink alike and no plane is left: notes.loop.exception. With 7/16 and "
      "9/16 its other eigenvalue is 1/16.",
      Rigour::certified));
}

/// The vertices at this end and around, which a rule may use.
std::set<int> closed_neighbourhood(const MeshTopology& mesh, int v) {
  std::set<int> result{v};
  for (const int w : neighbours(mesh, v)) result.insert(w);
  return result;
}

bool is_average_of(const Stencil<Rational>& stencil, const std::set<int>& vertices) {
  bool is = stencil.sum() == Rational(1);
  for (const auto& [vertex, weight] : stencil.terms())
    is = is && weight.sign() > 0 && vertices.contains(vertex);
  return is;
}

void add_local(Results& results) {
  const MeshScheme<Rational> scheme = loop<Rational>();
  bool local = true;
  constexpr int highest_valence = 40;
  for (int n = 3; n <= highest_valence; ++n) {
    const MeshTopology fan = fan_topology(3, n, 2);
    local = local && is_average_of(scheme.vertex_rule(fan, 0), closed_neighbourhood(fan, 0));
    for_each_outgoing(fan, 0, [&](int h) {
      const std::set<int> corners{0, fan.target(h), fan.target(fan.next(h)),
                                  fan.target(fan.next(fan.opposite(h)))};
      local = local && is_average_of(scheme.edge_rule(fan, h), corners);
    });
  }
  results.claims.push_back(statement("notes.loop.local", local, "true"));
}

// ---- Data that depend on one coordinate

/// The first lattice coordinate of each vertex of fan_topology(3, 6, rings): the spokes are (1, 0), (0, 1),
/// (-1, 1), (-1, 0), (0, -1), (1, -1).
std::vector<int> first_coordinates(int rings) {
  constexpr std::array<int, 6> spokes{1, 0, -1, -1, 0, 1};
  std::vector<int> result{0};
  for (std::size_t k = 0; k < spokes.size(); ++k) {
    for (const FanPlace& p : sector_places(3, rings))
      result.push_back(p.a * spokes[k] + p.b * spokes[(k + 1) % spokes.size()]);
  }
  return result;
}

/// A stencil for data f(x): the weights of f at each x.
Combination on_ridges(const Stencil<Rational>& stencil, const std::vector<int>& coordinates) {
  Combination sum;
  for (const auto& [vertex, weight] : stencil.terms())
    sum += weight * control_point(coordinates[static_cast<std::size_t>(vertex)]);
  return sum;
}

/// Whether the scheme is the binary mask for such data: at the centre, and in the middle of its six edges.
bool is_curve_scheme(const MeshScheme<Rational>& scheme, const Mask<Rational>& mask) {
  constexpr int rings = 3;
  const MeshTopology fan = fan_topology(3, 6, rings);
  const std::vector<int> x = first_coordinates(rings);
  // New point i is the sum of a_{i - 2 j} P_j.
  const auto rule = [&](int i) {
    Combination sum;
    for (int j = -rings; j <= rings; ++j) sum += mask.symbol[i - 2 * j] * control_point(j);
    return sum;
  };
  bool same = on_ridges(scheme.vertex_rule(fan, 0), x) == rule(0);
  for_each_outgoing(fan, 0, [&](int h) {
    const int end = x[static_cast<std::size_t>(fan.target(h))];
    same = same && on_ridges(scheme.edge_rule(fan, h), x) == rule(end);
  });
  return same;
}

void add_smoothness(Results& results) {
  const Mask<Rational> four = four_point(Rational(1, 16));
  const bool loop_ridge = is_curve_scheme(loop<Rational>(), bspline<Rational>(3));
  const bool butterfly_ridge = is_curve_scheme(butterfly<Rational>(), four);
  results.claims.push_back(statement("notes.loop.ridge", loop_ridge, "true"));
  results.claims.push_back(statement("notes.butterfly.ridge", butterfly_ridge, "true"));
  const bool cubic = reif_order(bspline<Rational>(3)) == 2;
  const bool not_c2 = reif_order(four) == 1;
  results.claims.push_back(statement(
      "notes.butterfly.less-smooth", loop_ridge && butterfly_ridge && cubic && not_c2,
      "C2 against C1 and not C2",
      "On regular meshes. Data of one coordinate give the four-point curve, whose subdivision matrix has not "
      "the eigenvalues of C2 limits (smooth.named.four-point: it is C1). Loop's surfaces there are box "
      "splines "
      "of three directions taken twice: after any one direction is left out 4 remain, so they are C2 (de "
      "Boor, "
      "Hoellig & Riemenschneider: Box Splines, 1993). At extraordinary vertices Loop's are C1 "
      "(mesh.characteristic-map.loop), and the butterfly's are not at valence 3 "
      "(notes.butterfly.valence-3)."));
}

}  // namespace

std::span<const ClaimHead> mesh_heads() { return table; }

Results run_meshes() {
  Results results;
  add_local(results);
  add_manifolds(results);
  add_solids(results);
  add_valence_3(results);
  add_smoothness(results);
  return results;
}

}  // namespace subdiv::notes
