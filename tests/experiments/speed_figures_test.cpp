#include "experiments/speed_figures.h"

#include <cmath>
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "experiments/report/figure_script.h"
#include "experiments/speed_figure_parts.h"
#include "tests/experiments/find_claim.h"

namespace subdiv {
namespace {

const Results& results() {
  static const Results once = run_speed_figures();
  return once;
}

TEST(SpeedFigures, EveryFigureHasItsIdentity) {
  std::set<std::string> ids;
  for (const Claim& claim : results().claims) {
    ids.insert(claim.head.id);
    EXPECT_EQ(claim.verdict, claim.head.printed ? Verdict::reproduced : Verdict::established)
        << claim.head.id;
    EXPECT_EQ(claim.rigour, Rigour::exact) << claim.head.id;
  }
  EXPECT_EQ(ids, (std::set<std::string>{"figure.speed.10", "figure.speed.2", "figure.speed.3",
                                        "figure.speed.4", "figure.speed.5"}));
  EXPECT_EQ(results().figures.size(), 5U);
}

// A figure is drawn from its series alone, the same bytes each time.
TEST(SpeedFigures, AreDeterministic) {
  const Results again = run_speed_figures();
  for (std::size_t i = 0; i < again.figures.size(); ++i)
    EXPECT_EQ(figure_script(again.figures[i], again.series),
              figure_script(results().figures[i], results().series));
}

/// The dots of a series by their names.
std::map<std::string, Spot> dots(const std::string& name) {
  std::map<std::string, Spot> result;
  for (const auto& row : test::find_series(results(), name).rows)
    EXPECT_TRUE(result.emplace(row[0], Spot{std::stod(row[1]), std::stod(row[2])}).second) << row[0];
  return result;
}

// Figure 5: 11 to 33 in a sector, and what its rules read beyond; the third ring is half again as far out.
TEST(SpeedFigures, IndicesStandWhereTheyBelong) {
  const auto labels = dots("speed-indices-labels");
  EXPECT_EQ(labels.size(), 15U);
  for (const auto& [label, spot] : labels) {  // the bisectrix of the sector is upright
    const std::string mirrored{label.rbegin(), label.rend()};
    EXPECT_NEAR(spot.x, -labels.at(mirrored).x, 1e-3) << label;
    EXPECT_NEAR(spot.y, labels.at(mirrored).y, 1e-3) << label;
  }
  EXPECT_NEAR(labels.at("33").y, 0, 1e-9);
  EXPECT_LT(labels.at("22").y, labels.at("11").y);
  // 23, 32, 43, 34 are edge neighbours of the vertex: all at the same distance.
  const double unit = std::hypot(labels.at("23").x, labels.at("23").y);
  for (const char* label : {"32", "43", "34"})
    EXPECT_NEAR(std::hypot(labels.at(label).x, labels.at(label).y), unit, 1e-3) << label;
  const auto numbers = dots("speed-indices-numbers");
  EXPECT_EQ(numbers.size(), 13U);
  const double middle = numbers.at("1").x;
  for (const auto& [k, other] : {std::pair{"4", "6"}, {"9", "13"}, {"10", "12"}}) {  // mirrored
    EXPECT_NEAR(numbers.at(k).x + numbers.at(other).x, 2 * middle, 1e-3) << k;
    EXPECT_NEAR(numbers.at(k).y, numbers.at(other).y, 1e-3) << k;
  }
  EXPECT_EQ(dots("speed-border-indices-indices").size(), 15U);
}

TEST(SpeedFigures, UnequalStepsAreSeen) {
  const RationalFunction one(1);
  BezierPatch<SymbolicPoint> border = border_points(mean_net(), ring_rules(RationalFunction::variable(0)), 0);
  EXPECT_TRUE(equal_steps(border, {one, one}, {one, one}, 15));
  border[6][1] += RationalFunction::variable(0);
  EXPECT_FALSE(equal_steps(border, {one, one}, {one, one}, 15));
}

}  // namespace
}  // namespace subdiv
