#include "analysis/circle_crossings.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "analysis/eigenvalues.h"

namespace subdiv {
namespace {

/// Crossings of the circle of radius 1/2, ascending, each once.
std::vector<Algebraic> crossings(const Polynomial& factor) {
  std::vector<Algebraic> values;
  append_crossings(factor, Rational(1, 2), 0, values);
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

const Polynomial x = Polynomial::variable(eigenvalue_variable);
const Polynomial p = Polynomial::variable(0);

TEST(CircleCrossings, OfRealEigenvalues) {
  EXPECT_EQ(crossings(x - p),
            (std::vector<Algebraic>{Algebraic(Rational(-1, 2)), Algebraic(Rational(1, 2))}));
}

TEST(CircleCrossings, OfComplexEigenvalues) {
  // x^2 + p: the modulus is sqrt |p|, a pair of complex or of real roots.
  const std::vector<Algebraic> found = crossings(x * x + p);
  for (const Rational& at : {Rational(-1, 4), Rational(1, 4)}) {
    EXPECT_NE(std::ranges::find(found, Algebraic(at)), found.end()) << at.to_string();
  }
}

TEST(CircleCrossings, OfAFactorThatIsItsOwnMirrorImage) {
  // x^2 - p x + 1/4: both roots on the circle for |p| <= 1.
  EXPECT_EQ(crossings(x * x - p * x + Polynomial(Rational(1, 4))),
            (std::vector<Algebraic>{Algebraic(-1), Algebraic(1)}));
}

}  // namespace
}  // namespace subdiv
