#include "experiments/characteristic_maps.h"

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "tests/experiments/find_claim.h"

namespace subdiv {
namespace {

const Results& results() {
  static const Results all = run_characteristic_maps();
  return all;
}

TEST(CharacteristicMaps, AllAreProved) {
  for (const char* id : {"mesh.characteristic-map.catmull-clark", "mesh.characteristic-map.quintic",
                         "mesh.characteristic-map.loop", "mesh.characteristic-map.loop-1987",
                         "mesh.characteristic-map.kobbelt", "mesh.characteristic-map.directional",
                         "mesh.characteristic-map.literal", "notes.butterfly.winds-twice"}) {
    const Claim& claim = test::find_claim(results().claims, id);
    EXPECT_EQ(claim.verdict, Verdict::established) << id;
    EXPECT_EQ(claim.rigour, Rigour::certified) << id;
  }
  EXPECT_EQ(test::find_claim(results().claims, "figure.characteristic-maps").verdict, Verdict::reproduced);
  const Claim& smooth = test::find_claim(results().claims, "notes.loop.smooth");
  EXPECT_EQ(smooth.verdict, Verdict::reproduced);
  EXPECT_EQ(smooth.rigour, Rigour::certified);
}

TEST(CharacteristicMaps, EveryHeadIsSettledOnce) {
  std::multiset<std::string> heads;
  std::multiset<std::string> settled;
  for (const ClaimHead& head : characteristic_map_heads()) heads.insert(head.id);
  for (const Claim& claim : results().claims) settled.insert(claim.head.id);
  EXPECT_EQ(heads, settled);
}

// The first map of a row has valence 3: its points come again after a third of a turn.
TEST(CharacteristicMaps, DrawnMapsAreSymmetric) {
  const Series& series = test::find_series(results(), "characteristic-maps-1");
  constexpr int lines_of_a_sector = 9;
  constexpr std::size_t rows = lines_of_a_sector * 6;
  const double c = std::cos(2 * std::numbers::pi / 3);
  const double s = std::sin(2 * std::numbers::pi / 3);
  for (std::size_t i = 0; i < rows; ++i) {
    if (series.rows[i][2].empty()) continue;
    const auto number = [&](std::size_t row, std::size_t column) {
      return std::strtod(series.rows[row][column].c_str(), nullptr);
    };
    const double x = number(i, 2);
    const double y = number(i, 3);
    EXPECT_NEAR(number(i + rows, 2), c * x - s * y, 2e-5);
    EXPECT_NEAR(number(i + rows, 3), s * x + c * y, 2e-5);
    EXPECT_LE(std::hypot(x, y), 1 + 1e-5);
  }
}

}  // namespace
}  // namespace subdiv
