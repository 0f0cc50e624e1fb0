#include "schemes/evaluate/speed_schedule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "schemes/evaluate/nested_rings.h"
#include "schemes/input_error.h"
#include "tests/schemes/evaluate/random_nets.h"

namespace subdiv {
namespace {

SpeedSchedule schedule(const std::vector<Rational>& speeds) {
  return SpeedSchedule(std::vector<Algebraic>(speeds.begin(), speeds.end()));
}

/// A double and a bound of its error, operation by operation: u = 2^-53 of every result, and half the least
/// positive double for products. Of points only the greatest size is known.
struct Tracked {
  static constexpr double u = 0x1p-53;
  double value = 0;
  double error = 0;
  double tiny = 0;

  Tracked() = default;
  Tracked(double x) : value(x) {}
  Tracked(double x, double e, double t) : value(x), error(e), tiny(t) {}

  friend Tracked operator*(const Tracked& a, const Tracked& b) {
    const double size = std::abs(a.value * b.value);
    return {size, std::abs(a.value) * b.error + a.error * std::abs(b.value) + u * size,
            std::abs(a.value) * b.tiny + 0.5};
  }
  Tracked& operator+=(const Tracked& b) {
    const bool exact = value == 0 && error == 0;
    value += std::abs(b.value);
    error += b.error + (exact ? 0 : u * value);
    tiny += b.tiny;
    return *this;
  }
  /// Of weights.
  friend Tracked operator-(const Tracked& a, const Tracked& b) {
    const double x = a.value - b.value;
    return {x, a.error + b.error + u * std::abs(x), 0};
  }
  friend Tracked operator/(const Tracked& a, const Tracked& b) {
    const double x = a.value / b.value;
    return {x, a.error / b.value + u * std::abs(x), 0};
  }
};

Tracked rounded_once(double weight) { return {weight, Tracked::u * std::abs(weight), 0}; }
SectorStencil<Tracked> tracked(const SectorStencil<double>& stencil) {
  SectorStencil<Tracked> result{rounded_once(stencil.centre), {}};
  for (const auto& term : stencil.terms)
    result.terms.push_back({term.sector, term.place, rounded_once(term.weight)});
  return result;
}
SpeedStep<Tracked> tracked(const SpeedStep<double>& step) {
  SpeedStep<Tracked> result{{}, {rounded_once(step.rules.sigma), {}, {}}};
  for (const auto& stencil : step.change) result.change.push_back(tracked(stencil));
  for (const auto& stencil : step.rules.refined) result.rules.refined.push_back(tracked(stencil));
  for (std::size_t k = 0; k < 16; ++k) {
    if (step.rules.border[k]) result.rules.border[k] = tracked(*step.rules.border[k]);
  }
  return result;
}

template <class P, class Visit>
void for_each_coefficient(const NestedRings<P>& rings, const Visit& visit) {
  for (const auto& ring : rings.rings) {
    for (const RingSector<P>& sector : ring) {
      for (const auto* patch : {&sector.corner, &sector.next_side, &sector.first_side})
        std::for_each(patch->begin(), patch->end(), visit);
    }
  }
  for (const BezierPatch<P>& patch : rings.hole) std::for_each(patch.begin(), patch.end(), visit);
}

const std::vector<std::vector<Rational>>& speeds_of_tests() {
  static const std::vector<std::vector<Rational>> all{
      {Rational(1, 2)},
      {Rational(1, 1000)},
      {Rational(1, 3), Rational(1, 3)},
      {Rational(9, 10), Rational(1, 7)},
      std::vector<Rational>(20, Rational(2, 3)),
      {Rational(3, 4), Rational(1, 5), Rational(3, 4), Rational(1, 5), Rational(3, 4), Rational(1, 5)},
      {Rational(999, 1000)}};
  return all;
}

// By a second route: the same code run over numbers that follow their own errors.
TEST(SpeedSchedule, RoundingIsThatOfEveryOperation) {
  for (const std::vector<Rational>& speeds : speeds_of_tests()) {
    for (const int n : {3, 5, 12}) {
      const SpeedSchedule rounded = schedule(speeds);
      std::vector<SpeedStep<Tracked>> steps;
      for (const SpeedStep<double>& step : rounded.steps()) steps.push_back(tracked(step));
      const auto weights = rounded.weights(n);
      const SectorNet<Tracked> net(n, std::vector<Tracked>(1 + 6 * static_cast<std::size_t>(n), 1.0));
      const auto rings = nested_rings<Tracked, Tracked>(net, steps, [&](std::size_t k) {
        return VertexWeights<Tracked>{rounded_once(weights[k].beta), rounded_once(weights[k].gamma)};
      });
      Tracked worst;
      for_each_coefficient(rings, [&](const Tracked& x) {
        worst.error = std::max(worst.error, x.error);
        worst.tiny = std::max(worst.tiny, x.tiny);
      });
      const RoundingBound bound = rounded.rounding(n);
      EXPECT_GE(bound.relative, worst.error) << speeds[0].to_string() << ' ' << speeds.size() << ' ' << n;
      EXPECT_LE(bound.relative, 4 * worst.error) << speeds[0].to_string() << ' ' << speeds.size() << ' ' << n;
      EXPECT_GE(bound.tiny, worst.tiny) << speeds[0].to_string() << ' ' << speeds.size() << ' ' << n;
      EXPECT_LE(bound.tiny, 8 * worst.tiny) << speeds[0].to_string() << ' ' << speeds.size() << ' ' << n;
    }
  }
}

// Down to the least positive double, where products underflow.
TEST(SpeedSchedule, RoundingIsBoundedAtAnyScale) {
  for (const int exponent : {0, -1000, -1060, -1068}) {
    for (const std::vector<Rational>& speeds : speeds_of_tests()) {
      constexpr int n = 5;
      const SectorNet<Rational> small = sample::random_net<Rational>(n, 4U);
      std::vector<double> points;
      std::vector<Rational> exact_points;
      double greatest = 0;
      for (const Rational& x : small.points()) {
        points.push_back(std::ldexp(x.to_double(), exponent));
        exact_points.push_back(Rational::from_double(points.back()));
        greatest = std::max(greatest, std::abs(points.back()));
      }
      const auto steps = speed_steps<Rational>(speeds);
      const auto exact =
          nested_rings<Rational, Rational>(SectorNet<Rational>(n, exact_points), steps,
                                           [&](std::size_t k) { return vertex_weights(speeds[k], n); });
      const SpeedSchedule rounded = schedule(speeds);
      const auto weights = rounded.weights(n);
      const auto rings = nested_rings<double, double>(SectorNet<double>(n, points), rounded.steps(),
                                                      [&](std::size_t k) { return weights[k]; });
      const Rational bound = Rational::from_double(rounded.rounding(n).of(greatest));
      std::vector<Rational> wanted;
      for_each_coefficient(exact, [&](const Rational& x) { wanted.push_back(x); });
      std::size_t place = 0;
      Rational worst(0);
      for_each_coefficient(
          rings, [&](double x) { worst = std::max(worst, abs(Rational::from_double(x) - wanted[place++])); });
      EXPECT_LE(worst, bound) << exponent << ' ' << speeds[0].to_string() << ' ' << speeds.size();
    }
  }
}

TEST(SpeedSchedule, BoundsAreRoundedUp) {
  const double least = std::numeric_limits<double>::denorm_min();
  EXPECT_GT((RoundingBound{1e-15, 0}.of(1e-320)), 0);
  EXPECT_GE((RoundingBound{0, 2.4}.of(1)), 3 * least);
  EXPECT_GT((RoundingBound{0.1, 0}.of(3)), 0.3);
}

// Weights near 0 and 1 come from differences that cancel; each is the double nearest to the exact one.
TEST(SpeedSchedule, WeightsAreRoundedOnce) {
  const Rational tiny = Rational::power_of_two(-60);
  const std::vector<Rational> speeds{tiny / Rational(3), Rational(1) - tiny / Rational(3), Rational(2, 7)};
  const SpeedSchedule rounded = schedule(speeds);
  const auto exact = speed_steps<Rational>(speeds);
  const auto expect_rounded = [](double weight, const Rational& wanted) {
    EXPECT_LE(abs(Rational::from_double(weight) - wanted), Rational::power_of_two(-53) * abs(wanted));
  };
  const auto expect_all = [&](const SectorStencil<double>& stencil, const SectorStencil<Rational>& wanted) {
    expect_rounded(stencil.centre, wanted.centre);
    // Weights that vanish for all speeds are left out of both; enclosures may keep others that are 0.
    for (const auto& term : stencil.terms) {
      Rational weight(0);
      for (const auto& other : wanted.terms) {
        if (other.sector == term.sector && other.place == term.place) weight = other.weight;
      }
      expect_rounded(term.weight, weight);
    }
  };
  for (std::size_t k = 0; k < speeds.size(); ++k) {
    const SpeedStep<double>& step = rounded.steps()[k];
    for (std::size_t p = 0; p < 6; ++p) {
      expect_all(step.change[p], exact[k].change[p]);
      expect_all(step.rules.refined[p], exact[k].rules.refined[p]);
    }
    for (std::size_t b = 0; b < 15; ++b) expect_all(*step.rules.border[b], *exact[k].rules.border[b]);
    const VertexWeights<Rational> wanted = vertex_weights(speeds[k], 7);
    expect_rounded(rounded.weights(7)[k].beta, wanted.beta);
    expect_rounded(rounded.weights(7)[k].gamma, wanted.gamma);
  }
}

TEST(SpeedSchedule, LeastWidthIsThatOfARingOrOfTheHole) {
  EXPECT_EQ(schedule({}).least_width(), 1);
  EXPECT_EQ(schedule({Rational(1, 4)}).least_width(), 0.25);                       // the ring
  EXPECT_EQ(schedule({Rational(3, 4)}).least_width(), 0.25);                       // the hole
  EXPECT_EQ(schedule({Rational(1, 2), Rational(1, 4)}).least_width(), 1.0 / 8);    // 1/2 1/4, the second ring
  EXPECT_EQ(schedule({Rational(1, 2), Rational(3, 4)}).least_width(), 1.0 / 8);    // 1/2 1/4, the hole
  EXPECT_EQ(schedule({Rational(1, 16), Rational(1, 2)}).least_width(), 1.0 / 16);  // the first ring
}

TEST(SpeedSchedule, RefusesSpeedsInFewWords) {
  const auto message = [](const Rational& speed) -> std::string {
    try {
      static_cast<void>(schedule({speed}));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(message(Rational(0)).find("between 0 and 1"), std::string::npos);
  EXPECT_NE(message(Rational(3, 2)).find("speed 3/2"), std::string::npos);
  const std::string near_zero = message(pow(Rational(10), -400));
  EXPECT_NE(near_zero.find("1.00000e-400"), std::string::npos) << near_zero;
  EXPECT_LT(near_zero.size(), 150U);
  EXPECT_LT(message(Rational(1) - pow(Rational(10), -400)).size(), 150U);
}

}  // namespace
}  // namespace subdiv
