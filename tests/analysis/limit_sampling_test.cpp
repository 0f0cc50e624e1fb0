#include "analysis/limit_sampling.h"

#include <gtest/gtest.h>

#include "analysis/limit_points.h"
#include "schemes/bspline.h"
#include "schemes/evaluate/ringing.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

TEST(LimitSampling, GivesTheLimitPointsOfALevel) {
  const auto j = [](long p, long q) { return stationary("J", jspline(Rational(p, q))); };
  const std::vector<Scheme<Rational>> schemes{j(3, 2),
                                              j(1, 2),
                                              mixed(j(-33, 26), j(3, 2)),
                                              mixed(mixed(j(0, 1), j(1, 1)), j(1, 3)),
                                              stationary("B2", bspline<Rational>(2)),
                                              stationary("B9", bspline<Rational>(9))};
  const auto controls = closed_polygon(std::vector<Rational>{1, 2, 4, 8, 16, 32, 64});
  for (const Scheme<Rational>& scheme : schemes) {
    for (int level = 1; level <= 4; ++level) {
      std::vector<Rational> points;
      const Scheme<Rational> sampling = limit_sampling(scheme, level);
      Ringing<Rational, Rational> rings(sampling, controls, level);
      for (const Rational& p : rings) points.push_back(p);
      EXPECT_EQ(points, limit_derivatives(scheme, controls, level, 0)) << scheme.name << ", level " << level;
      const IndexWindow ends = vertex_reach(sampling, level);
      const IndexWindow given = vertex_reach(scheme);
      EXPECT_TRUE(given.first <= ends.first && ends.last <= given.last) << scheme.name;
    }
  }
  EXPECT_THROW((void)limit_sampling(schemes[0], 0), std::invalid_argument);
}

}  // namespace
}  // namespace subdiv
