#include "schemes/instantiate.h"

#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "schemes/algebra/jet.h"
#include "schemes/algebra/real.h"
#include "schemes/bspline.h"
#include "schemes/four_point.h"
#include "schemes/jspline.h"
#include "tests/schemes/input_errors.h"

namespace subdiv {
namespace {

using testing::expect_input_error;
using testing::ScratchFolder;
using F = RationalFunction;

const Algebraic root_two = sqrt(Algebraic(2));

TEST(Instantiate, GivesTheMasksOfTheFamilies) {
  const auto scheme =
      instantiate<Rational>(parse_scheme("jspline:s=-33/26+jspline:a=1/2,b=0.75+lane-riesenfeld:degree=5"));
  EXPECT_EQ(scheme.name, "jspline:s=-33/26+jspline:a=1/2,b=0.75+lane-riesenfeld:degree=5");
  ASSERT_EQ(scheme.steps.size(), 3U);
  EXPECT_EQ(scheme.steps[0], jspline(Rational(-33, 26)));
  EXPECT_EQ(scheme.steps[1], jspline(Rational(1, 2), Rational(3, 4)));
  EXPECT_EQ(scheme.steps[2], bspline<Rational>(5));
  EXPECT_EQ(instantiate<Rational>(parse_scheme("four-point")).steps[0], four_point(Rational(1, 16)));
}

TEST(Instantiate, FreeParametersAreVariablesByFirstAppearance) {
  const auto scheme = symbolic_scheme(parse_scheme("jspline:b=y,a=(x-1)+jspline:s=y"));
  const F y = F::variable(0);
  const F x = F::variable(1);
  EXPECT_EQ(scheme.steps[0], jspline(x - F(1), y));
  EXPECT_EQ(scheme.steps[1], jspline(y));
  const std::vector<Rational> values{Rational(2), Rational(5)};
  const auto at = instantiate<Rational>(parse_scheme("jspline:b=y,a=(x-1)+jspline:s=y"), values);
  EXPECT_EQ(at.steps[0], jspline(Rational(4), Rational(2)));
}

TEST(Instantiate, NeedsAValueForEveryFreeParameter) {
  const SchemeDescription scheme = parse_scheme("jspline:s=s");
  EXPECT_THROW(instantiate<Rational>(scheme), std::domain_error);
  const std::vector<Rational> two{1, 2};
  EXPECT_THROW(instantiate<Rational>(scheme, two), std::domain_error);
}

TEST(Instantiate, WorksOverEveryRing) {
  const SchemeDescription scheme = parse_scheme("jspline:s=s");
  const std::vector<double> d{0.5};
  EXPECT_DOUBLE_EQ(instantiate<double>(scheme, d).steps[0].symbol[0], 0.875);
  const std::vector<Real> real{Real("0.5")};
  EXPECT_EQ(instantiate<Real>(scheme, real).steps[0].symbol[0], Real("0.875"));
  const std::vector<Interval> interval{Interval::hull(Rational(0), Rational(1))};
  EXPECT_TRUE(instantiate<Interval>(scheme, interval).steps[0].symbol[0].contains(Rational(9, 10)));
  const std::vector<Algebraic> algebraic{root_two};
  EXPECT_EQ(instantiate<Algebraic>(scheme, algebraic).steps[0], jspline(root_two));
  using Jet = ceres::Jet<double, 1>;
  const std::vector<Jet> jet{Jet(0.5, 0)};
  const Mask<Jet> mask = instantiate<Jet>(scheme, jet).steps[0];
  EXPECT_DOUBLE_EQ(mask.symbol[0].v[0], -0.25);
  EXPECT_DOUBLE_EQ(mask.symbol[1].v[0], -0.0625);
  EXPECT_DOUBLE_EQ(mask.symbol[2].v[0], 0.125);
}

TEST(Instantiate, ReportsTheSmallestField) {
  EXPECT_EQ(smallest_field(parse_scheme("jspline:s=3/2")), Field::rational);
  EXPECT_EQ(smallest_field(parse_scheme("jspline:s=sqrt(9/4)")), Field::rational);
  EXPECT_EQ(smallest_field(parse_scheme("jspline:s=1+jspline:s=sqrt(2)")), Field::algebraic);
  EXPECT_EQ(smallest_field(parse_scheme("jspline:s=s")), Field::rational_function);
  EXPECT_EQ(smallest_field(parse_scheme("jspline:a=sqrt(2),b=y")), Field::inexact);
  EXPECT_EQ(
      smallest_field(parse_scheme("jspline:s=sqrt(2)-sqrt(3)-sqrt(5)-sqrt(7)-sqrt(11)-sqrt(13)-sqrt(17)")),
      Field::inexact);
}

TEST(Instantiate, ExactSchemeTakesTheSmallestRing) {
  const auto rational =
      exact_scheme(parse_scheme("jspline:s=sqrt(2)*sqrt(2)"));  // algebraic on the way, rational in the end
  ASSERT_TRUE(std::holds_alternative<Scheme<Rational>>(rational));
  EXPECT_EQ(std::get<Scheme<Rational>>(rational).steps[0], jspline(Rational(2)));
  const auto algebraic = exact_scheme(parse_scheme("jspline:s=sqrt(2)"));
  ASSERT_TRUE(std::holds_alternative<Scheme<Algebraic>>(algebraic));
  EXPECT_EQ(std::get<Scheme<Algebraic>>(algebraic).steps[0], jspline(root_two));
  EXPECT_TRUE(std::holds_alternative<Scheme<F>>(exact_scheme(parse_scheme("four-point:w=w"))));
  EXPECT_THROW(exact_scheme(parse_scheme("jspline:a=sqrt(2),b=y")), OutsideRingError);
}

TEST(Instantiate, IntervalsHoldTheExactMaskAtEveryPrecision) {
  for (const char* text :
       {"jspline:s=-33/26", "jspline:s=sqrt(2)", "bspline:degree=60", "dyn-floater-hormann:w=1/100"}) {
    const SchemeDescription scheme = parse_scheme(text);
    for (const long bits : {64L, 400L}) {
      const auto intervals = interval_scheme(scheme, {}, bits).steps[0].symbol;
      const auto exact = instantiate<Algebraic>(scheme).steps[0].symbol;
      ASSERT_EQ(intervals.size(), exact.size());
      for (int i = exact.first(); i <= exact.last(); ++i) {
        EXPECT_TRUE(intervals[i].overlaps(exact[i].to_interval(1000))) << text << " at " << i;
        EXPECT_LT(intervals[i].radius(), bits > 64 ? 1e-115 : 1e-17) << text << " at " << i;
      }
    }
  }
}

TEST(Instantiate, IntervalsOfASymbolKeepTheirPrecision) {
  const ScratchFolder folder;
  const std::string path = folder.write(
      "thirds.json", R"json({"name": "t", "arity": 2, "symbol": "(1+z)*(1/3+2*z/3)*sqrt(9/4)*(2/3)"})json");
  const auto mask = interval_scheme(parse_scheme(path), {}, 400).steps[0].symbol;
  EXPECT_TRUE(mask[0].contains(Rational(1, 3)));
  EXPECT_LT(mask[0].radius(), 1e-115);
  EXPECT_LT(factored_interval_symbols(parse_scheme(path), {}, 400)[0].cofactor[0].radius(), 1e-115);
}

TEST(Instantiate, ReadsTheMaskOfAFile) {
  const ScratchFolder folder;
  const std::string path = folder.write("four.json", R"json({ "name": "generalised four-point", "arity": 2,
    "parameters": { "w": "1/16" },
    "mask": { "first": -3, "coefficients": ["-w", "0", "1/2+w", "1", "1/2+w", "0", "-w"] },
    "source": "Dyn, Levin, Gregory 1987" })json");
  EXPECT_EQ(instantiate<Rational>(parse_scheme(path)).steps[0], four_point(Rational(1, 16)));
  EXPECT_EQ(symbolic_scheme(parse_scheme(path + ":w=v")).steps[0], four_point(F::variable(0)));
  EXPECT_EQ(instantiate<Algebraic>(parse_scheme(path + ":w=sqrt(2)/32")).steps[0],
            four_point(root_two / Algebraic(32)));
}

TEST(Instantiate, ReadsTheSymbolOfAFile) {
  const ScratchFolder folder;
  const std::string path =
      folder.write("j.json", R"json({"name": "J_s as a symbol", "arity": 2, "parameters": {"s": 1},
    "symbol": "((1+z)/2)^4/z^3*(s-1 - 2*(s-2)*z + (s-1)*z^2)"
})json");
  const SchemeDescription scheme = parse_scheme(path + ":s=s");
  EXPECT_EQ(symbolic_scheme(scheme).steps[0], jspline(F::variable(0)));
  const std::vector<double> value{0.3};
  const Mask<double> expected = jspline(0.3);
  const Mask<double> found = instantiate<double>(scheme, value).steps[0];
  for (int i = -3; i <= 3; ++i) EXPECT_NEAR(found.symbol[i], expected.symbol[i], 1e-15);
  // A ternary symbol: the quadratic B-spline of arity 3, whose mask is (1, 3, 6, 7, 6, 3, 1)/9.
  const std::string ternary =
      folder.write("t.json", R"json({"name": "t", "arity": 3, "symbol": "3*((1+z+z^2)/3)^3/z^3"})json");
  std::vector<Rational> mask;
  for (const int c : {1, 3, 6, 7, 6, 3, 1}) mask.emplace_back(c, 9);
  const Mask<Rational> read = instantiate<Rational>(parse_scheme(ternary)).steps[0];
  EXPECT_EQ(read.arity, 3);
  EXPECT_EQ(read.symbol, Laurent<Rational>(-3, mask));
}

/// Daubechies' masks (sum 2) are orthogonal to their even shifts, and order n has n factors 1+z (Daubechies
/// 1988).
void expect_daubechies(const Laurent<Algebraic>& mask, int order) {
  ASSERT_EQ(mask.size(), 2 * order);
  for (int k = 0; k < order; ++k) {
    Algebraic product(0);
    for (int i = 0; i + 2 * k < 2 * order; ++i) product += mask[i] * mask[i + 2 * k];
    EXPECT_EQ(product, Algebraic(k == 0 ? 2 : 0)) << "shift " << 2 * k;
  }
  EXPECT_EQ(divide_out(mask, smoothing_factor<Algebraic>(2)).first, order);
}

TEST(Instantiate, HoldsDaubechiesMasksExactly) {
  const ScratchFolder folder;
  const std::string two = folder.write(
      "d2.json", R"json({"name": "order 2", "arity": 2, "symbol": "((1+z)/2)^2*((1+sqrt(3))+(1-sqrt(3))*z)"
})json");
  EXPECT_EQ(smallest_field(parse_scheme(two)), Field::algebraic);
  expect_daubechies(instantiate<Algebraic>(parse_scheme(two)).steps[0].symbol, 2);
  // The printed radicals of order 3.
  const std::string three =
      folder.write("d3.json", R"json({"name": "order 3", "arity": 2, "mask": {"first": 0, "coefficients": [
    "(1+sqrt(10)+sqrt(5+2*sqrt(10)))/16", "(5+sqrt(10)+3*sqrt(5+2*sqrt(10)))/16",
    "(10-2*sqrt(10)+2*sqrt(5+2*sqrt(10)))/16", "(10-2*sqrt(10)-2*sqrt(5+2*sqrt(10)))/16",
    "(5+sqrt(10)-3*sqrt(5+2*sqrt(10)))/16", "(1+sqrt(10)-sqrt(5+2*sqrt(10)))/16"]}})json");
  expect_daubechies(instantiate<Algebraic>(parse_scheme(three)).steps[0].symbol, 3);
}

TEST(Instantiate, KeepsWrittenSmoothingFactorsExact) {
  const ScratchFolder folder;
  const std::string path = folder.write(
      "d2.json", R"json({"name": "d2", "arity": 2, "symbol": "((1+z)/2)^2*((1+sqrt(3))+(1-sqrt(3))*z)"
})json");
  const auto symbols = factored_interval_symbols(parse_scheme(path + "+jspline:s=1"));
  ASSERT_EQ(symbols.size(), 2U);
  EXPECT_EQ(symbols[0].smoothing_factors, 2);
  EXPECT_EQ(symbols[0].cofactor.size(), 2);
  EXPECT_EQ(symbols[1].smoothing_factors, 0);  // not written as a symbol
  const std::string rounded =
      folder.write("r.json", R"json({"name": "r", "arity": 2, "symbol": "((1+z)/2)^2*(2.7320508-0.7320508*z)"
  })json");
  EXPECT_EQ(factored_interval_symbols(parse_scheme(rounded, {.rounded = true}))[0].smoothing_factors, 2);
}

TEST(Instantiate, RoundedMasksAreIntervalsOfHalfAUnit) {
  const ScratchFolder folder;
  const std::string path =
      folder.write("off.json", R"json({"name": "off", "arity": 2, "parameters": {"t": 0.5},
    "mask": {"first": 0, "coefficients": [0.683013, 1.183013, 0.316987, "-0.183012", "t-t"]}})json");
  const SchemeDescription scheme = parse_scheme(path, {.rounded = true});
  const auto mask = interval_scheme(scheme).steps[0].symbol;
  const Rational half_unit = Rational::parse("0.0000005");
  for (const auto& [i, text] : std::vector<std::pair<int, const char*>>{{0, "0.683013"}, {3, "-0.183012"}}) {
    EXPECT_LE(mask[i].lower(), Rational::parse(text) - half_unit);
    EXPECT_GE(mask[i].upper(), Rational::parse(text) + half_unit);
    EXPECT_LT(mask[i].upper() - mask[i].lower(), Rational(3) * half_unit);
  }
  EXPECT_TRUE(mask[4].contains(Rational(0)));
  EXPECT_LT(mask[4].radius(), 1e-30);  // values of parameters are exact
  // Exact rings take the decimals as written.
  EXPECT_EQ(instantiate<Rational>(scheme).steps[0].symbol[3], Rational(-183012, 1000000));
}

TEST(Instantiate, IntervalsThatCannotReachTheAritySayWhere) {
  const ScratchFolder folder;
  const std::string path = folder.write("s.json", R"json({"name": "s", "arity": 2, "parameters": {"w": 2},
    "mask": {"first": 0, "coefficients": ["sqrt(w)", "2-sqrt(w)"]
  }
  })json");
  const SchemeDescription scheme = parse_scheme(path + ":w=w");
  EXPECT_EQ(smallest_field(scheme), Field::inexact);
  const std::vector<Interval> inside{Interval::hull(Rational(1), Rational(2))};
  EXPECT_TRUE(interval_scheme(scheme, inside).steps[0].symbol[0].contains(Rational(5, 4)));
  const std::vector<Interval> across{Interval::hull(Rational(-1), Rational(2))};
  expect_input_error([&] { return interval_scheme(scheme, across); },
                     {"s.json:2: coefficient 1", "reaches zero", "w = w"});
}

}  // namespace
}  // namespace subdiv
