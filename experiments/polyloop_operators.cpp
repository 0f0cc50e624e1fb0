#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "experiments/polyloop_smoothing.h"
#include "schemes/algebra/rational_function.h"
#include "schemes/bspline.h"
#include "schemes/four_point.h"
#include "schemes/jspline.h"
#include "schemes/polyloop/operator_sequence.h"

namespace subdiv {
namespace {

using Function = RationalFunction;
using Operator = PolyloopOperator<Function>;

const std::string symbols = "Symbols of the operators, over Q(s) where s occurs: ";

ClaimHead printed(std::string id, std::string section, std::string text, std::string definition) {
  return {std::move(id),   "polyloops",      std::move(section),
          std::move(text), ClaimKind::exact, symbols + std::move(definition)};
}

const std::array table{
    printed("polyloops.laplace", "2", "M(B) is half the acceleration g(B)/2",
            "(BA + BC)/2 against half of BC - AB, as weights of A, B, C."),
    printed("polyloops.tuck.average", "2", "tuck(2/3) moves B to the average (A+B+C)/3",
            "the weights of tuck(2/3)."),
    printed("polyloops.dual.squared", "2", "dual2(B)=(A-6B+C)/4", "the weights of {dual; dual}."),
    printed("polyloops.dual.adjustment", "2", "The adjustment vector dual2(B)-B is (BA+BC)/4",
            "the weights of {dual; dual} less those of B."),
    printed("polyloops.dual.tuck", "2 and 3.1", "dual2 is equivalent to tuck(1/2)",
            "{dual; dual} against tuck(1/2), vertices numbered anew."),
    printed(
        "polyloops.rd", "3.1",
        "repeat the sequence {refine; dual;}. As we do so, the polyloop converges to the quadratic uniform "
        "B-spline curve",
        "{refine; dual} against the quadratic B-spline's mask."),
    printed("polyloops.rdd", "3.1",
            "Repeating {refine; dual2;} converges to the cubic uniform B-spline curve",
            "{refine; dual; dual} against the cubic B-spline's mask."),
    printed("polyloops.rdd.mid-edges", "3.1", "the mid-edge vertices are not affected by the dual2 step",
            "odd vertices of {refine; dual; dual} against those of refine."),
    printed("polyloops.split-tweak.cubic", "3.1",
            "Tweak tucks in the old vertices by moving them half-way towards the average of their new "
            "neighbors",
            "{split; tweak(1/2, 0)} against {refine; dual; dual}."),
    printed("polyloops.rtu", "3.1",
            "we may use the four-point scheme. .. To do so, we repeat the sequence {refine; tuck(1/2); "
            "tuck(–1);}",
            "the sequence against the four-point scheme's mask, w = 1/16."),
    printed("polyloops.split-tweak.four-point", "3.1",
            "the Tweak bulges out the new vertices by 1/8th away from the average of their third-degree "
            "neighbors",
            "{split; tweak(0, 1/8)} against the four-point scheme's mask; third neighbours are three "
            "vertices off after split."),
    printed("polyloops.rtu.caption", "3.1, caption", "r, rt, rtu, rturt, and rtutu",
            "whether rtutu = {refine; tuck(1/2); tuck(-1); tuck(1/2); tuck(-1)} is two steps of {refine; "
            "tuck(1/2); tuck(-1)}."),
    printed("polyloops.family", "3.1", "J(s)= {refine; tuck(1/2); tuck(-s/8);}",
            "the sequence, for all s, against J_{1 - s/8} of jsplines 3."),
    printed("polyloops.family.j0", "3.1", "J0 is the cubic uniform B-spline",
            "J(0) against the cubic B-spline's mask."),
    printed("polyloops.family.j8", "3.1", "J8 is the Four-point subdivision curve",
            "J(8) against the four-point scheme's mask, w = 1/16."),
    printed("polyloops.family.j-4", "3.1", "J-4 is the quintic B-spline",
            "J(-4) against the quintic B-spline's mask."),
    printed("polyloops.family.j-4.continuity", "3.1", "J-4 has C4 continuity",
            "how often (1 + z)/2 divides the symbol of J(-4), and what is left."),
    printed(
        "polyloops.split-tweak.j4", "3.1",
        "J4 can also be implemented as a Split&Tweak process, but here both the old and the new vertices are "
        "tweaked, each by half of their tweak vectors in the previous two schemes",
        "{split; tweak(1/4, 1/16)} against J(4)."),
    finding("polyloops.split-tweak.family", "polyloops 3.1",
            symbols + "the shares o and n for which {split; tweak(o, n)} is J(s), for all s."),
};

Claim equality(const std::string& id, bool holds, std::string found, std::string note = "") {
  return settle_statement(head(table, id), holds, std::move(found), std::move(note));
}

Operator of(const std::string& text) {
  const OperatorSequence sequence = parse_operators(text);
  std::vector<Function> values;
  for (std::size_t i = 0; i < sequence.free_parameters.size(); ++i)
    values.push_back(Function::variable(static_cast<int>(i)));
  return composed_operator<Function>(sequence, values);
}

/// "{1/4, 1/2, 1/4}".
std::string text_of(const Laurent<Function>& weights) {
  std::string text;
  for (const Function& w : weights.coefficients())
    text += (text.empty() ? "{" : ", ") + w.to_factored_string(std::array<std::string, 1>{"s"});
  return text + "}";
}

Claim same_scheme(const std::string& id, const std::string& sequence, const Mask<Function>& known,
                  std::string note = "") {
  const Mask<Function> mask = mask_of(of(sequence)).value();
  return equality(id, same_but_for_numbers(mask, known), "mask " + text_of(mask.symbol), std::move(note));
}

void add_operators(Results& results) {
  const Function half = fraction<Function>(1, 2);
  const Laurent<Function> laplace(-1, {half, Function(-1), half});
  const Laurent<Function> forth(0, {Function(-1), Function(1)});
  const Laurent<Function> back(-1, {Function(-1), Function(1)});
  results.claims.push_back(equality("polyloops.laplace", half * (forth - back) == laplace, text_of(laplace)));
  const Function third = fraction<Function>(1, 3);
  const Laurent<Function> average = of("tuck(2/3)").rows[0];
  results.claims.push_back(equality(
      "polyloops.tuck.average", average == Laurent<Function>(-1, {third, third, third}), text_of(average)));
  const Laurent<Function> twice = shift(of("dual^2").rows[0], -1);  // vertex 0 lies about P_1
  const Function quarter = fraction<Function>(1, 4);
  const Laurent<Function> misprint(-1, {quarter, fraction<Function>(-6, 4), quarter});
  results.claims.push_back(equality(
      "polyloops.dual.squared", twice == misprint, text_of(twice),
      "The weights of dual^2 are (A + 2B + C)/4; those printed sum to -1, so that they would move a polyloop "
      "that stands far from the origin to the other side of it. The chapter's own adjustment vector (BA + "
      "BC)/4 gives (A + 2B + C)/4."));
  results.claims.push_back(equality("polyloops.dual.adjustment",
                                    twice - Laurent<Function>(1) == half * laplace,
                                    text_of(twice - Laurent<Function>(1))));
  results.claims.push_back(equality("polyloops.dual.tuck", twice == of("tuck(1/2)").rows[0], text_of(twice)));
}

void add_schemes(Results& results) {
  const Function s = Function::variable(0);
  const Mask<Function> four_point_mask = four_point(fraction<Function>(1, 16));
  results.claims.push_back(same_scheme("polyloops.rd", "refine; dual", bspline<Function>(2)));
  results.claims.push_back(same_scheme("polyloops.rdd", "refine; dual^2", bspline<Function>(3)));
  // dual^2 numbers vertices from the second on: its even ones are the chapter's odd ones.
  const Operator cubic = of("refine; dual^2");
  const Operator split = of("refine");
  results.claims.push_back(
      equality("polyloops.rdd.mid-edges", cubic.rows[0] == split.rows[1], text_of(cubic.rows[0])));
  results.claims.push_back(
      same_scheme("polyloops.split-tweak.cubic", "split; tweak(1/2, 0)", mask_of(cubic).value()));
  results.claims.push_back(same_scheme("polyloops.rtu", "refine; tuck(1/2); tuck(-1)", four_point_mask));
  results.claims.push_back(
      same_scheme("polyloops.split-tweak.four-point", "split; tweak(0, 1/8)", four_point_mask));
  const Operator caption = of("refine; tuck(1/2); tuck(-1); tuck(1/2); tuck(-1)");
  const Operator meant = of("{refine; tuck(1/2); tuck(-1)}^2");
  results.claims.push_back(equality(
      "polyloops.rtu.caption", caption.rows == meant.rows,
      fmt::format(
          "rtutu makes {} vertices of one, rturtu {}; it moves old vertices to {}, rturtu leaves them",
          caption.outputs(), meant.outputs(), text_of(caption.rows[0])),
      "What is meant is rturtu: the sequence that is repeated begins with r. rtutu refines once only. "
      "The captions of the three "
      "rows are uneven, too: the first goes from two repetitions to four, the second from two to three, and "
      "this one leaves rtur out, which the first two show as rdr and rd2r."));
  const Mask<Function> family = jspline(Function(1) - s * fraction<Function>(1, 8));
  results.claims.push_back(same_scheme(
      "polyloops.family", "refine; tuck(1/2); tuck(-s/8)", family,
      "The parameter of the other documents is 1 - s/8: 1 for the cubic B-spline, 0 for the four-point "
      "scheme, 3/2 for the quintic."));
  results.claims.push_back(same_scheme("polyloops.family.j0", "J(0)", bspline<Function>(3)));
  results.claims.push_back(same_scheme("polyloops.family.j8", "J(8)", four_point_mask));
  results.claims.push_back(same_scheme("polyloops.family.j-4", "J(-4)", bspline<Function>(5)));
  const auto [smooth, rest] =
      divide_out(mask_of(of("J(-4)")).value().symbol, Laurent<Function>(0, {Function(1), Function(1)}));
  results.claims.push_back(equality("polyloops.family.j-4.continuity", smooth == 6 && rest.size() == 1,
                                    fmt::format("{} factors (1 + z)/2, a power of z left", smooth),
                                    "2 ((1 + z)/2)^6 is the B-spline of degree 5: C4, and not C5."));
  results.claims.push_back(
      same_scheme("polyloops.split-tweak.j4", "split; tweak(1/4, 1/16)", mask_of(of("J(4)")).value()));
  const Operator tweaked = sequence<Function>(
      {polyloop::refine<Function>(),
       polyloop::tweak((Function(1) - s * fraction<Function>(1, 8)) * fraction<Function>(1, 2),
                       s * fraction<Function>(1, 64))});
  results.claims.push_back(equality("polyloops.split-tweak.family", mask_of(tweaked).value() == family,
                                    "o = (8 - s)/16, n = s/64"));
}

}  // namespace

std::span<const ClaimHead> polyloop_operator_heads() { return table; }

Results run_polyloop_operators() {
  Results results;
  add_operators(results);
  add_schemes(results);
  return results;
}

}  // namespace subdiv
