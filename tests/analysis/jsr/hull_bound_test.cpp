#include "analysis/jsr/hull_bound.h"

#include <gtest/gtest.h>

namespace subdiv {
namespace {

constexpr long precision = 128;

BallMatrix column(const std::vector<std::complex<double>>& entries) {
  Eigen::MatrixXcd v(static_cast<Eigen::Index>(entries.size()), 1);
  for (std::size_t i = 0; i < entries.size(); ++i) v(static_cast<Eigen::Index>(i), 0) = entries[i];
  return BallMatrix(v);
}

/// The bound by way of the proposal of floating point.
Interval bound(const BallMatrix& x, const std::vector<BallMatrix>& vertices, bool complex_hull) {
  HullGauge gauge(x.rows(), complex_hull);
  for (const BallMatrix& v : vertices) gauge.add(v.midpoints());
  gauge.condition();
  const HullCombination proposal = gauge.combine(x.midpoints());
  const auto spanning = spanning_columns(vertices, complex_hull, precision);
  return gauge_bound(x, vertices, proposal, basis_near(proposal, vertices, *spanning), *spanning, precision);
}

/// conv +-{(1, 0), (0, 1), (1, 1)}: max(|x|, |y|) where the signs agree, else |x| + |y|.
const std::vector<BallMatrix> hexagon{column({1, 0}), column({0, 1}), column({1, 1})};

TEST(HullBound, IsTheGaugeOfAHexagon) {
  for (const auto& [x, y, gauge] :
       {std::tuple{0.75, 0.25, 0.75}, {-0.5, 0.25, 0.75}, {3.0, 4.0, 4.0}, {0.0, -2.0, 2.0}}) {
    const Interval b = bound(column({x, y}), hexagon, false);
    EXPECT_TRUE(b.contains(Rational::from_double(gauge))) << x << ' ' << y;
    EXPECT_LT(b.radius(), 1e-25);
  }
}

TEST(HullBound, OfABadProposalIsStillValid) {
  HullCombination bad;
  bad.terms.push_back({2, false, 0.9});
  const BallMatrix x = column({0.5, 0.5});
  const auto spanning = spanning_columns(hexagon, false, precision);
  ASSERT_TRUE(spanning);
  const Interval b = gauge_bound(x, hexagon, bad, *spanning, *spanning, precision);
  EXPECT_FALSE(certainly_less(b, Interval(Rational(1, 2))));  // 1/2 is the truth
}

TEST(HullBound, CoversTheWholeBalls) {
  // The vertex 1 known to a thousandth: the gauge of 1 may be anything up to 1000/999.
  std::vector<BallMatrix> vertices{column({1})};
  mag_set_d(arb_radref(acb_realref(vertices[0].at(0, 0))), 1e-3);
  const Interval b = bound(column({1}), vertices, false);
  EXPECT_GE(b.upper(), Rational(1000, 999));
  EXPECT_FALSE(certainly_at_most(b, Interval(1)));
}

TEST(HullBound, OfAComplexHull) {
  // conv { e^(it) (1, i) } and conjugates: (1, 0) is their mean, of gauge 1; (1/2, i/2) has gauge 1/2.
  const std::complex<double> i(0, 1);
  const std::vector<BallMatrix> circle{column({1, i})};
  const Interval mean = bound(column({1, 0}), circle, true);
  EXPECT_LT(mean.to_double(), 1.0001);
  EXPECT_FALSE(certainly_less(mean, Interval(1)));
  EXPECT_TRUE(bound(column({0.5, 0.5 * i}), circle, true).contains(Rational(1, 2)));
  // A turned vertex has gauge 1 in the complex hull.
  const std::complex<double> turn(0.6, 0.8);
  EXPECT_NEAR(bound(column({turn, turn * i}), circle, true).to_double(), 1, 1e-6);
}

TEST(HullBound, DependentVerticesSpanNothing) {
  EXPECT_FALSE(spanning_columns({column({1, 2}), column({-2, -4})}, false, precision));
  EXPECT_FALSE(spanning_columns({column({1, 2})}, false, precision));
  EXPECT_FALSE(spanning_columns({}, false, precision));
  // Independent only by rounding errors of their balls: not proved.
  std::vector<BallMatrix> close{column({1, 0}), column({1, 1e-20})};
  mag_set_d(arb_radref(acb_realref(close[1].at(1, 0))), 1e-19);
  EXPECT_FALSE(spanning_columns(close, false, precision));
}

Vector<FieldElement> exact(const Rational& x, const Rational& y) {
  Vector<FieldElement> v(2);
  v << FieldElement(x), FieldElement(y);
  return v;
}

TEST(HullBound, ExactInclusionSeesTheLastDigit) {
  const std::vector<Vector<FieldElement>> basis{exact(1, 0), exact(1, 1)};
  EXPECT_TRUE(is_exactly_inside(exact(1, Rational(1, 3)), basis));  // on an edge
  EXPECT_FALSE(is_exactly_inside(exact(Rational(1) + pow(Rational(10), -40), Rational(1, 3)), basis));
  // A vertex tampered with: (1, 1) shortened by 1e-4.
  const Rational shorter = Rational(1) - Rational(1, 10000);
  EXPECT_FALSE(is_exactly_inside(exact(1, Rational(1, 3)), {exact(1, 0), exact(shorter, shorter)}));
  EXPECT_FALSE(is_exactly_inside(exact(0, 0), {exact(1, 2), exact(2, 4)}));  // no basis
}

TEST(HullBound, OfATamperedVertexExceedsOne) {
  // J_{5/2}: T_0 = (3 0; 3 -2)/4, T_1 = (-2 3; 0 3)/4, rho = 3/4: T_0 (1, 0) / rho = (1, 1).
  const BallMatrix image = column({1, 1});
  EXPECT_FALSE(certainly_less(Interval(1), bound(image, hexagon, false)));
  std::vector<BallMatrix> tampered = hexagon;
  tampered[2] = column({1 / 1.0001, 1 / 1.0001});
  EXPECT_TRUE(certainly_less(Interval(1), bound(image, tampered, false)));
}

}  // namespace
}  // namespace subdiv
