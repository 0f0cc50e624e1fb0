#include "analysis/eigenvalues.h"

#include <algorithm>
#include <complex>
#include <random>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "analysis/subdivision_matrix.h"
#include "analysis/sum_rules.h"
#include "schemes/algebra/univariate.h"
#include "schemes/bspline.h"
#include "schemes/dyn_floater_hormann.h"
#include "schemes/four_point.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

using F = RationalFunction;
const F s = F::variable(0);
const std::vector<std::string> names{"s", "b"};

Matrix<Rational> rows(const std::vector<std::vector<Rational>>& entries) {
  Matrix<Rational> result(static_cast<Eigen::Index>(entries.size()),
                          static_cast<Eigen::Index>(entries[0].size()));
  for (std::size_t i = 0; i < entries.size(); ++i) {
    for (std::size_t j = 0; j < entries[i].size(); ++j) {
      result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = entries[i][j];
    }
  }
  return result;
}

std::string text(const std::vector<Eigenvalue>& spectrum, int digits = 12) {
  std::string result;
  for (const Eigenvalue& e : spectrum) {
    if (!result.empty()) result += ", ";
    result += e.to_string(digits);
    if (e.multiplicity > 1) result += " (" + std::to_string(e.multiplicity) + ")";
  }
  return result;
}

TEST(Eigenvalues, OfJsplines) {
  // js-report 3: 1, 1/2, 1/4, 1/8, (2-s)/8, (s-1)/16 twice, 0, 0 of the 9 x 9 matrix.
  const Mask<F> mask = jspline(s);
  EXPECT_EQ(to_string(eigenvalues(subdivision_matrix(mask, vertex_window(mask, 1))), names),
            "1, 1/2, 1/4, 1/8, 0 (2), (-s + 2)/8, (s - 1)/16 (2)");
  EXPECT_EQ(to_string(eigenvalues(subdivision_matrix(mask)), names),
            "1, 1/2, 1/4, 1/8, (-s + 2)/8, (s - 1)/16 (2)");
  EXPECT_EQ(text(eigenvalues(subdivision_matrix(jspline(Rational(2))))), "1, 1/2, 1/4, 1/8, 1/16 (2), 0");
  EXPECT_EQ(text(eigenvalues(subdivision_matrix(jspline(Rational(4))))), "1, 1/2, 1/4, -1/4, 3/16 (2), 1/8");
}

TEST(Eigenvalues, TwoParametersAndPoles) {
  // The even and odd blocks of {J_a,b}: 1 - a/4 - .. leaves a quadratic factor.
  const Matrix<F> matrix = subdivision_matrix(jspline(s, F::variable(1)));
  const ParametricSpectrum spectrum = eigenvalues(matrix);
  const Rational a(3, 5), b(-2, 7);
  const std::vector<Rational> point{a, b};
  // det(x I - J_a,b) at x = 3, twice: from the factors at (a, b), and from the matrix at (a, b).
  Rational product(1);
  const Rational x(3);
  for (const auto& [value, multiplicity] : spectrum.values) {
    product *= pow(x - value.evaluate(std::span<const Rational>(point)), multiplicity);
  }
  for (const auto& [factor, multiplicity] : spectrum.factors) {
    std::vector<Rational> all(max_parameters);
    all[0] = a;
    all[1] = b;
    all[eigenvalue_variable] = x;
    const std::vector<Polynomial> in_x = factor.coefficients_in(eigenvalue_variable);
    const Rational leading = in_x.back().evaluate(std::span<const Rational>(all));
    product *= pow(factor.evaluate(std::span<const Rational>(all)) / leading, multiplicity);
  }
  const std::vector<Rational> characteristic = characteristic_polynomial(subdivision_matrix(jspline(a, b)));
  EXPECT_EQ(product, UnivariatePolynomial(characteristic).evaluate(x));

  Matrix<F> with_pole(2, 2);
  with_pole << F(1) / s, F(1), F(0), s;
  const ParametricSpectrum reciprocal = eigenvalues(with_pole);
  ASSERT_EQ(reciprocal.values.size(), 2U);
  EXPECT_EQ(reciprocal.values[0].first * reciprocal.values[1].first, F(1));
  Matrix<F> taken(1, 1);
  taken << F::variable(eigenvalue_variable);
  EXPECT_THROW(eigenvalues(taken), std::domain_error);
  Matrix<F> golden(2, 2);
  golden << F(0), F(1), s, F(1);
  const ParametricSpectrum quadratic = eigenvalues(golden);
  ASSERT_EQ(quadratic.factors.size(), 1U);
  EXPECT_EQ(quadratic.factors[0].first.degree(eigenvalue_variable), 2);
  EXPECT_TRUE(quadratic.values.empty());
  EXPECT_EQ(to_string(quadratic, names).rfind("roots of ", 0), 0U);
}

TEST(Eigenvalues, ComplexAndIrrationalOnesOverQ) {
  EXPECT_EQ(text(eigenvalues(rows({{0, -1}, {1, 0}}))), "0+1.00000000000i, 0-1.00000000000i");
  EXPECT_EQ(text(eigenvalues(rows({{0, 2}, {1, 0}}))), "sqrt(2), -sqrt(2)");
  // The companion matrix of x^3 - 2: 2^(1/3) and 2^(1/3) e^{+-2 pi i / 3}.
  const std::vector<Eigenvalue> cubic = eigenvalues(rows({{0, 0, 2}, {1, 0, 0}, {0, 1, 0}}));
  ASSERT_EQ(cubic.size(), 3U);
  for (const Eigenvalue& e : cubic) EXPECT_NEAR(e.modulus().to_double(), std::cbrt(2.0), 1e-15);
  EXPECT_TRUE(cubic[0].is_real() && cubic[0].exact.has_value());
  EXPECT_FALSE(cubic[1].is_real() || cubic[1].exact.has_value());
  EXPECT_NEAR(cubic[1].imaginary.to_double(), std::cbrt(2.0) * std::sqrt(0.75), 1e-15);
  const std::vector<Eigenvalue> nilpotent = eigenvalues(rows({{0, 1}, {0, 0}}));
  EXPECT_EQ(text(nilpotent), "0 (2)");
}

TEST(Eigenvalues, AgreeWithFloatingPointOnRandomMatrices) {
  std::mt19937 generator(5);
  for (int trial = 0; trial < 10; ++trial) {
    constexpr int n = 5;
    Matrix<Rational> exact(n, n);
    Eigen::MatrixXd rounded(n, n);
    for (int i = 0; i < n * n; ++i) {
      exact.data()[i] = Rational(static_cast<int>(generator() % 41) - 20, 8);
      rounded.data()[i] = exact.data()[i].to_double();
    }
    const Eigen::VectorXcd expected = rounded.eigenvalues();
    for (const Eigenvalue& e : eigenvalues(exact)) {
      const std::complex<double> value(e.real.to_double(), e.imaginary.to_double());
      double distance = 1;
      for (const auto& other : expected) distance = std::min(distance, std::abs(value - other));
      EXPECT_LT(distance, 1e-10);
    }
  }
}

TEST(Eigenvalues, SumRulesSplitTheSpectrum) {
  // Differences: the spectrum is 1, 1/m, .., m^(1-n) and that of the cofactor's matrix, n the order of sum
  // rules.
  const Mask<Rational> ternary{
      3, Laurent<Rational>(-2, {Rational(1, 9), Rational(1, 3), Rational(1, 2), Rational(7, 9),
                                Rational(2, 3), Rational(1, 2), Rational(1, 9)})};
  for (const Mask<Rational>& mask : {jspline(Rational(5, 7)), four_point(Rational(1, 20)),
                                     dyn_floater_hormann(Rational(1, 50)), bspline<Rational>(4), ternary}) {
    const SumRules<Rational> rules = sum_rules(mask);
    ASSERT_GE(rules.order, 1);
    UnivariatePolynomial expected(
        characteristic_polynomial(subdivision_matrix(Mask<Rational>{mask.arity, rules.cofactor})));
    for (int k = 0; k < rules.order; ++k) {
      expected *= UnivariatePolynomial({-pow(Rational(mask.arity), -k), Rational(1)});
    }
    EXPECT_EQ(UnivariatePolynomial(characteristic_polynomial(subdivision_matrix(mask))), expected);
  }
}

TEST(Eigenvalues, OverAlgebraicNumbers) {
  const Algebraic root = sqrt(Algebraic(2));
  EXPECT_EQ(text(eigenvalues(subdivision_matrix(jspline(root)))),
            "1, 1/2, 1/4, 1/8, (2-sqrt(2))/8, (-1+sqrt(2))/16 (2)");
  EXPECT_EQ(text(eigenvalues(subdivision_matrix(jspline(Algebraic(2))))), "1, 1/2, 1/4, 1/8, 1/16 (2), 0");
  // x^2 + sqrt(2) x + 1: e^{+-3 pi i / 4}.
  Matrix<Algebraic> rotation(2, 2);
  rotation << Algebraic(0), Algebraic(-1), Algebraic(1), -root;
  const std::vector<Eigenvalue> pair = eigenvalues(rotation);
  ASSERT_EQ(pair.size(), 2U);
  EXPECT_FALSE(pair[0].is_real());
  EXPECT_NEAR(pair[0].imaginary.to_double(), std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(pair[1].imaginary.to_double(), -std::sqrt(0.5), 1e-15);
  // x^3 = sqrt(2), three times: no closed form is promised, multiplicities are exact.
  Matrix<Algebraic> blocks = zero_matrix<Algebraic>(6, 6);
  for (int k = 0; k < 2; ++k) {
    blocks(3 * k, 3 * k + 2) = root;
    blocks(3 * k + 1, 3 * k) = Algebraic(1);
    blocks(3 * k + 2, 3 * k + 1) = Algebraic(1);
  }
  const std::vector<Eigenvalue> sixth = eigenvalues(blocks);
  ASSERT_EQ(sixth.size(), 3U);
  for (const Eigenvalue& e : sixth) {
    EXPECT_EQ(e.multiplicity, 2);
    EXPECT_NEAR(e.modulus().to_double(), std::pow(2.0, 1.0 / 6), 1e-15);
  }
  EXPECT_TRUE(sixth[0].is_real());
}

}  // namespace
}  // namespace subdiv
