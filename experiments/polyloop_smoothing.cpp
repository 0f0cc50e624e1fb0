#include "experiments/polyloop_smoothing.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "analysis/polyloop/limit_shape.h"
#include "analysis/polyloop/transfer_function.h"
#include "experiments/simple_polygons.h"
#include "schemes/algebra/turn.h"
#include "schemes/input_error.h"
#include "schemes/polyloop/apply_operator.h"
#include "schemes/polyloop/operator_sequence.h"

namespace subdiv {
namespace {

const std::string gains =
    "The transfer function of {tuck(s); tuck(-t)} is g = (1 - s x)(1 + t x), x = 1 - cos omega in [0, 2], of "
    "tuck(s) 1 - s x. ";
const std::string on_loops =
    "On closed polyloops of n vertices a step multiplies the part of frequency 2 pi k/n by the transfer "
    "function there. ";
const std::string fixed = "w(z) - 1 for the symbol w of {tuck(s); tuck(-s)}, over Q(s). ";

ClaimHead printed(std::string id, std::string section, std::string text, std::string definition,
                  ClaimKind kind = ClaimKind::exact) {
  return {std::move(id), "polyloops", std::move(section), std::move(text), kind, std::move(definition)};
}
ClaimHead share(std::string id, std::string definition, std::string section = "polyloops 2") {
  ClaimHead result = finding(std::move(id), std::move(section), std::move(definition));
  result.kind = ClaimKind::tendency;
  return result;
}

std::vector<ClaimHead> make_table() {
  std::vector<ClaimHead> table{
      printed("polyloops.tuck.low-pass", "2",
              "tuck(2/3) moves B to the average (A+B+C)/3. This averaging process is a low-pass filter",
              gains + "|g| <= 1 everywhere and below 1 but for omega = 0; the largest |g| on the upper half "
                      "of the frequencies is below 1/2."),
      finding("polyloops.tuck.half-band", "polyloops 2",
              gains + "The s for which the largest |1 - s x| over the upper half of the frequencies, x in "
                      "[1, 2], is least; it is taken at an end."),
      printed(
          "polyloops.tuck.range", "2",
          "A sequence of tuck(s) steps for a value of s in [0,2/3] will eliminate the sharp features of L",
          gains + "|g| < 1 for every frequency but 0, for all s of (0, 2/3]; the end 0 is "
                  "polyloops.tuck.range.end."),
      printed(
          "polyloops.tuck.range.end", "2",
          "A sequence of tuck(s) steps for a value of s in [0,2/3] will eliminate the sharp features of L",
          gains + "The end of the range: |g| < 1 for every frequency but 0, for s = 0."),
      printed(
          "polyloops.tuck.inside", "2",
          "a sequence of tuck(s) steps changes the curve in smooth parts and pulls it inside the turns",
          "Turns of a uniformly sampled circle: for 0 < s < 1 a step takes its radius to r (1 - s (1 - cos "
          "2 pi/n)), by the symbol over Q(s): a smooth curve that is changed, and inwards."),
      printed("polyloops.shrink.quickly", "3", "it will quickly shrink L into a small circle",
              on_loops +
                  "The part k = 1 of n vertices, which lie on an ellipse, is multiplied by 1 - s (1 - cos "
                  "2 pi/n). Quickly: less than half of it is left after ten steps of tuck(1/2), and of "
                  "tuck(2/3), for all n from 3 to 8."),
      printed("polyloops.coarse", "3",
              "If the vertices of the polyloop L form a coarse sampling of some original curve J, then the "
              "smoothing technique discussed above will not make L smoother",
              "Four vertices: a square and a rectangle stay a square and a rectangle, scaled, under tuck(s) "
              "for all s, over Q(s), so that all their angles are what they were."),
      finding("polyloops.tuck.damping", "polyloops 2",
              gains + "The s for which tuck(s) damps every frequency but 0, exactly."),
      finding("polyloops.tuck.stable", "polyloops 2",
              gains + "The s for which tuck(s) amplifies no frequency, exactly."),
      printed("polyloops.shrink.point", "2",
              "a large number of these steps will shrink the whole curve to a point",
              on_loops + "For all 0 < s <= 2/3 and all n: every part but k = 0 tends to 0."),
      finding(
          "polyloops.shrink.centroid", "polyloops 2",
          on_loops + "What tuck(s), 0 < s < 1, leaves as it is on closed polyloops, and keeps as the mean."),
      printed("polyloops.cubic.value", "2", "F(0)=(-A+4B+4D-E)/6",
              "The value at 0 of the cubic through A, B, D, E at -2, -1, 1, 2: Lagrange's weights."),
      printed("polyloops.cubic.outer", "2", "A+E=8b+2d", "F(-2) + F(2) for F(u) = a u^3 + b u^2 + c u + d."),
      printed("polyloops.cubic.inner", "2", "B+D=2b+2d", "F(-1) + F(1) for F(u) = a u^3 + b u^2 + c u + d."),
      printed("polyloops.cubic.difference", "2", "6d=4(B+D)-(A+E)",
              "4 (F(-1) + F(1)) - (F(-2) + F(2)) for F(u) = a u^3 + b u^2 + c u + d."),
      printed(
          "polyloops.push-pull.cubic", "2",
          "the sequence {tuck(2/√6); tuck(–2/√6);}moves each vertex C in the subsequence A,B,C,D,E to its "
          "position F(0)=(–A+4B+4D–E)/6 on the parametric cubic curve F(t)",
          "The composed operator's weights over Q(sqrt(6)) against those of F(0)."),
      printed("polyloops.push-pull.adjust", "2",
              "{adjust(2/√6); adjust(–2/√6);}does indeed move C to (–A+4B+4D–E)/6",
              "Is adjust one of the chapter's operators, refine, dual, tuck, split, tweak? Read as tuck, the "
              "sentence is polyloops.push-pull.cubic."),
      printed("polyloops.push-pull.number", "2", "0.82", "2/sqrt(6).", ClaimKind::rounded),
      printed("polyloops.push-pull.unstable", "2",
              "to large for practical use and will produce instabilities",
              gains + "Is a frequency amplified by {tuck(2/sqrt 6); tuck(-2/sqrt 6)}?"),
      finding("polyloops.push-pull.unstable.gain", "polyloops 2",
              gains + "The largest |g| for s = t = 2/sqrt(6)."),
      finding("polyloops.push-pull.stable", "polyloops 2",
              gains + "The largest s for which {tuck(s); tuck(-s)} amplifies no frequency, exactly."),
      finding("polyloops.push-pull.region", "polyloops 2",
              gains + "For which s, t >= 0 no frequency is amplified: identities over Q[s, t, x]."),
      printed("polyloops.push-pull.towards", "2",
              "{tuck(s); tuck(-s);}moves C towards that F(0) position on the cubic defined by its neighbors",
              "The composed operator's weights less those of C, over Q(s), against F(0) - C."),
      printed(
          "polyloops.push-pull.details", "2",
          "The tuck(-t) exaggerates the details of the smoother curve (hence does not fully reproduce the "
          "original details)",
          gains + "For s = t: 1 - t x and 1 + t x multiply to 1 - t^2 x^2, which is not 1 for t > 0, x > 0."),
      printed("polyloops.push-pull.snap", "2",
              "tends to snap back the curve to its original position in smooth parts",
              gains + "1 - g near omega = 0 for s = t: its order in omega, x of order 2."),
      printed("polyloops.push-pull.fixed", "2",
              "the motion of vertices stops if they have converged to a uniformly sampled cubic curve",
              fixed + "The polynomials that the operator leaves as they are, on data without ends."),
      finding("polyloops.push-pull.fixed.only", "polyloops 2",
              fixed + "All sequences without ends that the operator leaves as they are, for s != 0."),
      printed(
          "polyloops.push-pull.fixed.closed", "2",
          "the motion of vertices stops if they have converged to a uniformly sampled cubic curve",
          fixed +
              "That closed polyloops, which the chapter is about, can come to rest as more than a point."),
      printed("polyloops.refine-then-smooth", "3",
              "Applying a short sequence of refine operations and then applying a smoothing technique will "
              "produce a smoother looking polyloop",
              "The share of " + simple_polygons_text() +
                  " whose sharpest turn (the greatest angle between consecutive edges, by exact squared "
                  "cosines with their signs) is less sharp after {refine^2; tuck(1/2)^4}.",
              ClaimKind::tendency),
      printed("polyloops.push-pull.shrinking", "2",
              "To avoid, or at least reduce the shrinking effect, one may use the push/pull approach",
              "The share of " + simple_polygons_text() +
                  " that {tuck(1/2); tuck(-1/2)} changes less in area than tuck(1/2) does, exact areas.",
              ClaimKind::tendency),
      share("polyloops.push-pull.area",
            "The median over " + simple_polygons_text() +
                " of the area after one {tuck(1/2); tuck(-1/2)} over that before."),
      share("polyloops.tuck.area", "The median over " + simple_polygons_text() +
                                       " of the area after one tuck(1/2) over that before."),
      printed("polyloops.shrink.circle", "3", "it will quickly shrink L into a small circle",
              on_loops + "Tucks of a rectangle of sides 2 and 1: the polygon after a step against the "
                         "rectangle, scaled about its centroid."),
      share(
          "polyloops.shrink.circle.share",
          "The share of " + simple_polygons_text() +
              " of whose limit ellipse (the part of k = 1) the half axes differ by more than a tenth of the "
              "longer.",
          "polyloops 3"),
  };
  for (const int n : {4, 5, 6, 8, 12}) {
    table.push_back(finding(
        fmt::format("polyloops.shrink.ellipse.n{}", n), "polyloops 3",
        on_loops +
            fmt::format("The s up to which the part k = 1 of {} vertices shrinks slowest under tuck(s), so "
                        "that the polyloop, scaled, tends to an affine image of the regular polygon.",
                        n)));
  }
  return table;
}

const std::vector<ClaimHead>& table() {
  static const std::vector<ClaimHead> heads = make_table();
  return heads;
}

using Function = RationalFunction;

Claim statement(const std::string& id, bool holds, std::string found, std::string note = "") {
  return settle_statement(head(table(), id), holds, std::move(found), std::move(note));
}

template <class R>
Laurent<R> filter(const std::string& text) {
  const OperatorSequence sequence = parse_operators(text);
  std::vector<R> values;
  if constexpr (requires { R::variable(0); }) {
    for (std::size_t i = 0; i < sequence.free_parameters.size(); ++i)
      values.push_back(R::variable(static_cast<int>(i)));
  }
  return weights_of(composed_operator<R>(sequence, values)).value();
}

Laurent<Rational> position_on_cubic() {
  const Rational sixth(1, 6);
  return {-2, {-sixth, Rational(4) * sixth, Rational(0), Rational(4) * sixth, -sixth}};
}

void add_tuck(Results& results) {
  const RealSet damping = damping_range(filter<Polynomial>("tuck(s)"));
  const RealSet stable = stable_range(filter<Polynomial>("tuck(s)"));
  const Rational two_thirds(2, 3);
  const Laurent<Rational> average = filter<Rational>("tuck(2/3)");
  // |1 - 2/3 x| at the ends of x in [1, 2].
  const Rational upper_half =
      std::max(abs(transfer_at_cosine(average, Rational(0))), abs(transfer_at_cosine(average, Rational(-1))));
  results.claims.push_back(statement(
      "polyloops.tuck.low-pass", damping.contains(Algebraic(two_thirds)) && upper_half < Rational(1, 2),
      "at most " + upper_half.to_string() + " of the upper half of the frequencies is kept",
      "It is not monotone: nothing is kept at omega = 2 pi/3, and -1/3 at omega = pi."));
  // Over x in [1, 2] the largest |1 - s x| is at least 1 - s and at least 2 s - 1, one falling and one rising
  // with s; at 2/3 they are equal, and nothing exceeds them.
  const bool equal = transfer_at_cosine(average, Rational(0)) == -transfer_at_cosine(average, Rational(-1));
  if (!equal) throw std::logic_error("the ends of the upper half differ");
  results.claims.push_back(
      settle(head(table(), "polyloops.tuck.half-band"), exact(two_thirds),
             "There 1 - s = -(1 - 2s) = 1/3: 1 - s falls with s and 2s - 1 rises. So 2/3 "
             "is the best value for the upper half."));
  const bool range_is_damped = damping.parts.size() == 1 && *damping.parts[0].lower == Algebraic(0) &&
                               *damping.parts[0].upper > Algebraic(two_thirds);
  results.claims.push_back(statement(
      "polyloops.tuck.range", range_is_damped, damping.to_string(),
      "Every s in (0, 1) damps all frequencies but 0, s = 1 keeps the alternating one, and beyond it is "
      "amplified. Up to s = 1/2 no frequency changes its sign."));
  results.claims.push_back(statement("polyloops.tuck.range.end", damping.contains(Algebraic(0)),
                                     damping.to_string(),
                                     "At s = 0 nothing moves; the range that is meant is (0, 2/3]."));
  results.claims.push_back(statement("polyloops.tuck.damping", true, damping.to_string()));
  results.claims.push_back(statement("polyloops.tuck.stable", true, stable.to_string()));
  results.claims.push_back(statement(
      "polyloops.shrink.point", range_is_damped, "for s in " + damping.to_string(),
      "The point is the centroid of the vertices. For odd n slightly larger s do, too: up to 2/(1 + "
      "cos(pi/n)), not reached."));
  const auto [zeros, rest] = fixed_factor(filter<Function>("tuck(s)"));
  results.claims.push_back(statement("polyloops.shrink.centroid", zeros == 2 && rest.size() == 1,
                                     "w(z) - 1 = s (1 - z)^2/(2z): polyloops in one point; the centroid"));
}

void add_shrinking(Results& results) {
  const Laurent<Polynomial> tuck = filter<Polynomial>("tuck(s)");
  const Polynomial s = Polynomial::variable(0);
  const Polynomial x = Polynomial(1) - Polynomial::variable(1);
  results.claims.push_back(statement(
      "polyloops.tuck.inside", transfer_at_cosine(tuck, Polynomial::variable(1)) == Polynomial(1) - s * x,
      "1 - s (1 - cos 2 pi/n)",
      "Between 0 and 1 for 0 < s < 1 and n >= 4: every vertex moves towards the centre. Of smooth parts "
      "little "
      "is lost, s x of order omega^2, but in every step."));
  bool quickly = true;
  Algebraic slowest(0);
  for (const std::string text : {"tuck(1/2)", "tuck(2/3)"}) {
    for (int n = 3; n <= 8; ++n) {
      const Algebraic gain = abs(mode_gains(filter<Rational>(text), n)[1]);
      quickly = quickly && pow(gain.to_interval(), 10).upper() < Rational(1, 2);
      if (gain > slowest) slowest = gain;
    }
  }
  results.claims.push_back(statement(
      "polyloops.shrink.quickly", quickly, "at most " + slowest.to_string() + " is left by a step",
      "Quickly where n is small: a step of tuck(s) keeps 1 - s (1 - cos 2 pi/n), about 1 - 2 s pi^2/n^2 "
      "for large n: for n = 96 and s = 1/2 over 0.998. That it is a circle is refuted, "
      "polyloops.shrink.circle."));
  // Coordinates of a rectangle: -1, 1, 1, -1 and -1, -1, 1, 1, each multiplied by 1 - s; the square is one.
  const Laurent<Function> weights = filter<Function>("tuck(s)");
  const Function factor = Function(1) - Function::variable(0);
  bool scaled = true;
  for (const std::vector<int>& signs : {std::vector{-1, 1, 1, -1}, std::vector{-1, -1, 1, 1}}) {
    for (int i = 0; i < 4; ++i) {
      Function sum(0);
      for (int j = weights.first(); j <= weights.last(); ++j)
        sum += weights[j] * Function(signs[static_cast<std::size_t>(residue(i + j, 4))]);
      scaled = scaled && sum == factor * Function(signs[static_cast<std::size_t>(i)]);
    }
  }
  results.claims.push_back(statement("polyloops.coarse", scaled, "rectangles scaled by 1 - s",
                                     "The right angles stay, however often they are tucked."));
}

void add_cubic(Results& results) {
  // Lagrange's weights at 0 for the abscissae -2, -1, 1, 2.
  const std::array abscissae{-2, -1, 1, 2};
  Laurent<Rational> weights;
  for (const int i : abscissae) {
    Rational weight(1);
    for (const int j : abscissae) {
      if (j != i) weight *= Rational(-j, i - j);
    }
    weights += Laurent<Rational>::monomial(i, weight);
  }
  const Laurent<Rational> on_cubic = position_on_cubic();
  results.claims.push_back(statement("polyloops.cubic.value", weights == on_cubic, "(-A + 4B + 4D - E)/6"));
  const std::array<Polynomial, 4> abcd{Polynomial::variable(0), Polynomial::variable(1),
                                       Polynomial::variable(2), Polynomial::variable(3)};
  const auto at = [&](int u) {
    const Polynomial x(u);
    return ((abcd[0] * x + abcd[1]) * x + abcd[2]) * x + abcd[3];
  };
  const Polynomial outer = at(-2) + at(2);
  const Polynomial inner = at(-1) + at(1);
  const std::array<std::string, 4> names{"a", "b", "c", "d"};
  results.claims.push_back(statement("polyloops.cubic.outer",
                                     outer == Polynomial(8) * abcd[1] + Polynomial(2) * abcd[3],
                                     outer.to_string(names)));
  results.claims.push_back(statement("polyloops.cubic.inner",
                                     inner == Polynomial(2) * abcd[1] + Polynomial(2) * abcd[3],
                                     inner.to_string(names)));
  const Polynomial difference = Polynomial(4) * inner - outer;
  results.claims.push_back(statement("polyloops.cubic.difference", difference == Polynomial(6) * abcd[3],
                                     difference.to_string(names)));
}

void add_push_pull(Results& results) {
  const Laurent<Rational> on_cubic = position_on_cubic();
  const auto irrational = filter<Algebraic>("tuck(2/sqrt(6)); tuck(-2/sqrt(6))");
  const Laurent<Rational> composed =
      map_coefficients(irrational, [](const Algebraic& x) { return x.to_rational(); });
  results.claims.push_back(
      statement("polyloops.push-pull.cubic", composed == on_cubic, "(-A + 4B + 4D - E)/6"));
  bool known = true;
  try {
    (void)parse_operators("adjust(2/sqrt(6)); adjust(-2/sqrt(6))");
  } catch (const InputError&) {
    known = false;
  }
  results.claims.push_back(statement(
      "polyloops.push-pull.adjust", known, "adjust is not defined",
      "The chapter defines no operator of this name: tuck is meant, {tuck(2/sqrt 6); tuck(-2/sqrt 6)}, "
      "which does move C to (-A + 4B + 4D - E)/6."));
  results.claims.push_back(
      settle(head(table(), "polyloops.push-pull.number"), exact(Algebraic(2) / sqrt(Algebraic(6)))));
  const LargestGain largest = largest_gain(composed);
  results.claims.push_back(
      statement("polyloops.push-pull.unstable", amplifies(largest.gain) == Decision::yes,
                "gain " + largest.gain.exact + " at cos omega = " + largest.cosine.value().to_string(),
                "Alternating vertices, omega = pi, grow by 5/3 and change sides a step."));
  results.claims.push_back(settle(head(table(), "polyloops.push-pull.unstable.gain"), largest.gain));
  const RealSet stable = stable_range(filter<Polynomial>("tuck(s); tuck(-s)"));
  if (stable.parts.size() != 1 || !stable.parts[0].upper) throw std::logic_error("the range is no interval");
  results.claims.push_back(settle(head(table(), "polyloops.push-pull.stable"), exact(*stable.parts[0].upper),
                                  "The range is " + stable.to_string() + "."));
}

void add_region(Results& results) {
  const Polynomial s = Polynomial::variable(0);
  const Polynomial t = Polynomial::variable(1);
  const Polynomial x = Polynomial::variable(2);
  const Laurent<Polynomial> weights = filter<Polynomial>("tuck(s); tuck(-t)");
  const Polynomial one(1);
  const Polynomial g = transfer_at_cosine(weights, one - x);
  const Polynomial last = one + g.substitute(2, Polynomial(2));  // 1 + g at omega = pi
  const bool below = one - g == x * ((s - t) + s * t * x);
  const Polynomial half(Rational(1, 2));
  const bool above = one + g == (Polynomial(2) - x) + half * x * last + s * t * x * (Polynomial(2) - x);
  const bool end = last == Polynomial(2) * ((one + t) - s * (one + Polynomial(2) * t));
  results.claims.push_back(statement("polyloops.push-pull.region", below && above && end,
                                     "t <= s <= (1 + t)/(1 + 2 t)",
                                     "1 - g = x ((s - t) + s t x) is not negative for all x in [0, 2] "
                                     "exactly for t <= s; 1 + "
                                     "g = (2 - x) + x/2 (1 + g(2)) + s t x (2 - x) exactly for 1 + g(2) = 2 "
                                     "((1 + t) - s (1 + 2t)) >= 0. For t > s "
                                     "low frequencies grow, for s beyond the bound the alternating one."));
}

void add_fixed(Results& results) {
  const Function s = Function::variable(0);
  const Laurent<Function> weights = filter<Function>("tuck(s); tuck(-s)");
  const Laurent<Function> way = map_coefficients(position_on_cubic() - Laurent<Rational>(1),
                                                 [](const Rational& q) { return Function(q); });
  results.claims.push_back(statement(
      "polyloops.push-pull.towards", weights - Laurent<Function>(1) == s * s * fraction<Function>(3, 2) * way,
      "C + 3/2 s^2 (F(0) - C)",
      "For all s but 0, not beyond F(0) up to s = 2/sqrt(6); the neighbours move, too, so that stability is "
      "another question."));
  const Polynomial g = transfer_at_cosine(filter<Polynomial>("tuck(s); tuck(-s)"), Polynomial::variable(1));
  const Polynomial x = Polynomial(1) - Polynomial::variable(1);
  const Polynomial lost = pow(Polynomial::variable(0) * x, 2);
  results.claims.push_back(
      statement("polyloops.push-pull.details", Polynomial(1) - g == lost, "1 - s^2 x^2"));
  results.claims.push_back(statement(
      "polyloops.push-pull.snap", Polynomial(1) - g == lost, "1 - g = s^2 x^2, of order omega^4",
      "tuck alone loses s x, of order omega^2. With t != s the loss is of that order again, (s - t) x."));
  const auto [zeros, rest] = fixed_factor(weights);
  const std::string factored =
      fmt::format("w(z) - 1 = (1 - z)^{} times {} z^{}", zeros,
                  rest[rest.first()].to_factored_string(std::array<std::string, 1>{"s"}), rest.first());
  const bool only_cubics = zeros == 4 && rest.size() == 1;
  results.claims.push_back(statement("polyloops.push-pull.fixed", zeros >= 4, factored,
                                     "True of data without ends: polynomials up to degree 3 stay."));
  results.claims.push_back(
      statement("polyloops.push-pull.fixed.only", only_cubics, "polynomials of degree <= 3", factored + "."));
  results.claims.push_back(statement(
      "polyloops.push-pull.fixed.closed", !only_cubics, "polyloops in one point",
      "A bounded cubic is constant, so that no closed polyloop but a point is at rest; repeated with 0 < s < "
      "1/sqrt(2) the sequence, too, shrinks every closed polyloop to its centroid: part k by 1 - s^2 x_k^2 a "
      "step, x_k = 1 - cos(2 pi k/n), where tuck(s) takes 1 - s x_k. The slowest part is k = 1, while s^2 "
      "(x_1^2 + x_max^2) < 2 (for n >= 4, x_max the largest x_k); beyond it that of x_max, which changes its "
      "sign and keeps s^2 x_max^2 - 1: at s = 7/10 a square keeps 51/100 of k = 1 and -24/25 of k = 2."));
}

Rational area(const PlanePolygon& polygon) {
  Rational twice(0);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto& [x, y] = polygon[i];
    const auto& [next_x, next_y] = polygon[(i + 1) % polygon.size()];
    twice += x * next_y - next_x * y;
  }
  return twice / Rational(2);
}

PlanePolygon smoothed(const PlanePolygon& polygon, const std::string& text) {
  const auto op = composed_operator<Rational>(parse_operators(text));
  VertexChain<Rational> xs;
  VertexChain<Rational> ys;
  for (const auto& [x, y] : polygon) {
    xs.vertices.push_back(x);
    ys.vertices.push_back(y);
  }
  xs = apply(op, xs);
  ys = apply(op, ys);
  PlanePolygon result;
  for (std::size_t i = 0; i < xs.vertices.size(); ++i) result.emplace_back(xs.vertices[i], ys.vertices[i]);
  return result;
}

/// The least cos |cos| of the angle by which an edge turns to the next one: 1 for straight on, -1 for back.
Rational sharpest_turn(const PlanePolygon& polygon) {
  const std::size_t n = polygon.size();
  const auto edge = [&](std::size_t i) {
    const auto& [x, y] = polygon[i % n];
    const auto& [next_x, next_y] = polygon[(i + 1) % n];
    return std::pair(next_x - x, next_y - y);
  };
  Rational least(1);
  for (std::size_t i = 0; i < n; ++i) {
    const auto [ux, uy] = edge(i);
    const auto [vx, vy] = edge(i + 1);
    const Rational lengths = (ux * ux + uy * uy) * (vx * vx + vy * vy);
    const Rational dot = ux * vx + uy * vy;
    if (!is_zero(lengths)) least = std::min(least, dot * abs(dot) / lengths);
  }
  return least;
}

Rational median(std::vector<Rational> values) {
  std::ranges::sort(values);
  const std::size_t n = values.size();
  return (values[(n - 1) / 2] + values[n / 2]) / Rational(2);
}

/// The modulus of the sum of P_j e^{+-2 pi i j/n}, n times a part of mode 1.
Interval mode_modulus(const PlanePolygon& polygon, int direction) {
  const int n = static_cast<int>(polygon.size());
  Interval real(0);
  Interval imaginary(0);
  for (int j = 0; j < n; ++j) {
    const auto cosine = cosine_of_turn<Interval>(j, n);
    const auto sine = Interval(direction) * cosine_of_turn<Interval>(4 * j - n, 4 * n);
    const auto& [x, y] = polygon[static_cast<std::size_t>(j)];
    real += Interval(x) * cosine - Interval(y) * sine;
    imaginary += Interval(x) * sine + Interval(y) * cosine;
  }
  return sqrt(real * real + imaginary * imaginary);
}

/// Whether the half axes |a| + |b| and ||a| - |b|| differ by more than a tenth of the longer; throws where
/// enclosures cannot tell.
bool has_flat_ellipse(const PlanePolygon& polygon) {
  const Interval a = mode_modulus(polygon, 1);
  const Interval b = mode_modulus(polygon, -1);
  const Interval minor = abs(a - b);
  const Interval bound = Interval(Rational(9, 10)) * (a + b);
  if (!certainly_less(minor, bound) && !certainly_less(bound, minor))
    throw std::logic_error("half axes too near to the bound");
  return certainly_less(minor, bound);
}

void add_areas(Results& results) {
  std::vector<Rational> pulled;
  std::vector<Rational> both;
  int less = 0;
  int flat = 0;
  int smoother = 0;
  for (const PlanePolygon& polygon : simple_polygons()) {
    const Rational whole = area(polygon);
    pulled.push_back(area(smoothed(polygon, "tuck(1/2)")) / whole);
    both.push_back(area(smoothed(polygon, "tuck(1/2); tuck(-1/2)")) / whole);
    if (abs(both.back() - Rational(1)) < abs(pulled.back() - Rational(1))) ++less;
    if (has_flat_ellipse(polygon)) ++flat;
    if (sharpest_turn(polygon) < sharpest_turn(smoothed(polygon, "refine^2; tuck(1/2)^4"))) ++smoother;
  }
  const int total = static_cast<int>(simple_polygons().size());
  results.claims.push_back(settle_share(head(table(), "polyloops.push-pull.shrinking"), less, total,
                                        "Reduced, not avoided: see polyloops.push-pull.fixed.closed."));
  results.claims.push_back(settle_share(
      head(table(), "polyloops.refine-then-smooth"), smoother, total,
      "Slow, as the chapter says: refine^2 makes four vertices of one before anything is smoothed."));
  const auto settle_median = [&](const std::string& id, const std::vector<Rational>& values) {
    const Rational value = median(values);
    constexpr int digits = 6;
    results.claims.push_back(settle_as(head(table(), id), Verdict::established, exact(value, "exact areas"),
                                       "The median is " + to_significant(value, digits) + "."));
  };
  settle_median("polyloops.push-pull.area", both);
  settle_median("polyloops.tuck.area", pulled);
  results.claims.push_back(settle_share(head(table(), "polyloops.shrink.circle.share"), flat, total,
                                        "By enclosures of the half axes.", Rigour::certified));
}

void add_shapes(Results& results) {
  const PlanePolygon rectangle{{Rational(-1), Rational(-1, 2)},
                               {Rational(1), Rational(-1, 2)},
                               {Rational(1), Rational(1, 2)},
                               {Rational(-1), Rational(1, 2)}};
  bool similar = true;
  for (const std::string value : {"1/3", "1/2", "2/3"}) {
    const Rational factor = Rational(1) - Rational::parse(value);
    const PlanePolygon after = smoothed(rectangle, "tuck(" + value + ")");
    for (std::size_t i = 0; i < after.size(); ++i) {
      similar = similar && after[i].first == factor * rectangle[i].first &&
                after[i].second == factor * rectangle[i].second;
    }
  }
  results.claims.push_back(
      statement("polyloops.shrink.circle", !similar, "the rectangle scaled by 1 - s",
                "A rectangle of sides 2 : 1 stays one of sides 2 : 1, its vertices on an ellipse of axes 2 : "
                "1, however "
                "often it is tucked. In general the part k = 1 shrinks slowest for 0 < s < 2/(3 - cos(2 "
                "pi/n)), n even: "
                "scaled to its size the polyloop tends to an affine image of the regular polygon, whose "
                "vertices lie on "
                "an ellipse with the axes that it has at first. See polyloops.shrink.ellipse.n4 and on, and "
                "polyloops.shrink.circle.share."));
  for (const int n : {4, 5, 6, 8, 12}) {
    constexpr int digits = 8;
    const Enclosure end = exact(ellipse_end(n));
    results.claims.push_back(settle(
        head(table(), fmt::format("polyloops.shrink.ellipse.n{}", n)), end,
        fmt::format("{}; beyond it the part k = {} shrinks slowest{}.", to_significant(end.lower, digits),
                    n / 2, n % 2 == 0 ? ", vertices that alternate between two places" : "")));
  }
}

}  // namespace

std::span<const ClaimHead> polyloop_smoothing_heads() { return table(); }

Results run_polyloop_smoothing() {
  Results results;
  add_tuck(results);
  add_shrinking(results);
  add_cubic(results);
  add_push_pull(results);
  add_region(results);
  add_fixed(results);
  add_areas(results);
  add_shapes(results);
  return results;
}

}  // namespace subdiv
