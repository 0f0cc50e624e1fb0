#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>
#include <string>

#include "tests/experiments/cli/program.h"

namespace subdiv {
namespace {

using Json = nlohmann::ordered_json;
using Strings = std::vector<std::string>;

double number(const Json& text) { return std::stod(text.get<std::string>()); }

Json eigen(const std::string& scheme, const std::string& valence, const Strings& more = {}) {
  Strings arguments{"eigen", scheme, "--valence", valence, "--json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const ProgramRun run = run_program(arguments);
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  return Json::parse(run.output);
}

TEST(Eigen, CatmullClarkHasItsClosedForm) {
  // Doo & Sabin 1978, Ball & Storry 1988: (5 + c + sqrt((c + 9)(c + 1)))/16, c = cos(2 pi/n).
  const Json records = eigen("catmull-clark", "3..12");
  ASSERT_EQ(records.size(), 10U);
  for (const Json& record : records) {
    const double c = std::cos(2 * std::numbers::pi / record["valence"].get<int>());
    const double lambda = (5 + c + std::sqrt((c + 9) * (c + 1))) / 16;
    EXPECT_LE(number(record["subdominant"]["lower"]), lambda + 1e-15);
    EXPECT_GE(number(record["subdominant"]["upper"]), lambda - 1e-15);
    EXPECT_LT(number(record["next"]["upper"]), lambda);
    EXPECT_EQ(record["condition"], true);
    EXPECT_EQ(record["rigour"], "certified");
    EXPECT_EQ(record["characteristic_map"]["regular"], true);
    EXPECT_EQ(record["characteristic_map"]["injective"], true);
    EXPECT_EQ(record["characteristic_map"]["rigour"], "certified");
    EXPECT_EQ(record["parameters"], Json::object());
  }
}

TEST(Eigen, ModesListEveryEigenvalueOnceWithItsMultiplicity) {
  const Json record = eigen("jspline-mesh:s=1/2", "5")[0];
  EXPECT_EQ(record["parameters"], Json({{"s", "1/2"}}));
  ASSERT_EQ(record["eigenvalues"].size(), 3U);  // modes 0, 1, 2
  for (const Json& mode : record["eigenvalues"]) {
    int count = 0;
    for (const Json& value : mode["values"]) count += value["multiplicity"].get<int>();
    EXPECT_EQ(count, mode["mode"] == 0 ? 13 : 12);  // three rings: 2 + 4 + 6 places a sector
  }
}

TEST(Eigen, ButterflyFailsAtThreeAndFromEightOn) {  // notes 5
  const Json records = eigen("butterfly", "3..9");
  for (const Json& record : records) {
    const int n = record["valence"].get<int>();
    EXPECT_EQ(record["condition"], n >= 4 && n <= 7) << n;
  }
  EXPECT_EQ(records[0]["characteristic_map"]["regular"], nullptr);
  EXPECT_EQ(records[5]["characteristic_map"]["mode"], 2);
  EXPECT_EQ(records[5]["characteristic_map"]["injective"], false);
}

TEST(Eigen, LoopsOwnWeightsHaveIrrationalCosines) {
  const Json record = eigen("loop-1987", "5")[0];
  const double lambda = 3.0 / 8 + std::cos(2 * std::numbers::pi / 5) / 4;
  EXPECT_NEAR(number(record["subdominant"]["lower"]), lambda, 1e-15);
  EXPECT_NEAR(number(record["next"]["upper"]), lambda * lambda, 1e-5) << "mode 0 has its square";
  EXPECT_EQ(record["condition"], true);
}

TEST(Eigen, AdjustableSpeedAtTheRegularVertexIsTheSpline) {
  // Knot insertion along one line has the eigenvalues 1, q, q^2, q^3, ..; the B-spline at the knot 0 is
  // 1/(1 + q), with q/2/(1 + q) for each neighbour (Karciauskas & Peters 2009, (13), t_3).
  const Json record = eigen("adjustable-speed:sigma=3/4", "4")[0];
  EXPECT_EQ(record["parameters"], Json({{"sigma", "3/4"}}));
  EXPECT_EQ(record["limit_stencil"], Json({{"alpha", "16/25"}, {"beta", "8/25"}, {"gamma", "1/25"}}));
  EXPECT_EQ(number(record["subdominant"]["lower"]), 0.25);
  EXPECT_EQ(number(record["next"]["upper"]), 0.0625);
  EXPECT_EQ(record["condition"], true);
}

TEST(Eigen, AdjustableSpeedAtExtraordinaryVertices) {
  const Json record = eigen("adjustable-speed:sigma=3/4", "5")[0];
  const double q = 0.25;
  const double d = 1 + std::cos(2 * std::numbers::pi / 5);
  const double s = 0.75;  // (8)
  const double lambda = q / 2 * (d * s * s + 2 * q + s * std::sqrt(d * (d * s * s + 4 * q)));
  EXPECT_NEAR(number(record["subdominant"]["lower"]), lambda, 1e-16);
  EXPECT_EQ(record["condition"], true);
  EXPECT_EQ(record["characteristic_map"]["regular"], true);
  EXPECT_EQ(record["characteristic_map"]["injective"], true);
  EXPECT_EQ(record["characteristic_map"]["rigour"], "certified");
  const Json whole = eigen("adjustable-speed:sigma=s", "3", {"--over", "s=1/3..2/3"})[0];
  EXPECT_EQ(whole["condition"], true);
  // Decided cells are rounded inwards.
  EXPECT_EQ(whole["cells"][0]["lower"], "0.333333333333333334");
  EXPECT_EQ(whole["cells"][0]["upper"], "0.666666666666666666");
}

TEST(Eigen, SpeedsNearTheEndsKeepTheirDigits) {
  const Json record = eigen("adjustable-speed:sigma=0.99999999999999999999", "5")[0];  // q = 1e-20
  const double limit = 1e-20 * (1 + std::cos(2 * std::numbers::pi / 5));               // (8) for q to 0
  EXPECT_NEAR(number(record["subdominant"]["lower"]) / limit, 1, 1e-14);
  EXPECT_EQ(record["rigour"], "certified");
  const ProgramRun run =
      run_program({"eigen", "adjustable-speed:sigma=0.99999999999999999999", "--valence", "5"});
  expect_contains(run.output, "e-20");
  for (const std::size_t nines : {40U, 100U}) {
    const Json map =
        eigen("adjustable-speed:sigma=0." + std::string(nines, '9'), "5")[0]["characteristic_map"];
    EXPECT_EQ(map["regular"], true);
    EXPECT_EQ(map["injective"], true);
    EXPECT_EQ(map["rigour"], "certified");
  }
}

TEST(Eigen, SpeedsOutsideAreRefused) {
  for (const std::string sigma : {"0", "1", "2", "-1/2", "sqrt(2)"}) {
    const ProgramRun run = run_program({"eigen", "adjustable-speed:sigma=" + sigma, "--valence", "5"});
    EXPECT_EQ(run.exit_code, 2) << sigma;
    expect_contains(run.errors, "strictly between 0 and 1");
  }
  for (const std::string range : {"s=0..1/2", "s=1/2..1", "s=-1..1/2"}) {
    const ProgramRun run =
        run_program({"eigen", "adjustable-speed:sigma=s", "--valence", "5", "--over", range});
    EXPECT_EQ(run.exit_code, 2) << range;
    expect_contains(run.errors, "strictly between 0 and 1");
  }
  const ProgramRun refined =
      run_program({"refine", "adjustable-speed:sigma=1/2", "mesh.obj", "--levels", "1", "-o", "out.obj"});
  EXPECT_EQ(refined.exit_code, 2);
  expect_contains(refined.errors, "subdivlab rings");
}

TEST(Eigen, RangesAreCutWhereTheAnswerChanges) {
  const Json record = eigen("jspline-mesh:s=s", "3", {"--over", "s=-2..6"})[0];
  EXPECT_EQ(record["condition"], nullptr);
  ASSERT_EQ(record["cells"].size(), 5U);
  EXPECT_EQ(record["cells"][0]["condition"], false);
  EXPECT_EQ(record["cells"][2]["condition"], true);
  EXPECT_EQ(record["cells"][4]["condition"], false);
  EXPECT_EQ(record["cells"][1]["condition"], nullptr);
  // Beside the ends, single values agree.
  EXPECT_LT(number(record["cells"][2]["lower"]), -0.35);
  EXPECT_EQ(eigen("jspline-mesh:s=-9/25", "3")[0]["condition"], false);
  EXPECT_EQ(eigen("jspline-mesh:s=-1/3", "3")[0]["condition"], true);
  EXPECT_EQ(eigen("jspline-mesh:s=s", "3", {"--over", "s=-1/4..3/2"})[0]["condition"], true);
}

TEST(Eigen, TheTableSaysTheSame) {
  const ProgramRun run = run_program({"eigen", "loop", "--valence", "3..4"});
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  expect_contains(run.output, "sub-dominant");
  expect_contains(run.output, "regular, injective (certified)");
}

TEST(Eigen, BadInputIsNamed) {
  const auto errors = [](const Strings& arguments) {
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.exit_code, 2) << run.output;
    EXPECT_TRUE(run.output.empty());
    return run.errors;
  };
  for (const char* valence : {"2", "0..5", "3..", "..5", "7..3", "x", "3..1001", "-3", "3...5", "3.5"})
    expect_contains(errors({"eigen", "loop", std::string("--valence=") + valence}), "--valence");
  expect_contains(errors({"eigen", "looop", "--valence", "3"}), "did you mean");
  expect_contains(errors({"eigen", "jspline:s=1", "--valence", "3"}), "curves");
  expect_contains(errors({"eigen", "jspline-mesh:s=s", "--valence", "3"}), "--over s=LO..HI");
  expect_contains(errors({"eigen", "loop", "--valence", "3", "--over", "s=0..1"}), "no free parameter");
  expect_contains(errors({"eigen", "jspline-mesh:s=sqrt(2)", "--valence", "3"}), "rational");
}

}  // namespace
}  // namespace subdiv
