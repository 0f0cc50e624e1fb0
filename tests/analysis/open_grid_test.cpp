#include "analysis/open_grid.h"

#include <gtest/gtest.h>

#include "analysis/limit_mask.h"
#include "schemes/evaluate/grid_ringing.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

Rational q(long p, long denominator = 1) { return {p, denominator}; }

ControlGrid<Rational> cubes() {
  std::vector<Rational> points;
  for (int i = 0; i < 12; ++i) points.push_back(q(i * i * i - 9 * i));
  return control_grid({3, true, 0, 0}, {4, true, 0, 0}, points);
}

TEST(OpenGrid, EndsAreAddedInBothDirections) {
  const auto given = cubes();
  const EndWeights<Rational> weights = end_weights(stationary("J", jspline(q(1, 2))), OpenEnd::reflected);
  const auto open = open_across(open_along(given, weights), weights);
  EXPECT_EQ(open.rows, (Topology{7, false, 2, 2}));
  EXPECT_EQ(open.columns(), (Topology{8, false, 2, 2}));
  EXPECT_EQ(open.at(1, 2), given.at(1, 2));
  EXPECT_EQ(open.at(0, -1), q(2) * given.at(0, 0) - given.at(0, 1));
  EXPECT_EQ(open.at(4, 0), q(2) * given.at(2, 0) - given.at(0, 0));
  EXPECT_EQ(open.at(-1, 4), q(2) * open.at(0, 4) - open.at(1, 4));
  const auto again = open_across(open, weights);  // added rows do not pile up
  EXPECT_EQ(again.rows, open.rows);
  EXPECT_EQ(again.at(-2, 3), open.at(-2, 3));
}

TEST(OpenGrid, ClampedSurfacesBeginAtTheCornersOfTheGrid) {  // js-report 11, 13: the limit at the corners
  const Scheme<Rational> scheme = stationary("J", jspline(q(3, 2)));
  const EndWeights<Rational> weights = end_weights(scheme, OpenEnd::clamped);
  const auto open = open_across(open_along(cubes(), weights), weights);
  const Laurent<Rational> limit = limit_mask(scheme.last());
  const auto limit_at = [&](int row, int column) {
    Rational sum;
    for (int i = limit.first(); i <= limit.last(); ++i)
      for (int j = limit.first(); j <= limit.last(); ++j)
        sum += limit[i] * limit[j] * open.at(row + i, column + j);
    return sum;
  };
  for (const int row : {0, 2})
    for (const int column : {0, 3}) EXPECT_EQ(limit_at(row, column), cubes().at(row, column));
}

TEST(OpenGrid, BordersAreTheCurvesOfTheBorderRows) {
  const Scheme<Rational> scheme = stationary("J", jspline(q(0)));  // interpolating: exact at every depth
  const EndWeights<Rational> weights = end_weights(scheme, OpenEnd::clamped);
  const auto open = open_across(open_along(cubes(), weights), weights);
  std::vector<Rational> vertices;
  const Refinement<Rational> twice{scheme, 2};
  stream_surface(open, twice, twice, [&](const Rational& p) { vertices.push_back(p); }, [](const auto&) {});
  ASSERT_EQ(vertices.size(), 13U * 9U);
  Ringing<Rational, Rational> border(scheme, open.lines[2], 2);  // row 0
  for (const Rational& p : border) EXPECT_EQ(p, vertices[static_cast<std::size_t>(border.index()) * 9]);
}

}  // namespace
}  // namespace subdiv
