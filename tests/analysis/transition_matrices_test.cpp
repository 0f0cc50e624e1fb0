#include "analysis/transition_matrices.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "schemes/bspline.h"
#include "schemes/dyn_floater_hormann.h"
#include "schemes/four_point.h"
#include "tests/analysis/daubechies.h"

namespace subdiv {
namespace {

Mask<Rational> ternary_bspline(int degree) {
  const Laurent<Rational> third = Laurent<Rational>::constant(Rational(1, 3)) * smoothing_factor<Rational>(3);
  return {3, Laurent<Rational>(3) * pow(third, degree + 1)};
}

/// m z^shift (sigma/m)^n b, multiplied out.
Laurent<Rational> expanded(const NormalForm<Rational>& form) {
  const Laurent<Rational> average =
      Laurent<Rational>::constant(Rational(1, form.arity)) * smoothing_factor<Rational>(form.arity);
  return shift(Laurent<Rational>(form.arity) * pow(average, form.factors) * form.b, form.shift);
}

TEST(NormalForm, OfKnownSchemes) {
  const NormalForm<Rational> four = normal_form(four_point(Rational(1, 10)));
  EXPECT_EQ(four.factors, 2);
  EXPECT_EQ(four.b, Laurent<Rational>(0, {Rational(-1, 5), Rational(2, 5), Rational(3, 5), Rational(2, 5),
                                          Rational(-1, 5)}));
  EXPECT_EQ(normal_form(four_point(Rational(1, 16))).factors, 4);
  const NormalForm<Rational> dual = normal_form(dyn_floater_hormann(Rational(1, 100)));
  EXPECT_EQ(dual.factors, 3);
  EXPECT_EQ(dual.b, Laurent<Rational>(0, {Rational(-1, 5), Rational(8, 25), Rational(19, 25), Rational(8, 25),
                                          Rational(-1, 5)}));
  for (int degree = 0; degree < 5; ++degree) {
    EXPECT_EQ(normal_form(bspline<Rational>(degree)).b, Laurent<Rational>(1));
    EXPECT_EQ(normal_form(bspline<Rational>(degree)).factors, degree + 1);
    EXPECT_EQ(normal_form(ternary_bspline(degree)).factors, degree + 1);
  }
}

TEST(NormalForm, MultipliesOutToTheSymbol) {
  const Laurent<Rational> odd(-3,
                              {Rational(1, 3), Rational(-2), Rational(5), Rational(1, 7), Rational(-4, 21)});
  for (const int arity : {2, 3, 4}) {
    const Laurent<Rational> scaled = Laurent<Rational>::constant(Rational(arity) / sum(odd)) * odd;
    const Mask<Rational> mask{arity, Laurent<Rational>::constant(pow(Rational(1, arity), 2)) *
                                         pow(smoothing_factor<Rational>(arity), 2) * scaled};
    const NormalForm<Rational> form = normal_form(mask);
    EXPECT_EQ(form.factors, 2);
    EXPECT_EQ(sum(form.b), Rational(1));
    EXPECT_EQ(form.b.first(), 0);
    EXPECT_EQ(expanded(form), mask.symbol);
  }
}

TEST(NormalForm, RejectsSymbolsThatDoNotSumToTheArity) {
  EXPECT_THROW((void)normal_form(Mask<Rational>{2, Laurent<Rational>()}), std::domain_error);
  EXPECT_THROW((void)normal_form(Mask<Rational>{2, Laurent<Rational>(0, {Rational(1), Rational(2)})}),
               std::domain_error);
  EXPECT_THROW((void)normal_form(Mask<Rational>{3, bspline<Rational>(2).symbol}), std::domain_error);
}

TEST(TransitionMatrices, OfKnownSchemes) {
  const auto t = transition_matrices(normal_form(four_point(Rational(1, 8))));
  ASSERT_EQ(t.size(), 2u);
  ASSERT_EQ(t[0].rows(), 4);
  // Rows b_{2i-j} and b_{2i+1-j} of b = (-1, 2, 2, 2, -1)/4.
  const std::vector<std::vector<int>> zero{{-1, 0, 0, 0}, {2, 2, -1, 0}, {-1, 2, 2, 2}, {0, 0, -1, 2}};
  const std::vector<std::vector<int>> one{{2, -1, 0, 0}, {2, 2, 2, -1}, {0, -1, 2, 2}, {0, 0, 0, -1}};
  for (Eigen::Index i = 0; i < 4; ++i) {
    for (Eigen::Index j = 0; j < 4; ++j) {
      EXPECT_EQ(t[0](i, j), Rational(zero[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)], 4));
      EXPECT_EQ(t[1](i, j), Rational(one[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)], 4));
    }
  }
  EXPECT_EQ(transition_matrices(normal_form(ternary_bspline(3))).size(), 3u);
}

TEST(TransitionMatrices, GiveTheResidueClassesOfTheIterates) {
  for (const int arity : {2, 3}) {
    const Laurent<Rational> b(0, {Rational(2), Rational(-1), Rational(1, 3), Rational(5), Rational(-16, 3)});
    const NormalForm<Rational> form{arity, 0, 0, b};
    const auto t = transition_matrices(form);
    const Laurent<Rational> twice = b * upsample(b, arity);
    Vector<Rational> start = Vector<Rational>::Constant(t[0].rows(), Rational(0));
    start(0) = Rational(1);
    for (int first = 0; first < arity; ++first) {
      for (int second = 0; second < arity; ++second) {
        const Vector<Rational> v = t[static_cast<std::size_t>(second)] *
                                   Vector<Rational>(t[static_cast<std::size_t>(first)] * start);
        for (Eigen::Index l = 0; l < v.size(); ++l) {
          EXPECT_EQ(v(l), twice[first + arity * second + arity * arity * static_cast<int>(l)]);
        }
      }
    }
  }
}

/// The mask of a normal form with each coefficient widened by the given radius.
Mask<Interval> widened(const NormalForm<Interval>& form, const Rational& radius) {
  Laurent<Interval> average(0, {Interval(Rational(1, 2)), Interval(Rational(1, 2))});
  const Laurent<Interval> symbol = Laurent<Interval>(2) * pow(average, form.factors) * form.b;
  return {2,
          map_coefficients(symbol, [&](const Interval& c) { return c + Interval::hull(-radius, radius); })};
}

TEST(NormalForm, OfIntervalsEnclosesTheExactOne) {
  const NormalForm<Interval> exact = testing::daubechies(4);
  const Rational radius = pow(Rational(10), -12);
  const NormalForm<Interval> form = normal_form(widened(exact, radius), 4);
  ASSERT_EQ(form.degree(), exact.degree());
  for (int i = 0; i <= form.degree(); ++i) {
    EXPECT_TRUE(form.b[i].contains(exact.b[i])) << i;
    EXPECT_LT(form.b[i].radius(), 1e-9) << i;
    EXPECT_GT(form.b[i].radius(), 1e-13) << i;
  }
}

TEST(NormalForm, OfIntervalsRefusesFactorsThatTheyExclude) {
  const Mask<Interval> mask = widened(testing::daubechies(4), pow(Rational(10), -12));
  EXPECT_THROW((void)normal_form(mask, 5), std::domain_error);
  EXPECT_THROW((void)normal_form(mask, 8), std::domain_error);
}

}  // namespace
}  // namespace subdiv
