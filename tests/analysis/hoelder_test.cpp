#include "analysis/hoelder.h"

#include <chrono>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/iterate_norm.h"
#include "analysis/nonnegative_symbol.h"
#include "analysis/sobolev.h"
#include "schemes/bspline.h"
#include "schemes/deslauriers_dubuc.h"
#include "schemes/dyn_floater_hormann.h"
#include "schemes/four_point.h"
#include "schemes/jspline.h"
#include "tests/analysis/daubechies.h"
#include "tests/analysis/enclosure_matchers.h"

namespace subdiv {
namespace {

using testing::agrees;

Smoothness of(const Mask<Rational>& mask) { return smoothness(normal_form(mask)); }

/// Hassan, Ivrissimtzis, Dodgson & Sabin, Computer Aided Geometric Design 19 (2002): the rule at 1/3 and its
/// mirror image.
Mask<Rational> ternary_four_point(const Rational& mu) {
  const Rational outer = Rational(-1, 18) - mu / Rational(6);
  const Rational near = Rational(13, 18) + mu / Rational(2);
  const Rational far = Rational(7, 18) - mu / Rational(2);
  const Rational last = Rational(-1, 18) + mu / Rational(6);
  return {3, Laurent<Rational>(-5, {last, outer, 0, far, near, 1, near, far, 0, outer, last})};
}

void expect_continuity(const Smoothness& s, int k) {
  EXPECT_EQ(s.continuity, k);
  EXPECT_EQ(s.continuity_limit, k);
}

TEST(Hoelder, OfBSplines) {
  for (int degree = 0; degree < 7; ++degree) {
    const Smoothness s = of(bspline<Rational>(degree));
    EXPECT_EQ(s.exponent.exact, std::to_string(degree));
    expect_continuity(s, degree - 1);
    EXPECT_EQ(s.converges, degree > 0 ? Decision::yes : Decision::no);
    EXPECT_EQ(s.attained, degree > 0 ? Decision::yes : Decision::undecided);
  }
}

TEST(Hoelder, OfDaubechiesMasks) {
  // 0.5500, 1.0878, 1.6179: Daubechies & Lagarias 1992; 1.969, 2.189, 2.460, 2.761, 3.074: Rioul 1992. For
  // order 10 the end points alone give 3.381.
  const std::vector<std::pair<int, std::string>> exponents{
      {2, "0.550015686523504151078837439938"}, {3, "1.08783392627124580618526252431"},
      {4, "1.61792631113875863821332537769"},  {5, "1.96896353023906305138951400228"},
      {6, "2.1891392779962126333136995202"},   {7, "2.46040889528136479895407315043"},
      {8, "2.76081838668143514401445688936"},  {9, "3.07361488069186131214184594758"},
      {10, "3.36139082139778059294261327157"}};
  for (const auto& [order, exponent] : exponents) {
    const SmoothnessReport<Interval> r = smoothness_report(testing::daubechies(order));
    EXPECT_TRUE(agrees(r.limits.exponent, exponent)) << order;
    EXPECT_EQ(r.reduction.independent, Decision::yes);
    EXPECT_EQ(r.limits.attained, Decision::yes);
    expect_continuity(r.limits, Rational::parse(exponent) < Rational(1) ? 0 : exponent[0] - '0');
  }
}

TEST(Hoelder, OfRoundedCoefficients) {
  // Daubechies' order 4 with coefficients of 12 decimals as intervals of half a unit, its four sum rules
  // assumed.
  const NormalForm<Interval> exact = testing::daubechies(4);
  const Laurent<Interval> average(0, {Interval(Rational(1, 2)), Interval(Rational(1, 2))});
  const Rational unit = pow(Rational(10), -12);
  const Laurent<Interval> rounded =
      map_coefficients(Laurent<Interval>(2) * pow(average, 4) * exact.b, [&](const Interval& c) {
        const Rational decimal = floor(c.midpoint() / unit + Rational(1, 2)) * unit;
        return Interval::hull(decimal - unit / Rational(2), decimal + unit / Rational(2));
      });
  const Smoothness s = smoothness(normal_form(Mask<Interval>{2, rounded}, 4));
  EXPECT_TRUE(s.exponent.contains(Rational::parse("1.61792631113875863821")));
  EXPECT_LT(s.exponent.width(), pow(Rational(10), -8));
  expect_continuity(s, 1);
}

TEST(Hoelder, OfInterpolatorySchemes) {
  // Deslauriers & Dubuc: exponents 2 (not attained), 6 - log2 9, ..; the four-point scheme is C^1 (Dyn,
  // Gregory & Levin).
  const Smoothness four = of(deslauriers_dubuc<Rational>(4));
  EXPECT_EQ(four.exponent.exact, "2");
  expect_continuity(four, 1);
  EXPECT_EQ(four.attained, Decision::no);
  const Smoothness six = of(deslauriers_dubuc<Rational>(6));
  EXPECT_EQ(six.exponent.exact, "6-log2(9)");
  EXPECT_TRUE(agrees(six.exponent, "2.8300749985576876370925221121"));
  EXPECT_EQ(six.attained, Decision::yes);
  expect_continuity(six, 2);
  EXPECT_TRUE(agrees(of(deslauriers_dubuc<Rational>(8)).exponent, "3.55113053156384975860658795852"));
  EXPECT_TRUE(agrees(of(deslauriers_dubuc<Rational>(10)).exponent, "4.19357343450185174416304729536"));
}

TEST(Hoelder, OfTheFourPointSchemeWithTension) {
  // C^1 exactly for 0 < w < 0.19273.., the root of 32w^3+4w-1 (Hechler, Moessner & Reif 2009).
  expect_continuity(of(four_point(Rational::parse("0.1927"))), 1);
  expect_continuity(of(four_point(Rational::parse("0.1928"))), 0);
  expect_continuity(of(four_point(Rational(-1, 10))), 0);
  EXPECT_TRUE(agrees(of(four_point(Rational(1, 10))).exponent, "1.583705366959"));
  const Smoothness divergent = of(four_point(Rational(3, 5)));
  EXPECT_EQ(divergent.converges, Decision::no);
  expect_continuity(divergent, -1);
  EXPECT_LT(divergent.exponent.upper, Rational(0));
}

TEST(Hoelder, OfTheDualFourPointScheme) {
  // C^2 for 0 < w < 0.021464007549332.., a root of 327680w^4+25600w^3+352w^2+24w-1.
  expect_continuity(of(dyn_floater_hormann(Rational::parse("0.02146"))), 2);
  expect_continuity(of(dyn_floater_hormann(Rational::parse("0.02147"))), 1);
  EXPECT_TRUE(agrees(of(dyn_floater_hormann(Rational(1, 128))).exponent, "2.830074998558"));
}

TEST(Hoelder, OfTernarySchemes) {
  const Smoothness s = of(ternary_four_point(Rational(1, 11)));
  EXPECT_EQ(s.factors, 3);
  EXPECT_TRUE(agrees(s.exponent, "2.182658338644"));  // 2 + log3(11/9)
  expect_continuity(s, 2);
  EXPECT_TRUE(agrees(of(ternary_four_point(Rational(1, 12))).exponent, "2.121545511553"));
  EXPECT_TRUE(agrees(of(ternary_four_point(Rational(1, 10))).exponent, "2.095903274289"));
}

TEST(Hoelder, OfJSplines) {
  const auto j = [](const char* s) { return of(jspline(Rational::parse(s), Rational::parse(s))); };
  EXPECT_EQ(j("1.27").exponent.exact, "3-log2(73/100)");
  EXPECT_TRUE(agrees(j("0.689").exponent, "2.609332314440332496069552"));
  EXPECT_TRUE(agrees(j("-0.531").exponent, "1.660292492551402912416043"));
  const Smoothness best = j("1.5");
  EXPECT_EQ(best.exponent.exact, "5");
  expect_continuity(best, 4);
  expect_continuity(j("1.27"), 3);
  expect_continuity(j("0.689"), 2);
  expect_continuity(j("-0.531"), 1);
  expect_continuity(j("1"), 2);
  EXPECT_EQ(j("9.99").converges, Decision::yes);
  EXPECT_EQ(j("10").converges, Decision::no);
}

TEST(Hoelder, KnowsWhetherWholeExponentsAreAttained) {
  // At s = 0 the matrix at the vertex has a Jordan block: f' is not Lipschitz, but has the modulus h
  // log(1/h).
  const std::vector<std::tuple<int, std::string, Decision>> cases{
      {0, "2", Decision::no}, {1, "3", Decision::yes}, {2, "4", Decision::yes}, {3, "3", Decision::yes}};
  for (const auto& [s, exponent, attained] : cases) {
    const Smoothness r = of(jspline<Rational>(s, s));
    EXPECT_EQ(r.exponent.exact, exponent) << s;
    EXPECT_EQ(r.attained, attained) << s;
  }
}

TEST(Hoelder, TellsLimitsFromSchemes) {
  // J_{1,7}: the second differences of the scheme grow by 5/4 a level, the limits have the exponent 1 -
  // log2(3/4).
  const SmoothnessReport<Rational> r = smoothness_report(normal_form(jspline<Rational>(1, 7)));
  EXPECT_EQ(r.scheme.radius.value.exact, "5/4");
  EXPECT_EQ(r.limits.radius.value.exact, "3/4");
  expect_continuity(r.scheme, 0);
  expect_continuity(r.limits, 1);
  EXPECT_TRUE(agrees(r.limits.exponent, "1.415037499278"));
  // Dyn, Floater & Hormann at w = -1/28: rho = 8/7 and 5/7.
  const SmoothnessReport<Rational> d = smoothness_report(normal_form(dyn_floater_hormann(Rational(-1, 28))));
  EXPECT_EQ(d.scheme.radius.value.exact, "8/7");
  expect_continuity(d.limits, 2);
  EXPECT_TRUE(agrees(d.limits.exponent, "2.485426827170242"));
  // J_2: quartic B-splines either way.
  const SmoothnessReport<Rational> two = smoothness_report(normal_form(jspline<Rational>(2, 2)));
  EXPECT_EQ(two.scheme.exponent.exact, "4");
  EXPECT_EQ(two.limits.exponent.exact, "4");
  EXPECT_EQ(two.reduction.form.factors, 5);
}

TEST(Hoelder, OfIntervalsExcludesNothingThatFurtherSumRulesAllow) {
  // Too few sum rules assumed of B-splines: rho = 1/2 hides how many more there are.
  for (int degree = 1; degree < 5; ++degree) {
    const Laurent<Interval> symbol = map_coefficients(bspline<Rational>(degree).symbol,
                                                      [](const Rational& q) { return Interval(q, 192); });
    for (int assumed = 0; assumed <= degree + 1; ++assumed) {
      const NormalForm<Interval> form = normal_form(Mask<Interval>{2, symbol}, assumed);
      const Smoothness s = smoothness(form, {0.5, 200, 192});
      EXPECT_TRUE(s.exponent.contains(Rational(degree))) << degree << ' ' << assumed;
      EXPECT_LE(s.continuity, degree - 1);
      EXPECT_GE(s.continuity_limit, degree - 1) << degree << ' ' << assumed;
      EXPECT_NE(s.converges, Decision::no) << degree << ' ' << assumed;
      EXPECT_TRUE(sobolev_exponent(form).contains(Rational(2 * degree + 1, 2))) << degree << ' ' << assumed;
    }
  }
}

TEST(Hoelder, KeepsToItsTime) {
  // Of whole exponents, boundedness is decided within the same budget.
  const auto seconds = [](const auto& run) {
    const auto start = std::chrono::steady_clock::now();
    run();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  JointSpectralRadiusBudget budget;
  budget.seconds = 2;
  EXPECT_LT(seconds([&] { (void)smoothness_report(testing::daubechies(14), budget); }), 3);
  const NormalForm<Rational> whole{
      2, 4, 0, Laurent<Rational>(0, {Rational(1), Rational(1, 2), Rational(-2, 5), Rational(-1, 10)})};
  EXPECT_LT(seconds([&] { EXPECT_EQ(smoothness(whole).exponent.exact, "3"); }), 5);
}

TEST(Hoelder, ClaimsNoMoreOfLimitsThanTheShiftsAllow) {
  JointSpectralRadiusBudget budget;
  budget.seconds = 0.5;
  const SmoothnessReport<Interval> r =
      smoothness_report(enclose(normal_form(jspline<Rational>(1, 7))), budget);
  EXPECT_EQ(r.reduction.independent, Decision::undecided);
  EXPECT_EQ(r.scheme.continuity, 0);
  EXPECT_EQ(r.limits.continuity, 0);
  EXPECT_GE(r.limits.continuity_limit, 1);
  EXPECT_TRUE(r.limits.exponent.contains(Rational::parse("1.415037499278")));
}

// ---- Second routes
// -----------------------------------------------------------------------------------------

TEST(Hoelder, AgreesWithTheSingleMatrixOfNonNegativeSymbols) {
  for (int points = 4; points <= 12; points += 2) {
    const NormalForm<Rational> form = normal_form(deslauriers_dubuc<Rational>(points));
    ASSERT_TRUE(is_nonnegative(form)) << points;
    const Enclosure single = nonnegative_radius(form);
    const JointSpectralRadius joint = joint_spectral_radius(transition_matrices(form));
    ASSERT_TRUE(joint.exact) << points;
    EXPECT_EQ(single.exact, joint.value.exact) << points;
  }
  EXPECT_TRUE(is_nonnegative(normal_form(bspline<Rational>(3))));
  EXPECT_TRUE(is_nonnegative(normal_form(jspline<Rational>(1, 1))));
  EXPECT_FALSE(is_nonnegative(normal_form(four_point(Rational(1, 10)))));
  EXPECT_FALSE(is_nonnegative(normal_form(jspline(Rational(5, 2), Rational(5, 2)))));
}

TEST(Hoelder, LiesWithinTheSobolevBounds) {
  for (int degree = 0; degree < 5; ++degree) {
    // A B-spline of degree d has d + 1/2 derivatives in L_2.
    EXPECT_EQ(sobolev_exponent(normal_form(bspline<Rational>(degree))).exact,
              Rational(2 * degree + 1, 2).to_string());
  }
  EXPECT_TRUE(agrees(sobolev_exponent(testing::daubechies(2)), "1"));
  // Long masks: 61 x 61, in time.
  EXPECT_LT(sobolev_exponent(testing::daubechies(30, 512)).width(), pow(Rational(10), -6));
  for (int order = 2; order <= 8; ++order) {
    const NormalForm<Interval> form = testing::daubechies(order);
    const Enclosure s = sobolev_exponent(form);
    const Enclosure alpha = smoothness(form).exponent;
    EXPECT_LE(s.lower - Rational(1, 2), alpha.upper) << order;
    EXPECT_LE(alpha.lower, s.upper) << order;
  }
  for (const char* w : {"0.02", "0.0625", "0.1", "0.15"}) {
    const NormalForm<Rational> form = normal_form(four_point(Rational::parse(w)));
    const Enclosure s = sobolev_exponent(form);
    const Enclosure alpha = smoothness(form).exponent;
    EXPECT_LE(s.lower - Rational(1, 2), alpha.upper) << w;
    EXPECT_LE(alpha.lower, s.upper) << w;
  }
}

TEST(Hoelder, RadiusIsBelowTheNormsOfPowers) {
  for (const char* w : {"0.02", "0.1", "0.15", "-0.1"}) {
    const NormalForm<Rational> form = normal_form(four_point(Rational::parse(w)));
    const Enclosure radius = joint_spectral_radius(transition_matrices(form)).value;
    const std::vector<Rational> norms = iterate_norms(form.b, 2, 10);
    for (int k = 1; k <= 10; ++k)
      EXPECT_LE(pow(radius.lower, k), norms[static_cast<std::size_t>(k)]) << w << ' ' << k;
    // norm_k <= C rho^k with C from few steps: the tenth root is near.
    EXPECT_LE(norms[10], Rational(10) * pow(radius.upper, 10)) << w;
  }
}

TEST(Hoelder, OfASchemeThatViolatesTheFirstSumRule) {
  const Mask<Rational> mask{2, Laurent<Rational>(0, {Rational(1), Rational(1, 2), Rational(1, 2)})};
  const Smoothness s = of(mask);
  EXPECT_EQ(s.factors, 0);
  EXPECT_EQ(s.converges, Decision::no);
  expect_continuity(s, -1);
}

}  // namespace
}  // namespace subdiv
