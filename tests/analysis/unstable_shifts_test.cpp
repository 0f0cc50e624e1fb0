#include "analysis/unstable_shifts.h"

#include <gtest/gtest.h>

#include "schemes/bspline.h"
#include "schemes/deslauriers_dubuc.h"
#include "schemes/dyn_floater_hormann.h"
#include "schemes/four_point.h"
#include "schemes/jspline.h"
#include "tests/analysis/daubechies.h"

namespace subdiv {
namespace {

Laurent<Rational> polynomial(std::vector<Rational> coefficients) { return {0, std::move(coefficients)}; }

IndependentForm<Rational> reduce(const Mask<Rational>& mask) { return independent_form(normal_form(mask)); }

TEST(UnstableShifts, CyclotomicPolynomials) {
  EXPECT_EQ(cyclotomic_polynomial(3), polynomial({1, 1, 1}));
  EXPECT_EQ(cyclotomic_polynomial(5), polynomial({1, 1, 1, 1, 1}));
  EXPECT_EQ(cyclotomic_polynomial(15), polynomial({1, -1, 0, 1, -1, 1, 0, -1, 1}));
  EXPECT_EQ(cycle_orders(2, 4), (std::vector{3, 5}));
  EXPECT_EQ(cycle_orders(3, 4), (std::vector{2, 4}));
  EXPECT_EQ(cycle_orders(2, 6), (std::vector{3, 5, 7, 9}));
}

TEST(UnstableShifts, OfJSplinesAtTwoAndThree) {
  // phi_2 is the mean of two shifted quartic B-splines, phi_3 of three cubic ones; elsewhere the shifts are
  // independent.
  const IndependentForm<Rational> two = reduce(jspline<Rational>(2, 2));
  EXPECT_EQ(two.independent, Decision::no);
  EXPECT_EQ(two.t, polynomial({Rational(1, 2), Rational(1, 2)}));
  EXPECT_EQ(two.form.factors, 5);
  EXPECT_EQ(two.form.b, Laurent<Rational>(1));
  const IndependentForm<Rational> three = reduce(jspline<Rational>(3, 3));
  EXPECT_EQ(three.independent, Decision::no);
  EXPECT_EQ(three.t, polynomial({Rational(1, 3), Rational(1, 3), Rational(1, 3)}));
  EXPECT_EQ(three.form.factors, 4);
  EXPECT_EQ(three.form.b, Laurent<Rational>(1));
  for (const Rational& s :
       {Rational(-1), Rational(1), Rational(3, 2), Rational(5, 2), Rational(7, 2), Rational(9)}) {
    const IndependentForm<Rational> r = reduce(jspline(s, s));
    EXPECT_EQ(r.independent, Decision::yes);
    EXPECT_EQ(r.t, Laurent<Rational>(1));
  }
}

TEST(UnstableShifts, SatisfyTheRefinementIdentity) {
  // a(z) t(z) = a'(z) t(z^m), that is b(z) t(z) = b'(z) t(z^m): both kinds of factors at once.
  for (const int arity : {2, 3}) {
    const Laurent<Rational> line = polynomial({Rational(2, 3), Rational(1, 3)});
    const Laurent<Rational> cycle = cyclotomic_polynomial(arity == 2 ? 5 : 4);
    const Laurent<Rational> normal = Laurent<Rational>::constant(Rational(1) / sum(cycle)) * cycle;
    const Laurent<Rational> rest = polynomial({3, -1, -1});
    const Laurent<Rational> b =
        rest * upsample(line, arity) * divide_exactly(upsample(normal, arity), normal).value();
    const NormalForm<Rational> form{arity, 2, 0, b};
    const IndependentForm<Rational> r = independent_form(form);
    EXPECT_EQ(r.independent, Decision::no);
    EXPECT_EQ(r.t, line * normal);
    EXPECT_EQ(r.form.b, rest * line);
    EXPECT_EQ(r.form.factors, 2);
    EXPECT_EQ(form.b * r.t, r.form.b * upsample(r.t, arity));
  }
}

TEST(UnstableShifts, OfTwoParameterJSplines) {
  // a = 2: a symmetric pair of zeros +-i; a = b - 1; 2a + b = 9: a cycle of order 3; (4, 9): one of order 5.
  const auto degree = [](const Rational& a, const Rational& b) { return reduce(jspline(a, b)).t.size() - 1; };
  EXPECT_EQ(degree(2, 4), 1);
  EXPECT_EQ(degree(Rational(5), Rational(6)), 2);
  EXPECT_EQ(degree(1, 7), 2);
  EXPECT_EQ(degree(4, 9), 4);
  EXPECT_EQ(degree(1, 3), 0);
  EXPECT_EQ(degree(Rational(1, 2), Rational(1, 3)), 0);
}

TEST(UnstableShifts, OfDualFourPointSchemes) {
  EXPECT_EQ(reduce(dyn_floater_hormann(Rational(-1, 28))).t.size(), 3);
  EXPECT_EQ(reduce(dyn_floater_hormann(Rational(-1, 16))).t.size(), 2);
  EXPECT_EQ(reduce(dyn_floater_hormann(Rational(1, 100))).independent, Decision::yes);
}

TEST(UnstableShifts, OfBSplinesAndInterpolatorySchemesAreIndependent) {
  for (int degree = 0; degree < 6; ++degree)
    EXPECT_EQ(reduce(bspline<Rational>(degree)).independent, Decision::yes);
  for (int points = 2; points <= 10; points += 2) {
    EXPECT_EQ(reduce(deslauriers_dubuc<Rational>(points)).independent, Decision::yes);
  }
  // (1+z)^4 (1+z^2) / 16 is the J-spline of 2 again.
  const Laurent<Rational> one_plus = polynomial({1, 1});
  const Mask<Rational> mask{
      2, Laurent<Rational>::constant(Rational(1, 16)) * pow(one_plus, 4) * upsample(one_plus, 2)};
  EXPECT_EQ(reduce(mask).form.factors, 5);
}

TEST(UnstableShifts, AreExcludedForIntervals) {
  for (int order = 2; order <= 10; ++order) {
    EXPECT_EQ(have_independent_shifts(testing::daubechies(order)), Decision::yes) << order;
  }
  for (const Rational& s : {Rational(1, 2), Rational(5, 2)}) {
    EXPECT_EQ(have_independent_shifts(enclose(normal_form(jspline(s, s)))), Decision::yes);
  }
  EXPECT_EQ(have_independent_shifts(enclose(normal_form(four_point(Rational(1, 10))))), Decision::yes);
  for (const int s : {2, 3}) {
    const Rational x(s);
    EXPECT_EQ(have_independent_shifts(enclose(normal_form(jspline(x, x)))), Decision::undecided) << s;
  }
  EXPECT_EQ(have_independent_shifts(enclose(normal_form(jspline(Rational(4), Rational(9))))),
            Decision::undecided);
}

TEST(UnstableShifts, OfAlgebraicCoefficients) {
  const Algebraic root = sqrt(Algebraic(2));
  const IndependentForm<Algebraic> r = independent_form(normal_form(jspline(root, root)));
  EXPECT_EQ(r.independent, Decision::yes);
  // a = 2 on any b.
  const IndependentForm<Algebraic> s = independent_form(normal_form(jspline(Algebraic(2), root)));
  EXPECT_EQ(s.independent, Decision::no);
  EXPECT_EQ(s.t.size(), 2);
}

}  // namespace
}  // namespace subdiv
