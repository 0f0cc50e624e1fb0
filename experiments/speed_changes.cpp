#include <array>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "experiments/speed_parts.h"
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

}  // namespace

std::vector<ClaimHead> speed_change_heads() {
  const auto printed = [](std::string id, std::string section, std::string text, std::string definition) {
    return ClaimHead{std::move(id),   "speed",          std::move(section),
                     std::move(text), ClaimKind::exact, std::move(definition)};
  };
  const std::string capped =
      "The ring between a Catmull-Clark net, converted by (11), and one step of adjustable speed with (1): "
      "limits "
      "for sigma -> 1 of its weights over Q(sigma, n), for all valences. ";
  return {
      printed("speed.eq10.matching", "V-A, equation (10)",
              "By matching the BB representation of a Catmull-Clark net with the BB representation in Figure "
              "4 (b)",
              "The 15 coefficients that (13) gives for the net of (11), against the bicubic Bezier "
              "coefficients of "
              "the Catmull-Clark net (uniform B-splines), over Q(sigma) and for all valences."),
      printed(
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
      printed("speed.limit-speed.border", "IV",
              "in the limit σ → 1, we obtain .. a finite bi-3 cap consisting of the bi-3 tensor-border",
              capped + "All coefficients of the corner patch but that at the vertex."),
      printed("speed.limit-speed.centre", "IV", "plus the central limit point of Catmull-Clark-subdivision",
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
