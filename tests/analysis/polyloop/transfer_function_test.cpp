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
