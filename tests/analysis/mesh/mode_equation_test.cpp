#include "analysis/mesh/mode_equation.h"

#include <gtest/gtest.h>

#include "analysis/eigenvalues.h"
#include "schemes/mesh/butterfly.h"
#include "schemes/mesh/jspline_mesh.h"
#include "schemes/mesh/loop.h"

namespace subdiv {
namespace {

using F = RationalFunction;
const F s = F::variable(0);
const Polynomial x = Polynomial::variable(eigenvalue_variable);
const Polynomial c = Polynomial::variable(turn_variable);
const Polynomial h = Polynomial::variable(valence_variable);

bool has_factor(const ModeEquation& equation, const Polynomial& p) {
  for (const auto& [base, multiplicity] : equation.factors) {
    Polynomial quotient;
    if (divides(base, p, quotient) && quotient.is_constant()) return true;
  }
  return false;
}

TEST(ModeEquation, CatmullClarkHasTheKnownQuadratics) {
  // Ball & Storry 1988: x^2 - (5 + c)/8 x + 1/16; mode 0: with the vertex weights 1 - 7/(4n), 3/(2n), 1/(4n).
  const ModeEquation turning = turning_modes(catmull_clark<F>());
  EXPECT_EQ(turning.degree(), 6);
  EXPECT_TRUE(
      has_factor(turning, Polynomial(16) * x * x - (Polynomial(10) + Polynomial(2) * c) * x + Polynomial(1)));
  const ModeEquation invariant = invariant_modes(catmull_clark<F>());
  EXPECT_TRUE(has_factor(invariant, x - Polynomial(1)));
  // At n = 4 mode 0 of the bicubic B-spline: 1, 1/4, 1/16 and others.
  EXPECT_TRUE(has_factor(invariant_mode(catmull_clark<F>(), 4), Polynomial(4) * x - Polynomial(1)));
}

TEST(ModeEquation, LoopHasTheKnownEigenvalue) {
  const ModeEquation turning = turning_modes(loop<F>());
  EXPECT_TRUE(has_factor(turning, Polynomial(8) * x - Polynomial(3) - Polynomial(2) * c));
  EXPECT_TRUE(has_factor(invariant_modes(loop<F>()), Polynomial(4) * x - Polynomial(1)));
}

/// det(x I - mode) at one valence, all modes but 0 together: a matrix over Q in real arithmetic, the control
/// points of all sectors that add up to 0 around the vertex.
std::vector<Rational> turning_characteristic(const MeshScheme<Rational>& scheme, int n) {
  const FanMatrix<Rational> fan = fan_matrix(scheme, n, eigenvalue_rings(scheme));
  const Eigen::Index p = fan.places();
  // P_{n-1} = -(P_0 + .. + P_{n-2}).
  Matrix<Rational> matrix = zero_matrix<Rational>(p * (n - 1), p * (n - 1));
  const auto block = [&](int from, int to) -> const Matrix<Rational>& {
    return fan.blocks[static_cast<std::size_t>((to - from + n) % n)];
  };
  for (int from = 0; from + 1 < n; ++from) {
    for (int to = 0; to + 1 < n; ++to) {
      for (Eigen::Index i = 0; i < p; ++i) {
        for (Eigen::Index j = 0; j < p; ++j) {
          matrix(from * p + i, to * p + j) = block(from, to)(i, j) - block(from, n - 1)(i, j);
        }
      }
    }
  }
  return characteristic_polynomial(matrix);
}

/// The same from the one equation in c: the product over k = 1 .. n-1 is the resultant with the polynomial of
/// the cosines, which is rational for n = 3 and 4.
TEST(ModeEquation, OneEquationServesAllValencesAndWrapsAtSmallOnes) {
  const Rational at(2, 3);
  const auto equal = [&](const MeshScheme<F>& scheme, const MeshScheme<Rational>& same) {
    const Polynomial p = turning_modes(scheme).product().substitute(0, Polynomial(at));
    for (const auto& [n, cosines] :
         {std::pair{3, std::vector<Rational>{Rational(-1, 2), Rational(-1, 2)}},
          std::pair{4, std::vector<Rational>{Rational(0), Rational(-1), Rational(0)}}}) {
      Polynomial product(1);
      for (const Rational& value : cosines) product *= p.substitute(turn_variable, Polynomial(value));
      const std::vector<Rational> direct = turning_characteristic(same, n);
      const std::vector<Polynomial> found = product.coefficients_in(eigenvalue_variable);
      ASSERT_EQ(found.size(), direct.size());
      for (std::size_t i = 0; i < direct.size(); ++i) {
        EXPECT_EQ(found[i].constant(), direct[i] * found.back().constant()) << same.name << " " << n;
      }
    }
  };
  equal(jspline_mesh<F>(s), jspline_mesh<Rational>(at));
  equal(jspline_mesh_literal<F>(s), jspline_mesh_literal<Rational>(at));
  equal(butterfly<F>(), butterfly<Rational>());
  equal(loop<F>(), loop<Rational>());
}

TEST(ModeEquation, InvariantModeIsLinearInTheReciprocalOfTheValence) {
  for (const auto& scheme : {jspline_mesh<F>(s), jspline_mesh_literal<F>(s)}) {
    const Polynomial all = invariant_modes(scheme).product();
    for (const int n : {3, 4, 6, 30}) {
      const Polynomial one = invariant_mode(scheme, n).product();
      const Polynomial at = all.substitute(valence_variable, Polynomial(Rational(1, n)));
      Polynomial quotient;
      EXPECT_TRUE(divides(one, at, quotient) && quotient.is_constant()) << scheme.name << " " << n;
    }
  }
}

}  // namespace
}  // namespace subdiv
