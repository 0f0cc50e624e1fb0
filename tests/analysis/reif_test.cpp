#include "analysis/reif.h"

#include <algorithm>
#include <complex>
#include <vector>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "schemes/bspline.h"
#include "schemes/dyn_floater_hormann.h"
#include "schemes/four_point.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

using F = RationalFunction;
const F s = F::variable(0);

TEST(Reif, JsplineRanges) {
  // js-report 3, and C0.
  const Mask<F> mask = jspline(s);
  const std::vector<std::string> expected{"(-6, 10)", "(-2, 6)", "(0, 4)", "(1, 3)", "{3/2}", "empty"};
  for (int order = 0; order <= 5; ++order) {
    EXPECT_EQ(reif_set(mask, order).to_string(), expected[static_cast<std::size_t>(order)]);
  }
}

TEST(Reif, OrderOfConcreteSchemes) {
  for (int degree = 1; degree <= 7; ++degree) EXPECT_EQ(reif_order(bspline<Rational>(degree)), degree - 1);
  EXPECT_EQ(reif_order(bspline<Rational>(0)), -1);
  EXPECT_EQ(reif_order(four_point(Rational(1, 16))), 1);
  EXPECT_EQ(reif_order(dyn_floater_hormann(Rational(1, 128))), 2);
  EXPECT_EQ(reif_order(jspline(Rational(2))), 3);  // a double 1/16
  EXPECT_EQ(reif_order(jspline(Rational(3, 2))), 4);
  EXPECT_EQ(reif_order(jspline(Rational(4))), 1);
  EXPECT_EQ(reif_order(jspline(Rational(-6))), -1);
  EXPECT_EQ(reif_order(jspline(sqrt(Algebraic(2)))), 3);
  EXPECT_EQ(reif_order(jspline(sqrt(Algebraic(10)))), 2);
  const Mask<Rational> ternary{3,
                               Laurent<Rational>(3) * pow(Rational(1, 3) * smoothing_factor<Rational>(3), 4)};
  EXPECT_EQ(reif_order(ternary), 2);
}

/// The same condition from floating-point eigenvalues; not to be trusted near equality.
bool holds_numerically(const Mask<Rational>& mask, int order) {
  const Matrix<Rational> exact = subdivision_matrix(mask);
  Eigen::MatrixXd matrix(exact.rows(), exact.cols());
  for (Eigen::Index i = 0; i < exact.size(); ++i) matrix.data()[i] = exact.data()[i].to_double();
  const Eigen::VectorXcd raw = matrix.eigenvalues();
  std::vector<std::complex<double>> spectrum(raw.begin(), raw.end());
  constexpr double tolerance = 1e-5;
  double power = 1;
  for (int k = 0; k <= order; ++k) {
    const auto found = std::find_if(spectrum.begin(), spectrum.end(),
                                    [&](const auto& e) { return std::abs(e - power) < tolerance; });
    if (found == spectrum.end()) return false;
    spectrum.erase(found);
    if (k < order) power /= mask.arity;
  }
  return std::all_of(spectrum.begin(), spectrum.end(), [&](const auto& e) { return std::abs(e) < power; });
}

void expect_as_numerically(const Mask<F>& mask, int order, int lower, int upper) {
  const RealSet set = reif_set(mask, order);
  int members = 0;
  for (int i = 37 * lower; i < 37 * upper; ++i) {
    const Rational value(2 * i + 1, 74);  // clear of all simple critical values
    const Mask<Rational> concrete = map_coefficients(mask, [&](const F& c) {
      const std::vector<Rational> point{value};
      return c.evaluate(std::span<const Rational>(point));
    });
    EXPECT_EQ(set.contains(Algebraic(value)), holds_numerically(concrete, order))
        << value.to_string() << " " << order;
    members += set.contains(Algebraic(value)) ? 1 : 0;
  }
  EXPECT_GT(members, 0);
}

TEST(Reif, SetsAgreeWithFloatingPointEigenvalues) {
  const F sixteenth(Rational(1, 16));
  for (int order = 0; order <= 3; ++order) expect_as_numerically(jspline(s), order, -7, 11);
  for (int order = 0; order <= 1; ++order) expect_as_numerically(four_point(sixteenth * s), order, -9, 9);
  for (int order = 0; order <= 2; ++order)
    expect_as_numerically(dyn_floater_hormann(sixteenth * s), order, -3, 3);
}

TEST(Reif, ComplexPairsCrossingTheCircle) {
  // (1+z) q(z), q of seven coefficients that add up to 1: the cofactor's matrix has a block whose eigenvalues
  // turn complex.
  const auto c = [](int p) { return F(Rational(p, 8)); };
  const F t = F(Rational(1, 4)) * s;
  const Laurent<F> q(-3, {c(1), c(2) - t, t, c(3), c(1) + t + t, c(0) - t, c(1) - t});
  const Mask<F> mask{2, Laurent<F>(0, {F(1), F(1)}) * q};
  const std::vector<Rational> at{Rational(1)};
  expect_as_numerically(mask, 0, -8, 8);
  const RealSet set = reif_set(mask, 0);
  bool irrational = false;
  for (const RealInterval& part : set.parts)
    irrational = irrational || (part.upper && !part.upper->is_rational());
  EXPECT_TRUE(irrational) << set.to_string();
}

TEST(Reif, PolesDoNotBelong) {
  // J_s with s = 1/p + 1: C3 for 0 < 1/p < 2, at p = 0 the mask is undefined; 1/p ranges over all of it for
  // C0 but p = 0.
  const F p = s;
  const Mask<F> mask = jspline(F(1) / p + F(1));
  EXPECT_EQ(reif_set(mask, 3).to_string(), "(1/2, inf)");
  EXPECT_EQ(reif_set(mask, 0).to_string(), "(-inf, -1/7) u (1/9, inf)");
  const Mask<F> removable{2, (p / p) * bspline<F>(3).symbol};
  EXPECT_EQ(reif_set(removable, 2).to_string(), "(-inf, inf)");
}

TEST(Reif, OtherParameters) {
  EXPECT_EQ(reif_set(jspline(F::variable(2)), 3, 2).to_string(), "(1, 3)");
  EXPECT_THROW(reif_set(jspline(F::variable(0), F::variable(1)), 1, 0), std::domain_error);
  EXPECT_THROW(reif_set(jspline(F::variable(0), F::variable(1)), 1, 1), std::domain_error);
}

}  // namespace
}  // namespace subdiv
