#include "schemes/polyloop/operator_sequence.h"

#include <cmath>

#include <gtest/gtest.h>

#include "schemes/algebra/rational_function.h"
#include "schemes/bspline.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

using F = RationalFunction;

Mask<Rational> mask(const std::string& text) {
  return mask_of(composed_operator<Rational>(parse_operators(text))).value();
}

void expect_rejected(const std::string& text, const std::vector<std::string>& parts) {
  try {
    (void)parse_operators(text);
    ADD_FAILURE() << "'" << text << "' was read";
  } catch (const InputError& error) {
    for (const std::string& part : parts)
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << part << " in: " << error.what();
  }
}

TEST(OperatorSequence, SequencesOfTheChapter) {  // polyloops 2, 3.1
  EXPECT_TRUE(same_but_for_numbers(mask("{refine; dual;}"), bspline<Rational>(2)));
  EXPECT_TRUE(same_but_for_numbers(mask("refine; dual^2"), bspline<Rational>(3)));
  EXPECT_EQ(mask("refine; tuck(1/2); untuck"), jspline(Rational(0)));
  EXPECT_EQ(mask("split; tweak(1/4, 1/16)"), jspline(Rational(1, 2)));
  EXPECT_EQ(mask("J(4)"), jspline(Rational(1, 2)));
  EXPECT_EQ(mask(" { tuck( 1/2 ) ; tuck(-0.53) } ^ 2 ; "),
            mask("tuck(0.5);tuck(-53/100);tuck(1/2);tuck(-5.3e-1)"));
  const std::vector<F> values{F::variable(0)};
  const OperatorSequence family = parse_operators("refine; tuck(1/2); tuck(-s/8)");
  EXPECT_EQ(family.free_parameters, std::vector<std::string>{"s"});
  EXPECT_EQ(mask_of(composed_operator<F>(family, values)).value(),
            jspline(F(1) - F::variable(0) * fraction<F>(1, 8)));
  EXPECT_EQ(composed_operator<F>(parse_operators("J(q)"), values).rows,
            composed_operator<F>(family, values).rows);
}

TEST(OperatorSequence, RepetitionsAreWrittenOut) {
  const OperatorSequence s = parse_operators("refine; {tuck(1/2); {dual}^2}^3; untuck^2");
  EXPECT_EQ(s.calls.size(), 4U);
  EXPECT_EQ(s.order, (std::vector<std::size_t>{0, 1, 2, 2, 1, 2, 2, 1, 2, 2, 3, 3}));
  EXPECT_EQ(parse_operators("{dual^100}^100").order.size(), longest_sequence);
}

TEST(OperatorSequence, ValuesAreExactAndRounded) {
  const OperatorSequence roots = parse_operators("tuck(2/sqrt(6)); tuck(-2/sqrt(6))");
  EXPECT_THROW((void)operators_of<Rational>(roots), OutsideRingError);
  const PolyloopOperator<Algebraic> op = composed_operator<Algebraic>(roots);
  EXPECT_EQ(op.rows[0][0], Algebraic(0));
  EXPECT_EQ(op.rows[0][1], Algebraic(Rational(2, 3)));
  EXPECT_DOUBLE_EQ(operators_in_double(roots)[0].rows[0][0], 1 - 2 / std::sqrt(6.0));
  EXPECT_THROW((void)operators_in_double(parse_operators("tuck(t)")), InputError);
  EXPECT_THROW((void)operators_in_double(parse_operators("tuck(1e400)")), InputError);
  EXPECT_THROW((void)operators_in_double(parse_operators("tuck(1/0)")), InputError);
  EXPECT_THROW((void)operators_of<Rational>(parse_operators("tuck(1/(2-2))")), InputError);
}

TEST(OperatorSequence, ErrorsNamePlaceAndRemedy) {
  expect_rejected("", {"column 1", "expected refine", "tweak(old, new)", "the end"});
  expect_rejected("refine; ; dual", {"column 9", "expected refine", "';'"});
  expect_rejected("refine dual", {"column 8", "expected ';'", "'d'"});
  expect_rejected("refine; tuk(1/2)", {"column 9", "no operator 'tuk'", "did you mean 'tuck'?"});
  expect_rejected("dual2", {"column 1", "did you mean 'dual^2'?"});
  expect_rejected("tuck", {"column 5", "tuck needs a value: tuck(t)"});
  expect_rejected("tuck(1, 2)", {"column 5", "takes 1 value, not 2"});
  expect_rejected("tweak(1/2)", {"takes 2 values, not 1", "tweak(old, new)"});
  expect_rejected("dual(2)", {"column 5", "takes no value"});
  expect_rejected("tuck()", {"column 5", "value of tuck"});
  expect_rejected("tuck(1/2", {"column 5", "no ')'"});
  expect_rejected("tuck(1+)", {"column 6", "value of tuck"});
  expect_rejected("{dual; tuck(1)", {"column 15", "'}' of the '{' in column 1", "the end"});
  expect_rejected("dual}", {"column 5", "no '{'"});
  expect_rejected("dual^0", {"column 6", "whole number"});
  expect_rejected("dual^-1", {"column 6", "'-'"});
  expect_rejected("dual^99999999999999999999999", {"more than 10000"});
  expect_rejected("{{dual^100}^100}^2", {"more than 10000"});
  expect_rejected(std::string(1000, '{'), {"more than 50 braces"});
  expect_rejected("tuck(z)", {"'z'"});
  expect_rejected("d\xc3\xbc", {"column 1", "no operator 'd\?\?'"});
}

}  // namespace
}  // namespace subdiv
