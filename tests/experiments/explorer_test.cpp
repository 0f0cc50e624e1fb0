#include <array>
#include <cmath>
#include <filesystem>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/area_mask.h"
#include "analysis/hoelder.h"
#include "analysis/limit_points.h"
#include "analysis/three_tap_smoothness.h"
#include "experiments/explorer/curve.h"
#include "experiments/explorer/explorer.h"
#include "experiments/explorer/facts.h"
#include "experiments/explorer/presets.h"
#include "experiments/report/files.h"
#include "experiments/report/folder.h"
#include "experiments/report/html_explorer.h"
#include "schemes/evaluate/ringing.h"
#include "schemes/jspline.h"

namespace subdiv::explorer {
namespace {

using Points = std::vector<std::pair<Rational, Rational>>;

const std::filesystem::path source_root{SUBDIVLAB_SOURCE_DIR};
Rational q(const char* text) { return Rational::parse(text); }

const ResultsFolder& committed() {
  static const ResultsFolder folder = load_results(source_root / "results");
  return folder;
}

/// The facts of the committed results, as the page gets them.
const Facts& facts() {
  static const Facts all = [] {
    ReportSource source{{}, committed().claims, &committed().manifest, {}, {}};
    source.series = [](const std::string& name) {
      return read_file(series_path(source_root / "results", name));
    };
    return parse_facts(explorer_facts(source));
  }();
  return all;
}

Algebraic tap(const Rational& s) { return Algebraic((s - Rational(1)) / Rational(2)); }

// ---- Exponents and continuity, against the exact route
// -----------------------------------------------------

TEST(ExplorerExponent, LogarithmsAndRootsAreEnclosed) {
  for (const char* text : {"1/3", "3", "1311/1000", "1/1000000007", "5/4", "7", "1000000007/3"}) {
    const Rational x = q(text);
    const Bracket log = log2_bracket(x);
    EXPECT_LT(log.lower, log.upper) << text;
    EXPECT_LT(log.upper - log.lower, Rational::power_of_two(-50)) << text;
    const Enclosure known = minus_log2(0, Algebraic(x));
    EXPECT_LE(log.lower, -known.lower) << text;
    EXPECT_GE(log.upper, -known.upper) << text;
    const Bracket root = sqrt_bracket(x);
    EXPECT_LE(root.lower * root.lower, x) << text;
    EXPECT_GE(root.upper * root.upper, x) << text;
    EXPECT_LT(root.upper - root.lower, Rational::power_of_two(-90)) << text;
  }
  EXPECT_EQ(log2_bracket(q("1/8")).lower, Rational(-3));
  EXPECT_TRUE(log2_bracket(q("1/8")).is_exact());
  EXPECT_TRUE(sqrt_bracket(q("9/4")).is_exact());
  EXPECT_THROW((void)log2_bracket(Rational(0)), std::domain_error);
}

TEST(ExplorerExponent, IsThatOfTheExactClosedForm) {
  for (Rational s(-59, 10); s < Rational(10); s += Rational(3, 20)) {
    const auto exponent = jspline_exponent(s);
    ASSERT_TRUE(exponent.has_value()) << s.to_string();
    const Enclosure known = three_tap_exponent(4, tap(s));
    EXPECT_LE(exponent->value.lower, known.upper) << s.to_string();
    EXPECT_GE(exponent->value.upper, known.lower) << s.to_string();
    EXPECT_EQ(exponent->value.is_exact(), known.lower == known.upper) << s.to_string();
  }
  for (const char* s : {"0", "1", "3/2", "2", "3", "5", "-2", "6", "7/4", "1.27", "9.9999"}) {
    const auto exponent = jspline_exponent(q(s));
    const Enclosure known = three_tap_exponent(4, tap(q(s)));
    EXPECT_TRUE(exponent->value.lower <= known.upper && known.lower <= exponent->value.upper) << s;
  }
  EXPECT_EQ(jspline_exponent(q("3/2"))->formula, "5");
  EXPECT_FALSE(jspline_exponent(Rational(-6)).has_value());
  EXPECT_FALSE(jspline_exponent(Rational(10)).has_value());
}

TEST(ExplorerContinuity, OfOneParameterIsExactUpToTheEnds) {
  const Rational hair(1, 1000000);
  for (const char* end : {"-6", "-2", "0", "1", "3/2", "2", "3", "4", "6", "10"}) {
    for (const Rational& s : {q(end) - hair, q(end), q(end) + hair}) {
      const Continuity known = continuity(facts(), s, s);
      const int exact = three_tap_continuity(4, tap(s));
      EXPECT_EQ(known.proved, exact) << s.to_string();
      EXPECT_EQ(known.refuted, exact + 1) << s.to_string();
      EXPECT_FALSE(known.reason.empty()) << s.to_string();
    }
  }
}

TEST(ExplorerContinuity, OfTwoParametersNeverContradictsTheGeneralAlgorithm) {
  int decided = 0;
  const std::vector<std::array<const char*, 2>> places{
      {"1", "1/2"}, {"0", "1"},      {"2", "3"},      {"2", "6"},          {"2", "8"},    {"1/2", "3/2"},
      {"-1", "2"},  {"3", "-1"},     {"3", "4"},      {"7/2", "2"},        {"1/3", "1"},  {"5", "1"},
      {"-3", "5"},  {"7/5", "31/5"}, {"5/4", "13/2"}, {"-1/100", "1/100"}, {"19/10", "6"}};
  for (const auto& [first, second] : places) {
    const Rational a = q(first);
    const Rational b = q(second);
    const std::string where = std::string(first) + ", " + second;
    const Continuity known = continuity(facts(), a, b);
    const Smoothness exact = smoothness_report(normal_form(jspline(a, b))).limits;
    EXPECT_LE(known.proved, exact.continuity) << where;
    if (known.refuted >= 0) {
      EXPECT_GT(known.refuted, exact.continuity_limit) << where;
    }
    const ExponentBounds bounds = exponent_bounds(facts(), a, b);
    if (bounds.lower) {
      EXPECT_LE(*bounds.lower, exact.exponent.upper) << where;
    }
    if (bounds.upper) {
      EXPECT_GE(*bounds.upper, exact.exponent.lower) << where;
    }
    if (known.refuted == known.proved + 1) ++decided;
  }
  EXPECT_GE(decided, 8);
}

TEST(ExplorerFacts, ComeFromTheCommittedResults) {
  EXPECT_EQ(facts().ranges.size(), 5U);
  EXPECT_EQ(facts().lines.size(), 4U);
  EXPECT_TRUE(facts().c2_is_decided);
  // The cells are those of the maps: they and the undecided ones fill the boxes, which have 357 and 165
  // units.
  for (const auto& [order, total] : {std::pair{0, Rational(357)}, std::pair{1, Rational(165)}}) {
    Rational area(0);
    for (const Facts::Cell& cell : facts().cells) {
      if (cell.order == order) area += (cell.a[1] - cell.a[0]) * (cell.b[1] - cell.b[0]);
    }
    EXPECT_LT(area, total);
    EXPECT_GT(area, total * Rational(95, 100));
  }
}

TEST(ExplorerFacts, WithoutClaimsNothingIsKnown) {
  const Facts none = parse_facts("");
  EXPECT_EQ(continuity(none, Rational(1), Rational(1)).proved, -1);
  EXPECT_EQ(continuity(none, Rational(1), Rational(2)).refuted, -1);
  for (const char* wrong : {"range 2 0", "rang 2 0 4 x", "range x 0 4 x", "cell 1 in 0 1 0"})
    EXPECT_THROW((void)parse_facts(wrong), std::invalid_argument) << wrong;
}

// ---- Curves
// ------------------------------------------------------------------------------------------------

const char* const heptagon =
    "point 10 4\npoint 6 3\npoint 1 1\npoint 5 4\npoint -5 3\npoint -10 5\npoint 2 -1\n";
const Points heptagon_points{{10, 4}, {6, 3}, {1, 1}, {5, 4}, {-5, 3}, {-10, 5}, {2, -1}};

Curve curve(const std::string& request) { return evaluate(parse_request(request + heptagon), true); }

TEST(ExplorerCurve, PointsAreThoseOfExactRinging) {
  const Curve drawn = curve("levels 5\nstep -7/4 59/52\nstep 3/2 3/2\n");
  const Scheme<Rational> scheme =
      mixed(stationary("J", jspline(q("-7/4"), q("59/52"))), stationary("J", jspline(q("3/2"))));
  std::vector<Rational> x;
  std::vector<Rational> y;
  for (const auto& [px, py] : heptagon_points) {
    x.push_back(px);
    y.push_back(py);
  }
  for (int c = 0; c < 2; ++c) {
    const auto controls = closed_polygon(c == 0 ? x : y);
    Ringing<Rational, Rational> rings(scheme, controls, 5);
    std::size_t i = 0;
    for (const Rational& exact : rings) {
      EXPECT_NEAR(drawn.curve.coordinates[static_cast<std::size_t>(c)].at(i++), exact.to_double(), 1e-13);
    }
    EXPECT_EQ(i, drawn.curve.topology.points);
  }
}

TEST(ExplorerCurve, AreasAreThoseOfTheExactMask) {
  const Curve drawn = curve("levels 6\nstep 0.836 0.836\nstep -0.531 -0.531\n");
  const Scheme<Rational> scheme =
      mixed(stationary("J", jspline(q("0.836"))), stationary("J", jspline(q("-0.531"))));
  const Rational exact = area<Rational>(area_mask(scheme), heptagon_points);
  EXPECT_NEAR(*drawn.limit_area, exact.to_double(), 1e-11);
  EXPECT_NEAR(*drawn.polygon_area, 33, 1e-12);
  EXPECT_NEAR(*drawn.area, *drawn.limit_area, 0.02);  // areas converge
}

TEST(ExplorerCurve, RetrofittedLimitsPassThroughThePoints) {
  for (const char* steps : {"step 3/2 3/2\n", "step 1/4 1/4\n", "step 2/3 2/3\nstep 1 1\n"}) {
    const Curve drawn = curve(std::string("levels 3\nretrofit\n") + steps);
    const Scheme<double> scheme =
        double_scheme(parse_request("levels 0\n" + std::string(steps) + heptagon).steps);
    const Laurent<double> mask = vertex_limit_mask(scheme);
    for (std::size_t c = 0; c < 2; ++c) {
      const auto polygon = closed_polygon(drawn.polygon.coordinates[c]);
      for (std::size_t i = 0; i < heptagon_points.size(); ++i) {
        const Rational& given = c == 0 ? heptagon_points[i].first : heptagon_points[i].second;
        EXPECT_NEAR(apply_mask(mask, polygon, static_cast<long long>(i)), given.to_double(), 1e-10) << steps;
      }
    }
  }
  EXPECT_THROW((void)evaluate(
                   parse_request("retrofit\nstep 2 2\npoint 0 0\npoint 4 0\npoint 4 4\npoint 0 4\n"), false),
               std::domain_error);  // s = 2 is singular for an even number of points
}

TEST(ExplorerCurve, ClosedFormsOfASquare) {
  const Curve drawn =
      evaluate(parse_request("levels 0\nstep 1 1\npoint 0 0\npoint 4 0\npoint 4 4\npoint 0 4\n"), true);
  EXPECT_DOUBLE_EQ(*drawn.area, 16);
  EXPECT_EQ(drawn.curvature.size(), 4U);
  EXPECT_NEAR(drawn.curvature[0], 1 / std::sqrt(8.0), 1e-15);  // the circle through the corners
  // Area of a closed uniform cubic B-spline: m_1 = 245/720 .., by its own mask; the square's cross sums are
  // 32, 0.
  const Laurent<Rational> mask = area_mask(stationary("J", jspline(Rational(1))));
  const Rational expected = Rational(32) * (mask[1] - mask[3] + mask[5]);
  EXPECT_NEAR(*drawn.limit_area, expected.to_double(), 1e-13);
}

TEST(ExplorerCurve, OpenCurvesEndAtTheirLastPoints) {
  const Curve drawn = curve("levels 4\nopen\nstep 1 1\n");
  EXPECT_EQ(drawn.curve.topology.points, 6U * 16 + 1);
  EXPECT_NEAR(drawn.curve.coordinates[0].front(), 10, 1e-12);
  EXPECT_NEAR(drawn.curve.coordinates[0].back(), 2, 1e-12);
  EXPECT_FALSE(drawn.area.has_value());
  EXPECT_EQ(drawn.curvature.size(), drawn.curve.topology.points);
}

TEST(ExplorerCurve, RefusesWhatItCannotDraw) {
  for (const char* wrong : {"step 1 1\npoint 0 0\npoint 1 1\n", "point 0 0\npoint 1 1\npoint 2 0\n",
                            "step x 1\npoint 0 0\npoint 1 1\npoint 2 0\n",
                            "levels 11\nstep 1 1\npoint 0 0\npoint 1 1\npoint 2 0\n",
                            "open\nretrofit\nstep 1 1\npoint 0 0\npoint 1 1\npoint 2 0\n",
                            "step 1 1\npoint 0 1e300\npoint 1 1\npoint 2 0\n", "bend 3\n"}) {
    EXPECT_THROW((void)parse_request(wrong), std::invalid_argument) << wrong;
  }
}

// ---- Presets and the interface of C
// ------------------------------------------------------------------------

TEST(ExplorerPresets, NameClaimsThatExistAndHaveTheirExponents) {
  for (const Preset& preset : presets()) {
    std::vector<Step> steps;
    for (const auto& step : preset.steps) {
      ASSERT_TRUE(step.size() == 1 || step.size() == 2) << preset.name;
      steps.push_back({Rational::parse(step.front()), Rational::parse(step.back())});
    }
    for (const std::string& id : preset.claims) {
      const auto claim = std::ranges::find(committed().claims, id, &ClaimRecord::id);
      ASSERT_NE(claim, committed().claims.end()) << id;
      if (!id.starts_with("smooth.named.")) continue;
      const ExponentBounds bounds = exponent_bounds(facts(), steps.back().a, steps.back().b);
      EXPECT_LE(*bounds.lower, Rational::parse(*claim->upper)) << id;
      EXPECT_GE(*bounds.upper, Rational::parse(*claim->lower)) << id;
    }
  }
}

TEST(ExplorerPresets, EveryNamedCurveIsAmongThem) {
  std::set<std::string> ids;
  for (const Preset& preset : presets()) ids.insert(preset.claims.begin(), preset.claims.end());
  for (const ClaimRecord& claim : committed().claims) {
    if (claim.id.starts_with("smooth.named.") && claim.id != "smooth.named.four-point.tension") {
      EXPECT_TRUE(ids.contains(claim.id)) << claim.id;
    }
  }
}

TEST(ExplorerInterface, AnswersInJson) {
  const auto reply = [](const char* text) { return nlohmann::json::parse(text); };
  EXPECT_TRUE(reply(explorer_set_facts("range 2 0 4 x\n")).empty());
  EXPECT_TRUE(reply(explorer_set_facts("\"nonsense\\")).contains("error"));
  const auto drawn = reply(explorer_evaluate((std::string("levels 2\nstep 1 1\n") + heptagon).c_str(), 1));
  EXPECT_EQ(drawn["points"], 28);
  EXPECT_EQ(explorer_size(0), 28);
  EXPECT_EQ(explorer_size(7), 0);
  EXPECT_NE(explorer_array(1), nullptr);
  EXPECT_EQ(reply(explorer_number(" 3/8 "))["value"], "3/8");
  EXPECT_EQ(reply(explorer_number("0.375"))["value"], "3/8");
  EXPECT_TRUE(reply(explorer_number("three")).contains("error"));
  const auto smooth = reply(explorer_smoothness("0.476", "0.476"));
  EXPECT_EQ(smooth["proved"], 2);
  EXPECT_EQ(smooth["exponent"]["formula"], "3-log2(381/250)");
}

TEST(ExplorerPage, IsWholeAndNamesNoOtherPlace) {
  ReportSource source{{}, committed().claims, &committed().manifest, {}, {}};
  source.series = [](const std::string& name) {
    return read_file(series_path(source_root / "results", name));
  };
  const std::string page = explorer_page(source);
  for (const char* part :
       {"WebAssembly", "id=\"plane\"", "range 2 0 4 smooth.exact.c2.lower", "figure-shape"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  for (const char* elsewhere : {"src=\"http", "href=\"http", "url(http"})
    EXPECT_EQ(page.find(elsewhere), std::string::npos) << elsewhere;
  EXPECT_EQ(page, explorer_page(source));
}

}  // namespace
}  // namespace subdiv::explorer
