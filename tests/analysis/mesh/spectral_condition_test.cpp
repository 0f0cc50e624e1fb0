#include "analysis/mesh/spectral_condition.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "schemes/mesh/butterfly.h"
#include "schemes/mesh/jspline_mesh.h"
#include "schemes/mesh/loop.h"

namespace subdiv {
namespace {

using F = RationalFunction;
const F s = F::variable(0);

SpectralCondition condition(const MeshScheme<F>& scheme, int valence) {
  return {turning_modes(scheme), invariant_mode(scheme, valence), valence};
}

/// The second route: eigenvalues of the blocks themselves, in double precision, by decreasing modulus.
std::vector<std::complex<double>> direct(const FanMatrix<double>& fan, int k) {
  Eigen::MatrixXcd block = Eigen::MatrixXcd::Zero(fan.places(), fan.places());
  for (int j = 0; j < fan.valence; ++j) {
    block += std::polar(1.0, 2 * std::numbers::pi * k * j / fan.valence) *
             fan.blocks[static_cast<std::size_t>(j)].cast<std::complex<double>>();
  }
  if (k == 0) block = invariant_block(fan).cast<std::complex<double>>();
  const Eigen::ComplexEigenSolver<Eigen::MatrixXcd> solver(block, false);
  std::vector<std::complex<double>> result(solver.eigenvalues().begin(), solver.eigenvalues().end());
  std::sort(result.begin(), result.end(), [](auto a, auto b) { return std::abs(a) > std::abs(b); });
  return result;
}

/// 1 > lambda > |others|, and the two numbers.
std::tuple<bool, double, double> direct(const MeshScheme<double>& scheme, int n) {
  const FanMatrix<double> fan = fan_matrix(scheme, n, eigenvalue_rings(scheme));
  const auto first = direct(fan, 1);
  double next = std::abs(first[1]);
  for (int k = 0; k <= n / 2; ++k) {
    if (k != 1) next = std::max(next, std::abs(direct(fan, k)[k == 0 ? 1 : 0]));
  }
  const bool real = std::abs(first[0].imag()) < 1e-9 && first[0].real() > 0;
  return {real && first[0].real() < 1 && std::abs(first[0]) > next, std::abs(first[0]), next};
}

TEST(SpectralCondition, CatmullClarkInClosedForm) {
  for (const int n : {3, 5, 6, 17, 30, 200}) {
    const auto leading = condition(catmull_clark<F>(), n).leading(Rational(0));
    ASSERT_TRUE(leading.has_value()) << n;
    const double c = std::cos(2 * std::numbers::pi / n);
    EXPECT_NEAR(leading->subdominant.to_double(), (5 + c + std::sqrt((c + 9) * (c + 1))) / 16, 1e-15);
    EXPECT_LT(leading->subdominant.radius(), 1e-25);
  }
}

TEST(SpectralCondition, LoopInClosedForm) {
  for (const int n : {4, 5, 12, 100}) {
    const auto leading = condition(loop<F>(), n).leading(Rational(0));
    ASSERT_TRUE(leading.has_value()) << n;
    EXPECT_NEAR(leading->subdominant.to_double(), 0.375 + 0.25 * std::cos(2 * std::numbers::pi / n), 1e-15);
  }
  EXPECT_EQ(condition(loop<F>(), 3).decide(Rational(0)), Decision::yes);
}

TEST(SpectralCondition, ButterflyFailsFromModeTwo) {
  const SpectralCondition eight = condition(butterfly<F>(), 8);
  EXPECT_EQ(eight.decide(Rational(0)), Decision::no);
  EXPECT_EQ(eight.rival(Rational(0)).mode, 2);
  EXPECT_EQ(condition(butterfly<F>(), 7).decide(Rational(0)), Decision::yes);
}

TEST(SpectralCondition, AgreesWithTheBlocksThemselves) {
  for (const int n : {3, 5, 8, 11}) {
    const SpectralCondition directional = condition(jspline_mesh<F>(s), n);
    const SpectralCondition literal = condition(jspline_mesh_literal<F>(s), n);
    for (int i = -8; i <= 24; i += 3) {
      const Rational at(i, 4);
      const double value = at.to_double();
      for (const auto& [exact, rounded] :
           {std::pair{&directional, direct(jspline_mesh<double>(value), n)},
            std::pair{&literal, direct(jspline_mesh_literal<double>(value), n)}}) {
        const auto [holds, lambda, next] = rounded;
        EXPECT_EQ(exact->decide(at), holds ? Decision::yes : Decision::no) << n << " " << value;
        if (!holds) continue;
        const auto leading = exact->leading(at);
        ASSERT_TRUE(leading.has_value()) << n << " " << value;
        EXPECT_NEAR(leading->subdominant.to_double(), lambda, 1e-9);
        EXPECT_NEAR(leading->next.to_double(), next, 1e-6);
      }
    }
  }
}

TEST(SpectralCondition, CellsAgreeWithSinglePoints) {
  const SpectralCondition five = condition(jspline_mesh_literal<F>(s), 5);
  const std::vector<ConditionCell> cells = five.cells(Rational(-2), Rational(6), Rational(1, 1L << 20));
  ASSERT_EQ(cells.size(), 5U);  // fails, end, holds, end, fails
  EXPECT_EQ(cells[2].holds, Decision::yes);
  EXPECT_LT(cells[1].upper - cells[1].lower, Rational(1, 1000));
  for (const ConditionCell& cell : cells) {
    if (cell.holds == Decision::undecided) continue;
    for (int i = 0; i <= 4; ++i) {
      const Rational at = cell.lower + (cell.upper - cell.lower) * Rational(i, 4);
      EXPECT_EQ(five.decide(at), cell.holds) << at.to_string();
    }
  }
}

TEST(RootCounter, CountsRootsOfWholeFamilies) {
  // (x - 1/2)^2 (x^2 + 9/16), and all with each coefficient off by 1/100000.
  const IntervalPolynomial p{Interval(Rational(9, 64)), Interval(Rational(-9, 16)),
                             Interval(Rational(13, 16)), Interval(-1), Interval(1)};
  const RootCounter one({p, {}, Interval(0)}, false);
  const RootCounter family({p, IntervalPolynomial(5, Interval(1)), Interval(Rational(1, 100000))}, false);
  for (const RootCounter* counter : {&one, &family}) {
    EXPECT_EQ(counter->within(Interval(Rational(1, 4))), 0);
    EXPECT_EQ(counter->within(Interval(Rational(5, 8))), 2);
    EXPECT_EQ(counter->within(Interval(1)), 4);
    EXPECT_FALSE(counter->within(Interval(Rational(3, 4))).has_value());
    EXPECT_FALSE(counter->within(Interval(Rational(1, 2))).has_value());
    EXPECT_FALSE(counter->complex_beyond(Interval(Rational(1, 4))));
  }
}

}  // namespace
}  // namespace subdiv
