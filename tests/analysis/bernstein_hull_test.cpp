#include "analysis/bernstein_hull.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace subdiv {
namespace {

using Function = RationalFunction;

const Function x = Function::variable(0);
const Function y = Function::variable(1);

Matrix<Function> single(const Function& f) { return Matrix<Function>::Constant(1, 1, f); }

std::vector<Rational> values(const BernsteinHull& hull, const ParameterBox& box, std::size_t letter = 0) {
  const auto families = hull.families(box);
  std::vector<Rational> result;
  if (!families) return result;
  for (const auto& family : *families) result.push_back(family.at(letter)(0, 0));
  return result;
}

TEST(BernsteinHull, CoefficientsOfKnownPolynomials) {
  // On [0, 1]: x^2 has 0, 0, 1; (1 - x)^2 has 1, 0, 0; x (1 - x) has 0, 1/2, 0.
  const BernsteinHull square({single(x * x)}, 1);
  EXPECT_EQ(values(square, {{0}, {1}}), (std::vector<Rational>{0, 0, 1}));
  // On [a, b] the polar form of x^2: a a, a b, b b.
  EXPECT_EQ(values(square, {{-1}, {3}}), (std::vector<Rational>{1, -3, 9}));
  EXPECT_EQ(values(BernsteinHull({single((Function(1) - x) * (Function(1) - x))}, 1), {{0}, {1}}),
            (std::vector<Rational>{1, 0, 0}));
  EXPECT_EQ(values(BernsteinHull({single(x * (Function(1) - x))}, 1), {{0}, {1}}),
            (std::vector<Rational>{0, Rational(1, 2), 0}));
}

TEST(BernsteinHull, EntriesLinearInEachParameterGiveTheCorners) {
  const BernsteinHull hull({single(x * y + Function(2) * x - y)}, 2);
  EXPECT_EQ(values(hull, {{1, 10}, {2, 20}}), (std::vector<Rational>{2, 2, 14, 24}));
}

TEST(BernsteinHull, DenominatorsAreCommonToAllMatrices) {
  const BernsteinHull hull({single(Function(1) / x), single(y)}, 2);
  // N = (1, x y), D = x.
  EXPECT_EQ(values(hull, {{1, 5}, {2, 7}}, 0), (std::vector<Rational>{1, 1, Rational(1, 2), Rational(1, 2)}));
  EXPECT_EQ(values(hull, {{1, 5}, {2, 7}}, 1), (std::vector<Rational>{5, 7, 5, 7}));
  EXPECT_FALSE(hull.families({{-1, 0}, {1, 1}}).has_value());
  EXPECT_FALSE(hull.families({{0, 0}, {1, 1}}).has_value());
  EXPECT_TRUE(hull.families({{-2, 0}, {-1, 1}}).has_value());
}

TEST(BernsteinHull, HullsContainTheValues) {
  const Function f = (x * x * x - Function(2) * x * y + Function(1)) / (x * x + y * y + Function(1));
  const BernsteinHull hull({single(f)}, 2);
  const ParameterBox box{{Rational(-1, 3), Rational(1, 2)}, {1, 2}};
  const std::vector<Rational> all = values(hull, box);
  ASSERT_FALSE(all.empty());
  const auto [low, high] = std::minmax_element(all.begin(), all.end());
  for (int i = 0; i <= 8; ++i) {
    for (int j = 0; j <= 8; ++j) {
      const std::vector<Rational> at{box.lower[0] + (box.upper[0] - box.lower[0]) * Rational(i, 8),
                                     box.lower[1] + (box.upper[1] - box.lower[1]) * Rational(j, 8)};
      const Rational value = f.evaluate<Rational>(at);
      EXPECT_TRUE(*low <= value && value <= *high);
    }
  }
}

TEST(BernsteinHull, ParametersNeedARange) { EXPECT_THROW(BernsteinHull({single(y)}, 1), std::domain_error); }

}  // namespace
}  // namespace subdiv
