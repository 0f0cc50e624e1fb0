#include "analysis/mesh/bernstein_patch.h"

#include <gtest/gtest.h>

namespace subdiv {
namespace {

/// (4 u - 1)(4 u - 3)/3 + 1/100 in Bernstein form, the same for all v: positive at the corners, its least
/// value -1/3 + 1/100 at u = 1/2.
SquarePatch valley() {
  SquarePatch f(2, 1);
  for (int j = 0; j <= 1; ++j) {
    f(0, j) = f(2, j) = Interval(Rational(101, 100));
    f(1, j) = Interval(Rational(-497, 300));
  }
  return f;
}

/// (1 - 2 u)^2 + 1/100: positive everywhere, with a negative coefficient until pieces are small.
SquarePatch positive() {
  SquarePatch f(2, 1);
  for (int j = 0; j <= 1; ++j) {
    f(0, j) = f(2, j) = Interval(Rational(101, 100));
    f(1, j) = Interval(Rational(-99, 100));
  }
  return f;
}

/// (3 u - 1)^2 - 1/1000: negative for |u - 1/3| < 0.0106 alone.
SquarePatch narrow() {
  const auto value = [](const Rational& q) { return Interval(q - Rational(1, 1000)); };
  SquarePatch f(2, 1);
  for (int j = 0; j <= 1; ++j) {
    f(0, j) = value(Rational(1));
    f(1, j) = value(Rational(-2));
    f(2, j) = value(Rational(4));
  }
  return f;
}

SignsFound signs_of(const SquarePatch& f, int depth, int parts) {
  SignsFound found;
  add_signs(found, f, depth, parts);
  return found;
}

TEST(BernsteinPatch, SignsStayOpenWhereThePartsEnd) {
  // Few parts: the dip, 0.021 wide, holds no corner of theirs.
  for (const int parts : {0, 1, 4, 8}) {
    const SignsFound found = signs_of(narrow(), 20, parts);
    EXPECT_TRUE(found.open) << parts;
    EXPECT_FALSE(found.negative) << parts;
  }
  EXPECT_TRUE(signs_of(narrow(), 20, 100000).both());
  // Nor is what holds everywhere known everywhere.
  EXPECT_TRUE(signs_of(positive(), 20, 0).open);
  const SignsFound enough = signs_of(positive(), 20, 100000);
  EXPECT_TRUE(enough.positive && !enough.negative && !enough.open);
}

TEST(BernsteinPatch, SignsStayOpenWhereTheDepthEnds) {
  EXPECT_TRUE(signs_of(narrow(), 0, 1000).open);
  EXPECT_TRUE(signs_of(narrow(), 2, 1000).open);
  EXPECT_TRUE(signs_of(valley(), 1, 1000).both());  // -97/300 at u = 1/2
}

TEST(BernsteinPatch, PartsAreCountedDownForAllPatchesTogether) {
  SignsFound found;
  int parts = 4;
  add_signs(found, positive(), 20, parts);
  EXPECT_LE(parts, 0);
  found = {};
  add_signs(found, narrow(), 20, parts);  // nothing left for the next one
  EXPECT_TRUE(found.open);
}

}  // namespace
}  // namespace subdiv
