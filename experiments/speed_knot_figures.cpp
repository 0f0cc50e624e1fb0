#include <array>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "analysis/adjustable_speed/sector_form.h"
#include "experiments/speed_figure_parts.h"
#include "schemes/evaluate/bezier_patch.h"

namespace subdiv {
namespace {

using Function = RationalFunction;
using Line = std::vector<Spot>;

const Function s = Function::variable(0);
const Function q = Function(1) - s;

using Form = SectorForm<Function>;
using Net = FormNet<Function>;
using Border = BezierPatch<Form>;

Spot rounded(const SymbolicPoint& p, const Rational& sigma, Spot origin, double scale) {
  const std::array<Rational, 1> at{sigma};
  const auto value = [&](const Function& f) { return f.evaluate(std::span<const Rational>(at)).to_double(); };
  return origin + scale * Spot{value(p[0]), value(p[1])};
}

void draw_derivation(Results& results, const BezierPatch<SymbolicPoint>& border,
                     const RingSector<SymbolicPoint>& ring) {
  const Rational sigma(2, 5);
  const double rest = 0.6;
  const double outer = 1 / rest;
  const double size = 3.4;  // of each picture
  const double outer_unit = size / outer;
  const std::array<Spot, 4> origins{{{0, 4.9}, {5.2, 4.9}, {10.4, 4.9}, {2.6, 0}}};
  const auto at = [&](std::size_t panel, double x, double y) {
    return origins.at(panel) + (panel < 2 ? outer_unit : size) * Spot{x, y};
  };
  PlaneDiagram diagram("speed-derivation", "From the net of a sector to its ring, speed 2/5");
  std::vector<NamedSpot> given;
  std::vector<NamedSpot> derived;
  std::vector<NamedSpot> from_refined;
  std::vector<Line> boxes;
  const auto box = [&](std::size_t panel, Spot low, Spot high) {
    boxes.push_back({at(panel, low.x, low.y), at(panel, high.x, low.y), at(panel, high.x, high.y),
                     at(panel, low.x, high.y), at(panel, low.x, low.y)});
  };
  // (a) On the patches outside [0, a]^2 the three layers nearest to it.
  const std::array<double, 3> layers{1, 1 + (outer - 1) / 3, 1 + 2 * (outer - 1) / 3};
  for (const std::size_t panel : {0U, 1U}) {
    for (const double x : layers) {
      for (const double y : {0.0, 1.0 / 3, 2.0 / 3}) {
        given.push_back({"", at(panel, x, y)});
        given.push_back({"", at(panel, y, x)});
      }
      for (const double y : layers) given.push_back({"", at(panel, x, y)});
    }
    box(panel, {1, 0}, {outer, 1});
    box(panel, {0, 1}, {1, outer});
    box(panel, {1, 1}, {outer, outer});
  }
  box(1, {0, 0}, {1, 1});
  // (b) The tensor border; (c) its parts; (d) the ring, its innermost layer from the refined net.
  for (std::size_t k = 0; k < 15; ++k)
    derived.push_back({"", rounded(border[k], sigma, origins[1], outer_unit)});
  const auto add_patch = [&](const BezierPatch<SymbolicPoint>& patch, const auto& is_innermost) {
    for (std::size_t k = 0; k < patch.size(); ++k) {
      for (const std::size_t panel : {2U, 3U}) {
        const NamedSpot dot{"", rounded(patch[k], sigma, origins.at(panel), size)};
        if (!is_innermost(k)) {
          derived.push_back(dot);
        } else if (panel == 3) {
          from_refined.push_back(dot);
        }
      }
    }
  };
  add_patch(ring.corner, [](std::size_t k) { return k == 15; });
  add_patch(ring.next_side, [](std::size_t k) { return k % 4 == 3; });
  add_patch(ring.first_side, [](std::size_t k) { return k / 4 == 3; });
  for (const std::size_t panel : {2U, 3U}) {
    box(panel, {0, 0}, {1, 1});
    box(panel, {rest, 0}, {1, rest});
    box(panel, {0, rest}, {rest, 1});
    box(panel, {rest, rest}, {1, 1});
  }
  diagram.add_lines("patches", boxes, style::line);
  diagram.add_dots("given", given, style::pale_dot);
  diagram.add_dots("derived", derived, style::dot);
  diagram.add_dots("refined", from_refined, style::bright_dot);
  constexpr std::array captions{"(a) Bezier form", "(b) extended inwards", "(c) subdivided", "(d) ring"};
  constexpr double below = -0.55;
  for (std::size_t panel = 0; panel < captions.size(); ++panel)
    diagram.add_text(captions.at(panel), origins.at(panel) + Spot{size / 2, below});

  const Spot star{10.4, 1.2};  // the vertex's rule
  constexpr double edge = 1.05;
  constexpr double outside = 1.4;
  std::vector<Line> faces;
  std::vector<NamedSpot> dots{{"", star}};
  for (int k = 0; k < drawn_valence; ++k) {
    const auto spot = [&](double a, double b) { return in_sector(star, k, edge * a, edge * b); };
    faces.push_back({star, spot(1, 0), spot(1, 1), spot(0, 1)});
    dots.push_back({"", spot(1, 0)});
    dots.push_back({"", spot(1, 1)});
    diagram.add_text("β/n", spot(outside + 0.15, 0));
    diagram.add_text("γ/n", spot(outside - 0.05, outside - 0.05));
  }
  diagram.add_text("α", in_sector(star, 0, 0.28, 0.28));
  diagram.add_lines("faces", faces, style::line);
  diagram.add_dots("rule", dots, style::dot);
  diagram.add_text("rule of the vertex", {star.x, below - 0.8});
  diagram.add_to(results, {"figure.speed.4"});
}

}  // namespace

void add_speed_knot_lines(Results& results, std::span<const ClaimHead> heads) {
  const RingRules<Function> rules = ring_rules(s);
  const Net refined = step_of_speed<Function>(s, {Function::variable(1), Function::variable(2)});
  const Border border = border_points<Function>(Net(), rules, 0);
  const Border inner = border_points<Function>(refined, rules, 0);
  const auto& [corner, next_side, first_side] = ring_sector(border, inner, s);
  const RingSector<Form> beyond =
      ring_sector(border_points<Function>(Net(), rules, 1), border_points<Function>(refined, rules, 1), s);
  const auto joined = [](const Border& one, PatchEdge edge, const Function& width, const Border& other,
                         PatchEdge other_edge, const Function& other_width) {
    return joins_c2(edge_layers(one, edge), width, edge_layers(other, other_edge), other_width);
  };
  // inner is the polynomial over [0, qa]^2 but for its coefficient at the vertex, which no layer has.
  const bool c2 = joined(corner, PatchEdge::last_i, s, next_side, PatchEdge::first_i, q) &&
                  joined(corner, PatchEdge::last_j, s, first_side, PatchEdge::first_j, q) &&
                  joined(next_side, PatchEdge::last_i, q, beyond.first_side, PatchEdge::last_j, q) &&
                  joined(first_side, PatchEdge::last_i, s, inner, PatchEdge::first_i, q) &&
                  joined(next_side, PatchEdge::last_j, s, inner, PatchEdge::first_j, q);
  results.claims.push_back(settle_statement(head(heads, "figure.speed.3"), c2, "C2, for all σ, β, γ and n"));

  constexpr double rest = 0.6;  // q; speed 2/5
  constexpr int steps = 4;
  constexpr double size = 2.6;
  std::vector<double> at{size};
  for (int k = 0; k < steps; ++k) at.push_back(at.back() * rest);
  PlaneDiagram diagram("speed-knots", "Knot lines of adjustable speed subdivision, speed 2/5, four steps");
  const Spot right{6.6, -0.15};
  std::vector<Line> lines;
  std::vector<Line> rings;
  for (const double a : at) {
    for (const double x : {-a, a}) {
      lines.push_back({{x, -size}, {x, size}});
      lines.push_back({{-size, x}, {size, x}});
    }
    rings.push_back({{-a, -a}, {a, -a}, {a, a}, {-a, a}, {-a, -a}});
  }
  lines.push_back({{0, -size}, {0, size}});
  lines.push_back({{-size, 0}, {size, 0}});
  std::vector<Line> patches;
  constexpr double scale = 0.72;  // the corners of five sectors reach further out
  for (int k = 0; k < drawn_valence; ++k) {
    const auto spot = [&](double a, double b) { return in_sector(right, k, scale * a, scale * b); };
    for (std::size_t i = 0; i < at.size(); ++i) {
      rings.push_back({spot(at[i], 0), spot(at[i], at[i]), spot(0, at[i])});
      if (i == 0) continue;
      patches.push_back({spot(at[i - 1], at[i]), spot(at[i], at[i]), spot(at[i], at[i - 1])});
    }
    patches.push_back({spot(size, 0), spot(0, 0)});
  }
  diagram.add_lines("tensored", lines, style::thin);
  diagram.add_lines("patches", patches, style::line);
  diagram.add_lines("rings", rings, style::thick);
  diagram.add_dots("nodes", {{"", {0, 0}}, {"", right}}, style::bright_dot);
  diagram.add_text("tensored, n = 4", {0, -3.1});
  diagram.add_text("around a node with n = 5", {right.x, -3.1});
  diagram.add_to(results, {"figure.speed.3"});
}

void add_speed_derivation(Results& results, std::span<const ClaimHead> heads) {
  const RingRules<Function> rules = ring_rules(s);
  const SectorNet<SymbolicPoint> net = mean_net();
  const auto refined = refined_net(net, rules, vertex_weights(s, 4));
  const BezierPatch<SymbolicPoint> border = border_points(net, rules, 0);
  const BezierPatch<SymbolicPoint> inner = border_points(refined, rules, 0);
  const auto ring = ring_sector(border, inner, s);
  const Function one(1);
  const bool even =
      equal_steps(border, {one, one}, {one, one}, 15) && equal_steps(ring.corner, {one, one}, {s, s}, 16) &&
      equal_steps(ring.next_side, {q, one}, {q, s}, 16) && equal_steps(ring.first_side, {one, q}, {s, q}, 16);
  results.claims.push_back(
      settle_statement(head(heads, "figure.speed.4"), even, "3 patches of 16 points at equal steps"));

  draw_derivation(results, border, ring);
}

}  // namespace subdiv
