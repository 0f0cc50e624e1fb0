#include "schemes/polyloop/apply_operator.h"

#include <random>

#include <gtest/gtest.h>

#include "schemes/evaluate/level_by_level.h"
#include "schemes/polyloop/operator_sequence.h"

namespace subdiv {
namespace {

using Chain = VertexChain<Rational>;
using Operator = PolyloopOperator<Rational>;

Rational q(long a, long b = 1) { return {a, b}; }

Chain chain(int n, bool closed, unsigned seed = 1) {
  std::mt19937 random(seed);
  Chain result{{}, closed, 0};
  for (int i = 0; i < n; ++i) result.vertices.push_back(q(static_cast<long>(random() % 199) - 99, 7));
  return result;
}

std::vector<Operator> steps(const std::string& text) {
  const OperatorSequence sequence = parse_operators(text);
  const std::vector<Operator> operators = operators_of<Rational>(sequence);
  std::vector<Operator> result;
  for (const std::size_t i : sequence.order) result.push_back(operators[i]);
  return result;
}

Chain step_by_step(const std::string& text, Chain c, OpenRule rule = OpenRule::drop) {
  for (const Operator& op : steps(text)) c = apply(op, c, rule);
  return c;
}

const std::vector<std::string> texts{"refine",
                                     "dual",
                                     "dual^2",
                                     "tuck(1/3)",
                                     "refine; tuck(1/2); tuck(-1)",
                                     "refine; tweak(1/2, 1/8); tuck(2)",
                                     "refine; tuck(1); tweak(1/2, 0)",
                                     "J(4); dual; J(-4)",
                                     "refine; tweak(1,1); tweak(2,1/3); refine; dual"};

TEST(ApplyOperator, ComposedIsStepByStepOnClosedPolyloops) {
  for (const std::string& text : texts) {
    for (const int n : {1, 2, 3, 5, 8}) {  // shorter than rules, too
      const Chain c = chain(n, true);
      EXPECT_EQ(apply(sequence(steps(text)), c).vertices, step_by_step(text, c).vertices) << text << " " << n;
    }
  }
}

TEST(ApplyOperator, StepByStepIsAPartOfComposedOnOpenPolygons) {
  for (const std::string& text : texts) {
    const Chain c = chain(12, false);
    const Chain all = apply(sequence(steps(text)), c);
    const Chain part = step_by_step(text, c);
    ASSERT_GT(part.size(), 0) << text;
    ASSERT_GE(part.first, all.first);
    for (int i = 0; i < part.size(); ++i) {
      EXPECT_EQ(part.vertices[static_cast<std::size_t>(i)],
                all.vertices.at(static_cast<std::size_t>(part.first - all.first + i)))
          << text << " " << i;
    }
  }
}

TEST(ApplyOperator, MasksRefineLevelByLevel) {
  for (const std::string text : {"refine; tuck(1/2); untuck", "refine; dual", "refine; dual^2", "J(2)"}) {
    const Chain c = chain(6, true);
    const Mask<Rational> mask = mask_of(sequence(steps(text))).value();
    const auto refined = refine_level_by_level(stationary("", mask), closed_polygon(c.vertices), 2);
    EXPECT_EQ(step_by_step("{" + text + "}^2", c).vertices, refined.points) << text;
  }
}

TEST(ApplyOperator, NumbersOfVerticesOfOpenPolygons) {
  const Chain c{{q(0), q(4), q(2), q(6)}, false, 0};
  EXPECT_EQ(apply(polyloop::refine<Rational>(), c).vertices,
            (std::vector<Rational>{q(0), q(2), q(4), q(3), q(2), q(4), q(6)}));
  EXPECT_EQ(apply(polyloop::dual<Rational>(), c).vertices, (std::vector<Rational>{q(2), q(3), q(4)}));
  const Chain inner = apply(polyloop::tuck(q(1)), c);
  EXPECT_EQ(inner.vertices, (std::vector<Rational>{q(1), q(5)}));
  EXPECT_EQ(inner.first, 1);
  EXPECT_EQ(apply(polyloop::tuck(q(1)), c, OpenRule::keep).vertices,
            (std::vector<Rational>{q(0), q(1), q(5), q(6)}));
  for (const OpenRule rule : {OpenRule::drop, OpenRule::keep}) {
    EXPECT_EQ(apply(polyloop::refine<Rational>(), c, rule).size(), 7);
    EXPECT_EQ(apply(polyloop::dual<Rational>(), c, rule).size(), 3);
    EXPECT_EQ(apply(polyloop::refine<Rational>(), Chain{{q(5)}, false, 0}, rule).size(), 1);
    EXPECT_EQ(apply(polyloop::dual<Rational>(), Chain{{q(5)}, false, 0}, rule).size(), 0);
  }
}

TEST(ApplyOperator, KeptEndsOfTheFourPointScheme) {
  const Chain c{{q(0), q(4), q(2), q(6)}, false, 0};
  const Chain kept = step_by_step("refine; tuck(1/2); untuck", c, OpenRule::keep);
  EXPECT_EQ(kept.size(), 7);
  EXPECT_EQ(kept.vertices.front(), q(0));
  EXPECT_EQ(kept.vertices.back(), q(6));
  EXPECT_EQ(kept.vertices[3], q(-1, 16) * (q(0) + q(6)) + q(9, 16) * (q(4) + q(2)));
}

TEST(ApplyOperator, DoublesAreNearRationals) {
  const Chain c = chain(9, true);
  VertexChain<double> rounded{{}, true, 0};
  for (const Rational& x : c.vertices) rounded.vertices.push_back(x.to_double());
  const auto op = operators_in_double(parse_operators("tuck(2/3)"))[0];
  const Chain exact = apply(polyloop::tuck(q(2, 3)), c);
  const auto approximate = apply(op, rounded);
  for (std::size_t i = 0; i < 9; ++i)
    EXPECT_NEAR(approximate.vertices[i], exact.vertices[i].to_double(), 1e-14 * 15);
}

TEST(ApplyOperator, ClosedPolyloopsHaveWholePeriods) {
  EXPECT_THROW((void)apply(polyloop::tweak(q(1), q(0)), chain(5, true)), InputError);
  EXPECT_EQ(apply(polyloop::tweak(q(1), q(0)), chain(6, true)).size(), 6);
  EXPECT_EQ(apply(polyloop::refine<Rational>(), Chain{}).size(), 0);
}

TEST(ApplyOperator, AShiftReachesAsFarAsItGoes) {
  const Chain c{{q(1), q(2), q(3)}, false, 2};
  for (const int places : {-5, -1, 0, 1, 5}) {  // vertex k is P_{k + places}
    const Operator op{1, {Laurent<Rational>::monomial(places, q(1))}, false};
    const Chain moved = apply(op, c);
    EXPECT_EQ(moved.vertices, c.vertices) << places;
    EXPECT_EQ(moved.first, 2 - places);
  }
}

TEST(ApplyOperator, KeptVerticesKeepTheirNumbers) {
  const Chain c{{q(0), q(4), q(2), q(6)}, false, 3};
  EXPECT_EQ(apply(polyloop::tuck(q(1)), c, OpenRule::keep).first, 3);
  EXPECT_EQ(apply(polyloop::tuck(q(1)), c, OpenRule::drop).first, 4);
  // Composed with refine it makes new vertices, which are not kept.
  const Operator refined = sequence<Rational>({polyloop::refine<Rational>(), polyloop::tuck(q(1, 2))});
  EXPECT_EQ(apply(refined, c, OpenRule::keep).vertices, apply(refined, c, OpenRule::drop).vertices);
}

}  // namespace
}  // namespace subdiv
