#include "experiments/speed_characteristic_ring.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analysis/adjustable_speed/characteristic_ring_map.h"
#include "analysis/adjustable_speed/contraction.h"
#include "analysis/adjustable_speed/ring_theorem.h"
#include "experiments/printed_border.h"
#include "experiments/speed_arrays.h"
#include "schemes/algebra/rational_function.h"
#include "tests/experiments/find_claim.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

TEST(SpeedCharacteristicRingClaims, AreSettledAsTheTheorySays) {
  const Results results = run_speed_characteristic_ring();
  const auto& claims = results.claims;
  ASSERT_EQ(claims.size(), speed_characteristic_ring_heads().size());
  for (const Claim& claim : claims) {
    EXPECT_NE(claim.verdict, Verdict::undecided) << claim.head.id;
    EXPECT_NE(claim.rigour, Rigour::approximate) << claim.head.id;
  }
  for (const char* id : {"speed.eq9.t10", "speed.eq9.t20", "speed.eq9.t30", "speed.eq9.t11", "speed.eq9.t21",
                         "speed.eq9.t31", "speed.eq9.t32", "speed.ring.c2", "speed.ring.two-patches",
                         "speed.ring.signs", "speed.ring.injective", "speed.ring.free", "speed.contraction"})
    EXPECT_EQ(test::find_claim(claims, id).verdict, Verdict::reproduced) << id;
  for (const char* id : {"speed.eq9.t22", "speed.eq9.c2", "speed.eq12"})
    EXPECT_EQ(test::find_claim(claims, id).verdict, Verdict::refuted) << id;
  for (const char* id : {"speed.eq12.corrected", "speed.eq12.digits", "speed.eq12.loss", "speed.ring.theorem",
                         "figure.speed.7", "figure.speed.8"})
    EXPECT_EQ(test::find_claim(claims, id).verdict, Verdict::established) << id;
}

TEST(SpeedCharacteristicRingClaims, TheSentenceOnSamplesIsQuoted) {
  const ClaimHead& signs = head(speed_characteristic_ring_heads(), "speed.ring.signs");
  EXPECT_TRUE(signs.printed->starts_with("Regularity and injectivity of characteristic ring"));
}

TEST(SpeedCharacteristicRingClaims, LossesNameTheirSpeeds) {
  const ClaimHead& loss = head(speed_characteristic_ring_heads(), "speed.eq12.loss");
  for (const char* speed : {"1/1000,", "1/2,", "99999/100000"})
    EXPECT_NE(loss.definition.find(speed), std::string::npos) << speed;
}

TEST(Contraction, IsTheSlopeOfLambda) {
  for (const int n : {3, 4, 5, 8, 100}) {
    double before = 1;
    for (int k = 1; k < 200; ++k) {
      const double sigma = k / 200.0;
      const double lambda = ring_shape(sigma, n).eigenvalue();
      EXPECT_LT(lambda, before);
      before = lambda;
      constexpr double h = 1e-6;
      const double slope =
          (ring_shape(sigma + h, n).eigenvalue() - ring_shape(sigma - h, n).eigenvalue()) / (2 * h);
      EXPECT_NEAR(contraction_rate(ring_shape(sigma, n)), slope, 1e-7) << n << ' ' << sigma;
    }
    EXPECT_NEAR(ring_shape(1e-12, n).eigenvalue(), 1, 1e-5);
    EXPECT_NEAR(ring_shape(1 - 1e-12, n).eigenvalue(), 0, 1e-11);
  }
}

TEST(Contraction, HasItsSignOnShapesAlone) {
  // Far beyond v = 2, where no valence is, lambda grows with sigma.
  EXPECT_GT(contraction_rate(RingShape<double>{0.01, 4}), 0);
  PlaneDomain wider = ring_shapes();
  wider.box.lower = {Rational(-3), Rational(-2)};
  wider.positive = {ring_coordinates().sigma.numerator()};
  EXPECT_EQ(DomainSigns(wider).sign(contraction_rate(ring_coordinates())).kind, DomainSign::Kind::not_strict);
}

TEST(SpeedArrays, AreThePapers) {
  // Their shape, and two rows as printed; all entries are tied by (12) itself.
  ASSERT_EQ(printed_denominator().size(), 15U);
  std::size_t entries = 0;
  const auto count = [&](const PrintedArray& rows) {
    ASSERT_EQ(rows.size(), 15U);
    for (const auto& row : rows) entries += row[0].size() + row[1].size();
  };
  count(printed_denominator());
  for (const PrintedArray& rows : printed_numerators()) count(rows);
  EXPECT_EQ(entries, 612U);
  EXPECT_EQ(printed_denominator()[7][1], (std::vector<int>{6981, 3895, -4957, -854, -18}));
  EXPECT_EQ(printed_numerators()[4][5][0], (std::vector<int>{-80505, -1850, -326, 9}));
}

/// h_0 .. h_4 of the eigenvector computed in double.
std::array<double, 5> own_scalars(double sigma, int n) {
  const CharacteristicRing<double> ring = characteristic_ring(ring_shape(sigma, n));
  const double unit = 1 / ring.border[0][0];
  const double sine = std::sin(std::numbers::pi / n);
  const double across = unit * (ring.border[8][0] - ring.border[8][1]);
  return {2 * unit * ring.border[12][0], across, 2 * unit * ring.border[4][0] - 4 * across * sine * sine,
          2 * unit * ring.border[13][0], unit * ring.border[5][0] / 2};
}

double largest_difference(const std::array<double, 5>& a, const std::array<double, 5>& b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

TEST(SpeedArrays, TheFactorOfTheRowsIsThatOfTheSpeed) {
  for (const int n : {3, 6, 11}) {
    for (const double sigma : {0.2, 0.6}) {
      const double c = std::cos(2 * std::numbers::pi / n);
      const double lambda = ring_shape(sigma, n).eigenvalue();
      EXPECT_LT(largest_difference(array_quotients(sigma, c, lambda), own_scalars(sigma, n)), 1e-10);
      EXPECT_GT(largest_difference(array_quotients(1.0, c, lambda), own_scalars(sigma, n)), 1e-3);
      EXPECT_GT(largest_difference(array_quotients(1 - sigma, c, lambda), own_scalars(sigma, n)), 1e-3);
    }
  }
}

TEST(SpeedArrays, EveryEntryMatters) {
  // One entry changed by 1 changes the exact sum, and with it the quotient.
  const Function s = Function::variable(0);
  const Function c = Function::variable(1);
  const Function lambda = Function::variable(2);
  const Function sum = array_sum(printed_denominator(), s, c, lambda);
  for (std::size_t i = 0; i < 15; ++i) {
    for (std::size_t part = 0; part < 2; ++part) {
      for (std::size_t j = 0; j < printed_denominator()[i][part].size(); ++j) {
        PrintedArray changed = printed_denominator();
        changed[i][part][j] += 1;
        EXPECT_FALSE(array_sum(changed, s, c, lambda) == sum) << i << ' ' << part << ' ' << j;
      }
    }
  }
}

TEST(PrintedBorder, IsTheRingsButForTheFactorOfT22) {
  for (const int n : {3, 4, 5, 12}) {
    const double angle = std::numbers::pi / n;
    const CharacteristicRing<double> ring = characteristic_ring(ring_shape(0.7, n));
    const double d = 1 + std::cos(2 * angle);
    const auto right = border_formulas(own_scalars(0.7, n), d, 1.0);
    const auto printed = border_formulas(own_scalars(0.7, n), d, std::tan(angle));
    for (std::size_t k = 0; k < border_places.size(); ++k) {
      const RingPoint<double>& own = ring.border[4 * border_places.at(k).i + border_places.at(k).j];
      for (std::size_t x = 0; x < 2; ++x) {
        EXPECT_NEAR(right.at(k)[x], own[x] / ring.border[0][0], 1e-12) << n << ' ' << k;
        const bool misprint = k == 6 && x == 0 && n != 4;
        EXPECT_EQ(std::abs(printed.at(k)[x] - right.at(k)[x]) > 1e-3, misprint) << n << ' ' << k;
      }
    }
  }
}

}  // namespace
}  // namespace subdiv
