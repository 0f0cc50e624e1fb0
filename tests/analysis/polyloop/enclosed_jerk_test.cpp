#include "analysis/polyloop/enclosed_jerk.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace subdiv {
namespace {

// A square of side 2: the jerk of an edge is -A + 3B - 3C + D = 3 (B - C) + (D - A) = -2 (C - B), along it.
TEST(EnclosedNormalJerk, OfASquareIsZero) {
  const EnclosedNormalJerk jerk = enclosed_normal_jerk(make_polyline({{0, 2, 2, 0}, {0, 0, 2, 2}}, true));
  EXPECT_TRUE(jerk.largest.contains(Rational(0)));
  EXPECT_TRUE(jerk.mean.contains(Rational(0)));
}

// Edge (0,0)-(1,0) between (-1,2) and (2,5): jerk y = -2 + 5 = 3.
TEST(EnclosedNormalJerk, ContainsTheComputedOne) {
  const Polyline polyline = make_polyline({{-1, 0, 1, 2, 7}, {2, 0, 0, 5, 9}}, true);
  const EnclosedNormalJerk enclosed = enclosed_normal_jerk(polyline);
  const std::vector<double> jerks = normal_jerks(polyline);
  EXPECT_NEAR(jerks[1], 3, 1e-14);
  const NormalJerk computed = normal_jerk(polyline);
  EXPECT_NEAR(enclosed.largest.to_double(), computed.largest, 1e-12);
  EXPECT_NEAR(enclosed.mean.to_double(), computed.mean, 1e-12);
  EXPECT_LT(enclosed.mean.radius(), 1e-30);
}

TEST(EnclosedNormalJerk, RefusesWhatItCannotEnclose) {
  EXPECT_THROW(static_cast<void>(enclosed_normal_jerk(make_polyline({{0, 1, 1}, {0, 0, 1}}, false))),
               std::invalid_argument);
  EXPECT_THROW(static_cast<void>(enclosed_normal_jerk(make_polyline({{0, 1, 1, 1}, {0, 0, 0, 1}}, true))),
               std::invalid_argument);
}

}  // namespace
}  // namespace subdiv
