#include "schemes/adjustable_speed/speed_rules.h"

#include <gtest/gtest.h>

#include <map>
#include <utility>

#include "schemes/algebra/rational_function.h"

namespace subdiv {
namespace {

using F = RationalFunction;

const F s = F::variable(0);
const F q = F(1) - s;
const F e1 = s * s + q;
const F e2 = s * s + F(3) * q;

void expect_row(const LineWeights<F>& row, const LineWeights<F>& expected) {
  for (std::size_t i = 0; i < row.size(); ++i)
    EXPECT_TRUE(row[i] == expected[i]) << i << " " << row[i].to_string();
}

F half(const F& x) { return x * fraction<F>(1, 2); }

// Karciauskas & Peters, (4) and what (3) must be for its tensor products.
TEST(SpeedRules, KnotInsertionAlongALine) {
  const auto rows = inserted_rows(s);
  expect_row(rows[0], {half(s * q), e1, half(s * q), F(0)});
  expect_row(rows[1], {F(0), s, q, F(0)});
  expect_row(rows[2], {F(0), F(0), s * e2, q * q * q});
  expect_row(rows[3], {F(0), F(0), F(0), F(1)});
}

// Karciauskas & Peters, (13): its weights are products of these, each with the factor 1/(1 + q).
TEST(SpeedRules, BezierPointsAlongALine) {
  const F d1 = F(1) + q;
  const F d2 = F(6) - F(4) * s + s * s;
  const auto rows = bezier_rows(s);
  expect_row(rows[0], {F(0), s * s / d1, s * q * d2 / d1, q * q * q});
  expect_row(rows[1], {F(0), s / d1, F(2) * q / d1, F(0)});
  expect_row(rows[2], {F(0), F(1) / d1, q / d1, F(0)});
  expect_row(rows[3], {half(q) / d1, F(1) / d1, half(q) / d1, F(0)});
}

// Karciauskas & Peters, (11).
TEST(SpeedRules, ChangeFromUniformKnots) {
  const F f1 = q - s;
  const F f2 = q + F(1);
  const F f3 = F(2) * q * q - F(1);
  const F f4 = q * q * q + q * q - s;
  const auto rows = changed_rows(uniform_knots<F>(), unit_speed_knots(s));
  expect_row(rows[1], {F(0), f1 / (F(3) * q), f2 / (F(3) * q), F(0)});
  const F q3 = q * q * q;
  expect_row(rows[2], {F(0), f1 * f3 / (F(6) * q3), f4 / (F(3) * q3), F(1) / (F(6) * q3)});
}

}  // namespace
}  // namespace subdiv
