#include "analysis/bspline_distance.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "schemes/bspline.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

constexpr int level = 8;

/// phi_s - B_d at multiples of 1/256, index 0 at t = -4, by the values of the whole basis function.
std::vector<double> samples(const Rational& s, int degree) {
  const Laurent<Rational> phi = basis_values(stationary<Rational>("", jspline(s)), level);
  const UniformBspline b(degree);
  std::vector<double> result;
  for (int i = -(4 << level); i <= 4 << level; ++i) {
    result.push_back((phi[i] - b.value(Rational(i, 1 << level))).to_double());
  }
  return result;
}

struct Case {
  Rational s;
  int degree;
};

const std::vector<Case> cases{{Rational(689, 1000), 2}, {Rational(127, 100), 4}, {Rational(1, 7), 1},
                              {Rational(2), 3},         {Rational(5, 2), 5},     {Rational(3), 2}};

TEST(BsplineDistance, L1AgreesWithASum) {
  for (const auto& [s, degree] : cases) {
    const Enclosure distance = bspline_distance_l1(s, degree);
    double sum = 0;
    for (const double e : samples(s, degree)) sum += std::abs(e) / (1 << level);
    EXPECT_EQ(distance.status, Status::closed);
    EXPECT_EQ(distance.rigour, Rigour::certified);
    EXPECT_LT(distance.width(), Rational::power_of_two(-100));
    EXPECT_NEAR(distance.lower.to_double(), sum, 2e-5) << s.to_string();
  }
}

TEST(BsplineDistance, LinfLiesJustAboveTheSamples) {
  for (const auto& [s, degree] : cases) {
    const Enclosure distance = bspline_distance_linf(s, degree);
    double largest = 0;
    for (const double e : samples(s, degree)) largest = std::max(largest, std::abs(e));
    EXPECT_EQ(distance.status, Status::closed);
    EXPECT_LE(largest, distance.upper.to_double() + 1e-15) << s.to_string();
    EXPECT_NEAR(distance.lower.to_double(), largest, 1e-5) << s.to_string();
  }
}

TEST(BsplineDistance, OfTheCubicAndQuinticMembersIsZero) {
  for (const auto& distance :
       {bspline_distance_l1(1, 3), bspline_distance_linf(1, 3), bspline_edge_bound(1, 3),
        bspline_distance_l1(Rational(3, 2), 5), bspline_distance_linf(Rational(3, 2), 5)}) {
    EXPECT_EQ(distance.upper, Rational(0));
    EXPECT_EQ(distance.rigour, Rigour::exact);
  }
}

TEST(BsplineDistance, ParametersJustBesideAMemberAreFine) {
  const Enclosure near = bspline_distance_linf(Rational(1001, 1000), 3);
  EXPECT_GT(near.lower, Rational(0));
  EXPECT_LT(near.upper, Rational(1, 1000));
}

TEST(BsplineDistance, OfTheSecondMemberFromQuarticBsplines) {
  // phi_2(t) = (B_4(t - 1/2) + B_4(t + 1/2))/2, by symbols: S_2(z) (1+z) = B_4's symbol times (1 + z^2).
  const Laurent<Rational> one_plus_z(0, {1, 1});
  EXPECT_EQ(jspline(Rational(2)).symbol * one_plus_z,
            shift(bspline<Rational>(4).symbol * upsample(one_plus_z, 2), -1));
  const UniformBspline quartic(4);
  double sum = 0;
  double largest = 0;
  constexpr int steps = 3000;
  for (int i = -3 * steps; i <= 3 * steps; ++i) {
    const Rational t(i, steps);
    const Rational phi =
        (quartic.value(t - Rational(1, 2)) + quartic.value(t + Rational(1, 2))) / Rational(2);
    const double e = std::abs((phi - quartic.value(t)).to_double());
    sum += e / steps;
    largest = std::max(largest, e);
  }
  EXPECT_NEAR(bspline_distance_l1(2, 4).lower.to_double(), sum, 1e-7);
  EXPECT_NEAR(bspline_distance_linf(2, 4).lower.to_double(), largest, 1e-7);
}

/// sum over k of |H_k(t)| on the samples' grid, t = i/256 in [0, 1).
double edge_sum(const std::vector<double>& e, int i) {
  double sum = 0;
  double h = 0;
  for (int m = 3; m >= -4; --m) {
    h += e[static_cast<std::size_t>(i + ((m + 4) << level))];
    sum += std::abs(h);
  }
  return sum;
}

TEST(BsplineDistance, EdgeBoundIsTheSupremumOfTheSamples) {
  const Rational s(689, 1000);
  const std::vector<double> e = samples(s, 2);
  double largest = 0;
  for (int i = 0; i < 1 << level; ++i) largest = std::max(largest, edge_sum(e, i));
  const Enclosure bound = bspline_edge_bound(s, 2);
  EXPECT_EQ(bound.status, Status::closed);
  EXPECT_GE(bound.upper.to_double(), largest);
  EXPECT_NEAR(bound.upper.to_double(), largest, 1e-6);
}

TEST(BsplineDistance, EdgeBoundIsAttainedByAPolygonAndNeverPassed) {
  const std::vector<double> e = samples(Rational(689, 1000), 2);
  const double bound = bspline_edge_bound(Rational(689, 1000), 2).upper.to_double();
  int worst = 0;
  for (int i = 0; i < 1 << level; ++i) worst = edge_sum(e, i) > edge_sum(e, worst) ? i : worst;
  // The curves' difference at t is sum over m of e(t + m) P_{-m}; P_{-m} - P_{-m-1} is the edge's sign.
  const auto difference = [&](const std::vector<double>& edges, int i) {
    double sum = 0;
    double p = 0;  // P_{-m}, from m = 3 down
    for (int m = 3; m >= -4; --m) {
      sum += e[static_cast<std::size_t>(i + ((m + 4) << level))] * p;
      p += edges[static_cast<std::size_t>(m + 4)];
    }
    return std::abs(sum);
  };
  std::vector<double> edges(8);
  double attained = 0;
  for (int signs = 0; signs < 256; ++signs) {
    for (std::size_t k = 0; k < 8; ++k) edges[k] = (signs >> k) % 2 == 0 ? 1 : -1;
    attained = std::max(attained, difference(edges, worst));
    for (int i = 0; i < 1 << level; i += 16) EXPECT_LE(difference(edges, i), bound);
  }
  EXPECT_NEAR(attained, bound, 1e-6);
}

TEST(BsplineDistance, BowHoldsTheDeviationFromTheChordAndNotMuchMore) {
  const BsplineDifference e(Rational(689, 1000), 2, 256);
  for (BsplineDifference::Piece piece : e.pieces(0, 2)) {
    for (int k = 0; k < 20; ++k) {
      const auto [left, right] = e.halves(piece);
      const Interval deviation = abs(left.right - (piece.left + piece.right) / Interval(2));
      const Rational bow = BsplineDifference::bow(piece).upper();
      EXPECT_LE(deviation.lower(), bow);
      if (k == 19) {
        EXPECT_LT(bow, Rational(2) * deviation.lower());
      }
      piece = right;
    }
  }
}

TEST(BsplineDistance, SaysWhenThePiecesRunOut) {
  DistanceOptions few;
  few.max_pieces = 20;
  const Enclosure l1 = bspline_distance_l1(Rational(689, 1000), 2, few);
  EXPECT_EQ(l1.status, Status::out_of_depth);
  EXPECT_LE(l1.lower, bspline_distance_l1(Rational(689, 1000), 2).lower);
  EXPECT_GE(l1.upper, bspline_distance_l1(Rational(689, 1000), 2).upper);
  const Enclosure linf = bspline_distance_linf(Rational(689, 1000), 2, few);
  EXPECT_EQ(linf.status, Status::out_of_depth);
  EXPECT_GE(linf.upper, bspline_distance_linf(Rational(689, 1000), 2).upper);
}

TEST(BsplineDistance, RejectsParametersWithoutABound) {
  EXPECT_THROW((void)bspline_distance_l1(0, 2), std::domain_error);
  EXPECT_THROW((void)bspline_distance_linf(Rational(31, 10), 2), std::domain_error);
  EXPECT_THROW((void)bspline_edge_bound(Rational(1, 2), 0), std::domain_error);
}

TEST(BsplineDistance, CurvatureHoldsTheSecondDifferencesOfTheLimit) {
  // The lemma itself: second difference quotients of finely sampled limits are averages of e''.
  for (const Rational& s : {Rational(1, 10), Rational(689, 1000), Rational(3, 2), Rational(29, 10)}) {
    const BsplineDifference difference(s, 2, 128);
    const std::vector<double> e = samples(s, 2);
    for (const auto& top : difference.pieces(-3, 3)) {
      for (const auto& piece : {difference.halves(top).first, difference.halves(top).second}) {
        const Interval margin = Interval::hull(Rational(-1, 100000), Rational(1, 100000));
        const int first =
            static_cast<int>(((piece.basis.left + Rational(4)) * Rational(1 << level)).to_integer());
        const int count = (1 << level) >> piece.basis.level;
        for (int i = first + 1; i < first + count; ++i) {
          const auto j = static_cast<std::size_t>(i);
          const double quotient = (e[j - 1] - 2 * e[j] + e[j + 1]) * (1 << level) * (1 << level);
          EXPECT_TRUE((piece.curvature + margin).contains(Rational::from_double(quotient)))
              << s.to_string() << " " << i;
        }
      }
    }
  }
}

}  // namespace
}  // namespace subdiv
