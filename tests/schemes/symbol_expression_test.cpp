#include "schemes/symbol_expression.h"

#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/schemes/input_errors.h"

namespace subdiv {
namespace {

using testing::expect_input_error;
using P = Laurent<Rational>;

template <class R>
FactoredSymbol<R> factored(const std::string& text, int arity = 2, const Bindings<R>& bindings = {}) {
  return factored_symbol(Expression::parse(text), arity, bindings, ExactLiteral<R>{});
}

FactoredSymbol<Interval> rounded_symbol(const std::string& text) {
  const IntervalLiteral literal{.precision = 100, .decimals_are_exact = false};
  return factored_symbol(Expression::parse(text), 2, Bindings<Interval>{}, literal);
}

P symbol(const std::string& text, int arity = 2) {
  const P value = symbol_value(Expression::parse(text), Bindings<Rational>{}, ExactLiteral<Rational>{});
  EXPECT_EQ(factored<Rational>(text, arity).expanded(arity), value);
  return value;
}

TEST(SymbolExpression, IsALaurentPolynomialIndexedByThePowerOfZ) {
  EXPECT_EQ(symbol("2*((1+z)/2)^4"),
            P(0, {Rational(1, 8), Rational(1, 2), Rational(3, 4), Rational(1, 2), Rational(1, 8)}));
  EXPECT_EQ(symbol("2*((1+z)/2)^4/z^2").first(), -2);
  EXPECT_EQ(symbol("z^-1 + 3 + z/2"), P(-1, {1, 3, Rational(1, 2)}));
  EXPECT_EQ(symbol("-(1-z)^2*z^(-5)"), P(-5, {-1, 2, -1}));
  EXPECT_EQ(symbol("(1/z+2)/z"), P(-2, {1, 2}));
  EXPECT_EQ(symbol("-(-z)^3"), P::monomial(3));
  EXPECT_EQ(symbol("(-z)^2*(-(1+z))"), P(2, {-1, -1}));
  EXPECT_TRUE(symbol("z-z").is_zero());
  EXPECT_EQ(symbol("7"), P(7));
}

TEST(SymbolExpression, DividesByPolynomialsWhenExact) {
  const P sum_of_four(0, {1, 1, 1, 1});
  EXPECT_EQ(symbol("(1-z^4)/(1-z)"), sum_of_four);
  EXPECT_EQ(symbol("1/(1-z)*(1-z^4)"), sum_of_four);
  EXPECT_EQ(symbol("1+(1-z^4)/(1-z)"), sum_of_four + P(1));
  EXPECT_EQ(symbol("(1-z^4)*(1-z)^-1"), sum_of_four);
  expect_input_error([] { symbol("1/(1-z)"); }, {"by its own factors only"});
  expect_input_error([] { symbol("z/(z-z)"); }, {"division by zero"});
  expect_input_error([] { symbol("(1+z)/0"); }, {"division by zero"});
  // In inexact rings the rational factors are still divided exactly, others cannot be.
  EXPECT_EQ(factored<double>("sqrt(2)*(1-z^4)/(1-z)").expanded(2).size(), 4);
  expect_input_error([] { factored<double>("(2-sqrt(2)*z)/(1-z/sqrt(2))"); }, {"needs exact coefficients"});
  EXPECT_EQ(factored<Algebraic>("(2-sqrt(2)*z)/(1-z/sqrt(2))").cofactor, Laurent<Algebraic>(2));
}

TEST(SymbolExpression, RootsOfConstantsOnly) {
  EXPECT_EQ(symbol("sqrt(9/4)*z"), P::monomial(1, Rational(3, 2)));
  expect_input_error([] { symbol("sqrt(z)"); }, {"column 1", "no symbol"});
  EXPECT_THROW(symbol("sqrt(3)*z"), OutsideRingError);
}

TEST(SymbolExpression, ExactRingsCountEverySmoothingFactor) {
  const auto hidden = factored<Rational>("1 + 3*z + 3*z^2 + z^3");
  EXPECT_EQ(hidden.smoothing_factors, 3);
  EXPECT_EQ(hidden.cofactor, P(1));
  const auto ternary = factored<Rational>("3*((1+z+z^2)/3)^3*(2-z)", 3);
  EXPECT_EQ(ternary.smoothing_factors, 3);
  EXPECT_EQ(factored<Rational>("3*((1+z+z^2)/3)^3*(2-z)", 2).smoothing_factors, 0);
  const Algebraic root = sqrt(Algebraic(3));
  const auto daubechies = factored<Algebraic>("((1+z)/2)^2*((1+sqrt(3))+(1-sqrt(3))*z)");
  EXPECT_EQ(daubechies.smoothing_factors, 2);
  EXPECT_EQ(daubechies.cofactor, Laurent<Algebraic>(0, {(Algebraic(1) + root) / Algebraic(4),
                                                        (Algebraic(1) - root) / Algebraic(4)}));
}

TEST(SymbolExpression, InexactRingsCountTheWrittenFactors) {
  struct Case {
    const char* text;
    int factors;
    int cofactor_size;
  };
  for (const Case& c : std::vector<Case>{{"((1+z)/2)^2*((1+sqrt(3))+(1-sqrt(3))*z)", 2, 2},
                                         {"sqrt(2)*(1+z)^3/z^2", 3, 1},
                                         {"(z+1)*(2+2*z)*(sqrt(2)-z)", 2, 2},
                                         {"-(1+2*z+z^2)*sqrt(2)", 2, 1},
                                         {"((1+z)*(1+z)*sqrt(2))^2", 4, 1},
                                         {"(sqrt(2)*(1+z)^4)/(1+z)", 3, 1},
                                         {"(1+z)*sqrt(2)+(1+z)", 0, 2}}) {  // a sum is not taken apart
    const auto result = factored<Interval>(c.text);
    EXPECT_EQ(result.smoothing_factors, c.factors) << c.text;
    EXPECT_EQ(result.cofactor.size(), c.cofactor_size) << c.text;
    const auto exact = factored<Algebraic>(c.text).expanded(2);
    const auto expanded = result.expanded(2);
    for (int i = exact.first(); i <= exact.last(); ++i) {
      EXPECT_TRUE(expanded[i].overlaps(exact[i].to_interval())) << c.text << " at " << i;
    }
  }
}

TEST(SymbolExpression, RoundedDecimalsAreNotExactFactors) {
  const std::string text = "2*((1+z)/2)^4*(0.5+0.5*z)*(1.25-0.5*z+0.25*z^2)";
  EXPECT_EQ(factored<Interval>(text).smoothing_factors, 5);
  const auto rounded = rounded_symbol(text);
  EXPECT_EQ(rounded.smoothing_factors, 4);
  EXPECT_TRUE(rounded.cofactor[0].contains(Rational(1, 16) * Rational(125, 100)));
  EXPECT_GT(rounded.cofactor[0].radius(), 1e-3);
}

TEST(SymbolExpression, ParametersThatAreRationalKeepFactorsExact) {
  Bindings<Interval> bindings;
  bindings.values.emplace("w", Interval(1));
  bindings.rational.emplace("w", Rational(1));
  EXPECT_EQ(factored<Interval>("(1+w*z)^3*sqrt(2)", 2, bindings).smoothing_factors, 3);
  bindings.rational.clear();  // now only an interval is known
  EXPECT_EQ(factored<Interval>("(1+w*z)^3*sqrt(2)", 2, bindings).smoothing_factors, 0);
  Bindings<RationalFunction> free;
  free.values.emplace("w", RationalFunction::variable(0));
  const auto symbolic = factored<RationalFunction>("(1+z)^2*(w+w*z)*(1-z^2)/(1-z)/(w+1)", 2, free);
  EXPECT_EQ(symbolic.smoothing_factors, 4);
  EXPECT_EQ(symbolic.cofactor.size(), 1);
  EXPECT_EQ(symbolic.cofactor[0],
            RationalFunction::variable(0) / (RationalFunction::variable(0) + RationalFunction(1)));
}

TEST(SymbolExpression, UnboundNamesAndSizesAreErrors) {
  expect_input_error([] { symbol("1+y*z"); }, {"column 3", "unknown name 'y'"});
  expect_input_error([] { symbol("(z+2)^1000*(z+3)^1000*(z+5)^1000*(z+7)^1000*(z+11)^1000"); },
                     {"too large"});
}

TEST(WrittenProduct, TakesProductsQuotientsPowersAndSignsApart) {
  const Expression e = Expression::parse("-2*((1+z)/2)^4/z^3*(1-z)");
  const WrittenProduct product = written_product(e);
  EXPECT_EQ(product.sign, -1);
  std::vector<std::string> factors;
  for (const WrittenFactor& f : product.factors) {
    factors.push_back(std::string(e.source(e.nodes()[f.root])) + "^" + std::to_string(f.power));
  }
  EXPECT_EQ(factors, (std::vector<std::string>{"2^1", "(1+z)^4", "2^-4", "z^-3", "(1-z)^1"}));
}

}  // namespace
}  // namespace subdiv
