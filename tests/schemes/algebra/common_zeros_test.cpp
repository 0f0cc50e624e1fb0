#include "schemes/algebra/common_zeros.h"

#include <gtest/gtest.h>

namespace subdiv {
namespace {

const Polynomial x = Polynomial::variable(0);
const Polynomial y = Polynomial::variable(1);
const Polynomial z = Polynomial::variable(2);

bool empty(const std::vector<Polynomial>& equations, const std::vector<Polynomial>& nonzero = {}) {
  return prove_empty({equations, nonzero}).proved;
}

TEST(CommonZeros, OneVariable) {
  EXPECT_TRUE(empty({x * x - Polynomial(2), x * x - Polynomial(3)}));
  EXPECT_FALSE(empty({x * x - Polynomial(2), x * x * x - Polynomial(2) * x}));
  EXPECT_FALSE(empty({x * x + Polynomial(1)})) << "zeros may be complex";
  EXPECT_TRUE(empty({Polynomial(3)}));
  EXPECT_FALSE(empty({Polynomial(0)}));
  EXPECT_FALSE(empty({}));
}

TEST(CommonZeros, FactorsThatMustNotVanishAreDropped) {
  EXPECT_TRUE(empty({x * (x - Polynomial(1)), x * (x + Polynomial(1))}, {x}));
  EXPECT_FALSE(empty({x * (x - Polynomial(1)), x * (x + Polynomial(1))}, {x - Polynomial(1)}));
  EXPECT_TRUE(empty({x * x - y * y}, {x - y, x + y}));
}

TEST(CommonZeros, LinearEquationsAreEliminatedWithTheirDegenerateCase) {
  // x y = 1 and x = 0.
  EXPECT_TRUE(empty({x * y - Polynomial(1), x}));
  // x y = z, z = 0, y != 0, x = 1.
  EXPECT_TRUE(empty({x * y - z, z, x - Polynomial(1)}, {y}));
  // The degenerate case c = d = 0 is where the zero is: (y - 1) x = y^2 - 1 holds for every x at y = 1.
  EXPECT_FALSE(empty({(y - Polynomial(1)) * x - (y * y - Polynomial(1)) * z, (y - Polynomial(1)) * z}));
}

TEST(CommonZeros, ADegenerateCaseIsNotLostWhenTheMainCaseIsExcluded) {
  // x y = 0 with x != 0 on the main case y != 0: impossible there, but y = 0 has the zeros (x, 0), x != 0.
  EXPECT_FALSE(empty({x * y + y * z, z}, {x}));
  // c v + d with c = z, d = z - z^2, and v - z + 1 = (c v + d)/z excluded: only z = 0 is left, and there are
  // zeros.
  EXPECT_FALSE(empty({z * x + z - z * z}, {x + Polynomial(1) - z}));
}

TEST(CommonZeros, ResultantsProject) {
  // Two circles that meet in (1, +-1) and a hyperbola elsewhere, or through one of the points.
  const Polynomial first = x * x + y * y - Polynomial(2);
  const Polynomial second = (x - Polynomial(2)) * (x - Polynomial(2)) + y * y - Polynomial(2);
  EXPECT_TRUE(empty({first, second, x * x * y * y - Polynomial(2)}));
  EXPECT_FALSE(empty({first, second, x * x * y * y - Polynomial(1)}));
}

TEST(CommonZeros, AnAlgebraicCommonZeroIsSeen) {
  // x = sqrt 2, y = sqrt 3, x y = sqrt 6: the product equation holds for one choice of signs, so there are
  // zeros.
  const Polynomial roots_x = x * x - Polynomial(2);
  const Polynomial roots_y = y * y - Polynomial(3);
  EXPECT_FALSE(empty({roots_x, roots_y, x * y - z, z * z - Polynomial(6)}));
  EXPECT_TRUE(empty({roots_x, roots_y, x * y - z, z * z - Polynomial(5)}));
}

TEST(CommonZeros, ReportsItsCases) {
  const EmptinessProof proof =
      prove_empty({{(x - Polynomial(1)) * (x - Polynomial(2)), x * y - Polynomial(1), y - Polynomial(2)}, {}},
                  {"x", "y"});
  EXPECT_TRUE(proof.proved);
  EXPECT_FALSE(proof.cases.empty());
}

}  // namespace
}  // namespace subdiv
