#include "analysis/radius_map.h"

#include <random>
#include <stdexcept>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "analysis/three_tap_radius.h"
#include "analysis/transition_matrices.h"
#include "schemes/four_point.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

const Function a = Function::variable(0);
const Function b = Function::variable(1);

RadiusMapOptions depth(int levels) {
  RadiusMapOptions options;
  options.depth = levels;
  return options;
}

/// Bounds of the radius at a point by all products of six matrices, in floating point.
std::pair<double, double> brute_force(const std::vector<Eigen::MatrixXd>& family) {
  constexpr int length = 6;
  double low = 0;
  double high = 0;
  for (int bits = 0; bits < 1 << length; ++bits) {
    Eigen::MatrixXd p = Eigen::MatrixXd::Identity(family[0].rows(), family[0].cols());
    for (int i = 0; i < length; ++i) p = family[static_cast<std::size_t>(bits >> i & 1)] * p;
    low = std::max(low, std::pow(p.eigenvalues().cwiseAbs().maxCoeff(), 1.0 / length));
    high = std::max(high, std::pow(p.norm(), 1.0 / length));
  }
  return {low, high};
}

std::vector<Eigen::MatrixXd> value_at(const std::vector<Matrix<Function>>& family,
                                      const std::vector<Rational>& x) {
  std::vector<Eigen::MatrixXd> result;
  for (const auto& t : family) {
    result.push_back(t.unaryExpr([&](const Function& f) { return f.evaluate<Rational>(x).to_double(); }));
  }
  return result;
}

TEST(RadiusMap, CellsCoverTheBox) {
  const ParameterBox box{{-4, -5}, {7, 10}};
  EXPECT_EQ(box.volume(), Rational(165));
  Rational undecided(166);
  for (const int levels : {2, 4, 5}) {
    const RadiusMap map = continuity_map(jspline(a, b), 1, box, depth(levels));
    EXPECT_EQ(map.volume(Decision::yes) + map.volume(Decision::no) + map.volume(Decision::undecided),
              Rational(165));
    EXPECT_LT(map.volume(Decision::undecided), undecided);
    undecided = map.volume(Decision::undecided);
  }
  EXPECT_LT(undecided, Rational(165) * Rational(3, 20));
}

TEST(RadiusMap, DecidedCellsAgreeWithSamples) {
  const std::vector<Matrix<Function>> family = transition_matrices(normal_form(jspline(a, b)));
  std::mt19937 random(7);
  std::uniform_int_distribution<int> part(0, 64);
  int checked = 0;
  for (const int continuity : {0, 1}) {
    const RadiusMap map = continuity_map(jspline(a, b), continuity, {{-7, -10}, {10, 11}}, depth(5));
    const double bound = continuity == 0 ? 2 : 1;
    for (const MapCell& cell : map.cells) {
      if (cell.below == Decision::undecided) continue;
      std::vector<Rational> x;
      for (std::size_t k = 0; k < 2; ++k) {
        x.push_back(cell.box.lower[k] + (cell.box.upper[k] - cell.box.lower[k]) * Rational(part(random), 64));
      }
      const auto [low, high] = brute_force(value_at(family, x));
      if (cell.below == Decision::yes) {
        EXPECT_LT(low, bound) << x[0].to_string() << " " << x[1].to_string();
      } else {
        EXPECT_GE(high, bound) << x[0].to_string() << " " << x[1].to_string();
        EXPECT_FALSE(cell.word.empty());
      }
      ++checked;
    }
  }
  EXPECT_GT(checked, 200);
}

TEST(RadiusMap, AgreesWithTheClosedFormOnTheDiagonal) {
  // J_{s,s} is C^1 exactly for -2 < s < 6 and C^0 for -6 < s < 10.
  for (const auto& [continuity, lower, upper] : {std::tuple(1, -2, 6), std::tuple(0, -6, 10)}) {
    const RadiusMap map = continuity_map(jspline(a, b), continuity, {{-7, -7}, {11, 11}}, depth(6));
    for (const MapCell& cell : map.cells) {
      for (int s = -28; s <= 44; ++s) {
        const Rational at(s, 4);
        bool inside = true;
        for (std::size_t k = 0; k < 2; ++k)
          inside = inside && cell.box.lower[k] <= at && at <= cell.box.upper[k];
        if (!inside || cell.below == Decision::undecided) continue;
        EXPECT_EQ(cell.below == Decision::yes, Rational(lower) < at && at < Rational(upper))
            << at.to_string();
      }
    }
  }
}

TEST(RadiusMap, OneParameterEnclosesTheExactRange) {
  const RadiusMap map = radius_map(three_tap_matrices(), Rational(1), {{-1}, {2}}, depth(9));
  const RealSet exact = three_tap_radius_below(1);
  for (const MapCell& cell : map.cells) {
    const bool inside =
        exact.contains(Algebraic(cell.box.lower[0])) && exact.contains(Algebraic(cell.box.upper[0]));
    EXPECT_TRUE(cell.below != Decision::yes || inside);
    const Algebraic middle((cell.box.lower[0] + cell.box.upper[0]) / Rational(2));
    EXPECT_FALSE(cell.below == Decision::no && exact.contains(middle));
  }
  EXPECT_LT(map.volume(Decision::undecided), Rational(1, 20));
  EXPECT_GT(map.volume(Decision::yes), Rational(19, 20));
  EXPECT_GE(map.volume(Decision::no), Rational(19, 10));
}

TEST(RadiusMap, FourPointTension) {
  const RadiusMap map = continuity_map(four_point(a), 1, {{Rational(-1, 10)}, {Rational(3, 10)}}, depth(9));
  Rational low(1);
  Rational high(-1);
  for (const MapCell& cell : map.cells) {
    if (cell.below != Decision::yes) continue;
    low = std::min(low, cell.box.lower[0]);
    high = std::max(high, cell.box.upper[0]);
  }
  EXPECT_GT(low, Rational(0));
  EXPECT_LT(low, Rational(1, 100));
  EXPECT_LT(high, Rational(19273, 100000));
  EXPECT_GT(high, Rational(185, 1000));
}

/// The hull of the cells that are yes.
std::pair<Rational, Rational> proved_range(const RadiusMap& map) {
  Rational low = map.cells.back().box.upper[0];
  Rational high = map.cells.front().box.lower[0];
  for (const MapCell& cell : map.cells) {
    if (cell.below != Decision::yes) continue;
    low = std::min(low, cell.box.lower[0]);
    high = std::max(high, cell.box.upper[0]);
  }
  return {low, high};
}

TEST(RadiusMap, EntriesMayBeRationalFunctions) {
  // |x^2| < 1, |1/x| < 1, |(x^2 - 1)/(x^2 + 1)| < 1.
  const auto map = [](const Function& f, const ParameterBox& box) {
    return radius_map({Matrix<Function>::Constant(1, 1, f)}, Rational(1), box, depth(12));
  };
  const Rational tiny(1, 100);
  const auto square = proved_range(map(a * a, {{-3}, {2}}));
  EXPECT_LT(abs(square.first + Rational(1)), tiny);
  EXPECT_LT(abs(square.second - Rational(1)), tiny);
  const RadiusMap inverse = map(Function(1) / a, {{Rational(1, 10)}, {3}});
  EXPECT_LT(proved_range(inverse).first, Rational(1) + tiny);
  EXPECT_GT(proved_range(inverse).first, Rational(1));
  EXPECT_GT(inverse.volume(Decision::no), Rational(89, 100));
  const Function bounded = (a * a - Function(1)) / (a * a + Function(1));
  EXPECT_EQ(map(bounded, {{Rational(1, 50)}, {7}}).volume(Decision::undecided), Rational(0));
}

TEST(RadiusMap, PolesAreUndecided) {
  const RadiusMap map =
      radius_map({Matrix<Function>::Constant(1, 1, Function(1) / a)}, Rational(1), {{-1}, {1}}, depth(9));
  for (const MapCell& cell : map.cells) {
    EXPECT_NE(cell.below, Decision::yes);
    if (cell.box.lower[0] > Rational(0) || cell.box.upper[0] < Rational(0)) continue;
    EXPECT_EQ(cell.below, Decision::undecided);
  }
  EXPECT_LT(map.volume(Decision::undecided), Rational(1, 50));
}

TEST(RadiusMap, ReparametrisedTensionKeepsItsRange) {
  // C^1 exactly for 0 < w < 0.19272924926481.., the real root of 32 w^3 + 4 w - 1 (Hechler, Moessner & Reif
  // 2009).
  const double limit = 0.19272924926481;
  const double tiny = 2e-3;
  const auto squared = proved_range(continuity_map(four_point(a * a), 1, {{0}, {1}}, depth(10)));
  EXPECT_LT(squared.first.to_double(), 0.05);
  EXPECT_LT(squared.second.to_double(), std::sqrt(limit));
  EXPECT_GT(squared.second.to_double(), std::sqrt(limit) - tiny);
  const auto inverse = proved_range(continuity_map(four_point(Function(1) / a), 1, {{5}, {9}}, depth(10)));
  EXPECT_GT(inverse.first.to_double(), 1 / limit);
  EXPECT_LT(inverse.first.to_double(), 1 / limit + 0.05);
  EXPECT_EQ(inverse.second, Rational(9));
}

TEST(RadiusMap, MisuseIsRefused) {
  const Matrix<Function> linear = Matrix<Function>::Constant(1, 1, b);
  const ParameterBox line{{0}, {1}};
  EXPECT_THROW((void)radius_map({linear}, Rational(1), line), std::domain_error);
  EXPECT_THROW((void)radius_map({linear}, Rational(1), {{}, {}}), std::domain_error);
  EXPECT_THROW((void)radius_map({linear}, Rational(1), {{0, 0}, {1}}), std::domain_error);
  EXPECT_NO_THROW((void)radius_map({linear}, Rational(1), {{0, 0}, {1, 1}}, depth(2)));
  EXPECT_THROW((void)continuity_map(jspline(a, b), 2, {{0, 0}, {1, 1}}), std::domain_error);
  EXPECT_THROW((void)continuity_map(jspline(a, b), -1, {{0, 0}, {1, 1}}), std::domain_error);
}

}  // namespace
}  // namespace subdiv
