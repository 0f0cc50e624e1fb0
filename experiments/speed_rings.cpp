#include "experiments/speed_rings.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "analysis/adjustable_speed/sector_form.h"
#include "experiments/data.h"
#include "experiments/mesh_file.h"
#include "experiments/ring_shapes.h"
#include "experiments/speed_connectivity.h"
#include "schemes/adjustable_speed/limit_point.h"
#include "schemes/algebra/rational_function.h"
#include "schemes/evaluate/bezier_patch.h"
#include "schemes/evaluate/nested_rings.h"
#include "schemes/mesh/fan.h"

namespace subdiv {
namespace {

using Function = RationalFunction;
using Form = SectorForm<Function>;
using SpacePoint = std::array<Rational, 3>;

const std::string family =
    "40 nets over convex quadrics, 8 each of the valences 3, 5, 6, 7, 8 (experiments/ring_shapes.h), speeds "
    "after (11). ";
const std::string blend = "The stored net speed-blend.obj (valence 5), ";
const std::string angles =
    "at the vertex, tan^2 of the greatest angle between the normals of neighbouring patches of the cap after "
    "two steps at speed ";

const std::array table{
    ClaimHead{
        "speed.rings.c2", "speed", "II, figure 3", "define a sequence of C2 connected bi-3 surface rings",
        ClaimKind::exact,
        "For all valences, over Q(sigma, beta, gamma): the patches of a sector of one ring join with equal "
        "derivatives up to the second in the parameters of the knots, so do those of neighbouring sectors, "
        "and the ring and the tensor border of the refined net, which the next ring is made of, also when "
        "that net goes over to the knots of another speed tau."},
    ClaimHead{"speed.combinatorial", "speed", "II",
              "Combinatorially, this refinement step mimics Catmull-Clark subdivision", ClaimKind::exact,
              "For the valences 3 .. 40, all sectors being alike: the refined net's three rings of quads are "
              "those of the two rings with every face split into four, place by place: new vertices, edge "
              "points and face points; and over Q(sigma) no new point reads a control point that "
              "Catmull-Clark's at the same place does not read."},
    ClaimHead{
        "speed.completion", "speed", "I",
        "the bi-3 (bicubic) completion of a surface after one or two subdivision steps", ClaimKind::exact,
        "For all valences, over Q(sigma, beta, gamma): the patches of the tensor border of the last net "
        "with its limit point join the last ring with equal derivatives up to the second, and each "
        "other continuously; their first derivatives across common edges agree in three of the four "
        "coefficients, those away from the vertex."},
    ClaimHead{
        "speed.poor-shape", "speed", "IV",
        "the surface shape for higher speeds is increasingly poor when σ ≥ 3/4", ClaimKind::tendency,
        family +
            "Rings until the hole is 1/64 wide in parameters: 6 steps at speed 1/2, 3 at 3/4, 2 at 7/8, 1 at "
            "63/64. Share of the nets for which the greatest less the least mean curvature over all rings "
            "grows from each of these speeds to the next."},
    ClaimHead{"speed.fault", "speed", "figure 1",
              "Note the strong fault in the highlight line in the center area", ClaimKind::tendency,
              family +
                  "Two steps at speed 1/2, two at 3/4, and the cap of the tensor border and the limit point. "
                  "Share of the nets for which the greatest angle between normals across edges of the cap is "
                  "smaller at 3/4."},
    finding("figure.speed.1.half", "speed figure 1", blend + angles + "1/2. Exact."),
    finding("figure.speed.1.high", "speed figure 1", blend + angles + "3/4. Exact."),
    finding("figure.speed.6", "speed figure 6",
            "Control points after a step at a vertex of valence n: those that define the surface ring, and "
            "those that the next step needs. By the rules' sectors, and by the vertices of three and two "
            "rings of quads."),
    finding("figure.speed.9", "speed figure 9",
            "Width in parameters of what m steps of speeds sigma_1 .. sigma_m leave open, the first border "
            "having width 1: where the outermost corner of the last tensor border of a regular flat net "
            "lies, for all 1 <= m <= 3 and speeds 1/4, 1/2, 3/4, in exact rings."),
};

const ClaimHead& claim(const std::string& id) { return head(table, id); }

// ---- Joints

/// Whether the border stays when the net of one speed goes over to the knots of another.
bool border_is_kept() {
  const Function s = Function::variable(0);
  const Function tau = Function::variable(3);
  const FormNet<Function> changed = change_of_knots(unit_speed_knots(s), unit_speed_knots(tau));
  return border_points<Function>(changed, ring_rules(tau), 0) ==
         border_points<Function>(FormNet<Function>(), ring_rules(s), 0);
}

struct CapJoints {
  bool outwards = false;
  bool continuous = false;
  std::array<bool, 4> smooth{};  // first derivatives across an inner edge, the last one at the vertex
};

/// The cap of a refined net.
CapJoints cap_joints() {
  const Function s = Function::variable(0);
  const Function q = Function(1) - s;
  const VertexWeights<Function> weights{Function::variable(1), Function::variable(2)};
  const RingRules<Function> rules = ring_rules(s);
  const FormNet<Function> refined = step_of_speed(s, weights);
  const VertexWeights<Function> limit = limit_weights(weights, s);
  BezierPatch<Form> cap = border_points<Function>(refined, rules, 0);
  cap[15] =
      substituted(central_form(Function(1) - limit.beta - limit.gamma, limit.beta, limit.gamma), refined);
  const RingSector<Form> ring = ring_sector(border_points<Function>(FormNet<Function>(), rules, 0), cap, s);
  CapJoints joints;
  joints.outwards =
      joins_c2(edge_layers(ring.first_side, PatchEdge::last_i), s, edge_layers(cap, PatchEdge::first_i), q) &&
      joins_c2(edge_layers(ring.next_side, PatchEdge::last_j), s, edge_layers(cap, PatchEdge::first_j), q);
  BezierPatch<Form> beyond{};
  std::ranges::transform(cap, beyond.begin(), [](const Form& f) { return turned(f, 1); });
  const auto own = edge_layers(cap, PatchEdge::last_i);
  const auto next = edge_layers(beyond, PatchEdge::last_j);
  joints.continuous = own[0] == next[0];
  for (std::size_t k = 0; k < 4; ++k) {
    Form sum = own[1].at(k);
    add_weighted(sum, Function(1), next[1].at(k));
    add_weighted(sum, Function(-2), own[0].at(k));
    joints.smooth.at(k) = sum == Form{};
  }
  return joints;
}

// ---- Shapes on the family of nets

constexpr unsigned seed = 20090910;
constexpr int nets = 40;

Verdict verdict(bool holds) { return holds ? Verdict::consistent : Verdict::inconsistent; }

Claim share(const char* id, int count, std::string note) {
  constexpr int believed = 3;
  return settle_as(claim(id), verdict(2 * count > nets),
                   approximate(static_cast<double>(count) / nets, believed, "floating point"),
                   fmt::format("{} of {} nets. {}", count, nets, note));
}

std::string shown(double x) {
  constexpr int digits = 6;
  return to_significant(Rational::from_double(x), digits);
}

void add_shapes(Results& results) {
  const std::array<std::pair<Rational, std::size_t>, 4> speeds{
      {{{1, 2}, 6}, {{3, 4}, 3}, {{7, 8}, 2}, {{63, 64}, 1}}};
  Series spreads{
      "speed-curvature", {"net", "valence", "half", "three_quarters", "seven_eighths", "highest"}, {}};
  Series faults{"speed-faults", {"net", "valence", "half", "three_quarters"}, {}};
  int poorer = 0;
  int milder = 0;
  std::array<double, 4> mean{};
  for (const RingModel& model : convex_nets(seed, nets)) {
    const std::string number = std::to_string(spreads.rows.size() + 1);
    const std::string valence = std::to_string(model.mesh.valence(0));
    std::vector<double> values;
    for (std::size_t k = 0; k < speeds.size(); ++k) {
      values.push_back(curvature_spread(
          model.surface(std::vector<Rational>(speeds.at(k).second, speeds.at(k).first), false)));
      mean.at(k) += values.back() / nets;
    }
    poorer += std::ranges::is_sorted(values) ? 1 : 0;
    spreads.rows.push_back({number, valence});
    for (const double x : values) spreads.rows.back().push_back(shown(x));
    const double half = cap_fault(model.surface({{1, 2}, {1, 2}}, true));
    const double high = cap_fault(model.surface({{3, 4}, {3, 4}}, true));
    milder += high < half ? 1 : 0;
    faults.rows.push_back({number, valence, shown(half), shown(high)});
  }
  results.claims.push_back(share(
      "speed.poor-shape", poorer,
      fmt::format("Means of the spread, times the size of the hole without rings: {:.2f} at 1/2, {:.2f} "
                  "at 3/4, {:.2f} at 7/8, {:.2f} at 63/64.",
                  mean[0], mean[1], mean[2], mean[3])));
  results.claims.push_back(share("speed.fault", milder, "The surfaces of the paper's figure are lost."));
  results.series.push_back(std::move(spreads));
  results.series.push_back(std::move(faults));
}

// ---- Exact numbers of the figures

SpacePoint difference(const SpacePoint& a, const SpacePoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
SpacePoint cross(const SpacePoint& a, const SpacePoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Rational dot(const SpacePoint& a, const SpacePoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// The greatest tan^2 of an angle between neighbours' normals at the vertex.
Rational fault_at_vertex(const SectorNet<SpacePoint>& net, const Rational& sigma) {
  const std::vector<Rational> speeds{sigma, sigma};
  const auto steps = speed_steps<Rational>(speeds);
  const auto rings = nested_rings<SpacePoint, Rational>(
      net, steps, [&](std::size_t /*k*/) { return vertex_weights(sigma, net.valence()); });
  const SpacePoint limit = vertex_point(net, uniform_limit_weights<Rational>(net.valence()));
  std::vector<SpacePoint> normals;
  constexpr std::size_t before_i = 11;  // (2, 3)
  constexpr std::size_t before_j = 14;  // (3, 2)
  for (const auto& border : rings.hole)
    normals.push_back(cross(difference(limit, border[before_i]), difference(limit, border[before_j])));
  Rational greatest(0);
  for (std::size_t l = 0; l < normals.size(); ++l) {
    const SpacePoint& a = normals[l];
    const SpacePoint& b = normals[(l + 1) % normals.size()];
    const SpacePoint sine = cross(a, b);
    greatest = std::max(greatest, dot(sine, sine) / (dot(a, b) * dot(a, b)));
  }
  return greatest;
}

void add_faults(Results& results) {
  const MeshFile file = read_mesh(data_folder() / "speed-blend.obj");
  const MeshTopology mesh = surface_of(file);
  std::vector<SpacePoint> points;
  const std::vector<int> around = fan_vertices(mesh, mesh.outgoing(0), 2).value();
  for (const int v : around) {
    SpacePoint& p = points.emplace_back();
    for (std::size_t d = 0; d < p.size(); ++d)
      p[d] = Rational::from_double(file.points[static_cast<std::size_t>(v)][d]);
  }
  const SectorNet<SpacePoint> net(mesh.valence(0), std::move(points));
  const RingModel model{mesh, file.points};
  for (const auto& [id, sigma] :
       {std::pair{"figure.speed.1.half", Rational(1, 2)}, {"figure.speed.1.high", Rational(3, 4)}}) {
    results.claims.push_back(
        settle(claim(id), exact(fault_at_vertex(net, sigma), "rational arithmetic"),
               fmt::format("Along the edges of the cap the angle is at most {:.2f} degrees (computed).",
                           cap_fault(model.surface({sigma, sigma}, true)))));
  }
}

/// Where the outermost corner of the last border of the flat regular net (a, b) lies, times -1 the distance.
bool widths_are_products() {
  const std::array speeds{Rational(1, 4), Rational(1, 2), Rational(3, 4)};
  constexpr std::array<std::array<int, 2>, 4> spokes{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  std::vector<Rational> points{Rational(0)};
  for (std::size_t k = 0; k < 4; ++k) {
    for (const FanPlace& p : sector_places(4, 2))
      points.emplace_back(p.a * spokes.at(k)[0] + p.b * spokes.at((k + 1) % 4)[0]);
  }
  const SectorNet<Rational> net(4, std::move(points));
  bool holds = true;
  constexpr int most = 27;
  for (int m = 1; m <= 3; ++m) {
    for (int code = 0; code < most; ++code) {
      std::vector<Rational> chosen;
      Rational width(1);
      for (int k = 0, rest = code; k < m; ++k, rest /= 3) {
        chosen.push_back(speeds.at(static_cast<std::size_t>(rest % 3)));
        width *= Rational(1) - chosen.back();
      }
      const auto steps = speed_steps<Rational>(chosen);
      const auto rings = nested_rings<Rational, Rational>(
          net, steps, [&](std::size_t k) { return vertex_weights(chosen[k], 4); });
      holds = holds && rings.hole[0][0] == width;
    }
  }
  return holds;
}

bool counts_agree() {
  bool same = true;
  constexpr int most = 40;
  for (int n = 3; n <= most; ++n) {
    same = same && fan_topology(4, n, 3).vertices() == 1 + 12 * n &&
           fan_topology(4, n, 2).vertices() == 1 + static_cast<int>(SectorNet<Rational>::places) * n;
  }
  return same && refined_places(Rational(1, 2)).size() == 12;
}

bool steps_mimic_catmull_clark() {
  const std::vector<SectorStencil<Function>> rules = refined_places(Function::variable(0));
  constexpr int most = 40;
  bool same = true;
  for (int n = 3; n <= most; ++n) same = same && mimics_catmull_clark(n, rules);
  return same;
}

}  // namespace

std::span<const ClaimHead> speed_ring_heads() { return table; }

RingJoints ring_joints(const RationalFunction& sigma, const FormNet<RationalFunction>& refined) {
  const Function q = Function(1) - sigma;
  const RingRules<Function> rules = ring_rules(sigma);
  const auto border = border_points<Function>(FormNet<Function>(), rules, 0);
  const auto inner = border_points<Function>(refined, rules, 0);
  const RingSector<Form> ring = ring_sector(border, inner, sigma);
  BezierPatch<Form> beyond{};  // forms of sector k are turned by k
  std::ranges::transform(ring.first_side, beyond.begin(), [](const Form& f) { return turned(f, 1); });
  const auto joins = [](const BezierPatch<Form>& one, PatchEdge edge, const Function& width,
                        const BezierPatch<Form>& other, PatchEdge other_edge, const Function& other_width) {
    return joins_c2(edge_layers(one, edge), width, edge_layers(other, other_edge), other_width);
  };
  return {.inside = joins(ring.corner, PatchEdge::last_j, sigma, ring.first_side, PatchEdge::first_j, q) &&
                    joins(ring.corner, PatchEdge::last_i, sigma, ring.next_side, PatchEdge::first_i, q),
          .sectors = joins(ring.next_side, PatchEdge::last_i, q, beyond, PatchEdge::last_j, q),
          .inwards = joins(ring.first_side, PatchEdge::last_i, sigma, inner, PatchEdge::first_i, q) &&
                     joins(ring.next_side, PatchEdge::last_j, sigma, inner, PatchEdge::first_j, q)};
}

Results run_speed_rings() {
  Results results;
  const Function s = Function::variable(0);
  const RingJoints joints = ring_joints(s, step_of_speed(s, {Function::variable(1), Function::variable(2)}));
  results.claims.push_back(settle_statement(
      claim("speed.combinatorial"), steps_mimic_catmull_clark(), "the same vertices, edges and faces",
      "From the second ring on the step reads fewer points than Catmull-Clark's."));
  results.claims.push_back(settle_statement(claim("speed.rings.c2"), joints.all() && border_is_kept(), "true",
                                            "For any weights of the vertex, whatever the speeds."));
  const CapJoints cap = cap_joints();
  results.claims.push_back(settle_statement(
      claim("speed.completion"),
      cap.outwards && cap.continuous && cap.smooth == std::array<bool, 4>{true, true, true, false},
      "C2 outwards, C0 inside",
      "Normals differ across the inner edges near the vertex in general: speed.fault measures by how much."));
  add_shapes(results);
  add_faults(results);
  results.claims.push_back(settle_statement(claim("figure.speed.6"), counts_agree(), "1 + 12 n and 1 + 6 n"));
  results.claims.push_back(
      settle_statement(claim("figure.speed.9"), widths_are_products(), "(1 - sigma_1) .. (1 - sigma_m)"));
  add_speed_ring_figures(results);
  return results;
}

}  // namespace subdiv
