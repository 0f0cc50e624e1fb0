#include "analysis/bernstein_form.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace subdiv {
namespace {

const Polynomial x = Polynomial::variable(0);
const Polynomial y = Polynomial::variable(1);

/// The value at (u, v) of the cell by the definition.
Rational value(const BernsteinForm& form, std::size_t m, std::size_t n, const Rational& u,
               const Rational& v) {
  const auto basis = [](std::size_t degree, std::size_t i, const Rational& t) {
    Rational result(1);
    for (std::size_t k = 1; k <= i; ++k)
      result *= Rational(static_cast<std::int64_t>(degree - i + k), static_cast<std::int64_t>(k)) * t;
    for (std::size_t k = i; k < degree; ++k) result *= Rational(1) - t;
    return result;
  };
  Rational sum(0);
  for (std::size_t i = 0; i <= m; ++i) {
    for (std::size_t j = 0; j <= n; ++j)
      sum += form.coefficients()[i * (n + 1) + j] * basis(m, i, u) * basis(n, j, v);
  }
  return sum;
}

TEST(BernsteinForm, IsThePolynomial) {
  const Polynomial f =
      x * x * x * y - Polynomial(2) * x * y * y + Polynomial(Rational(3, 7)) * y + Polynomial(5);
  const ParameterBox cell{{Rational(-1), Rational(1, 3)}, {Rational(2), Rational(5, 2)}};
  const BernsteinForm form(f, cell);
  ASSERT_EQ(form.coefficients().size(), 12U);
  for (const Rational& u : {Rational(0), Rational(1, 5), Rational(1)}) {
    for (const Rational& v : {Rational(0), Rational(2, 3), Rational(1)}) {
      const std::array<Rational, 2> at{cell.lower[0] + u * (cell.upper[0] - cell.lower[0]),
                                       cell.lower[1] + v * (cell.upper[1] - cell.lower[1])};
      EXPECT_EQ(value(form, 3, 2, u, v), f.evaluate<Rational>(at));
    }
  }
}

TEST(BernsteinForm, CornersAreValues) {
  const ParameterBox cell{{Rational(0), Rational(1)}, {Rational(2), Rational(3)}};
  const Polynomial f = x * x - x * y + y;
  const BernsteinForm form(f, cell);
  for (const bool right : {false, true}) {
    for (const bool up : {false, true}) {
      const std::array<Rational, 2> at{right ? cell.upper[0] : cell.lower[0],
                                       up ? cell.upper[1] : cell.lower[1]};
      EXPECT_EQ(form.coefficients()[form.corner_slot(right, up)], f.evaluate<Rational>(at));
    }
  }
}

TEST(BernsteinForm, ZerosAreAllowedAtFreeCornersAlone) {
  const ParameterBox cell{{Rational(0), Rational(0)}, {Rational(1), Rational(1)}};
  const auto signs = [&](const Polynomial& f, const std::array<bool, 4>& free) {
    return BernsteinForm(f, cell).has_sign(1, free);
  };
  const std::array<bool, 4> all{true, true, true, true};
  for (std::size_t zero = 0; zero < 4; ++zero) {
    // 1 at three corners, 0 at one.
    const Polynomial far_x = zero >= 2 ? x : Polynomial(1) - x;
    const Polynomial far_y = zero % 2 != 0 ? y : Polynomial(1) - y;
    const Polynomial f = Polynomial(1) - far_x * far_y;
    for (std::size_t free = 0; free < 4; ++free) {
      std::array<bool, 4> one{};
      one.at(free) = true;
      EXPECT_EQ(signs(f, one), free == zero) << zero << ' ' << free;
    }
    EXPECT_TRUE(signs(f + Polynomial(1), {}));
    EXPECT_FALSE(signs(Polynomial(-1) * f, all));
    EXPECT_TRUE(BernsteinForm(Polynomial(-1) * f, cell).has_sign(-1, all));
  }
  // One coefficient for two corners: both have to be free.
  EXPECT_FALSE(signs(x, {false, true, false, false}));
  EXPECT_FALSE(signs(x, {true, false, false, false}));
  EXPECT_TRUE(signs(x, {true, true, false, false}));
  EXPECT_FALSE(signs(y, {true, false, false, false}));
  EXPECT_FALSE(signs(y, {false, false, true, false}));
  EXPECT_TRUE(signs(y, {true, false, true, false}));
  // A coefficient between the corners may not be 0: those of (x - 1/2)^2 + 1/4 are 1/2, 0, 1/2.
  const Polynomial half(Rational(1, 2));
  EXPECT_FALSE(signs((x - half) * (x - half) + Polynomial(Rational(1, 4)), all));
}

TEST(BernsteinForm, HalvesAreTheFormsOnHalves) {
  const Polynomial f = x * x * x - Polynomial(4) * x * y * y + y * y * y * y;
  const ParameterBox cell{{Rational(-1), Rational(0)}, {Rational(3), Rational(1)}};
  for (const bool first : {true, false}) {
    const auto halves = BernsteinForm(f, cell).halves(first);
    const std::size_t k = first ? 0 : 1;
    const Rational middle = (cell.lower[k] + cell.upper[k]) / Rational(2);
    ParameterBox low = cell;
    ParameterBox high = cell;
    low.upper[k] = high.lower[k] = middle;
    EXPECT_EQ(halves[0].coefficients(), BernsteinForm(f, low).coefficients());
    EXPECT_EQ(halves[1].coefficients(), BernsteinForm(f, high).coefficients());
  }
}

}  // namespace
}  // namespace subdiv
