#include "analysis/continuity_certificate.h"

#include <random>
#include <stdexcept>
#include <tuple>

#include <gtest/gtest.h>

#include "analysis/hoelder.h"
#include "schemes/algebra/specialize.h"
#include "schemes/bspline.h"
#include "schemes/dyn_floater_hormann.h"
#include "schemes/four_point.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

const Function a = Function::variable(0);
const Function b = Function::variable(1);

/// Where the answer is `smooth`.
std::string set_text(const ContinuityCertificate& certificate, Decision smooth) {
  RealSet set;
  for (const CertificateCell& cell : certificate.cells) {
    if (cell.smooth == smooth) set.parts.push_back(cell.sides.at(0));
  }
  return set.to_string();
}

CertificateOptions patient(std::optional<int> depth = std::nullopt) {
  CertificateOptions options;
  options.seconds = 120;
  options.depth = depth;
  return options;
}

/// The one proved interval; its upper end has this minimal polynomial, constant term first.
void expect_upper_end(const ContinuityCertificate& certificate, const std::vector<Rational>& polynomial,
                      double value) {
  int proved = 0;
  for (const CertificateCell& cell : certificate.cells) {
    if (cell.smooth != Decision::yes) continue;
    ++proved;
    EXPECT_EQ(cell.sides[0].upper->minimal_polynomial(), polynomial);
    EXPECT_NEAR(cell.sides[0].upper->to_interval().to_double(), value, 1e-12);
    EXPECT_FALSE(cell.sides[0].upper_closed);
  }
  EXPECT_EQ(proved, 1);
  EXPECT_EQ(certificate.undecided, Rational(0));
}

TEST(ContinuityCertificate, JSplinesHaveOpenRangesWithIntegerEnds) {
  // C^0 on (-6, 10), C^1 on (-2, 6), C^2 on (0, 4), C^3 on (1, 3): the joint spectral radius of the cofactor
  // reaches 8, 4, 2, 1 there (three_tap_smoothness.h).
  const Rational lower(-8);
  const Rational upper(12);
  for (const auto& [continuity, inside, outside] :
       {std::tuple(0, "(-6, 10)", "[-8, -6] u [10, 12]"), std::tuple(1, "(-2, 6)", "[-8, -2] u [6, 12]"),
        std::tuple(2, "(0, 4)", "[-8, 0] u [4, 12]"), std::tuple(3, "(1, 3)", "[-8, 1] u [3, 12]")}) {
    const auto certificate = certify_continuity(jspline(a), continuity, {{lower}, {upper}}, patient());
    EXPECT_EQ(set_text(certificate, Decision::yes), inside);
    EXPECT_EQ(set_text(certificate, Decision::no), outside);
    EXPECT_EQ(certificate.undecided, Rational(0));
    EXPECT_EQ(certificate.status(), std::nullopt);
  }
}

TEST(ContinuityCertificate, MoreSmoothnessThanFactorsNeedsFurtherSumRules) {
  // Only J_{3/2}, the quintic B-spline, is C^4 (jsplines 3); it is not C^5.
  const ParameterBox box{{0}, {4}};
  const auto fourth = certify_continuity(jspline(a), 4, box, patient());
  EXPECT_EQ(fourth.factors, 4);
  EXPECT_EQ(set_text(fourth, Decision::yes), "{3/2}");
  EXPECT_EQ(set_text(fourth, Decision::no), "[0, 3/2) u (3/2, 4]");
  EXPECT_EQ(certify_continuity(jspline(a), 5, box, patient()).status(), Decision::no);
  EXPECT_EQ(certify_continuity(jspline(a), 300, box, patient()).status(), Decision::no);
  EXPECT_EQ(certify_continuity(jspline(a), 4, {{2}, {3}}, patient()).status(), Decision::no);
  const auto at_end = certify_continuity(jspline(a), 4, {{Rational(3, 2)}, {2}}, patient());
  EXPECT_EQ(set_text(at_end, Decision::yes), "{3/2}");
  EXPECT_EQ(set_text(at_end, Decision::no), "(3/2, 2]");
}

TEST(ContinuityCertificate, TensionsUpToTheirAlgebraicLimits) {
  // Hechler, Moessner & Reif 2009: four-point tension is C^1 for 0 < w < w*, the root of 32 w^3 + 4 w - 1.
  const auto four = certify_continuity(four_point(a), 1, {{Rational(-1, 10)}, {Rational(3, 10)}}, patient());
  expect_upper_end(four, {-1, 4, 0, 32}, 0.19272924926481);
  EXPECT_TRUE(*four.cells.at(0).sides[0].upper == Algebraic(0));
  // dyn-floater-hormann: the product T_0 T_1 expands from a root of this quartic on.
  const auto dual =
      certify_continuity(dyn_floater_hormann(a), 2, {{Rational(-1, 10)}, {Rational(1, 10)}}, patient());
  expect_upper_end(dual, {-1, 24, 352, 25600, 327680}, 0.0214640075493);
  // At w = -1/28 the symbol has the factor of a cycle, and the limits are C^2 though the scheme is not.
  ASSERT_TRUE(dual.dependent.has_value());
  bool found = false;
  for (const DependentValue& value : *dual.dependent) {
    if (!(value.value == Algebraic(Rational(-1, 28)))) continue;
    found = true;
    EXPECT_EQ(value.limits_smooth, Decision::yes);
  }
  EXPECT_TRUE(found);
}

TEST(ContinuityCertificate, RationalFunctionsOfTheParameter) {
  // w = 1/t: the limit w* becomes the root of 32 + 4 t^2 - t^3.
  const auto certificate = certify_continuity(four_point(Function(1) / a), 1, {{1}, {9}}, patient());
  ASSERT_EQ(certificate.cells.size(), 2U);
  const RealInterval& proved = certificate.cells[1].sides[0];
  EXPECT_EQ(proved.lower->minimal_polynomial(), (std::vector<Rational>{-32, 0, -4, 1}));
  EXPECT_FALSE(proved.lower_closed);
  EXPECT_TRUE(*proved.upper == Algebraic(9));
  EXPECT_THROW((void)certify_continuity(four_point(Function(1) / a), 1, {{-1}, {1}}), std::domain_error);
  EXPECT_THROW((void)certify_continuity(four_point(Function(1) / a), 1, {{0}, {0}}), std::domain_error);
}

TEST(ContinuityCertificate, PartsOfALineAgreeWithSingleSchemes) {
  // Symbols without symmetry: (1+z)^3/4 times 1 + t (1 - z)(1 + 3 z), and arity 3.
  const auto asymmetric = [](const Function& t) {
    Laurent<Function> cofactor(0, {Function(1) + t, Function(2) * t, Function(-3) * t});
    return Mask<Function>{2, Laurent<Function>::constant(fraction<Function>(1, 4)) *
                                 pow(smoothing_factor<Function>(2), 3) * cofactor};
  };
  const auto ternary = [](const Function& t) {
    Laurent<Function> cofactor(0, {t, Function(1) - Function(2) * t, t});
    return Mask<Function>{3, Laurent<Function>::constant(fraction<Function>(1, 3)) *
                                 pow(smoothing_factor<Function>(3), 2) * cofactor};
  };
  std::mt19937 random(5);
  std::uniform_int_distribution<int> grid(-100, 100);
  for (const auto& mask : {asymmetric(a), ternary(a)}) {
    for (const int continuity : {0, 1}) {
      const auto certificate = certify_continuity(mask, continuity, {{-2}, {2}}, patient());
      EXPECT_LT(certificate.undecided, Rational(1, 100000));
      int proved = 0;
      for (int trial = 0; trial < 12; ++trial) {
        const Rational at(grid(random), 51);
        const auto single = smoothness(
            normal_form(map_coefficients(mask, [&](const Function& f) { return specialize(f, 0, at); })));
        for (const CertificateCell& cell : certificate.cells) {
          if (!cell.sides[0].contains(Algebraic(at))) continue;
          EXPECT_TRUE(cell.smooth != Decision::yes || single.continuity_limit >= continuity)
              << at.to_string();
          EXPECT_TRUE(cell.smooth != Decision::no || single.continuity < continuity) << at.to_string();
          if (cell.smooth == Decision::yes) ++proved;
        }
      }
      EXPECT_GT(proved, 0);
    }
  }
}

TEST(ContinuityCertificate, SidesOfOneValueAndUnusedParameters) {
  // One value of the only parameter: J_{-2} is not C^1, J_{-1} is.
  EXPECT_EQ(certify_continuity(jspline(a), 1, {{-2}, {-2}}, patient()).status(), Decision::no);
  const auto inside = certify_continuity(jspline(a), 1, {{-1}, {-1}}, patient());
  EXPECT_EQ(inside.status(), Decision::yes);
  EXPECT_EQ(inside.cells.at(0).ground, Ground::value);
  // J_{a,b} with a = 2 is C^1 exactly for -1 < b < 7: its cofactor has a further factor 1 + z.
  const auto line = certify_continuity(jspline(a, b), 1, {{2, -3}, {2, 8}}, patient());
  ASSERT_EQ(line.cells.size(), 3U);
  EXPECT_TRUE(line.cells[0].sides[0].is_point());
  EXPECT_TRUE(*line.cells[1].sides[1].lower == Algebraic(-1));
  EXPECT_TRUE(*line.cells[1].sides[1].upper == Algebraic(7));
  EXPECT_EQ(line.cells[1].smooth, Decision::yes);
  // A scheme that does not use the parameter.
  const auto cubic = certify_continuity(bspline<Function>(3), 2, {{-5}, {5}}, patient());
  EXPECT_EQ(cubic.status(), Decision::yes);
  EXPECT_TRUE(*cubic.cells.at(0).sides[0].upper == Algebraic(5));
}

TEST(ContinuityCertificate, BoxesOfTwoParameters) {
  const ParameterBox box{{-4, -5}, {7, 10}};
  const auto coarse = certify_continuity(jspline(a, b), 1, box, patient(3));
  const auto fine = certify_continuity(jspline(a, b), 1, box, patient(5));
  EXPECT_LT(fine.undecided, coarse.undecided);
  EXPECT_LT(fine.undecided, Rational(165) * Rational(3, 20));
  EXPECT_EQ(fine.status(), Decision::undecided);
  // The diagonal: C^1 exactly for -2 < s < 6.
  for (const CertificateCell& cell : fine.cells) {
    for (int s = -16; s <= 28; ++s) {
      const Algebraic at(Rational(s, 4));
      if (!cell.sides[0].contains(at) || !cell.sides[1].contains(at)) continue;
      if (cell.smooth == Decision::undecided) continue;
      EXPECT_EQ(cell.smooth == Decision::yes, -8 < s && s < 24) << s;
    }
  }
  // Off the diagonal there are two factors only: no C^2 but, possibly, on a = b.
  const auto second = certify_continuity(jspline(a, b), 2, box, patient());
  EXPECT_EQ(second.status(), Decision::undecided);
  ASSERT_EQ(second.exceptions.size(), 1U);
  EXPECT_TRUE(second.exceptions[0] == Polynomial::variable(0) - Polynomial::variable(1) ||
              second.exceptions[0] == Polynomial::variable(1) - Polynomial::variable(0));
  EXPECT_EQ(certify_continuity(jspline(a, b), 2, {{0, 2}, {1, 3}}, patient()).status(), Decision::no);
}

TEST(ContinuityCertificate, NothingIsClaimedWithoutTime) {
  CertificateOptions hasty;
  hasty.seconds = 0;
  const auto certificate = certify_continuity(jspline(a), 1, {{-3}, {7}}, hasty);
  EXPECT_EQ(certificate.status(), Decision::undecided);
  EXPECT_GE(certificate.undecided, Rational(10));
}

TEST(ContinuityCertificate, TheFirstSumRuleIsNeeded) {
  const Mask<Function> mask{2, Laurent<Function>(0, {a, Function(2) - a})};
  EXPECT_THROW((void)certify_continuity(mask, 0, {{0}, {2}}), std::domain_error);
}

}  // namespace
}  // namespace subdiv
