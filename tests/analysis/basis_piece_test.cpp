#include "analysis/basis_piece.h"

#include <gtest/gtest.h>

#include "schemes/bspline.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

LocalBasis<Rational> local(const Mask<Rational>& mask) {
  return {basis_tables(mask), mask.symbol.first(), mask.symbol.last()};
}

/// Every piece of a level between two integers, in order.
std::vector<BasisPiece<Rational>> pieces(const LocalBasis<Rational>& basis, int lower, int upper, int level) {
  std::vector<BasisPiece<Rational>> result;
  for (int i = lower; i < upper; ++i) result.push_back(basis.unit(i));
  for (int k = 0; k < level; ++k) {
    std::vector<BasisPiece<Rational>> finer;
    for (const auto& piece : result) {
      auto [left, right] = basis.halves(piece);
      finer.push_back(left);
      finer.push_back(right);
    }
    result = finer;
  }
  return result;
}

/// Values, slopes and integrals of the pieces against those of the whole basis function.
void expect_agreement(const Mask<Rational>& mask, int lower, int upper) {
  constexpr int level = 4;
  const LocalBasis<Rational> basis = local(mask);
  const Scheme<Rational> scheme = stationary<Rational>("", mask);
  const Laurent<Rational> values = basis_values(scheme, level);
  const Laurent<Rational> slopes = basis_values(scheme, level, 1);
  const BasisIntegral<Rational> integral = basis_integral(mask, level);
  int i = lower << level;
  for (const auto& piece : pieces(basis, lower, upper, level)) {
    EXPECT_EQ(piece.left, Rational(i, 1 << level));
    EXPECT_EQ(piece.right(), Rational(i + 1, 1 << level));
    EXPECT_EQ(basis.left_value(piece), values[i]) << i;
    EXPECT_EQ(basis.right_value(piece), values[i + 1]) << i;
    EXPECT_EQ(basis.left_slope(piece) * Rational(1 << level), slopes[i]) << i;
    EXPECT_EQ(basis.right_slope(piece) * Rational(1 << level), slopes[i + 1]) << i;
    EXPECT_EQ(basis.integral(piece) * piece.width(), integral.at(i + 1) - integral.at(i)) << i;
    ++i;
  }
}

TEST(BasisPiece, AgreesWithTheWholeBasisFunction) {
  expect_agreement(jspline(Rational(689, 1000)), -4, 4);
  expect_agreement(bspline<Rational>(4), -3, 4);                           // even number of taps
  expect_agreement({2, shift(jspline(Rational(1, 2)).symbol, 3)}, -1, 7);  // off centre
}

TEST(BasisPiece, OuterCoefficientsMayVanish) {
  // At s = 1 the ends of the family's mask are zero: the window stays that of the family.
  const LocalBasis<Rational> basis(basis_tables(jspline(Rational(1))), -3, 3);
  const BasisPiece<Rational> piece = basis.halves(basis.unit(0)).second;
  EXPECT_EQ(piece.coefficients.size(), 6U);
  EXPECT_EQ(basis.left_value(piece), Rational(23, 48));  // the cubic B-spline at 1/2
  EXPECT_EQ(basis.right_value(piece), Rational(1, 6));
}

TEST(BasisPiece, NeedsArityTwo) {
  EXPECT_THROW(basis_tables(Mask<Rational>{3, Laurent<Rational>(-1, {1, 1, 1})}), std::domain_error);
}

}  // namespace
}  // namespace subdiv
