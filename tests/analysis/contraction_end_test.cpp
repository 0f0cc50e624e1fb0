#include "analysis/contraction_end.h"

#include <gtest/gtest.h>

#include "analysis/map_cell.h"
#include "analysis/transition_matrices.h"
#include "schemes/algebra/univariate.h"
#include "schemes/dyn_floater_hormann.h"
#include "schemes/four_point.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

const Function p = Function::variable(0);

/// Matrices whose radius decides C^continuity.
std::vector<Matrix<Function>> family(const Mask<Function>& mask, int continuity) {
  const NormalForm<Function> form = normal_form(mask);
  return divided(transition_matrices(form), pow(Rational(form.arity), form.factors - 1 - continuity));
}

void expect_proof(const std::optional<ContractionEnd>& proof, const Algebraic& end, const Rational& inside) {
  ASSERT_TRUE(proof.has_value());
  const bool upwards = end > Algebraic(proof->cut);
  EXPECT_EQ(upwards, end > Algebraic(inside));
  for (const PolytopeProof& piece : proof->polytopes) {
    EXPECT_EQ(find_flaw(piece.polytope, piece.range, Containment::interior), std::nullopt);
  }
  const RealInterval first = proof->polytopes.front().range;
  const RealInterval last = proof->polytopes.back().range;
  EXPECT_TRUE(*first.lower == (upwards ? Algebraic(proof->cut) : end));
  EXPECT_TRUE(*last.upper == (upwards ? end : Algebraic(proof->cut)));
  EXPECT_FALSE(upwards ? last.upper_closed : first.lower_closed);
}

TEST(ContractionEnd, JSplinesAtBothEndsOfTheirRanges) {
  // J_s is C^1 exactly for -2 < s < 6, C^2 for 0 < s < 4, C^3 for 1 < s < 3.
  const Rational middle(2);
  for (const auto& [continuity, low, high] :
       {std::tuple(1, -2, 6), std::tuple(2, 0, 4), std::tuple(3, 1, 3)}) {
    const auto matrices = family(jspline(p), continuity);
    expect_proof(prove_contraction_at_end(matrices, {0}, Algebraic(low), middle), Algebraic(low), middle);
    expect_proof(prove_contraction_at_end(matrices, {0}, Algebraic(high), middle), Algebraic(high), middle);
  }
}

TEST(ContractionEnd, IrrationalEnds) {
  // Four-point tension: C^1 below the real root of 32 w^3 + 4 w - 1 (Hechler, Moessner & Reif 2009).
  const auto roots = real_roots(UnivariatePolynomial(std::vector<Rational>{-1, 4, 0, 32}));
  const auto matrices = family(four_point(p), 1);
  expect_proof(prove_contraction_at_end(matrices, {0, 1}, roots.at(0).value, Rational(1, 8)),
               roots.at(0).value, Rational(1, 8));
}

TEST(ContractionEnd, WithoutASymmetryTheCycleGivesTheVertices) {
  // A e_2 = 2p e_1 and B e_1 = (p/2) e_2: the product has the eigenvalue p^2, the scales of the two
  // coordinates differ.
  const Function zero(0);
  Matrix<Function> a(2, 2);
  a << zero, Function(2) * p, zero, zero;
  Matrix<Function> b(2, 2);
  b << zero, zero, p / Function(2), zero;
  expect_proof(prove_contraction_at_end({a, b}, {0, 1}, Algebraic(1), Rational(1, 2)), Algebraic(1),
               Rational(1, 2));
}

TEST(ContractionEnd, NoProofWhereAnotherProductExpands) {
  Matrix<Function> a = Matrix<Function>::Constant(1, 1, p);
  Matrix<Function> b = Matrix<Function>::Constant(1, 1, Function(2));
  EXPECT_FALSE(prove_contraction_at_end({a, b}, {0}, Algebraic(1), Rational(1, 2)).has_value());
}

}  // namespace
}  // namespace subdiv
