#include "analysis/contraction_set.h"

#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "analysis/sign_on_interval.h"
#include "schemes/algebra/specialize.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

const Function p = Function::variable(0);

Matrix<Function> square(std::initializer_list<Function> entries) {
  const Eigen::Index n = entries.size() == 4 ? 2 : 3;
  Matrix<Function> result(n, n);
  Eigen::Index i = 0;
  for (const Function& f : entries) {
    result(i / n, i % n) = f;
    ++i;
  }
  return result;
}

TEST(ContractionSet, RealAndComplexEigenvalues) {
  EXPECT_EQ(contraction_set(square({p, 0, 0, p * 2})).to_string(), "(-1/2, 1/2)");
  EXPECT_EQ(contraction_set(square({p, 0, 0, p * 2}), Rational(3)).to_string(), "(-3/2, 3/2)");
  // A rotation times p: complex eigenvalues of modulus |p|.
  EXPECT_EQ(contraction_set(square({p * fraction<Function>(3, 5), p * fraction<Function>(-4, 5),
                                    p * fraction<Function>(4, 5), p * fraction<Function>(3, 5)}))
                .to_string(),
            "(-1, 1)");
  // Companion matrix of x^2 - x + p: a root -> 1 at p = 0, complex roots of modulus sqrt(p) from p = 1/4 on.
  EXPECT_EQ(contraction_set(square({0, -p, 1, 1})).to_string(), "(0, 1)");
}

TEST(ContractionSet, PointsThatTouchAndPolesAreLeftOut) {
  // The eigenvalue p^2 + 1 - p^4 ... 1 - p^2 touches 1 at p = 0.
  const Matrix<Function> touching = square({Function(1) - p * p, 0, 0, 0});
  EXPECT_EQ(contraction_set(touching).to_string(), "(-sqrt(2), 0) u (0, sqrt(2))");
  const Matrix<Function> pole = square({fraction<Function>(1, 2), Function(1) / p, 0, 0});
  EXPECT_EQ(contraction_set(pole).to_string(), "(-inf, 0) u (0, inf)");
}

TEST(ContractionSet, EverythingAndNothing) {
  EXPECT_EQ(contraction_set(square({0, p, 0, 0})).to_string(), "(-inf, inf)");
  EXPECT_TRUE(contraction_set(square({1, p, 0, 0})).is_empty());
  // x^2 - p x + 1 is its own mirror image: never inside.
  EXPECT_TRUE(contraction_set(square({p, -1, 1, 0})).is_empty());
}

TEST(ContractionSet, AgreesWithEigenvaluesOfSamples) {
  std::mt19937 random(11);
  std::uniform_int_distribution<int> entry(-4, 4);
  for (int trial = 0; trial < 12; ++trial) {
    Matrix<Function> m(3, 3);
    for (Eigen::Index i = 0; i < 9; ++i) {
      m.data()[i] = fraction<Function>(entry(random), 6) + p * fraction<Function>(entry(random), 5);
    }
    const RealSet set = contraction_set(m);
    for (int i = -20; i <= 20; ++i) {
      const Rational at(i * 7 + 1, 31);
      const Eigen::MatrixXd here =
          m.unaryExpr([&](const Function& f) { return specialize(f, 0, at).to_double(); });
      const double radius = here.eigenvalues().cwiseAbs().maxCoeff();
      if (std::abs(radius - 1) < 1e-9) continue;
      EXPECT_EQ(set.contains(Algebraic(at)), radius < 1) << trial << " " << at.to_string();
    }
  }
}

TEST(ContractionSet, Intersections) {
  const auto set = [](const RealInterval& part) { return RealSet{{part}}; };
  EXPECT_EQ(intersection(set(open_interval(0, 2)), set(closed_interval(1, 3))).to_string(), "[1, 2)");
  EXPECT_TRUE(intersection(set(open_interval(0, 1)), set(open_interval(1, 2))).is_empty());
  EXPECT_EQ(intersection(set(closed_interval(0, 1)), set(closed_interval(1, 2))).to_string(), "{1}");
  EXPECT_EQ(intersection(set(RealInterval{}), set(open_interval(0, 1))).to_string(), "(0, 1)");
}

}  // namespace
}  // namespace subdiv
