#include "experiments/speed_rules.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "analysis/sign_on_interval.h"
#include "experiments/speed_parts.h"
#include "experiments/speed_printed.h"
#include "schemes/adjustable_speed/speed_rules.h"

namespace subdiv {
namespace {

using Function = RationalFunction;
using Row = LineWeights<Function>;

const std::string knots =
    "Knots 0, +-a, +-a/q, +-a/q^2 in each direction, q = 1 - sigma; a step inserts +-qa. ";
const std::string over_sigma = " Over Q(sigma).";

std::vector<ClaimHead> make_table() {
  std::vector<ClaimHead> table{
      speed_head("speed.ratio", "abstract and II",
                 "partitions the neighborhood of an extraordinary point in the ratio σ : 1−σ",
                 knots + "The lengths of [qa, a] and [0, qa]."),
      speed_head(
          "speed.geometric", "II", "the knot intervals for fixed σ show a geometric progression",
          knots + "Lengths of the intervals between neighbouring knots after three steps, from outside."),
      speed_head("speed.recursive", "II", "knot ratios σ^2, σσ̄, σ̄σ, σ̄^2 in the second step",
                 "An interval split in the ratio sigma : q, and both parts again." + over_sigma),
      speed_head(
          "speed.steps", "II, steps [1] to [4]",
          "Convert p to bi-3 BB form; extend C2 inwards; subdivide with ratio σ : σ̄; revert to p̃",
          knots +
              "These steps along a line of control points: Bezier coefficients on [a, a/q], those on [0, a] "
              "with the same derivatives up to the second at a, de Casteljau's algorithm at qa, control "
              "points over the refined knots; against knot insertion." +
              over_sigma),
      speed_head("speed.eq3", "II, equation (3)", "the non-zero w^ij_k are given by e1, e2 and w",
                 "The table of weights."),
      finding("speed.eq3.table", "speed II, equation (3)",
              "The non-zero weights w^ij_k for k = 2 .. 7 of one step: tensor products of knot insertion. " +
                  knots + "Others follow from the stated symmetries; p1 has the weights of (1)."),
      speed_head("speed.eq3.e1", "II", "e1 := σ^2 + σ̄",
                 "The weight of the vertex's own control point when qa and -qa are inserted." + over_sigma),
      speed_head("speed.eq3.e2", "II", "e2 := σ^2 + 3 σ̄",
                 "1/sigma times the weight of P_1 in P'_2 when qa is inserted." + over_sigma),
      finding("speed.eq3.sums", "speed II, equations (2) to (4)",
              "The sum of the weights of each refined point, k = 1 .. 13, for all sigma, beta, gamma."),
      finding("speed.eq3.positive", "speed II, equations (1) to (4)",
              "Signs of all weights for all sigma in (0, 1) and all valences n >= 3, those of (1) included."),
      speed_head("speed.eq2.bisectrix.6", "II", "w^ij_6 = w^ji_4",
                 "Weights of the refined points 4 and 6." + over_sigma),
      speed_head("speed.eq2.bisectrix.3-7", "II", "w^ij_k = w^ji_k, k = 3, 7",
                 "Weights of the refined points 3 and 7." + over_sigma),
      speed_head("speed.eq2.ray", "II", "w^i4_k = w^i2_k, k = 2, 5, 8",
                 "Weights of the refined points 2, 5 and 8." + over_sigma),
      speed_head("speed.eq4.mirrored", "II, equation (4)", "w^ij_{11+k} = w^ji_{11−k}, k = 1, 2",
                 "Weights of the refined points 9, 10, 12 and 13." + over_sigma),
      speed_head("speed.eq4.complete", "II, equation (4)",
                 "the 'outer' refined control points with refinement rules (4)",
                 "The printed weights of the refined points 8 .. 13 and those that follow by the symmetries, "
                 "against all that are not 0." +
                     over_sigma),
      speed_head("speed.eq4.next", "II, equation (4)", "need not be considered for the next subdivision step",
                 "The points that the rules of 1 .. 7 and of the third ring, 8 .. 13, read."),
      speed_head(
          "speed.eq11.complete", "V-A, equation (11)",
          "nonzero entries are given below unless they follow from bisectrix symmetry or sector symmetry",
          "The printed weights of k = 1 .. 7 and those that follow, against all that are not 0." +
              over_sigma),
      speed_head(
          "speed.eq13.complete", "V-C, equation (13)",
          "nonzero entries are given in (13) unless they follow from bisectrix symmetry or sector symmetry",
          "The printed weights, w^33_22 read for w^33_2, and those that follow, against all that are not 0." +
              over_sigma),
      speed_head("speed.eq13.bisectrix", "V-C", "w̄^rs_ij = w̄^sr_ji",
                 "All weights of the tensor border." + over_sigma),
      speed_head("speed.eq13.sector", "V-C", "w̄^4s_3j = w̄^2s_3j",
                 "All weights of the tensor border." + over_sigma),
      speed_head("speed.eq13.factor", "V-C", "1/(1 + σ̄)^2",
                 "1 over the sum of the printed weights of a Bezier coefficient and those that follow by the "
                 "symmetries." +
                     over_sigma),
      speed_head("speed.doo-sabin", "IV",
                 "an adjustable-speed variant of Doo-Sabin subdivision has been derived",
                 "The variant's rules."),
  };
  for (std::vector<ClaimHead> part : {printed_weight_heads(), speed_limit_heads(), speed_change_heads()})
    table.insert(table.end(), part.begin(), part.end());
  return table;
}

const std::vector<ClaimHead>& table() {
  static const std::vector<ClaimHead> all = make_table();
  return all;
}

const ClaimHead& claim(const std::string& id) { return head(table(), id); }

Claim statement(const std::string& id, bool holds, std::string found, std::string note = "") {
  return settle_statement(claim(id), holds, std::move(found), std::move(note));
}

const Function& s = speed_variables::sigma;
const Function q = Function(1) - s;

std::string text(const Function& f) { return f.to_factored_string(speed_variables::names); }

// ---- Knots

void add_knots(Results& results) {
  results.claims.push_back(statement("speed.ratio", (Function(1) - q) / q == s / q,
                                     "[qa, a] : [0, qa] = " + text(Function(1) - q) + " : " + greek("q")));
  std::vector<Function> places{Function(1) / (q * q), Function(1) / q, Function(1)};  // from outside, a = 1
  constexpr int steps = 3;
  for (int step = 0; step < steps; ++step) places.push_back(places.back() * q);
  bool geometric = true;
  for (std::size_t i = 2; i < places.size(); ++i)
    geometric = geometric && places[i - 1] - places[i] == q * (places[i - 2] - places[i - 1]);
  results.claims.push_back(statement("speed.geometric", geometric, "ratio σ̄",
                                     "All but the innermost interval [0, q^m a], which is split next."));
  const auto split = [](const std::vector<Function>& lengths) {
    std::vector<Function> parts;
    for (const Function& length : lengths) {
      parts.push_back(length * s);
      parts.push_back(length * q);
    }
    return parts;
  };
  results.claims.push_back(statement(
      "speed.recursive", split(split({Function(1)})) == std::vector<Function>{s * s, s * q, q * s, q * q},
      "σ^2, σσ̄, σ̄σ, σ̄^2", "The adjustable speed step splits the innermost interval alone: σ, σ̄σ, σ̄^2."));
}

// ---- Steps [1] to [4]

Row combined(const Function& a, const Row& x, const Function& b, const Row& y) {
  Row result;
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = a * x[i] + b * y[i];
  return result;
}
/// The affine function with the value v0 at x0 and v1 at x1.
Row on_line(const Function& at, const Function& x0, const Row& v0, const Function& x1, const Row& v1) {
  return combined((x1 - at) / (x1 - x0), v0, (at - x0) / (x1 - x0), v1);
}

/// P'_0 .. P'_3 by the paper's four steps; a = 1.
std::array<Row, 4> rows_by_steps() {
  using Line = KnotLine<Function>;
  const Line line(unit_speed_knots(s));
  const Function zero(0);
  const Function one(1);
  const Function b = one / q;
  // [1] On [a, b] the three coefficients nearest to a: aaa, aab, abb in the notation of polar forms.
  const Row aaa = line.polar(Line::first, Line::first, Line::first);
  const Row aab = line.polar(Line::second, Line::first, Line::first);
  const Row abb = line.polar(Line::second, Line::second, Line::first);
  // [2] Affine in each argument, from a and b to 0; the vertex's coefficient by symmetry.
  const Row aa0 = on_line(zero, one, aaa, b, aab);
  const Row ab0 = on_line(zero, one, aab, b, abb);
  const Row a00 = on_line(zero, one, aa0, b, ab0);
  const Row mirrored{a00[2], a00[1], a00[0], zero};  // a00 has no weight on P_2
  const Row a000 = combined(fraction<Function>(1, 2), a00, fraction<Function>(1, 2), mirrored);
  // [3] De Casteljau at c = qa.
  const Row aac = on_line(q, zero, aa0, one, aaa);
  const Row ac0 = on_line(q, zero, a00, one, aa0);
  const Row c00 = on_line(q, zero, a000, one, a00);
  const Row acc = on_line(q, zero, ac0, one, aac);
  const Row cc0 = on_line(q, zero, c00, one, ac0);
  // [4] Control points over the knots -c, 0, c, a, b.
  return {on_line(zero - q, zero, c00, q, cc0), ac0, on_line(b, q, acc, one, aac),
          on_line(one / (q * q), one, aab, b, abb)};
}

// ---- Tables

bool symmetric_under_swap(const std::string& k, const std::string& other) {
  const auto& rules = refined_by_number();
  bool same = true;
  for (int i = 1; i <= 4; ++i) {
    for (int j = 1; j <= 4; ++j) {
      if (i == 4 && j == 4) continue;
      same = same && weight_of(rules.at(k), 10 * i + j) == weight_of(rules.at(other), 10 * j + i);
    }
  }
  return same;
}

bool symmetric_under_reflection(const std::string& k) {
  const auto& rule = refined_by_number().at(k);
  bool same = true;
  for (int i = 1; i <= 3; ++i) same = same && weight_of(rule, 10 * i + 4) == weight_of(rule, 10 * i + 2);
  return same;
}

void add_table(Results& results) {
  const PrintedTable& recovered = recovered_refinement();
  Series series{"speed-weights", {"k", "ij", "weight", "in powers of s"}, {}};
  const std::vector<std::string> name{"s"};
  std::string rows;
  std::string last;
  bool right = is_complete(recovered);
  for (const PrintedWeight& w : recovered.weights) {
    right = right && holds(recovered, w);
    series.rows.push_back(
        {w.target, std::to_string(w.source), w.text, value_of_text(w.text).to_string(name)});
    rows += (w.target == last ? ", " : fmt::format("{}k = {}: ", rows.empty() ? "" : "; ", w.target)) +
            fmt::format("{}: {}", w.source, greek(w.text));
    last = w.target;
  }
  results.series.push_back(std::move(series));
  results.claims.push_back(statement("speed.eq3.table", right, rows));
  results.claims.push_back(settle_not_reproducible(
      claim("speed.eq3"),
      "The table itself is missing in the copy at hand. All that is printed about it holds "
      "for the weights of speed.eq3.table."));
}

void add_rules(Results& results) {
  const std::array<Row, 4> rows = inserted_rows(s);
  results.claims.push_back(statement("speed.steps", rows_by_steps() == rows, "the same rows P'_0 .. P'_3"));
  add_table(results);
  results.claims.push_back(statement("speed.eq3.e1", value_of_text("e1") == rows[0][1], text(rows[0][1])));
  results.claims.push_back(
      statement("speed.eq3.e2", value_of_text("e2") == rows[2][2] / s, text(rows[2][2] / s)));
  const auto& rules = refined_by_number();
  const FormNet<Function> step = step_of_speed<Function>(s, {speed_variables::beta, speed_variables::gamma});
  const RealInterval speeds = open_interval(Rational(0), Rational(1));
  bool sums = step.centre().sum() == Function(1);
  const VertexWeights<Function> own = printed_vertex_weights(s);
  bool positive = is_positive_at_all_valences(own.beta) && is_positive_at_all_valences(own.gamma) &&
                  is_positive_at_all_valences(Function(1) - own.beta - own.gamma);
  bool inside = true;
  for (const auto& [k, rule] : rules) {
    sums = sums && rule.sum() == Function(1);
    positive = positive && (rule.centre.is_zero() || is_positive(rule.centre, speeds));
    for (const auto& term : rule.terms) {
      positive = positive && is_positive(term.weight, speeds);
      inside = inside && term.place < static_cast<int>(SectorNet<Function>::places);
    }
  }
  results.claims.push_back(statement("speed.eq3.sums", sums, "1"));
  results.claims.push_back(statement("speed.eq3.positive", positive, "all that are not 0 are positive"));
  results.claims.push_back(statement("speed.eq2.bisectrix.6", symmetric_under_swap("4", "6"), "true"));
  results.claims.push_back(statement(
      "speed.eq2.bisectrix.3-7", symmetric_under_swap("3", "3") && symmetric_under_swap("7", "7"), "true"));
  results.claims.push_back(statement(
      "speed.eq2.ray",
      symmetric_under_reflection("2") && symmetric_under_reflection("5") && symmetric_under_reflection("8"),
      "true"));
  results.claims.push_back(statement(
      "speed.eq4.mirrored", symmetric_under_swap("10", "12") && symmetric_under_swap("9", "13"), "true"));
  results.claims.push_back(statement("speed.eq4.complete", is_complete(printed_refinement()), "complete"));
  results.claims.push_back(statement("speed.eq4.next", inside, "the vertex and the first two rings"));
}

// ---- Conversions

void add_conversions(Results& results) {
  results.claims.push_back(statement("speed.eq11.complete", is_complete(printed_conversion()), "complete"));
  PrintedTable corrected = printed_border();
  for (PrintedWeight& w : corrected.weights) {
    if (w.target == "2") w.target = "22";
  }
  results.claims.push_back(statement("speed.eq13.complete", is_complete(corrected), "complete"));
  bool swapped = true;
  bool reflected = true;
  bool factor = true;
  for (const auto& [target, rule] : corrected.rules) {
    const std::string other{target.rbegin(), target.rend()};
    factor = factor && rule.sum() == (Function(1) + q) * (Function(1) + q);
    for (int label = 11; label < 44; ++label) {
      if (label % 10 < 1 || label % 10 > 4) continue;
      const int mirrored = 10 * (label % 10) + label / 10;
      const Function weight = weight_of(rule, label);
      swapped = swapped && weight == weight_of(corrected.rules.at(other), mirrored);
      if (target.front() == '3' && label / 10 == 2 && label % 10 < 4)
        reflected = reflected && weight == weight_of(rule, label + 20);
    }
  }
  results.claims.push_back(statement("speed.eq13.bisectrix", swapped, "true"));
  results.claims.push_back(statement("speed.eq13.sector", reflected, "true"));
  results.claims.push_back(statement("speed.eq13.factor", factor, "1/(σ - 2)^2"));
  results.claims.push_back(
      settle_not_reproducible(claim("speed.doo-sabin"), "The paper gives no formula of the variant."));
}

/// 1 or -1 when p has this sign for all sigma in (0, 1) and n >= 3, as is_positive_at_all_valences sees it.
int sign_at_all_valences(const Polynomial& p) {
  const RealInterval speeds = open_interval(Rational(0), Rational(1));
  constexpr int valence = 3;  // x_3, and the least n
  const std::vector<Polynomial> parts =
      p.substitute(valence, Polynomial::variable(valence) + Polynomial(3)).coefficients_in(valence);
  for (const int sign : {1, -1}) {
    const auto has_sign = [&](const Polynomial& part) {
      return is_positive(Function(Polynomial(sign) * part), speeds);
    };
    if (has_sign(parts.front()) &&
        std::ranges::all_of(parts, [&](const Polynomial& part) { return part.is_zero() || has_sign(part); }))
      return sign;
  }
  return 0;
}

}  // namespace

bool is_positive_at_all_valences(const RationalFunction& f) {
  return sign_at_all_valences(f.numerator()) * sign_at_all_valences(f.denominator()) == 1;
}

std::span<const ClaimHead> speed_rule_heads() { return table(); }

Results run_speed_rules() {
  Results results;
  add_knots(results);
  add_rules(results);
  add_conversions(results);
  add_printed_weights(results, table());
  add_speed_limit(results, table());
  add_speed_changes(results, table());
  return results;
}

}  // namespace subdiv
