#include "analysis/contraction_range.h"

#include <gtest/gtest.h>

#include "analysis/contraction_set.h"
#include "analysis/jsr/word.h"
#include "analysis/sign_on_interval.h"
#include "analysis/transition_matrices.h"
#include "schemes/dyn_floater_hormann.h"
#include "schemes/four_point.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

struct Family {
  std::vector<Matrix<Function>> matrices;
  Matrix<Function> mirror;
  Matrix<Function> leading;  // T_0 F: its square is T_0 T_1
};

Family family(const Mask<Function>& mask) {
  Family result;
  result.matrices = transition_matrices(normal_form(mask));
  result.mirror = reversal(result.matrices[0].rows());
  result.leading = result.matrices[0] * result.mirror;
  return result;
}

RealInterval necessary(const Family& f) {
  const RealSet set = intersection(contraction_set(f.matrices[0]), contraction_set(f.leading));
  EXPECT_EQ(set.parts.size(), 1U);
  return set.parts.at(0);
}

/// Proofs that fit together from end to end and have no flaw.
void expect_proof(const Family& f, const ContractionRange& proof) {
  std::vector<PolytopeProof> all = proof.products;
  all.insert(all.end(), proof.polytopes.begin(), proof.polytopes.end());
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(find_flaw(all[i].polytope, all[i].range, Containment::interior), std::nullopt);
    if (i == 0) continue;
    EXPECT_TRUE(all[i].range.lower == all[i - 1].range.upper);
    EXPECT_TRUE(all[i].range.lower_closed || all[i - 1].range.upper_closed);
  }
  EXPECT_TRUE(all.front().range.lower == proof.range.lower);
  EXPECT_TRUE(all.back().range.upper == proof.range.upper);
  for (const PolytopeProof& piece : proof.polytopes) EXPECT_TRUE(piece.polytope.matrices == f.matrices);
  for (const PolytopeProof& piece : proof.products) {
    EXPECT_EQ(piece.polytope.matrices.size(), std::size_t{1} << proof.length);
    EXPECT_TRUE(piece.polytope.matrices.front() ==
                product(f.matrices, Word(static_cast<std::size_t>(proof.length), 0)));
    EXPECT_TRUE(piece.polytope.matrices.back() ==
                product(f.matrices, Word(static_cast<std::size_t>(proof.length), 1)));
  }
}

TEST(ContractionRange, FourPointTensionIsC1UpToARootOfACubic) {
  // Hechler, Moessner & Reif 2009: C^1 exactly for 0 < w < 0.19273.., the real root of 32 w^3 + 4 w - 1.
  const Family f = family(four_point(Function::variable(0)));
  const RealInterval range = necessary(f);
  EXPECT_TRUE(*range.lower == Algebraic(0));
  EXPECT_EQ(range.upper->minimal_polynomial(), (std::vector<Rational>{-1, 4, 0, 32}));
  const auto proof = prove_contraction(f.matrices, f.leading, f.mirror, range);
  ASSERT_TRUE(proof.has_value());
  expect_proof(f, *proof);
  // Beyond the end there is nothing to be proved.
  EXPECT_FALSE(prove_containment(f.matrices, proof->polytopes.back().polytope.vertices, Function(1),
                                 closed_interval(Rational(19, 100), Rational(194, 1000)),
                                 Containment::interior, 2));
}

TEST(ContractionRange, SquaresOfTheFlippedMatrixAreProducts) {
  const Family f = family(dyn_floater_hormann(Function::variable(0)));
  EXPECT_TRUE(Matrix<Function>(f.leading * f.leading) == product(f.matrices, {1, 0}));
  EXPECT_TRUE(Matrix<Function>(f.mirror * f.matrices[0] * f.mirror) == f.matrices[1]);
  const RealInterval range = necessary(f);
  EXPECT_EQ(range.upper->minimal_polynomial(), (std::vector<Rational>{-1, 24, 352, 25600, 327680}));
}

TEST(ContractionRange, CriticalVerticesStartWithTheAdjugateOrbit) {
  const Family f = family(four_point(Function::variable(0)));
  const auto vertices = critical_vertices(f.matrices, f.leading, f.mirror, Rational(19, 100));
  ASSERT_TRUE(vertices.has_value());
  // (I - T_0 F) v is det(I - T_0 F) times a constant vector.
  const Matrix<Function> rest = identity_matrix<Function>(4) - f.leading;
  const Vector<Function> v = rest * vertices->col(0);
  const Function determinant = characteristic_polynomial(rest)[0];
  for (Eigen::Index i = 0; i < 4; ++i) EXPECT_TRUE((v(i) / determinant).is_constant());
  EXPECT_TRUE(Vector<Function>(vertices->col(1)) == Vector<Function>(f.mirror * vertices->col(0)));
}

TEST(ContractionRange, NoLeadingEigenvectorNoVertices) {
  const Matrix<Function> rotation = (Matrix<Function>(2, 2) << 0, -1, 1, 0).finished();
  EXPECT_FALSE(critical_vertices({rotation}, rotation, std::nullopt, Rational(1)).has_value());
}

}  // namespace
}  // namespace subdiv
