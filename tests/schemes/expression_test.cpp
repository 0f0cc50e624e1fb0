#include "schemes/expression.h"

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "schemes/algebra/jet.h"
#include "schemes/algebra/real.h"
#include "tests/schemes/algebra/random_elements.h"
#include "tests/schemes/input_errors.h"

namespace subdiv {
namespace {

using testing::expect_input_error;
using testing::Generator;
using testing::random_int;

template <class R = Rational>
R value(const std::string& text) {
  return evaluate_constant<R>(Expression::parse(text));
}

template <class R>
R value_at(const std::string& text, const std::map<std::string, R>& names) {
  return evaluate<R>(Expression::parse(text), [&](const std::string& name, const Expression::Node& /*node*/) {
    return names.at(name);
  });
}

TEST(Expression, NumbersAreExact) {
  EXPECT_EQ(value("42"), Rational(42));
  EXPECT_EQ(value("-33/26"), Rational(-33, 26));
  EXPECT_EQ(value("0.1 + 0.2 - 0.3"), Rational(0));
  EXPECT_EQ(value("1.5e-3"), Rational(3, 2000));
  EXPECT_EQ(value("1.5E+3"), Rational(1500));
  EXPECT_EQ(value(".25"), Rational(1, 4));
  EXPECT_EQ(value("2."), Rational(2));
  EXPECT_EQ(value("2e3"), Rational(2000));
}

TEST(Expression, PrecedenceAndAssociativity) {
  EXPECT_EQ(value("1-2-3"), Rational(-4));
  EXPECT_EQ(value("1-(2-3)"), Rational(2));
  EXPECT_EQ(value("2/3/4"), Rational(1, 6));
  EXPECT_EQ(value("2/3*4"), Rational(8, 3));
  EXPECT_EQ(value("1+2*3^2"), Rational(19));
  EXPECT_EQ(value("-2^2"), Rational(-4));
  EXPECT_EQ(value("(-2)^2"), Rational(4));
  EXPECT_EQ(value("2^-3"), Rational(1, 8));
  EXPECT_EQ(value("2^(-3)"), Rational(1, 8));
  EXPECT_EQ(value("2^( + 3 )"), Rational(8));
  EXPECT_EQ(value("2*-3"), Rational(-6));
  EXPECT_EQ(value("--3"), Rational(3));
  EXPECT_EQ(value("+-+3"), Rational(-3));
  EXPECT_EQ(value("-3^2*2"), Rational(-18));
  EXPECT_EQ(value("0^0"), Rational(1));
  EXPECT_EQ(value(" ( 1 + 2 ) * 3 "), Rational(9));
}

TEST(Expression, SquareRootsStayInTheRingOrSayThatTheyDoNot) {
  EXPECT_EQ(value("sqrt(9/16)"), Rational(3, 4));
  EXPECT_EQ(value("sqrt(0)"), Rational(0));
  expect_input_error([] { value("1+sqrt(2)"); }, {"column 3", "square root of 2", "irrational"});
  EXPECT_THROW(value("sqrt(2)"), OutsideRingError);
  EXPECT_EQ(value<Algebraic>("(1+sqrt(5))/2").to_string(), "(1+sqrt(5))/2");
  EXPECT_EQ(value<Algebraic>("sqrt(2)*sqrt(8)"), Algebraic(4));
  EXPECT_EQ(value<Algebraic>("sqrt(2+sqrt(3)) - (sqrt(6)+sqrt(2))/2"), Algebraic(0));
  EXPECT_DOUBLE_EQ(value<double>("sqrt(2)"), std::sqrt(2.0));
  EXPECT_TRUE((value<Interval>("sqrt(2)^2")).contains(Rational(2)));
  EXPECT_EQ(value<RationalFunction>("sqrt(4/9)"), RationalFunction(Rational(2, 3)));
  EXPECT_THROW(value<RationalFunction>("sqrt(2)"), OutsideRingError);
  const std::map<std::string, RationalFunction> s{{"s", RationalFunction::variable(0)}};
  EXPECT_THROW(value_at("sqrt(s^2)", s), OutsideRingError);  // s^2 has no root: it would be |s|
  for (const char* text : {"sqrt(-1)", "sqrt(1-4)"}) {
    expect_input_error([&] { value(text); }, {"column 1", "negative"});
    expect_input_error([&] { value<Algebraic>(text); }, {"negative"});
    expect_input_error([&] { value<double>(text); }, {"negative"});
    expect_input_error([&] { value<Interval>(text); }, {"negative"});
  }
}

TEST(Expression, DivisionByZeroNamesTheDivisor) {
  expect_input_error([] { value("1+1/(3-3)"); },
                     {"column 4 of '1+1/(3-3)'", "division by zero", "'(3-3)' is 0"});
  expect_input_error([] { value("0^-1"); }, {"column 2", "division by zero"});
  expect_input_error([] { value<double>("1/0"); }, {"division by zero"});
  expect_input_error([] { value<Algebraic>("1/(sqrt(4)-2)"); }, {"division by zero"});
  const std::map<std::string, Interval> box{{"s", Interval::hull(Rational(-7), Rational(-5))}};
  expect_input_error([&] { value_at("1/(s+6)", box); }, {"contains zero"});
  const std::map<std::string, RationalFunction> s{{"s", RationalFunction::variable(0)}};
  expect_input_error([&] { value_at("1/(s-s)", s); }, {"'(s-s)' is 0"});
}

TEST(Expression, EvaluatesOverEveryRing) {
  const std::string text = "(s+1)*(s-1)/2 - s^2/2 + 3*s^-1";
  const RationalFunction s = RationalFunction::variable(0);
  EXPECT_EQ(value_at<RationalFunction>(text, {{"s", s}}),
            RationalFunction(Rational(-1, 2)) + RationalFunction(3) / s);
  EXPECT_EQ(value_at<Rational>(text, {{"s", Rational(2)}}), Rational(1));
  EXPECT_EQ(value_at<double>(text, {{"s", 2.0}}), 1.0);
  EXPECT_EQ(value_at<Algebraic>(text, {{"s", sqrt(Algebraic(9))}}), Algebraic(Rational(1, 2)));
  EXPECT_TRUE(value_at<Interval>(text, {{"s", Interval(Rational(2, 3))}}).contains(Rational(4)));
  EXPECT_EQ(value_at<Real>(text, {{"s", Real(2)}}), Real(1));
  using Jet = ceres::Jet<double, 1>;
  const Jet jet = value_at<Jet>(text, {{"s", Jet(2.0, 0)}});
  EXPECT_DOUBLE_EQ(jet.a, 1.0);
  EXPECT_DOUBLE_EQ(jet.v[0], -0.75);  // of 3/s - 1/2 at 2
  const Polynomial x = Polynomial::variable(0);
  EXPECT_EQ(value_at<Polynomial>("(x^2-1)/(x-1)/2", {{"x", x}}),
            (x + Polynomial(1)) * Polynomial(Rational(1, 2)));
  expect_input_error([&] { value_at<Polynomial>("1/x", {{"x", x}}); }, {"no polynomial"});
}

TEST(Expression, ListsItsNamesAndDecimals) {
  const Expression e = Expression::parse("b*(a - b2) + sqrt(a)/2 - b");
  EXPECT_EQ(e.names(), (std::vector<std::string>{"b", "a", "b2"}));
  EXPECT_FALSE(e.has_decimals());
  EXPECT_TRUE(Expression::parse("1 + 2*0.5").has_decimals());
  EXPECT_TRUE(Expression::parse("1e-3").has_decimals());
  EXPECT_EQ(Expression::parse("  1 + x ").text(), "1 + x");
  expect_input_error([] { value("1+y"); }, {"column 3", "expected a number", "'y'"});
}

TEST(Expression, KnowsHalfAUnitOfADecimalsLastDigit) {
  const auto half_unit = [](const std::string& text) {
    return Expression::parse(text).nodes().front().half_unit;
  };
  EXPECT_EQ(half_unit("0.50"), Rational(1, 200));
  EXPECT_EQ(half_unit("12"), Rational(0));
  EXPECT_EQ(half_unit("12."), Rational(1, 2));
  EXPECT_EQ(half_unit("1.5e-3"), Rational(5, 100'000));
  EXPECT_EQ(half_unit("2e3"), Rational(500));
}

TEST(Expression, SyntaxErrorsHaveAColumnAndARemedy) {
  struct Case {
    const char* text;
    const char* column;
    const char* remedy;
  };
  for (const Case& c : std::vector<Case>{{"", "empty", "expected a number"},
                                         {"   ", "empty", "expected a number"},
                                         {"1+", "column 3", "expected a number, a name or '('"},
                                         {"*2", "column 1", "found '*'"},
                                         {"2**3", "column 3", "found '*'"},
                                         {"(1+2", "column 5", "expected ')' for the '(' of column 1"},
                                         {"1+2)", "column 4", "')' without its '('"},
                                         {"2z", "column 2", "write a product with '*'"},
                                         {"2(3)", "column 2", "write a product with '*'"},
                                         {"f(3)", "column 1", "only sqrt is known"},
                                         {"sqrt 2", "column 6", "expected '(' after sqrt"},
                                         {"sqrt", "column 5", "expected '(' after sqrt"},
                                         {"sqrt()", "column 6", "expected a number"},
                                         {"1,5", "column 2", "decimals have a point"},
                                         {"1 % 2", "column 3", "expected an operator"},
                                         {"z^1.5", "column 4", "whole number"},
                                         {"z^x", "column 3", "whole number"},
                                         {"z^", "column 3", "whole number"},
                                         {"z^(2", "column 5", "whole number"},
                                         {"z^1001", "column 3", "up to 1000"},
                                         {"z^99999999999999999999", "column 3", "up to 1000"},
                                         {"2^3^2", "column 4", "parentheses"},
                                         {"1e5000", "column 1", "exponent is at most 1000"},
                                         {"0x10", "column 2", "'*'"},
                                         {"1..2", "column 3", "'*'"},
                                         {"1_000", "column 2", "'*'"},
                                         {"a=1", "column 2", "expected an operator"},
                                         {"\xE2\x88\x92"
                                          "1",
                                          "column 1", "not ASCII (minus is '-')"},
                                         {"1\n+", "column 4", "the text ends"}}) {
    expect_input_error([&] { Expression::parse(c.text); }, {c.column, c.remedy});
  }
}

TEST(Expression, LongTextIsShownAroundTheError) {
  const std::string text = std::string(500, '1') + "+" + std::string(500, '2') + "?";
  expect_input_error([&] { Expression::parse(text); }, {"column 1002", "...222", "?'"});
}

// Neither the stack nor the memory nor the time can be exhausted by a text.
TEST(Expression, DepthAndSizeAreLimited) {
  const auto repeated = [](const std::string& piece, int n) {
    std::string result;
    for (int i = 0; i < n; ++i) result += piece;
    return result;
  };
  EXPECT_EQ(value(repeated("(", 100) + "7" + repeated(")", 100)), Rational(7));
  expect_input_error([&] { Expression::parse(repeated("(", 90'000)); }, {"nested parentheses"});
  expect_input_error([&] { Expression::parse(repeated("sqrt(", 15'000)); }, {"nested parentheses"});
  EXPECT_EQ(value(repeated("-", 90'000) + "1"), Rational(1));
  EXPECT_EQ(value("1" + repeated("+1", 20'000)), Rational(20'001));
  expect_input_error([&] { Expression::parse(repeated("1+", 60'000)); }, {"100000"});
  expect_input_error([] { value("((9^1000)^1000)^1000"); }, {"column 10", "too large"});
  expect_input_error([] { value("((1e1000)^1000)^10"); }, {"too large"});
  // A power of a sum of many free names would have millions of terms; many roots a degree of thousands.
  const std::map<std::string, RationalFunction> names{
      {"a", RationalFunction::variable(0)}, {"b", RationalFunction::variable(1)},
      {"c", RationalFunction::variable(2)}, {"d", RationalFunction::variable(3)},
      {"e", RationalFunction::variable(4)}, {"f", RationalFunction::variable(5)}};
  expect_input_error([&] { value_at("(1+a+b+c+d+e+f)^500", names); }, {"too large"});
  expect_input_error(
      [] { value<Algebraic>("sqrt(2)+sqrt(3)+sqrt(5)+sqrt(7)+sqrt(11)+sqrt(13)+sqrt(17)+sqrt(19)"); },
      {"too large"});
}

/// A random expression as text, with the value that a second evaluator (this recursion) finds.
std::string random_text(Generator& generator, int depth, Rational& result) {
  if (depth == 0) {
    result = Rational(random_int(generator, 0, 99), random_int(generator, 0, 1) == 0 ? 1 : 100);
    return result.is_integer() ? result.to_string() : to_decimal(result, 2);
  }
  Rational a;
  Rational b;
  const std::string left = random_text(generator, depth - 1, a);
  const std::string right = random_text(generator, random_int(generator, 0, depth - 1), b);
  switch (random_int(generator, 0, 5)) {
    case 0:
      result = a + b;
      return "(" + left + " + " + right + ")";
    case 1:
      result = a - b;
      return "(" + left + "-" + right + ")";
    case 2:
      result = a * b;
      return left + "*" + right;
    case 3:
      result = -a;
      return "(-" + left + ")";
    case 4: {
      const int n = random_int(generator, 0, 3);
      result = pow(a, n);
      return "(" + left + ")^" + std::to_string(n);
    }
    default:
      if (b.sign() == 0) b = Rational(1);
      result = a / b;
      return "(" + left + "/(" + (b == Rational(1) ? "1" : right) + "))";
  }
}

TEST(Expression, AgreesWithASecondEvaluatorOnRandomExpressions) {
  Generator generator(81);
  for (int i = 0; i < 2000; ++i) {
    Rational expected;
    const std::string text = random_text(generator, 4, expected);
    ASSERT_EQ(value(text), expected) << text;
    ASSERT_TRUE(value<Interval>(text).contains(expected)) << text;
  }
}

}  // namespace
}  // namespace subdiv
