#include "analysis/parametric_polytope.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/sign_on_interval.h"
#include "schemes/algebra/specialize.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

const Function p = Function::variable(0);

Function half() { return fraction<Function>(1, 2); }

/// The transition matrices of p + (1 - 2p) z + p z^2.
std::vector<Matrix<Function>> matrices() {
  const Function q = Function(1) - Function(2) * p;
  std::vector<Matrix<Function>> t(2, zero_matrix<Function>(2, 2));
  t[0] << p, Function(0), p, q;
  t[1] << q, p, Function(0), p;
  return t;
}

/// For 0 <= p <= 1/2 the hexagon +-(1,0), +-(0,1), +-(1,1) is mapped into 1 - p times itself, by these
/// combinations: T_0 (1,0) = p (1,1), T_0 (0,1) = q (0,1), T_0 (1,1) = p (1,1) + q (0,1), and mirror images.
ParametricPolytope hexagon() {
  const Function q = Function(1) - Function(2) * p;
  const Function zero(0);
  ParametricPolytope result{matrices(), Matrix<Function>(2, 3), {}, Function(1) - p};
  result.vertices << Function(1), zero, Function(1), zero, Function(1), Function(1);
  Matrix<Function> first(3, 3);
  first << zero, zero, zero,  //
      zero, q, q,             //
      p, zero, p;
  Matrix<Function> second(3, 3);
  second << q, zero, q,  //
      zero, zero, zero,  //
      zero, p, p;
  result.combinations = {first, second};
  return result;
}

const RealInterval valid = closed_interval(0, Rational(1, 2));

TEST(ParametricPolytope, HexagonIsAProof) {
  EXPECT_EQ(find_flaw(hexagon(), valid), std::nullopt);
  // q + p = 1 - p is not below the factor.
  EXPECT_TRUE(find_flaw(hexagon(), valid, Containment::interior).has_value());
  ParametricPolytope roomy = hexagon();
  roomy.factor += fraction<Function>(1, 1000);
  EXPECT_EQ(find_flaw(roomy, valid, Containment::interior), std::nullopt);
}

TEST(ParametricPolytope, WrongCoefficientsVerticesFactorsAndMatricesAreRejected) {
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 9; ++j) {
      ParametricPolytope wrong = hexagon();
      wrong.combinations[static_cast<std::size_t>(i)].data()[j] += fraction<Function>(1, 1000000);
      EXPECT_TRUE(find_flaw(wrong, valid).has_value()) << i << " " << j;
    }
  }
  for (int j = 0; j < 6; ++j) {
    ParametricPolytope wrong = hexagon();
    wrong.vertices.data()[j] += p * fraction<Function>(1, 1000000);
    EXPECT_TRUE(find_flaw(wrong, valid).has_value()) << j;
  }
  ParametricPolytope tight = hexagon();
  tight.factor = fraction<Function>(999999, 1000000) - p;
  EXPECT_TRUE(find_flaw(tight, valid).has_value());
  ParametricPolytope other = hexagon();
  other.matrices[1](0, 0) += p;
  EXPECT_EQ(find_flaw(other, valid), "T_1 v_1 is not its combination");
}

TEST(ParametricPolytope, WrongIntervalsAreRejected) {
  EXPECT_TRUE(find_flaw(hexagon(), closed_interval(Rational(-1, 1000000), Rational(1, 2))).has_value());
  EXPECT_TRUE(find_flaw(hexagon(), closed_interval(0, Rational(500001, 1000000))).has_value());
  EXPECT_TRUE(find_flaw(hexagon(), {std::nullopt, Algebraic(Rational(1, 2)), false, true}).has_value());
  EXPECT_EQ(find_flaw(hexagon(), open_interval(0, Rational(1, 2))), std::nullopt);
}

TEST(ParametricPolytope, VerticesHaveToSpanEverywhere) {
  ParametricPolytope flat{
      {Matrix<Function>::Constant(2, 2, Function(0))}, Matrix<Function>(2, 2), {}, Function(1)};
  flat.vertices << Function(1), Function(1), Function(0), p - half();
  flat.combinations = {Matrix<Function>::Constant(2, 2, Function(0))};
  EXPECT_EQ(find_flaw(flat, closed_interval(0, Rational(1, 4))), std::nullopt);
  EXPECT_EQ(find_flaw(flat, valid), "the vertices do not span the space everywhere");
  flat.vertices.col(1) = flat.vertices.col(0);
  EXPECT_TRUE(find_flaw(flat, closed_interval(0, Rational(1, 4))).has_value());
}

TEST(ParametricPolytope, PolesAndShapes) {
  ParametricPolytope scaled = hexagon();
  for (Eigen::Index i = 0; i < 6; ++i) scaled.vertices.data()[i] /= p - fraction<Function>(1, 3);
  EXPECT_EQ(find_flaw(scaled, valid), "an entry has a pole in the range");
  EXPECT_EQ(find_flaw(scaled, closed_interval(0, Rational(1, 4))), std::nullopt);
  ParametricPolytope misshapen = hexagon();
  misshapen.combinations.pop_back();
  EXPECT_THROW((void)find_flaw(misshapen, valid), std::domain_error);
}

TEST(ParametricPolytope, CoefficientsOfChangingSign) {
  // T (1,0) = (1/2 - p, p - 1/3) in the diamond: |1/2 - p| + |p - 1/3| reaches 5/6 at p = 0 and 1 and 1/6
  // between.
  Matrix<Function> t = zero_matrix<Function>(2, 2);
  t(0, 0) = half() - p;
  t(1, 0) = p - fraction<Function>(1, 3);
  ParametricPolytope diamond{{t}, identity_matrix<Function>(2), {t}, fraction<Function>(7, 6)};
  EXPECT_EQ(find_flaw(diamond, closed_interval(0, 1)), std::nullopt);
  EXPECT_TRUE(find_flaw(diamond, closed_interval(0, Rational(101, 100))).has_value());
  diamond.factor = fraction<Function>(5, 6);
  EXPECT_EQ(find_flaw(diamond, closed_interval(0, Rational(5, 6))), std::nullopt);
  EXPECT_TRUE(find_flaw(diamond, closed_interval(0, 1)).has_value());
}

TEST(ParametricPolytope, CramerFindsCombinations) {
  const ParametricPolytope h = hexagon();
  const auto c = combine(h.vertices, {1, 2}, Vector<Function>(h.matrices[0] * h.vertices.col(2)));
  ASSERT_TRUE(c.has_value());
  EXPECT_EQ((*c)(0), Function(0));
  EXPECT_EQ((*c)(1), Function(1) - Function(2) * p);
  EXPECT_EQ((*c)(2), p);
  Matrix<Function> parallel = h.vertices;
  parallel.col(2) = parallel.col(1);
  EXPECT_FALSE(combine(parallel, {1, 2}, Vector<Function>(parallel.col(0))).has_value());
}

TEST(ParametricPolytope, ProposalsAreExactIdentitiesAndGoodAtTheirPoint) {
  const auto proposed = propose_combinations(matrices(), hexagon().vertices, Function(1) - p, Rational(1, 3));
  ASSERT_TRUE(proposed.has_value());
  EXPECT_EQ(find_flaw(*proposed, valid), std::nullopt);
}

TEST(ParametricPolytope, BisectionCoversARangeWithPieces) {
  // Below 101/100 of the norm max(1 - p, p) on [0, 1] no single choice of combinations serves.
  const Matrix<Function> vertices = hexagon().vertices;
  const Function one(1);
  const auto proofs = prove_containment(
      matrices(), vertices, one, closed_interval(Rational(1, 10), Rational(9, 10)), Containment::interior);
  ASSERT_TRUE(proofs.has_value());
  EXPECT_GT(proofs->size(), 1U);
  for (std::size_t i = 0; i < proofs->size(); ++i) {
    EXPECT_EQ(find_flaw((*proofs)[i].polytope, (*proofs)[i].range, Containment::interior), std::nullopt);
    EXPECT_TRUE(i == 0 || (*proofs)[i].range.lower == (*proofs)[i - 1].range.upper);
  }
  EXPECT_TRUE(*proofs->front().range.lower == Algebraic(Rational(1, 10)));
  EXPECT_TRUE(*proofs->back().range.upper == Algebraic(Rational(9, 10)));
  // At p = 0 and 1 the radius is 1.
  EXPECT_FALSE(prove_containment(matrices(), vertices, one, closed_interval(Rational(1, 2), 1),
                                 Containment::interior));
}

TEST(ParametricPolytope, EigenvaluesOverTheFunctionField) {
  EXPECT_TRUE(is_eigenvalue(matrices()[0], p));
  EXPECT_TRUE(is_eigenvalue(matrices()[0], Function(1) - Function(2) * p));
  EXPECT_FALSE(is_eigenvalue(matrices()[0], Function(1) - p));
}

}  // namespace
}  // namespace subdiv
