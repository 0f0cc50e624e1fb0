#include "analysis/polyloop/transfer_function.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "schemes/polyloop/apply_operator.h"
#include "schemes/polyloop/operator_sequence.h"

namespace subdiv {
namespace {

Laurent<Rational> weights(const std::string& text) {
  return weights_of(composed_operator<Rational>(parse_operators(text))).value();
}

Laurent<Polynomial> family(const std::string& text) {
  const OperatorSequence sequence = parse_operators(text);
  std::vector<Polynomial> values;
  for (std::size_t i = 0; i < sequence.free_parameters.size(); ++i)
    values.push_back(Polynomial::variable(static_cast<int>(i)));
  return weights_of(composed_operator<Polynomial>(sequence, values)).value();
}

TEST(TransferFunction, TuckAndDual) {
  const Polynomial c = Polynomial::variable(1);
  EXPECT_EQ(transfer_at_cosine(family("tuck(t)"), c),
            Polynomial(1) - Polynomial::variable(0) * (Polynomial(1) - c));
  EXPECT_EQ(power_at_cosine(weights("dual"), Rational(1, 5)), Rational(3, 5));
  EXPECT_THROW((void)transfer_at_cosine(weights("dual"), Rational(0)), std::domain_error);
  EXPECT_FALSE(weights_of(polyloop::refine<Rational>()));
  EXPECT_FALSE(weights_of(polyloop::tweak(Rational(1), Rational(0))));
}

TEST(TransferFunction, IsWhatAWaveIsMultipliedBy) {
  constexpr int n = 12;
  const PolyloopOperator<Rational> op = composed_operator<Rational>(parse_operators("tuck(2/3); tuck(-1/4)"));
  for (int k = 0; k <= n / 2; ++k) {
    VertexChain<double> wave{{}, true, 0};
    for (int j = 0; j < n; ++j) wave.vertices.push_back(std::cos(2 * std::numbers::pi * k * j / n));
    PolyloopOperator<double> rounded{op.period, {}, op.moves_vertices};
    rounded.rows.push_back(map_coefficients(op.rows[0], [](const Rational& q) { return q.to_double(); }));
    const auto after = apply(rounded, wave);
    const double gain = transfer_at_cosine(rounded.rows[0], std::cos(2 * std::numbers::pi * k / n));
    for (std::size_t j = 0; j < n; ++j) EXPECT_NEAR(after.vertices[j], gain * wave.vertices[j], 1e-14);
  }
}

TEST(TransferFunction, LargestGains) {
  const LargestGain pull = largest_gain(weights("tuck(2/3)"));
  EXPECT_EQ(pull.gain.exact, "1");
  EXPECT_EQ(pull.cosine, Algebraic(1));
  const LargestGain push = largest_gain(weights("untuck"));
  EXPECT_EQ(push.gain.exact, "3");  // 1 + (1 - c) at c = -1
  EXPECT_EQ(push.cosine, Algebraic(-1));
  // (1 - x/2)(1 + 53 x/100), x = 1 - c, has its greatest value at 3/100 - 53 x/100 = 0.
  const LargestGain both = largest_gain(weights("tuck(1/2); tuck(-0.53)"));
  EXPECT_EQ(both.cosine, Algebraic(Rational(50, 53)));
  const Rational x(3, 53);
  const Rational value = (Rational(1) - x / Rational(2)) * (Rational(1) + Rational(53, 100) * x);
  EXPECT_EQ(both.gain.exact, value.to_string());
  // A sequence in parts is the same, and its powers have the power.
  const LargestGain often = largest_gain({{weights("tuck(1/2)"), 20}, {weights("tuck(-0.53)"), 20}});
  EXPECT_EQ(often.cosine, both.cosine);
  EXPECT_EQ(often.gain.exact, pow(value, 20).to_string());
  EXPECT_EQ(amplifies(often.gain), Decision::yes);
  EXPECT_EQ(amplifies(pull.gain), Decision::no);
  // The gain of dual is cos(omega/2): with untuck (1 + c)/2 (2 - c)^2 squared, greatest at c = 0.
  EXPECT_EQ(largest_gain({{weights("dual"), 1}, {weights("untuck"), 1}}).gain.exact, "sqrt(2)");
}

TEST(TransferFunction, LongSequencesAreEnclosed) {
  const LargestGain often = largest_gain({{weights("tuck(1/2)"), 3000}, {weights("tuck(-0.53)"), 3000}});
  EXPECT_EQ(often.gain.rigour, Rigour::certified);
  const double x = 3 / 53.0;  // 1 - cos omega
  EXPECT_NEAR(often.gain.midpoint().to_double() / std::pow((1 - x / 2) * (1 + 0.53 * x), 3000), 1, 1e-10);
}

/// Parts of unequal powers: (1 - x/2)(1 + 53 x/100)^2 has its greatest value at x = 28/53.
TEST(TransferFunction, PartsCountAsOftenAsTheyAreApplied) {
  const LargestGain uneven = largest_gain({{weights("tuck(1/2)"), 1}, {weights("tuck(-0.53)"), 2}});
  const Rational t(53, 100);
  const Rational x = (Rational(2) * t - Rational(1, 2)) / (Rational(3, 2) * t);  // of the derivative
  EXPECT_EQ(uneven.cosine, Algebraic(Rational(1) - x));
  const Rational value = (Rational(1) - x / Rational(2)) * pow(Rational(1) + t * x, 2);
  EXPECT_EQ(uneven.gain.exact, value.to_string());
}

/// Of two places with the same gain the lower frequency is named.
TEST(TransferFunction, TiesGoToTheLowerFrequency) {
  EXPECT_EQ(largest_gain(weights("tuck(1)")).cosine, Algebraic(1));  // |c| at 1 and -1
  const Laurent<Rational> two(-2, {Rational(-1), Rational(0), Rational(4), Rational(0), Rational(-1)});
  const LargestGain tie = largest_gain(two);  // 4 - 2 cos 2 omega: 6 at omega = pi/2
  EXPECT_EQ(tie.gain.exact, "6");
  EXPECT_EQ(tie.cosine, Algebraic(0));
  // cos 3 omega is 1 or -1 at omega = 0, pi/3, 2 pi/3, pi.
  const Laurent<Rational> three(
      -3, {Rational(1, 2), Rational(0), Rational(0), Rational(0), Rational(0), Rational(0), Rational(1, 2)});
  EXPECT_EQ(largest_gain(three).cosine, Algebraic(1));
  const LargestGain shifted = largest_gain(three - Laurent<Rational>(1));  // cos 3 omega - 1: -2 at pi/3, pi
  EXPECT_EQ(shifted.gain.exact, "2");
  EXPECT_EQ(shifted.cosine, Algebraic(Rational(1, 2)));
  // cos 4 omega - 1 is -2 at pi/4 and 3 pi/4, where cosines are irrational.
  const Laurent<Rational> four = Laurent<Rational>::monomial(4, Rational(1, 2));
  const LargestGain irrational = largest_gain(four + reverse(four) - Laurent<Rational>(1));
  EXPECT_EQ(irrational.gain.exact, "2");
  EXPECT_EQ(irrational.cosine, sqrt(Algebraic(Rational(1, 2))));
}

/// (1 + x/10^400)^300, x = 1 - c in [0, 2], is greatest at c = -1, by less than 1024 bits show.
TEST(TransferFunction, NoPlaceWhereComparisonsStayOpen) {
  const Laurent<Rational> slight = polyloop::tuck(Rational(-1) / pow(Rational(10), 400)).rows.front();
  const LargestGain gain = largest_gain({{slight, 300}});
  EXPECT_FALSE(gain.cosine);
  EXPECT_EQ(gain.gain.rigour, Rigour::certified);
  const Rational truth = pow(Rational(1) + Rational(2) / pow(Rational(10), 400), 300);
  EXPECT_TRUE(gain.gain.lower <= truth && truth <= gain.gain.upper);
  EXPECT_EQ(amplifies(gain.gain), Decision::undecided);
  EXPECT_EQ(largest_gain({{slight, 100}}).cosine, Algebraic(-1)) << "few factors are compared exactly";
}

/// Transfer functions that reach 1 or -1 between the ends, at an end alone, or where two zeros meet.
TEST(TransferFunction, RangesThatChangeWhereZerosMeetOrReachTheEnds) {
  const Rational half(1, 2);
  const Polynomial t = Polynomial::variable(0);
  const auto scaled = [&](const Polynomial& f, const std::vector<Rational>& numbers, int first) {
    std::vector<Polynomial> values;
    for (const Rational& q : numbers) values.push_back(f * Polynomial(q));
    return Laurent<Polynomial>(first, values);
  };
  // t cos 2 omega: 1 - w^2 touches 0 from above at omega = pi/2 for t = +-1, a double zero.
  const auto twice = scaled(t, {half, Rational(0), Rational(0), Rational(0), half}, -2);
  EXPECT_EQ(stable_range(twice).to_string(), "[-1, 1]");
  // t (1 + cos omega)/2 reaches 1 at omega = 0 alone.
  const auto mean = scaled(t, {Rational(1, 4), half, Rational(1, 4)}, -1);
  EXPECT_EQ(stable_range(mean).to_string(), "[-1, 1]");
  // 1 - t sin^2 omega = 1 - t/2 + t/2 cos 2 omega is -1 for t = 2 at omega = pi/2, inside.
  const auto sine = scaled(t, {Rational(1, 4), Rational(0), -half, Rational(0), Rational(1, 4)}, -2) +
                    Laurent<Polynomial>(1);
  EXPECT_EQ(stable_range(sine).to_string(), "[0, 2]");
  // 1 - w = cos^2 omega - t^2 is not negative where its two zeros meet alone.
  const Rational quarter(1, 4);
  const Laurent<Polynomial> meeting(-2, {Polynomial(-quarter), Polynomial(0), Polynomial(half) + t * t,
                                         Polynomial(0), Polynomial(-quarter)});
  const RealSet at_meeting = stable_range(meeting);
  ASSERT_EQ(at_meeting.parts.size(), 1U) << at_meeting.to_string();
  EXPECT_EQ(at_meeting.parts[0].lower, Algebraic(0));
  EXPECT_EQ(at_meeting.parts[0].upper, Algebraic(0));
}

TEST(TransferFunction, IntervalsEncloseTheExactGain) {
  for (const std::string text :
       {"tuck(1/2); tuck(-0.53)", "untuck", "tuck(1/3)", "tuck(2/3); tuck(-1); dual"}) {
    const auto as_interval = [](const Rational& q) { return Interval(q); };
    const Laurent<Rational> w = weights(text);
    const Enclosure bounds =
        largest_gain(std::vector<IntervalFilterPart>{{map_coefficients(w, as_interval), 1}});
    EXPECT_EQ(bounds.status, Status::closed) << text;
    const LargestGain exact = largest_gain(w);
    EXPECT_TRUE(bounds.lower <= exact.gain.upper && exact.gain.lower <= bounds.upper) << text;
    EXPECT_LE(bounds.width().to_double(), 2e-6) << text;
  }
}

TEST(TransferFunction, StableRanges) {
  EXPECT_EQ(stable_range(family("tuck(t)")).to_string(), "[0, 1]");
  EXPECT_EQ(damping_range(family("tuck(t)")).to_string(), "(0, 1)");
  const RealSet both = stable_range(family("tuck(t); tuck(-t)"));  // 1 - t^2 x^2 >= -1 for x = 2
  ASSERT_EQ(both.parts.size(), 1U);
  EXPECT_EQ(*both.parts[0].upper, sqrt(Algebraic(Rational(1, 2))));
  EXPECT_EQ(*both.parts[0].lower, -sqrt(Algebraic(Rational(1, 2))));
  EXPECT_TRUE(both.parts[0].lower_closed && both.parts[0].upper_closed);
  EXPECT_EQ(damping_range(family("tuck(t); tuck(-t)")).parts.size(), 2U) << "t = 0 damps nothing";
  EXPECT_EQ(stable_range(family("tuck(1)")).to_string(), "(-inf, inf)");
  EXPECT_EQ(stable_range(family("untuck")).to_string(), "empty");
  EXPECT_EQ(stable_range(family("dual; tuck(t - t)")).to_string(), "(-inf, inf)");
}

TEST(TransferFunction, StableRangesAgreeWithGainsAtNumbers) {
  for (const std::string text : {"tuck(t)", "tuck(t); tuck(-t)", "tuck(1/2); tuck(-t)"}) {
    const RealSet stable = stable_range(family(text));
    for (int i = -12; i <= 12; ++i) {
      const Rational t(i, 8);
      const Laurent<Rational> at = map_coefficients(
          family(text), [&](const Polynomial& p) { return p.evaluate(std::span<const Rational>(&t, 1)); });
      EXPECT_EQ(stable.contains(Algebraic(t)), amplifies(largest_gain(at).gain) == Decision::no)
          << text << " at " << t.to_string() << ": " << stable.to_string();
    }
  }
}

TEST(TransferFunction, PushAndPullFixesCubics) {
  const auto [multiplicity, rest] = fixed_factor(family("tuck(t); tuck(-t)"));
  EXPECT_EQ(multiplicity, 4);
  EXPECT_EQ(rest.size(), 1);
  const auto once = fixed_factor(family("tuck(t)"));
  EXPECT_EQ(once.first, 2);
  // Applied to j^3 and j^4: the first stays, the second does not.
  const PolyloopOperator<Rational> op = composed_operator<Rational>(parse_operators("tuck(2/5); tuck(-2/5)"));
  for (const int degree : {3, 4}) {
    VertexChain<Rational> data{{}, false, 0};
    for (int j = 0; j < 9; ++j) data.vertices.push_back(pow(Rational(j), degree));
    const auto after = apply(op, data);
    const bool same =
        after.vertices == std::vector<Rational>(data.vertices.begin() + 2, data.vertices.end() - 2);
    EXPECT_EQ(same, degree == 3);
  }
}

}  // namespace
}  // namespace subdiv
