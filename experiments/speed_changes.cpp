#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "experiments/speed_parts.h"
#include "schemes/algebra/univariate.h"
#include "schemes/evaluate/surface_ring.h"

namespace subdiv {
namespace {

using Function = RationalFunction;
using Net = FormNet<Function>;
using Form = SectorForm<Function>;
using Border = BezierPatch<Form>;
using speed_variables::sigma;
using speed_variables::tau;
using speed_variables::valence;

const Function& s = sigma;
const Function q = Function(1) - s;

std::string text(const Function& f) { return f.to_factored_string(speed_variables::names); }

Border border_of(const Net& net, const Function& speed) {
  return border_points<Function>(net, ring_rules(speed), 0);
}

/// The bicubic Bezier coefficients of a Catmull-Clark net on the face of sector 0, (3, 3) left out: products
/// of (1, 4, 1)/6, (2, 1)/3, (1, 2)/3, (1, 4, 1)/6.
Border uniform_border() {
  const auto sixths = [](int a, int b, int c, int d) {
    return LineWeights<Function>{fraction<Function>(a, 6), fraction<Function>(b, 6), fraction<Function>(c, 6),
                                 fraction<Function>(d, 6)};
  };
  const std::array rows{sixths(0, 1, 4, 1), sixths(0, 2, 4, 0), sixths(0, 4, 2, 0), sixths(1, 4, 1, 0)};
  Border result{};
  for (std::size_t k = 0; k < 15; ++k)
    result[k] = apply(tensor_stencil(rows.at(k / 4), rows.at(k % 4)), Net(), 0);
  return result;
}

/// The weights at sigma = 1.
Form at_one(const Form& form) {
  const std::vector<Function> point{Function(1), speed_variables::beta, speed_variables::gamma, valence, tau};
  const auto value = [&](const Function& f) { return f.evaluate(std::span<const Function>(point)); };
  Form result;
  result.vertex = value(form.vertex);
  for (const auto& [place, w] : form.mean) add_to_weight(result.mean, place, value(w));
  for (const auto& [place, w] : form.at) add_to_weight(result.at, place, value(w));
  return result;
}

std::string rows_text(const std::array<LineWeights<Function>, 3>& rows) {
  std::string result;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    result += fmt::format("{}P'_{} =", i == 1 ? "" : "; ", i);
    bool first = true;
    for (std::size_t k = rows[i].size(); k-- > 0;) {
      if (rows[i][k].is_zero()) continue;
      result += fmt::format("{} [{}] P_{}", first ? "" : " +", text(rows[i][k]), static_cast<int>(k) - 1);
      first = false;
    }
  }
  return result;
}

/// The largest speed up to which no weight of (11) is negative, if there is such a one: every weight keeps
/// its sign between the roots of all.
std::optional<Algebraic> convex_up_to() {
  std::vector<UnivariatePolynomial> weights;  // over positive denominators, powers of q
  std::vector<Algebraic> roots;
  for (const auto& stencil : changed_places(uniform_knots<Function>(), unit_speed_knots(s))) {
    std::vector<Function> all{stencil.centre};
    for (const auto& term : stencil.terms) all.push_back(term.weight);
    for (const Function& w : all) {
      if (w.is_zero()) continue;
      weights.emplace_back(w.numerator() * w.denominator(), 0);
      for (const RealRoot& root : real_roots(weights.back())) {
        if (Algebraic(0) < root.value && root.value < Algebraic(1)) roots.push_back(root.value);
      }
    }
  }
  std::sort(roots.begin(), roots.end());
  roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
  std::optional<Algebraic> end;
  bool ended = false;
  for (std::size_t k = 0; k <= roots.size(); ++k) {
    const Interval low = k == 0 ? Interval(0) : roots[k - 1].to_interval();
    const Interval high = k == roots.size() ? Interval(1) : roots[k].to_interval();
    const Rational inside = (low.midpoint() + high.midpoint()) / Rational(2);
    const bool convex =
        std::ranges::none_of(weights, [&](const auto& w) { return w.evaluate(inside).sign() < 0; });
    if (convex && ended) return std::nullopt;  // not up to one speed
    if (!convex) ended = true;
    if (convex && k < roots.size()) end = roots[k];
  }
  return end;
}

using Values = std::array<Function, 25>;

/// A regular vertex whose 25 control points are independent.
SectorNet<Values> regular_net() {
  std::vector<Values> points(25);
  for (std::size_t k = 0; k < points.size(); ++k) points[k][k] = Function(1);
  return {4, std::move(points)};
}

/// The point P_(i, j), from -1 to 2, of a regular net.
const Values& regular_point(const SectorNet<Values>& net, int i, int j) {
  const SectorPlace at = i < 0 && j < 0 ? SectorPlace{2, sector_place(-j, -i).place} : sector_place(i, j);
  return at.place < 0 ? net.centre() : net.at(at.sector, at.place);
}

/// Coefficients of a sector's three patches that depend on the weights of the refined vertex.
std::size_t coefficients_of_the_vertex_rule() {
  const Net step = step_of_speed<Function>(s, {speed_variables::beta, speed_variables::gamma});
  const RingSector<Form> ring = ring_sector(border_of(Net(), s), border_of(step, s), s);
  const auto depends = [](const Form& form) {
    const auto uses = [](const Function& f) {
      return !f.derivative(1).is_zero() || !f.derivative(2).is_zero();  // beta, gamma
    };
    const auto weight_uses = [&](const auto& entry) { return uses(entry.second); };
    return uses(form.vertex) || std::ranges::any_of(form.mean, weight_uses) ||
           std::ranges::any_of(form.at, weight_uses);
  };
  std::size_t count = 0;
  for (const auto* patch : {&ring.corner, &ring.first_side, &ring.next_side})
    count += static_cast<std::size_t>(std::ranges::count_if(*patch, depends));
  return count;
}

/// At a regular vertex: the patches of the ring are the spline's own, by its polar form over [qa, a] and [0,
/// qa], though only the tensor borders (13) of the net and of the refined one go in.
bool ring_is_the_spline() {
  using Line = KnotLine<Function>;
  const Line line(unit_speed_knots(s), {q});
  using Rows = std::array<LineWeights<Function>, 4>;
  const Rows outer{
      line.polar(Line::first, Line::first, Line::first), line.polar(Line::first, Line::first, Line::other),
      line.polar(Line::first, Line::other, Line::other), line.polar(Line::other, Line::other, Line::other)};
  const Rows inner{outer[3], line.polar(Line::zero, Line::other, Line::other),
                   line.polar(Line::zero, Line::zero, Line::other),
                   line.polar(Line::zero, Line::zero, Line::zero)};
  const SectorNet<Values> net = regular_net();
  const auto is_product = [&](const BezierPatch<Values>& patch, const Rows& along, const Rows& across) {
    bool same = true;
    for (std::size_t k = 0; k < patch.size(); ++k) {
      Values sum{};
      for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j)
          add_weighted(sum, Function(along.at(k / 4)[i] * across.at(k % 4)[j]),
                       regular_point(net, static_cast<int>(i) - 1, static_cast<int>(j) - 1));
      }
      same = same && patch[k] == sum;
    }
    return same;
  };
  const RingRules<Function> rules = ring_rules(s);
  const RingSector<Values> ring =
      ring_sector(border_points(net, rules, 0),
                  border_points(refined_net(net, rules, vertex_weights(s, 4)), rules, 0), s);
  return is_product(ring.corner, outer, outer) && is_product(ring.next_side, inner, outer) &&
         is_product(ring.first_side, outer, inner);
}

}  // namespace

std::vector<ClaimHead> speed_change_heads() {
  const std::string capped =
      "The ring between a Catmull-Clark net, converted by (11), and one step of adjustable speed with (1): "
      "limits "
      "for sigma -> 1 of its weights over Q(sigma, n), for all valences. ";
  return {
      speed_head(
          "speed.eq10.matching", "V-A, equation (10)",
          "By matching the BB representation of a Catmull-Clark net with the BB representation in Figure "
          "4 (b)",
          "The 15 coefficients that (13) gives for the net of (11), against the bicubic Bezier "
          "coefficients of "
          "the Catmull-Clark net (uniform B-splines), over Q(sigma) and for all valences."),
      speed_head(
          "speed.change", "IV", "At any subdivision step, σ can be changed",
          "The net is changed from the knots of sigma to those of tau; the tensor border (13) of either net, "
          "and the limit point with the weights (1) of either speed, over Q(sigma, tau, n), for all "
          "valences."),
      finding(
          "speed.change.formula", "speed IV",
          "The change of a net from the speed sigma to tau, which the paper does not give, along a line: P_0 "
          "at the vertex and P_1, P_2 outwards over the knots 0, 1, 1/q, 1/q^2, q = 1 - sigma. Points of the "
          "net are tensor products."),
      finding("speed.change.none", "speed IV",
              "Without such a change: does the tensor border of a net depend on the speed?"),
      finding("speed.eq11.convex", "speed V-A, equation (11)",
              "The largest sigma up to which no weight of (11) is negative: up to there the converted net "
              "lies in "
              "the convex hull of the Catmull-Clark net."),
      speed_head(
          "speed.appendix", "V",
          "Only the formulas of Appendix V-C are needed to output nested surface rings in BB form",
          "Read: of the appendix's formulas (10) to (13), only (13). The three patches of a sector from "
          "(13), "
          "for the net and for the one refined by (1) to (3), and de Casteljau's algorithm, at a regular "
          "vertex with 25 independent control points: against the spline's Bezier coefficients by its polar "
          "form, over Q(sigma). For other valences: figure.speed.3."),
      finding(
          "speed.appendix.alone", "speed V",
          "Read: no formulas at all but (13). With any weights beta and gamma of the refined vertex, over "
          "Q(sigma, beta, gamma) and for all valences: the coefficients of a ring's sector that depend on "
          "beta or gamma, which V-C does not contain."),
      speed_head("speed.limit-speed.border", "IV",
                 "in the limit σ → 1, we obtain .. a finite bi-3 cap consisting of the bi-3 tensor-border",
                 capped + "All coefficients of the corner patch but that at the vertex."),
      speed_head("speed.limit-speed.centre", "IV",
                 "plus the central limit point of Catmull-Clark-subdivision",
                 capped + "The coefficient of the corner patch at the vertex."),
  };
}

void add_speed_changes(Results& results, std::span<const ClaimHead> heads) {
  const auto statement = [&](const char* id, bool holds, std::string found, std::string note = "") {
    results.claims.push_back(settle_statement(head(heads, id), holds, std::move(found), std::move(note)));
  };
  const Net converted = change_of_knots(uniform_knots<Function>(), unit_speed_knots(s));
  const Border own = border_of(converted, s);
  statement("speed.eq10.matching", own == uniform_border(), "the same 15 coefficients");

  const Net changed = change_of_knots(unit_speed_knots(s), unit_speed_knots(tau));
  const Border before = border_of(Net(), s);
  statement(
      "speed.change",
      before == border_of(changed, tau) &&
          substituted(printed_limit(tau, printed_vertex_weights(tau)), changed) ==
              printed_limit(s, printed_vertex_weights(s)),
      "tensor border and limit point stay",
      "If the net is changed with it: its control points belong to the knots of one speed. The paper gives "
      "no formula; speed.change.formula is one.");
  statement("speed.change.formula", true,
            rows_text(changed_rows(unit_speed_knots(s), unit_speed_knots(tau))));
  statement("speed.change.none", !(before[0] == border_of(Net(), tau)[0]), "yes",
            "Its outermost corner t00 already does: rings of different speeds would not even be continuous.");

  if (const std::optional<Algebraic> end = convex_up_to())
    results.claims.push_back(settle(head(heads, "speed.eq11.convex"), exact(*end, "exact real roots"),
                                    "Beyond, and at every higher speed, points of the converted net are "
                                    "extrapolated, the farther the faster: the weight of p11 in p7 is "
                                    "1/(36 σ̄^6)."));
  statement("speed.appendix", ring_is_the_spline(), "the spline's own coefficients",
            "None of (10) to (12) is used. But (13) is applied to the refined net too, and its rules (1) to "
            "(3) are not in V-C: taken literally the sentence is false (speed.appendix.alone).");
  const std::size_t open = coefficients_of_the_vertex_rule();
  statement("speed.appendix.alone", open > 0, fmt::format("{} of 48 coefficients", open),
            "They lie on the ring's inner border, which (13) gives for the refined net alone.");

  const Net step = composed(step_of_speed(s, printed_vertex_weights(s)), converted);
  const RingSector<Form> ring = ring_sector(own, border_of(step, s), s);
  bool border = true;
  const Border wanted = uniform_border();
  for (std::size_t k = 0; k < 15; ++k) border = border && at_one(ring.corner[k]) == wanted[k];
  const Form centre = at_one(ring.corner[15]);
  statement("speed.limit-speed.border", border, "the tensor border of the Catmull-Clark net");
  statement("speed.limit-speed.centre", centre == catmull_clark_limit(), "n/(n+5), 4/(n+5), 1/(n+5)",
            "Weights of the vertex, of the mean of its edge neighbours and of that of the face neighbours.");
}

}  // namespace subdiv
