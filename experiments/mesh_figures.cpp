#include "experiments/mesh_figures.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include <fmt/format.h>

#include "experiments/data.h"
#include "experiments/mesh_file.h"
#include "experiments/mesh_pictures.h"
#include "schemes/evaluate/refine_mesh.h"
#include "schemes/mesh/butterfly.h"
#include "schemes/mesh/fan.h"
#include "schemes/mesh/jspline_mesh.h"
#include "schemes/mesh/loop.h"

namespace subdiv {
namespace {

const std::string handles = "On the stored mesh mesh-handles.obj (99 quads, valences 3 to 8): ";
const std::string example =
    "On the stored mesh mesh-valence-8.obj, whose vertex P9 has the neighbours P1 .. P8: ";

const std::array table{
    finding("figure.mesh.valences", "jsplines 10, figure 14",
            handles + "vertices - edges + faces, the same after two levels, and the sum of (4 - n)/4 over "
                      "the vertices' valences n."),
    finding("figure.mesh.volume.j0", "jsplines 10, figure 14",
            handles +
                "volume after two levels of jspline-mesh at s = 0 over that of the mesh, quads filled by "
                "bilinear patches."),
    finding("figure.mesh.volume.average", "jsplines 10, figure 14", "The same at s = 1/2."),
    finding("figure.mesh.volume.j1", "jsplines 10, figure 14", "The same at s = 1."),
    finding("figure.mesh.volume.quintic", "jsplines 10, figure 14", "The same at s = 3/2."),
    ClaimHead{
        "notes.loop.edge", "notes", "4, figure 7", "3/8, 3/8, 1/8, 1/8", ClaimKind::exact,
        "Weights of the ends of an edge and of the two vertices opposite to it: the coefficients at odd "
        "places of the quartic box spline's mask (1+z)^2 (1+w)^2 (1+zw)^2/16."},
    ClaimHead{"notes.loop.vertex", "notes", "4, figure 7", "5/8 + 3/(8n)", ClaimKind::exact,
              "A vertex of valence n = 4 .. 40 keeps 5/8, each neighbour gets 3/(8n); at n = 6 these are the "
              "coefficients at even places of the quartic box spline's mask."},
    ClaimHead{
        "notes.loop.valence-3", "notes", "4", "7/16 and 3/16", ClaimKind::exact,
        "Weights at a vertex of degree 3, the centre's and each neighbour's: those of Loop's own formula "
        "(1987) at n = 3."},
    ClaimHead{"notes.loop.example.edge", "notes", "4, figure 8", "3/8 P2 + 3/8 P9 + 1/8 P1 + 1/8 P3",
              ClaimKind::exact, example + "the point of the edge of P2 and P9."},
    ClaimHead{"notes.loop.example.vertex", "notes", "4, figure 8", "5/8 P9 + 3/(8*8) (P1 + P2 + .. + P8)",
              ClaimKind::exact, example + "the new location of P9."},
    finding(
        "figure.notes.tetrahedron", "notes 4, figure 5",
        "Loop's scheme on the tetrahedron, four levels: vertices - edges + faces, and the sum of (6 - n)/6 "
        "over the valences n, at each level."),
    finding("figure.notes.tetrahedron.volume", "notes 4, figure 5",
            "Its volume after four levels over that of the tetrahedron."),
    finding("figure.notes.split", "notes 4, figure 6",
            example +
                "a step adds a vertex an edge, and the new vertices have valence 6: vertices after a step."),
    ClaimHead{"notes.butterfly.interpolates", "notes", "5", "does not move the original (black) vertices",
              ClaimKind::exact, "The vertices of mesh-handles-triangles.obj after two levels."},
    finding(
        "notes.butterfly.weights", "notes 5, figure 9",
        "Weights of the ends of an edge, of the two vertices opposite to it and of the four wings. On the "
        "regular lattice they reproduce all polynomials of degree 3."),
};

using SpacePoint = std::array<Rational, 3>;
using Scheme3 = MeshScheme<Rational>;

const ClaimHead& claim(const std::string& id) { return head(table, id); }
Claim number(const std::string& id, const Rational& value) {
  return settle(claim(id), exact(value, "rational arithmetic"));
}

MeshFile stored(const char* name) { return read_mesh(data_folder() / name); }

/// A mesh with exact points.
struct ExactMesh {
  MeshTopology topology;
  std::vector<SpacePoint> points;
};

ExactMesh exact_mesh(const MeshFile& file) {
  ExactMesh mesh{surface_of(file), {}};
  for (const Point3& p : file.points)
    mesh.points.push_back(
        {Rational::from_double(p[0]), Rational::from_double(p[1]), Rational::from_double(p[2])});
  return mesh;
}

ExactMesh refined(ExactMesh mesh, const Scheme3& scheme, int levels) {
  for (int level = 0; level < levels; ++level) {
    mesh.points = refined_points(mesh.topology, scheme, mesh.points);
    mesh.topology = split(mesh.topology, scheme.split);
  }
  return mesh;
}

std::vector<SpaceQuad> drawn_faces(const ExactMesh& mesh) {
  IndexedMesh drawn;
  drawn.sides = mesh.topology.sides();
  for (const SpacePoint& p : mesh.points)
    drawn.points.push_back({p[0].to_double(), p[1].to_double(), p[2].to_double()});
  drawn.corners.assign(mesh.topology.origins().begin(), mesh.topology.origins().end());
  return mesh_quads(drawn);
}

int characteristic(const MeshTopology& mesh) { return mesh.vertices() - mesh.edges() + mesh.faces(); }

/// The same by valences: in a closed mesh of faces with s corners, of valences n, sum of 1 - n/2 + n/s.
Rational characteristic_by_valences(const MeshTopology& mesh) {
  Rational sum(0);
  for (int v = 0; v < mesh.vertices(); ++v)
    sum += Rational(1) - Rational(mesh.valence(v), 2) + Rational(mesh.valence(v), mesh.sides());
  return sum;
}

Rational determinant(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Twelve times the volume: of a quad both pairs of triangles, whose mean is the bilinear patch.
Rational volume(const ExactMesh& mesh) {
  Rational sum(0);
  for (int f = 0; f < mesh.topology.faces(); ++f) {
    const auto at = [&](int i) {
      return mesh.points[static_cast<std::size_t>(mesh.topology.origin(mesh.topology.first(f) + i))];
    };
    if (mesh.topology.sides() == 3) {
      sum += Rational(2) * determinant(at(0), at(1), at(2));
    } else {
      for (int i = 0; i < 4; ++i) sum += determinant(at(i), at((i + 1) % 4), at((i + 2) % 4));
    }
  }
  return sum;
}

// ---- J-splines, figure 14

void add_handles(Results& results) {
  constexpr double cell = 230;
  constexpr double row_height = 175;
  constexpr double scale = 20;
  const ExactMesh mesh = exact_mesh(stored("mesh-handles.obj"));
  std::vector<Curve> curves;
  std::vector<FigureText> captions;
  constexpr int columns = 3;
  const auto draw = [&](const std::string& name, const std::string& caption, const ExactMesh& shape,
                        int panel, unsigned colour) {
    const int row = panel / columns;
    const int column = panel % columns;
    Series series = polygons("mesh-handles-" + name);
    add_quads(series, drawn_faces(shape), true,
              {view_from({2, -5, 4}), scale, {column * cell, -row * row_height}}, Paint::shaded, colour);
    curves.push_back(filled(series));
    captions.push_back(caption_below(series, caption));
    results.series.push_back(std::move(series));
  };
  draw("control", "control mesh", mesh, 0, style::lit_grey);
  const int count = characteristic(mesh.topology);
  bool same = characteristic_by_valences(mesh.topology) == Rational(count);
  const std::vector<std::pair<std::string, Rational>> shapes{
      {"j0", Rational(0)}, {"average", Rational(1, 2)}, {"j1", Rational(1)}, {"quintic", Rational(3, 2)}};
  int panel = 1;
  for (const auto& [name, s] : shapes) {
    const ExactMesh fine = refined(mesh, jspline_mesh(s), 2);
    same = same && characteristic(fine.topology) == count &&
           characteristic_by_valences(fine.topology) == Rational(count);
    results.claims.push_back(number("figure.mesh.volume." + name, volume(fine) / volume(mesh)));
    draw(name, "s = " + s.to_string(), fine, panel++, style::lit_orange);
  }
  results.claims.push_back(settle_statement(claim("figure.mesh.valences"), same, std::to_string(count)));
  results.figures.push_back(bare_figure("mesh-handles",
                                        "A control mesh, and two levels of jspline-mesh (jsplines figure 14)",
                                        std::move(curves), std::move(captions), {"figure.mesh."}));
}

// ---- Notes, figures 5 .. 9

void add_tetrahedron(Results& results) {
  constexpr int levels = 4;
  constexpr std::array<double, levels + 1> places{0, 105, 155, 205, 255};
  constexpr double scale = 45;
  const ExactMesh first = exact_mesh(stored("mesh-tetrahedron.obj"));
  std::vector<Curve> curves;
  Series volumes{"mesh-tetrahedron-volumes", {"level", "volume"}, {}};
  bool same = true;
  ExactMesh mesh = first;
  for (int level = 0; level <= levels; ++level) {
    if (level > 0) mesh = refined(std::move(mesh), loop<Rational>(), 1);
    same = same && characteristic(mesh.topology) == 2 &&
           characteristic_by_valences(mesh.topology) == Rational(2);
    constexpr int digits = 12;
    volumes.rows.push_back({std::to_string(level), to_significant(volume(mesh) / Rational(12), digits)});
    Series series = polygons(fmt::format("mesh-tetrahedron-{}", level));
    add_quads(series, drawn_faces(mesh), true,
              {view_from({2, -5, 4}), scale, {places[static_cast<std::size_t>(level)], 0}}, Paint::shaded,
              style::lit_sky);
    curves.push_back(filled(series));
    results.series.push_back(std::move(series));
  }
  results.claims.push_back(settle_statement(claim("figure.notes.tetrahedron"), same, "2 at each level"));
  results.claims.push_back(number("figure.notes.tetrahedron.volume", volume(mesh) / volume(first)));
  results.series.push_back(std::move(volumes));
  results.figures.push_back(bare_figure("mesh-tetrahedron", "Loop's scheme on a tetrahedron (notes figure 5)",
                                        std::move(curves), {},
                                        {"figure.notes.tetrahedron", "figure.notes.tetrahedron.volume"}));
}

/// A diagram in the plane: edges of a mesh seen from above, and texts.
class Diagram {
 public:
  Diagram(std::string name, std::string title) : name_(std::move(name)), title_(std::move(title)) {}

  void add_edges(const std::string& part, const std::vector<std::array<Eigen::Vector3d, 2>>& edges,
                 const std::string& style) {
    Series series = polylines(name_ + "-" + part);
    for (const auto& [a, b] : edges) add_line(series, {a, b}, false, above_);
    curves_.push_back(drawn(series, "", style));
    series_.push_back(std::move(series));
  }
  void add_dots(const std::string& part, const std::vector<Eigen::Vector3d>& points) {
    Series series = polylines(name_ + "-" + part);
    add_line(series, points, false, above_);
    curves_.push_back(drawn(series, "", style::bright_dot));
    series_.push_back(std::move(series));
  }
  void add_text(const std::string& text, const Eigen::Vector3d& at) {
    const Eigen::Vector2d p = above_.centre + above_.scale * above_.view.project(at);
    texts_.push_back({text, p.x(), p.y(), "left offset 0.6,0.7"});
  }
  void add_to(Results& results, std::vector<std::string> claims) {
    results.figures.push_back(
        bare_figure(name_, title_, std::move(curves_), std::move(texts_), std::move(claims)));
    for (Series& series : series_) results.series.push_back(std::move(series));
  }

 private:
  std::string name_;
  std::string title_;
  Placement above_{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 40, {0, 0}};
  std::vector<Curve> curves_;
  std::vector<Series> series_;
  std::vector<FigureText> texts_;
};

Eigen::Vector3d vector_of(const SpacePoint& p) {
  return {p[0].to_double(), p[1].to_double(), p[2].to_double()};
}

/// The edges between vertices that are wanted.
template <class Wanted>
std::vector<std::array<Eigen::Vector3d, 2>> edges_of(const ExactMesh& mesh, const Wanted& wanted) {
  std::vector<std::array<Eigen::Vector3d, 2>> edges;
  for (int e = 0; e < mesh.topology.edges(); ++e) {
    const int a = mesh.topology.origin(mesh.topology.half_edge(e));
    const int b = mesh.topology.target(mesh.topology.half_edge(e));
    if (!wanted(a) || !wanted(b)) continue;
    edges.push_back({vector_of(mesh.points[static_cast<std::size_t>(a)]),
                     vector_of(mesh.points[static_cast<std::size_t>(b)])});
  }
  return edges;
}

constexpr int ring = 8;  // P1 .. P8 have the numbers 0 .. 7, P9 has 8

int edge_of(const MeshTopology& mesh, int a, int b) {
  for (int e = 0; e < mesh.edges(); ++e) {
    const int h = mesh.half_edge(e);
    if (std::minmax(mesh.origin(h), mesh.target(h)) == std::minmax(a, b)) return e;
  }
  throw std::logic_error("no such edge");
}

void add_split(Results& results, const ExactMesh& mesh) {
  const MeshTopology fine = split(mesh.topology, MeshSplit::triangles);
  const int added = fine.vertices() - mesh.topology.vertices();
  bool holds = added == mesh.topology.edges() && fine.faces() == 4 * mesh.topology.faces();
  for (int v = 0; v < fine.vertices(); ++v)
    holds = holds && fine.valence(v) == (v < mesh.topology.vertices() ? mesh.topology.valence(v) : 6);
  results.claims.push_back(
      settle_statement(claim("figure.notes.split"), holds, std::to_string(fine.vertices())));
  // The logical picture: new vertices in the middle of edges, though the scheme puts them elsewhere.
  ExactMesh middle{fine, mesh.points};
  std::vector<Eigen::Vector3d> dots;
  for (int e = 0; e < mesh.topology.edges(); ++e) {
    middle.points.push_back(
        combine(edge_midpoint<Rational>(mesh.topology, mesh.topology.half_edge(e)), mesh.points));
    const int h = mesh.topology.half_edge(e);
    if (std::max(mesh.topology.origin(h), mesh.topology.target(h)) <= ring)
      dots.push_back(vector_of(middle.points.back()));
  }
  Diagram diagram("mesh-loop-split", "Every triangle is split into four (notes figure 6)");
  diagram.add_edges(
      "fine",
      edges_of(middle, [&](int v) { return middle.points[static_cast<std::size_t>(v)][2] >= Rational(0); }),
      style::in_colour(style::vermilion, 1.2));
  diagram.add_edges("coarse", edges_of(mesh, [](int v) { return v <= ring; }),
                    style::in_colour(style::black, 1.5));
  diagram.add_dots("vertices", dots);
  diagram.add_to(results, {"figure.notes.split"});
}

/// Whether a stencil is these weights at these vertices.
bool is_stencil(const Stencil<Rational>& stencil, const std::vector<std::pair<int, Rational>>& expected) {
  std::size_t terms = 0;
  for (const auto& [vertex, weight] : stencil.terms()) terms += weight.sign() == 0 ? 0 : 1;
  return terms == expected.size() && std::all_of(expected.begin(), expected.end(), [&](const auto& term) {
           return stencil.weight(term.first) == term.second;
         });
}

void add_example(Results& results, const ExactMesh& mesh) {
  const Scheme3 scheme = loop<Rational>();
  const auto edge = scheme.edge_rule(mesh.topology, mesh.topology.half_edge(edge_of(mesh.topology, 1, ring)));
  results.claims.push_back(
      settle_statement(claim("notes.loop.example.edge"),
                       is_stencil(edge, {{1, {3, 8}}, {ring, {3, 8}}, {0, {1, 8}}, {2, {1, 8}}}),
                       "3/8 P2 + 3/8 P9 + 1/8 P1 + 1/8 P3"));
  const auto vertex = scheme.vertex_rule(mesh.topology, ring);
  std::vector<std::pair<int, Rational>> expected{{ring, {5, 8}}};
  for (int i = 0; i < ring; ++i) expected.emplace_back(i, Rational(3, 64));
  results.claims.push_back(settle_statement(claim("notes.loop.example.vertex"), is_stencil(vertex, expected),
                                            "5/8 P9 + 3/64 (P1 + P2 + .. + P8)"));
  Diagram diagram("mesh-loop-example",
                  "A vertex of valence 8, the point Q of an edge, the new P9 (notes figure 8)");
  diagram.add_edges("mesh", edges_of(mesh, [](int v) { return v <= ring; }),
                    style::in_colour(style::black, 1.5));
  for (int v = 0; v <= ring; ++v)
    diagram.add_text(fmt::format("P{}", v + 1), vector_of(mesh.points[static_cast<std::size_t>(v)]));
  const std::vector<Eigen::Vector3d> points{vector_of(combine(edge, mesh.points)),
                                            vector_of(combine(vertex, mesh.points))};
  diagram.add_text("Q", points[0]);
  diagram.add_dots("points", points);
  diagram.add_to(results, {"notes.loop.example."});
}

/// The place of a vertex of fan_topology(3, 6, rings) on the lattice.
std::vector<std::array<long, 2>> lattice_places(int rings) {
  constexpr std::array<std::array<long, 2>, 6> spokes{{{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}}};
  std::vector<std::array<long, 2>> places{{0, 0}};
  for (std::size_t k = 0; k < spokes.size(); ++k) {
    const auto& u = spokes[k];
    const auto& v = spokes[(k + 1) % spokes.size()];
    for (const FanPlace& p : sector_places(3, rings))
      places.push_back({p.a * u[0] + p.b * v[0], p.a * u[1] + p.b * v[1]});
  }
  return places;
}

/// Sixteen times the coefficients of (1+z)^2 (1+w)^2 (1+zw)^2/16, by powers of z and w.
std::array<std::array<int, 5>, 5> box_spline_mask() {
  std::array<std::array<int, 5>, 5> mask{};
  constexpr std::array<int, 3> square{1, 2, 1};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) mask[i + k][j + k] += square[i] * square[j] * square[k];
    }
  }
  return mask;
}

/// Does a stencil have the box spline's coefficients for a point of this parity, vertex by vertex? The mask's
/// middle is at z^2 w^2; a point at q/2 takes the coefficient q - 2 p + (2, 2) of the vertex p.
bool is_box_spline(const Stencil<Rational>& stencil, const std::vector<std::array<long, 2>>& places, long qx,
                   long qy) {
  const auto mask = box_spline_mask();
  bool same = true;
  for (std::size_t v = 0; v < places.size(); ++v) {
    // The third direction of the lattice is (-1, 1), that of the mask (1, 1): z goes along (-1, 0).
    const long i = 2 - (qx - 2 * places[v][0]);
    const long j = 2 + (qy - 2 * places[v][1]);
    const bool inside = i >= 0 && i <= 4 && j >= 0 && j <= 4;
    const Rational expected =
        inside ? Rational(mask[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)], 16) : Rational(0);
    same = same && stencil.weight(static_cast<int>(v)) == expected;
  }
  return same;
}

void add_loop_weights(Results& results) {
  constexpr int rings = 3;
  const Scheme3 scheme = loop<Rational>();
  const MeshTopology fan = fan_topology(3, 6, rings);
  const auto places = lattice_places(rings);
  bool edges = true;
  for_each_outgoing(fan, 0, [&](int h) {
    const auto& end = places[static_cast<std::size_t>(fan.target(h))];
    edges = edges && is_box_spline(scheme.edge_rule(fan, h), places, end[0], end[1]);
  });
  results.claims.push_back(settle_statement(claim("notes.loop.edge"), edges, "3/8, 3/8, 1/8, 1/8"));
  bool vertices = is_box_spline(scheme.vertex_rule(fan, 0), places, 0, 0);
  constexpr int most = 40;
  for (int n = 4; n <= most; ++n) {
    const MeshTopology around = fan_topology(3, n, 1);
    const auto stencil = scheme.vertex_rule(around, 0);
    vertices = vertices && stencil.weight(0) == Rational(5, 8);
    for (int i = 1; i <= n; ++i) vertices = vertices && stencil.weight(i) == Rational(3, 8L * n);
  }
  results.claims.push_back(settle_statement(claim("notes.loop.vertex"), vertices, "5/8 and 3/(8n)"));
  const MeshTopology three = fan_topology(3, 3, 1);
  bool special = true;
  for (const Scheme3& s : {loop<Rational>(), loop_1987<Rational>()})
    special = special &&
              is_stencil(s.vertex_rule(three, 0), {{0, {7, 16}}, {1, {3, 16}}, {2, {3, 16}}, {3, {3, 16}}});
  results.claims.push_back(settle_statement(claim("notes.loop.valence-3"), special, "7/16 and 3/16"));
}

/// Draws the edges of the regular lattice around an edge or a vertex, and the weights of the point there.
void add_weights(Diagram& diagram, const std::string& part, const Stencil<Rational>& stencil,
                 const std::vector<std::array<long, 2>>& places, const MeshTopology& fan,
                 Eigen::Vector3d point, const Eigen::Vector3d& shift) {
  constexpr double height = 0.8660254037844386;  // of the triangle with unit sides
  const auto at = [&](int v) -> Eigen::Vector3d {
    const auto& p = places[static_cast<std::size_t>(v)];
    const auto x = static_cast<double>(p[0]);
    const auto y = static_cast<double>(p[1]);
    return Eigen::Vector3d(2 * (x + y / 2), 2 * y * height, 0) + shift;
  };
  std::vector<std::array<Eigen::Vector3d, 2>> edges;
  for (int e = 0; e < fan.edges(); ++e) {
    const int a = fan.origin(fan.half_edge(e));
    const int b = fan.target(fan.half_edge(e));
    if (stencil.weight(a).sign() != 0 && stencil.weight(b).sign() != 0) edges.push_back({at(a), at(b)});
  }
  diagram.add_edges(part, edges, style::in_colour(style::black, 1.5));
  for (const auto& [vertex, weight] : stencil.terms()) diagram.add_text(weight.to_string(), at(vertex));
  point = 2 * Eigen::Vector3d(point.x() + point.y() / 2, point.y() * height, 0);
  diagram.add_dots(part + "-point", {point + shift});
}

void add_weight_diagrams(Results& results) {
  constexpr int rings = 3;
  const MeshTopology fan = fan_topology(3, 6, rings);
  const auto places = lattice_places(rings);
  const int h = fan.outgoing(0);
  const auto& end = places[static_cast<std::size_t>(fan.target(h))];
  const Eigen::Vector3d middle(static_cast<double>(end[0]) / 2, static_cast<double>(end[1]) / 2, 0);
  Diagram loops("mesh-loop-weights",
                "Loop's weights: of an edge, and of a vertex of valence 6 (notes figure 7)");
  add_weights(loops, "edge", loop<Rational>().edge_rule(fan, h), places, fan, middle, {0, 0, 0});
  add_weights(loops, "vertex", loop<Rational>().vertex_rule(fan, 0), places, fan, {0, 0, 0}, {7, 0, 0});
  loops.add_to(results, {"notes.loop.edge", "notes.loop.vertex", "notes.loop.valence-3"});
  Diagram wings("mesh-butterfly-weights", "The butterfly scheme's weights (notes figure 9)");
  add_weights(wings, "edge", butterfly<Rational>().edge_rule(fan, h), places, fan, middle, {0, 0, 0});
  wings.add_to(results, {"notes.butterfly.weights"});
}

Rational power(const Rational& x, int k) { return k == 0 ? Rational(1) : x * power(x, k - 1); }

void add_butterfly(Results& results) {
  const Scheme3 scheme = butterfly<Rational>();
  const ExactMesh mesh = exact_mesh(stored("mesh-handles-triangles.obj"));
  const ExactMesh fine = refined(mesh, scheme, 2);
  results.claims.push_back(
      settle_statement(claim("notes.butterfly.interpolates"),
                       std::equal(mesh.points.begin(), mesh.points.end(), fine.points.begin()), "true"));
  constexpr int rings = 3;
  const MeshTopology fan = fan_topology(3, 6, rings);
  const auto places = lattice_places(rings);
  bool holds = true;
  for_each_outgoing(fan, 0, [&](int h) {
    const Stencil<Rational> stencil = scheme.edge_rule(fan, h);
    const auto& end = places[static_cast<std::size_t>(fan.target(h))];
    std::vector<Rational> weights;
    for (const auto& term : stencil.terms()) weights.push_back(term.second);
    std::sort(weights.begin(), weights.end());
    const Rational wing(-1, 16);
    holds = holds && weights == std::vector<Rational>{wing, wing, wing, wing, {1, 8}, {1, 8}, {1, 2}, {1, 2}};
    for (int i = 0; i <= 3; ++i) {
      for (int j = 0; i + j <= 3; ++j) {
        Rational value(0);
        for (const auto& [vertex, weight] : stencil.terms()) {
          const auto& p = places[static_cast<std::size_t>(vertex)];
          value += weight * power(Rational(p[0]), i) * power(Rational(p[1]), j);
        }
        holds = holds && value == power(Rational(end[0], 2), i) * power(Rational(end[1], 2), j);
      }
    }
  });
  results.claims.push_back(
      settle_statement(claim("notes.butterfly.weights"), holds, "1/2 twice, 1/8 twice, -1/16 four times"));
}

}  // namespace

std::span<const ClaimHead> mesh_figure_heads() { return table; }

Results run_mesh_figures() {
  Results results;
  const ExactMesh valence_8 = exact_mesh(stored("mesh-valence-8.obj"));
  add_handles(results);
  add_loop_weights(results);
  add_example(results, valence_8);
  add_tetrahedron(results);
  add_split(results, valence_8);
  add_weight_diagrams(results);
  add_butterfly(results);
  return results;
}

}  // namespace subdiv
