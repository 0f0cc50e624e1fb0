#include "optimize/objectives.h"

#include <algorithm>
#include <functional>

#include <gtest/gtest.h>

#include "analysis/iterate_norm.h"
#include "analysis/uniform_bspline.h"
#include "schemes/algebra/univariate.h"
#include "schemes/bspline.h"
#include "schemes/dyn_floater_hormann.h"
#include "schemes/four_point.h"
#include "schemes/input_error.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

const Function x = Function::variable(0);
const Range range{Rational(-17, 10), Rational(29, 5)};

Scheme<Function> scheme(const Mask<Function>& mask) { return stationary<Function>("scheme", mask); }

Problem problem(const Mask<Function>& mask, const std::string& objective, Norm norm = Norm::linf) {
  return make_problem(scheme(mask), parse_objective(objective), norm, {range}, {"x"});
}

Summary solve(const Scheme<Function>& s, const std::string& objective, Norm norm,
              std::vector<Range> box = {range}) {
  return minimise(s, parse_objective(objective), norm, std::move(box), {"x", "y"});
}

std::string error_of(const std::function<void()>& f) {
  try {
    f();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string parse_error(const std::string& text) {
  return error_of([&] { (void)parse_objective(text); });
}

Rational at(const Function& f, const Rational& value) {
  const std::vector<Rational> point{value};
  return f.evaluate<Rational>(point);
}

TEST(Objectives, EveryListedExampleParsesAndPrintsItself) {
  EXPECT_EQ(objectives().size(), 6U);
  for (const ObjectiveDescription& entry : objectives()) {
    const Objective objective = parse_objective(entry.example);
    EXPECT_EQ(to_string(parse_objective(to_string(objective))), to_string(objective));
    EXPECT_FALSE(entry.description.empty());
    EXPECT_EQ(entry.norms, objective.kind == Objective::Kind::difference_norm ? "linf" : "l1, l2, linf");
  }
}

TEST(Objectives, OptionsAndDefaults) {
  const Objective discrete = parse_objective(" fit-bspline : degree = 4 ");
  EXPECT_EQ(discrete.kind, Objective::Kind::fit_bspline);
  EXPECT_EQ(discrete.degree, 4);
  EXPECT_EQ(discrete.level, 8);
  EXPECT_FALSE(discrete.continuum);
  const Objective continuum = parse_objective("fit-bspline:continuum,degree=2");
  EXPECT_TRUE(continuum.continuum);
  EXPECT_EQ(continuum.level, 0);
  EXPECT_EQ(parse_objective("popping").level, 1);
  EXPECT_EQ(parse_objective("popping:level=3").level, 3);
  EXPECT_EQ(to_string(parse_objective("fit-bspline:degree=2,level=5")), "fit-bspline:degree=2,level=5");
}

TEST(Objectives, BadNamesAndOptionsSayWhatWouldBeRight) {
  EXPECT_NE(parse_error("vertx").find("'vertex'"), std::string::npos);
  EXPECT_NE(parse_error("").find("fit-bspline, vertex, edge, area, popping and difference-norm"),
            std::string::npos);
  EXPECT_NE(parse_error("vertex:level=2").find("it takes none"), std::string::npos);
  EXPECT_NE(parse_error("popping:levels=2").find("level=K"), std::string::npos);
  EXPECT_NE(parse_error("popping:level=0").find("from 1 to 8"), std::string::npos);
  EXPECT_NE(parse_error("popping:level=two").find("'two'"), std::string::npos);
  EXPECT_NE(parse_error("popping:level").find("whole number"), std::string::npos);
  EXPECT_NE(parse_error("popping:continuum").find("unknown option"), std::string::npos);
  EXPECT_NE(parse_error("fit-bspline").find("degree"), std::string::npos);
  EXPECT_NE(parse_error("fit-bspline:degree=99").find("1 to 20"), std::string::npos);
  EXPECT_NE(parse_error("fit-bspline:degree=2,continuum=1").find("unknown option"), std::string::npos);
  EXPECT_NE(parse_error("fit-bspline:degree=2,level=4,continuum").find("continuum"), std::string::npos);
  EXPECT_NE(parse_error("fit-bspline:degree=2,,").find("unknown option"), std::string::npos);
}

TEST(FitObjective, HasTheDocuments1531Samples) {
  const Problem p = problem(jspline(x), "fit-bspline:degree=2");
  ASSERT_EQ(p.residuals.size(), 1531U);
  // At s = 1 the iterates are cubic B-splines' control points: coefficient 765 of level 8, and B_2(0) = 3/4.
  const Laurent<Rational> iterate = iterated_symbol(stationary<Rational>("", bspline<Rational>(3)), 8);
  EXPECT_EQ(at(p.residuals[765], 1), iterate[0] - Rational(3, 4));
  EXPECT_EQ(at(p.residuals[765 + 100], 1), iterate[100] - (Rational(3, 4) - pow(Rational(100, 256), 2)));
  EXPECT_EQ(p.residuals[765 - 300], p.residuals[765 + 300]);
}

TEST(FitObjective, ReproducesTheDocuments) {
  const Scheme<Function> j = scheme(jspline(x));
  const auto expect_digits = [&](const std::string& objective, Norm norm, const std::string& digits) {
    const Summary s = solve(j, objective, norm);
    ASSERT_EQ(s.termination, Termination::proved) << s.message;
    EXPECT_EQ(to_significant(s.minimiser[0].midpoint(), static_cast<int>(digits.size()) - 2), digits);
  };
  // js-report 9 prints .152773.
  expect_digits("fit-bspline:degree=1", Norm::linf, "0.152773");
  // js-report 4 prints .639.
  expect_digits("fit-bspline:degree=2", Norm::linf, "0.639");
}

TEST(FitObjective, AWiderTargetCountsBeyondTheIterate) {
  // Against degree 9, half width 5, the iterate of a scheme of half width 3 has no coefficients near 4.
  const Problem p = problem(jspline(x), "fit-bspline:degree=9,level=2");
  EXPECT_EQ(p.residuals.size(), 41U);  // multiples of 1/4 in [-5, 5]
  EXPECT_TRUE(p.residuals.front().is_zero());
  EXPECT_TRUE(p.residuals[4].is_constant());
  EXPECT_LT(p.residuals[4].constant(), Rational(0));
}

TEST(FitObjective, DualSchemesAreCentred) {
  // The quadratic B-spline's own iterates against B_2: of order 1/4^k, and symmetric.
  const Problem p = problem(bspline<Function>(2), "fit-bspline:degree=2,level=5");
  for (std::size_t i = 0; i < p.residuals.size(); ++i) {
    EXPECT_EQ(p.residuals[i], p.residuals[p.residuals.size() - 1 - i]);
    EXPECT_LT(abs(p.residuals[i].constant()), Rational(1, 1000));
  }
  // In the continuum it is the same function.
  EXPECT_TRUE(
      problem(bspline<Function>(2), "fit-bspline:degree=2,continuum", Norm::l2).residuals[0].is_zero());
}

TEST(FitObjective, ContinuumOfOtherFamilies) {
  // The tension for which the dual scheme of Dyn, Floater & Hormann comes nearest to B_2 in l2 is 0: Chaikin.
  const Summary dual = solve(scheme(dyn_floater_hormann(x)), "fit-bspline:degree=2,continuum", Norm::l2,
                             {{Rational(-1, 100), Rational(1, 50)}});
  ASSERT_EQ(dual.termination, Termination::proved) << dual.message;
  EXPECT_EQ(dual.minimiser[0].exact, "0");
  EXPECT_EQ(dual.minimum.exact, "0");
  // The four-point scheme with tension 0 is linear.
  const Summary hat = solve(scheme(four_point(x)), "fit-bspline:degree=1,continuum", Norm::l2,
                            {{Rational(-1, 20), Rational(1, 10)}});
  EXPECT_EQ(hat.minimiser[0].exact, "0");
}

TEST(FitObjective, ContinuumOfJsplines) {
  const Scheme<Function> j = scheme(jspline(x));
  const Summary l2 = solve(j, "fit-bspline:degree=2,continuum", Norm::l2);
  ASSERT_EQ(l2.termination, Termination::proved) << l2.message;
  // A root of the squared distance's derivative, irreducible over Q.
  const std::vector<Rational> derivative{
      Rational(7864132665600), Rational(-15443175659328), Rational(6412753894464), Rational(-1152202341744),
      Rational(94621253664),   Rational(-1581292444),     Rational(-340812412),    Rational(39201415),
      Rational(-2956777),      Rational(135901),          Rational(-2599),         Rational(20)};
  const UnivariatePolynomial p(derivative);
  EXPECT_EQ(count_roots(p, l2.minimiser[0].lower, l2.minimiser[0].upper), 1);
  EXPECT_EQ(solve(j, "fit-bspline:degree=5,continuum", Norm::l2).minimiser[0].exact, "3/2");
  const Summary linf = solve(j, "fit-bspline:degree=3,continuum", Norm::linf);
  EXPECT_EQ(linf.minimiser[0].exact, "1");
  EXPECT_NE(error_of([&] {
              (void)solve(scheme(four_point(x)), "fit-bspline:degree=2,continuum", Norm::l1);
            }).find("jspline:s=NAME"),
            std::string::npos);
}

TEST(VertexObjective, OneStepThenTheQuintic) {
  // js-report 6: r = -33/26.
  const Scheme<Function> s = mixed(scheme(jspline(x)), scheme(jspline(Function(Rational(3, 2)))));
  const Summary best = solve(s, "vertex", Norm::linf, {{Rational(-3), Rational(3)}});
  EXPECT_EQ(best.minimiser[0].exact, "-33/26");
  EXPECT_EQ(best.minimum.exact, "5/156");
  // Two parameters interpolate: jsplines 6, a = -7/4, b = 59/52.
  const Function y = Function::variable(1);
  const Scheme<Function> two = mixed(scheme(jspline(x, y)), scheme(jspline(Function(Rational(3, 2)))));
  const Range wide{Rational(-3), Rational(3)};
  const Summary exact = solve(two, "vertex", Norm::linf, {wide, wide});
  EXPECT_EQ(exact.minimiser[0].exact, "-7/4");
  EXPECT_EQ(exact.minimiser[1].exact, "59/52");
  EXPECT_EQ(exact.minimum.exact, "0");
}

TEST(EdgeObjective, OneStepThenTheCubicAndTheQuintic) {
  const Range wide{Rational(-3), Rational(3)};
  const Scheme<Function> cubic = mixed(scheme(jspline(x)), scheme(jspline(Function(1))));
  EXPECT_EQ(solve(cubic, "edge", Norm::linf, {wide}).minimiser[0].exact, "2/3");  // jsplines 7
  EXPECT_EQ(solve(cubic, "edge", Norm::l2, {wide}).minimiser[0].exact, "2/3");    // it interpolates
  const Scheme<Function> quintic = mixed(scheme(jspline(x)), scheme(jspline(Function(Rational(3, 2)))));
  EXPECT_EQ(solve(quintic, "edge", Norm::linf, {wide}).minimiser[0].exact, "29/59");
}

TEST(AreaObjective, IsTheDifferenceOfTheMasks) {
  const Problem p = problem(jspline(x), "area");
  // At s = 1: cubic B-splines, whose mask is (1, 56, 245)/720 on each side.
  std::vector<Rational> values;
  for (const Function& r : p.residuals) values.push_back(at(r, 1));
  const auto holds = [&](const Rational& q) {
    return std::find(values.begin(), values.end(), q) != values.end();
  };
  EXPECT_TRUE(holds(Rational(1, 720)));
  EXPECT_TRUE(holds(Rational(56, 720)));
  EXPECT_TRUE(holds(Rational(245, 720) - Rational(1, 2)));
  const Summary best = solve(scheme(jspline(x)), "area", Norm::linf);
  EXPECT_EQ(to_significant(best.minimiser[0].midpoint(), 5), "0.46415");  // js-report 8
  // Chaikin's scheme is dual: the objective applies all the same.
  EXPECT_FALSE(problem(bspline<Function>(2), "area").residuals.empty());
}

TEST(PoppingObjective, FirstLevelsOfTheDocument) {
  const Scheme<Function> j = scheme(jspline(x));
  EXPECT_EQ(solve(j, "popping", Norm::linf).minimiser[0].exact, "1/5");
  EXPECT_EQ(solve(j, "popping:level=2", Norm::linf).minimiser[0].exact, "37/101");
  // Level 1 by hand: max(|s|/4, |1-s|/16).
  EXPECT_EQ(solve(j, "popping", Norm::linf).minimum.exact, "1/20");
  // The four-point scheme's own pop is least where it is linear subdivision.
  EXPECT_EQ(solve(scheme(four_point(x)), "popping:level=3", Norm::linf, {{Rational(-1), Rational(1)}})
                .minimum.exact,
            "0");
}

TEST(PoppingObjective, OtherNormsFollowTheirOwnSchedule) {
  const Scheme<Function> j = scheme(jspline(x));
  // Level 1, squares: 2 (s/8)^2 + (s/4)^2 + 4 ((1-s)/16)^2 is least at s = 1/7.
  EXPECT_EQ(solve(j, "popping", Norm::l2).minimiser[0].exact, "1/7");
  const Summary second = solve(j, "popping:level=2", Norm::l2);
  EXPECT_EQ(second.termination, Termination::proved);
  EXPECT_GT(second.minimiser[0].lower, Rational(1, 7));
}

/// Hassan, Ivrissimtzis, Dodgson & Sabin 2002.
Mask<Function> ternary_four_point(const Function& mu) {
  const auto sum = [&](int p, int q, int r) {
    return fraction<Function>(p, 18) + mu * fraction<Function>(q, r);
  };
  const Function far = sum(-1, -1, 6);
  const Function end = sum(-1, 1, 6);
  const Function near = sum(13, 1, 2);
  const Function next = sum(7, -1, 2);
  return {3, Laurent<Function>(-5, {end, far, 0, next, near, 1, near, next, 0, far, end})};
}

TEST(DifferenceNorm, IsTheNormOfTheFirstPower) {
  const Mask<Function> schemes[] = {ternary_four_point(x), jspline(x), four_point(x)};
  for (const Mask<Function>& mask : schemes) {
    const Problem p = problem(mask, "difference-norm:continuity=1");
    for (const Rational& value : {Rational(0), Rational(1, 11), Rational(-3, 7), Rational(2)}) {
      Rational largest;
      for (const Function& r : p.residuals) largest = std::max(largest, abs(at(r, value)));
      const Mask<Rational> fixed = map_coefficients(mask, [&](const Function& f) { return at(f, value); });
      EXPECT_EQ(largest, iterate_norms(*difference_symbol(fixed, 1), mask.arity, 1).at(1));
    }
  }
}

TEST(DifferenceNorm, OfTheTernaryFourPointSchemeIsLeastAtOneEleventh) {
  // By hand: d = ((3 mu - 1)/2, 1 - 6 mu, 9 mu, 1 - 6 mu, (3 mu - 1)/2), in classes 3/2 - 15/2 mu and 9 mu.
  const Summary best = solve(scheme(ternary_four_point(x)), "difference-norm:continuity=2", Norm::linf,
                             {{Rational(1, 15), Rational(1, 9)}});
  EXPECT_EQ(best.minimiser[0].exact, "1/11");
  EXPECT_EQ(best.minimum.exact, "9/11");
  EXPECT_EQ(best.termination, Termination::proved);
}

TEST(DifferenceNorm, SaysWhatItNeeds) {
  EXPECT_NE(parse_error("difference-norm").find("order of continuity"), std::string::npos);
  const auto reason = [&](const std::string& objective, Norm norm) {
    return error_of([&] { (void)problem(jspline(x), objective, norm); });
  };
  EXPECT_NE(reason("difference-norm:continuity=9", Norm::linf).find("fewer than 10"), std::string::npos);
  EXPECT_NE(reason("difference-norm:continuity=1", Norm::l1).find("linf"), std::string::npos);
}

TEST(FitObjective, OfATernarySchemeComparesAtThirds) {
  // One step of the quadratic B-spline's ternary mask (1, 3, 6, 7, 6, 3, 1)/9 at i/3 beside its values there.
  const Mask<Function> quadratic{
      3, map_coefficients(pow(Laurent<Rational>(-1, {1, 1, 1}), 3),
                          [](const Rational& q) { return Function(q / Rational(9)); })};
  const Problem p = problem(quadratic, "fit-bspline:degree=2,level=1");
  const UniformBspline b(2);
  const Rational ninths[] = {1, 3, 6, 7, 6, 3, 1};
  for (int i = -3; i <= 3; ++i) {
    const Rational expected = ninths[i + 3] / Rational(9) - b.value(Rational(i, 3));
    EXPECT_NE(std::find(p.residuals.begin(), p.residuals.end(), Function(expected)), p.residuals.end()) << i;
  }
}

TEST(Objectives, SchemesThatLackWhatIsNeededAreToldWhat) {
  const auto reason = [&](const Scheme<Function>& s, const std::string& objective, Norm norm) {
    return error_of([&] { (void)make_problem(s, parse_objective(objective), norm, {range}, {"x"}); });
  };
  const Mask<Function> ternary{3, Laurent<Function>(-1, {1, 1, 1})};
  EXPECT_NE(reason(scheme(ternary), "edge", Norm::linf).find("arity 2"), std::string::npos);
  EXPECT_NE(reason(scheme({2, Laurent<Function>(-1, {x, 1, x})}), "area", Norm::linf).find("not to 2"),
            std::string::npos);
  EXPECT_NE(reason(scheme(bspline<Function>(2)), "vertex", Norm::linf).find("centre is 1/2"),
            std::string::npos);
  EXPECT_NE(reason(scheme(bspline<Function>(2)), "edge", Norm::linf).find("primal"), std::string::npos);
  EXPECT_NE(reason(scheme(bspline<Function>(2)), "popping", Norm::linf).find("primal"), std::string::npos);
  const Mask<Function> leaning{2, Laurent<Function>(-1, {Function(1) - x, 1, x})};
  EXPECT_NE(reason(scheme(leaning), "fit-bspline:degree=1", Norm::l1).find("moves with the parameters"),
            std::string::npos);
  const Scheme<Function> steps = mixed(scheme(jspline(x)), scheme(jspline(Function(1))));
  EXPECT_NE(reason(steps, "popping", Norm::linf).find("stationary"), std::string::npos);
  // (2, 0, 0): sums to 2 but has no limit.
  EXPECT_NE(reason(scheme({2, Laurent<Function>(0, {2})}), "vertex", Norm::linf), "");
}

TEST(Objectives, PoppingNeedsRationalMinimisersBeforeALevel) {
  // Coefficients with s^2: the best s of level 1 is irrational.
  const Mask<Function> square = jspline(x, x * x * x);
  const std::string error = error_of([&] {
    (void)make_problem(scheme(square), parse_objective("popping:level=2"), Norm::linf, {range}, {"x"});
  });
  EXPECT_NE(error.find("level 1"), std::string::npos) << error;
}

}  // namespace
}  // namespace subdiv
