#include "experiments/smoothness_maps.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/experiments/find_claim.h"

namespace subdiv {
namespace {

class SmoothnessMaps : public ::testing::Test {
 protected:
  static const Results& results() {
    static const Results all = run_smoothness_maps();
    return all;
  }
  static const std::vector<Claim>& claims() { return results().claims; }
  static const Series& series(const std::string& name) { return test::find_series(results(), name); }
};

Rational exact_value(const Claim& claim) { return Rational::parse(claim.exact); }

TEST_F(SmoothnessMaps, EveryClaimIsSettled) {
  EXPECT_EQ(claims().size(), smoothness_map_heads().size());
  for (const Claim& claim : claims()) EXPECT_EQ(claim.verdict, Verdict::established) << claim.head.id;
}

TEST_F(SmoothnessMaps, AreasAddUpToTheRectangles) {
  for (const auto& [order, whole] : {std::pair("0", 357), std::pair("1", 165)}) {
    const std::string id = std::string("smooth.map.c") + order;
    const Rational in = exact_value(test::find_claim(claims(), id + ".in"));
    const Rational out = exact_value(test::find_claim(claims(), id + ".out"));
    const Rational undecided = exact_value(test::find_claim(claims(), id + ".undecided"));
    EXPECT_EQ(in + out + undecided, Rational(whole));
    EXPECT_LT(undecided, Rational(whole) * Rational(1, 50));
  }
}

/// Which of the drawn rectangles hold a point in their interior: "in", "out" or "undecided".
std::string drawn_at(const Results& results, const std::string& map, double a, double b) {
  std::string found;
  for (const Series& s : results.series) {
    if (!s.name.starts_with(map + "-")) continue;
    for (const auto& row : s.rows) {
      const bool inside =
          std::stod(row[0]) < a && a < std::stod(row[1]) && std::stod(row[2]) < b && b < std::stod(row[3]);
      if (inside) found += s.name.substr(map.size() + 1);
    }
  }
  return found;
}

TEST_F(SmoothnessMaps, DrawnCellsCoverOnceAndAgreeWithKnownLines) {
  // J_s is C1 for -2 < s < 6 and C0 for -6 < s < 10; on 2a + b = 9 the scheme is C1 for 1 < b < 19/3.
  const auto c1 = [&](double a, double b) { return drawn_at(results(), "smooth-map-c1", a, b); };
  const auto c0 = [&](double a, double b) { return drawn_at(results(), "smooth-map-c0", a, b); };
  for (const double s : {-1.9, -0.7, 0.3, 1.6, 2.9, 4.4, 5.9}) EXPECT_NE(c1(s, s + 1e-6), "out") << s;
  for (const double s : {-1.5, -0.7, 0.3, 1.6, 2.9, 4.4, 5.5}) EXPECT_EQ(c1(s, s + 1e-6), "in") << s;
  for (const double s : {-3.1, -2.5, 6.5}) EXPECT_EQ(c1(s, s + 1e-6), "out") << s;
  for (const double s : {-5.5, -3.3, 0.3, 7.7, 9.5}) EXPECT_EQ(c0(s, s + 1e-6), "in") << s;
  for (const double s : {-6.6}) EXPECT_EQ(c0(s, s + 1e-6), "out") << s;
  for (const double b : {1.5, 3.3, 5.7}) EXPECT_EQ(c1((9 - b) / 2, b), "in") << b;
  for (const double b : {0.3, 6.9, 8.1}) EXPECT_EQ(c1((9 - b) / 2, b), "out") << b;
}

TEST_F(SmoothnessMaps, RectanglesHaveTheAreasOfTheirDepth) {
  const auto area = [&](const std::string& name) {
    double sum = 0;
    for (const auto& row : series(name).rows) {
      sum += (std::stod(row[1]) - std::stod(row[0])) * (std::stod(row[3]) - std::stod(row[2]));
    }
    return sum;
  };
  const Series& areas = series("smooth-map-area");
  for (const auto& row : areas.rows) {
    if (row[0] != "8") continue;
    EXPECT_NEAR(area("smooth-map-c0-in"), std::stod(row[1]), 1e-9);
    EXPECT_NEAR(area("smooth-map-c0-undecided"), std::stod(row[3]), 1e-9);
    EXPECT_NEAR(area("smooth-map-c1-in"), std::stod(row[4]), 1e-9);
    EXPECT_NEAR(area("smooth-map-c1-out"), std::stod(row[5]), 1e-9);
  }
  // The undecided cells line a curve: each halving nearly halves their area.
  for (std::size_t i = 1; i < areas.rows.size(); ++i) {
    EXPECT_LT(std::stod(areas.rows[i][3]), 0.7 * std::stod(areas.rows[i - 1][3]));
    EXPECT_LT(std::stod(areas.rows[i][6]), 0.8 * std::stod(areas.rows[i - 1][6]));
  }
}

}  // namespace
}  // namespace subdiv
