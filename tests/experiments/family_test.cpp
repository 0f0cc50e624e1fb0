#include "experiments/family.h"

#include <gtest/gtest.h>

#include "schemes/bspline.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

const Claim& find(const Results& results, const std::string& id) {
  for (const Claim& claim : results.claims) {
    if (claim.head.id == id) return claim;
  }
  throw std::logic_error("no claim " + id);
}

TEST(Family, EverythingPrintedHoldsButEvenDegrees) {
  const Results results = run_family();
  EXPECT_EQ(results.claims.size(), family_heads().size());
  for (const Claim& claim : results.claims) {
    const Verdict expected = claim.head.id == "family.even-degree" ? Verdict::refuted
                             : claim.head.printed                  ? Verdict::reproduced
                                                                   : Verdict::established;
    EXPECT_EQ(claim.verdict, expected) << claim.head.id;
    EXPECT_EQ(claim.rigour, Rigour::exact) << claim.head.id;
  }
  EXPECT_EQ(find(results, "family.members.four-point").exact, "(-1/16, 0, 9/16, 1, 9/16, 0, -1/16)");
}

// A second route to the refutation: ten steps of J_2 on a closed heptagon give the same points as ten steps
// of the quartic B-spline scheme on its mid-edge polygon, once the former's neighbours are averaged.
TEST(Family, TheCurveOfJ2IsAQuarticSpline) {
  constexpr int points = 7;
  constexpr std::array<int, points> heights{0, 3, -1, 4, 1, -5, 9};
  const auto refine = [](std::vector<Rational> p, const Mask<Rational>& mask, int steps) {
    for (int step = 0; step < steps; ++step) {
      const int n = static_cast<int>(p.size());
      std::vector<Rational> next(p.size() * 2);
      for (int j = 0; j < n; ++j) {
        for (int i = mask.symbol.first(); i <= mask.symbol.last(); ++i) {
          next[static_cast<std::size_t>(residue(2 * j + i, 2 * n))] +=
              mask.symbol[i] * p[static_cast<std::size_t>(j)];
        }
      }
      p = std::move(next);
    }
    return p;
  };
  std::vector<Rational> polygon;
  std::vector<Rational> mid_edges;
  for (int j = 0; j < points; ++j) {
    const auto here = static_cast<std::size_t>(j);
    const auto next = static_cast<std::size_t>((j + 1) % points);
    polygon.emplace_back(heights[here]);
    mid_edges.emplace_back(heights[here] + heights[next], 2);
  }
  constexpr int steps = 4;
  const auto refined = refine(polygon, jspline<Rational>(2), steps);
  const auto quartic = refine(mid_edges, bspline<Rational>(4), steps);
  // Neighbours' averages are the quartic scheme's points, up to a shift of the numbering.
  const std::size_t n = refined.size();
  bool found = false;
  for (std::size_t shift = 0; shift < n && !found; ++shift) {
    found = true;
    for (std::size_t i = 0; i < n && found; ++i) {
      found = (refined[i] + refined[(i + 1) % n]) / Rational(2) == quartic[(i + shift) % n];
    }
  }
  EXPECT_TRUE(found);
}

}  // namespace
}  // namespace subdiv
