#include "experiments/interpolation.h"

#include <cmath>
#include <functional>
#include <map>

#include <gtest/gtest.h>

#include "tests/experiments/find_claim.h"

namespace subdiv {
namespace {

using Values = std::map<int, double>;

/// One step of J_{a,b}, written from the stencils of jsplines 1 and not from the catalogue's mask.
Values refine(const Values& p, double a, double b) {
  const auto at = [&](int i) {
    const auto found = p.find(i);
    return found == p.end() ? 0.0 : found->second;
  };
  Values result;
  for (int j = p.begin()->first - 2; j <= p.rbegin()->first + 2; ++j) {
    result[2 * j] = (a * at(j - 1) + (8 - 2 * a) * at(j) + a * at(j + 1)) / 8;
    result[2 * j + 1] =
        ((b - 1) * at(j - 1) + (9 - b) * at(j) + (9 - b) * at(j + 1) + (b - 1) * at(j + 2)) / 16;
  }
  return result;
}

/// Largest deviation of the limit of {J_{a,b}, *J_s} from what interpolation wants, at old vertices (phase 0)
/// or at new mid-edge vertices (phase 1), by sixteen refinements of a unit impulse: the second route to every
/// number here.
double deviation(double a, double b, double s, int phase) {
  Values values = refine({{0, 1.0}}, a, b);
  constexpr int steps = 15;
  for (int k = 0; k < steps; ++k) values = refine(values, s, s);
  double worst = 0;
  const int unit = 1 << (steps + 1);
  for (int j = -6; j <= 6; ++j) {
    const auto found = values.find(j * unit + phase * unit / 2);
    const double value = found == values.end() ? 0.0 : found->second;
    const double wanted = phase == 0 ? (j == 0 ? 1.0 : 0.0) : (j == 0 || j == -1 ? 0.5 : 0.0);
    worst = std::max(worst, std::abs(value - wanted));
  }
  return worst;
}

class Interpolation : public ::testing::Test {
 protected:
  static const std::vector<Claim>& claims() {
    static const std::vector<Claim> all = run_interpolation().claims;
    return all;
  }
};

/// f has its least value at x, to within the accuracy of the refinement.
void expect_minimum(const std::function<double(double)>& f, double x, double least) {
  EXPECT_NEAR(f(x), least, 1e-6);
  for (const double step : {1e-3, 1e-2, 0.1, 1.0}) {
    EXPECT_GT(f(x + step), least + step * 1e-6);
    EXPECT_GT(f(x - step), least + step * 1e-6);
  }
}

TEST_F(Interpolation, VertexMinimaxByRefinement) {
  expect_minimum([](double r) { return deviation(r, r, 1.5, 0); }, -33.0 / 26, 5.0 / 156);
  EXPECT_EQ(test::find_claim(claims(), "vertex.r").exact, "-33/26");
  EXPECT_EQ(test::find_claim(claims(), "vertex.r.error").exact, "5/156");
}

TEST_F(Interpolation, EdgeMinimaxByRefinement) {
  expect_minimum([](double r) { return deviation(r, r, 1.5, 1); }, 29.0 / 59, 1.0 / 3776);
  EXPECT_EQ(test::find_claim(claims(), "edge.r").exact, "29/59");
  const double s = test::value_of(claims(), "edge.s");
  expect_minimum([](double x) { return deviation(x, x, x, 1); }, s, deviation(s, s, s, 1));
  EXPECT_NEAR(s, 0.751, 5e-4);
}

TEST_F(Interpolation, ExactPairsInterpolateByRefinement) {
  EXPECT_NEAR(deviation(-7.0 / 4, 59.0 / 52, 1.5, 0), 0, 1e-7);
  EXPECT_NEAR(deviation(2.0 / 3, 2.0 / 3, 1, 1), 0, 1e-7);
  EXPECT_NEAR(deviation(-2.0 / 13, 1, 1.5, 1), 0, 1e-7);
  EXPECT_EQ(test::find_claim(claims(), "edge.exact.a").exact, "-2/13");
  EXPECT_EQ(test::find_claim(claims(), "edge.exact.b").exact, "1");
}

TEST_F(Interpolation, PairsForEverySByRefinement) {
  // The closed forms that the claims print, at a few s.
  EXPECT_EQ(test::find_claim(claims(), "vertex.exact.a").exact, "7*s/(2*s - 9)");
  EXPECT_EQ(test::find_claim(claims(), "edge.exact.every-s.a").exact, "2*(s - 1)/(s - 8)");
  for (const double s : {0.25, 0.7, 1.3}) {
    const double a = 7 * s / (2 * s - 9);
    const double b = (9 * s * s - 32 * s + 72) / ((2 * s - 9) * (s - 8));
    EXPECT_NEAR(deviation(a, b, s, 0), 0, 1e-6) << s;
    EXPECT_NEAR(deviation(2 * (s - 1) / (s - 8), 1, s, 1), 0, 1e-6) << s;
  }
}

TEST_F(Interpolation, EveryClaimIsSettledOnce) {
  EXPECT_EQ(claims().size(), interpolation_heads().size());
  for (const Claim& claim : claims()) EXPECT_NE(claim.verdict, Verdict::undecided) << claim.head.id;
}

}  // namespace
}  // namespace subdiv
