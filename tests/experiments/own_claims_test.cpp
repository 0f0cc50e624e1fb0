#include "experiments/own_claims.h"

#include <algorithm>
#include <fstream>
#include <functional>

#include <gtest/gtest.h>

#include "schemes/input_error.h"
#include "tests/experiments/temporary_folder.h"

namespace subdiv {
namespace {

/// The only claim of a file whose claim has these members.
OwnClaim claim_with(const std::string& members, const std::filesystem::path& path = "mine.json") {
  const OwnClaims own = parse_own_claims(R"({"claims": [{"id": "mine", )" + members + "}]}", path);
  return own.claims.at(0);
}

Claim settled(const std::string& members) { return settle_own(claim_with(members)); }

Verdict verdict(const std::string& members) { return settled(members).verdict; }

std::string mistakes(const std::string& text) {
  try {
    (void)parse_own_claims(text, "mine.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

void expect_part(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in:\n" << text;
}

TEST(OwnClaims, ContinuityIsReadAsPapersPrintIt) {
  const std::string cubic = R"("definition": {"name": "continuity", "scheme": "bspline:degree=3"})";
  for (const char* printed : {R"("C2")", R"("C^2")", R"("2")", "2"})
    EXPECT_EQ(verdict(std::string(R"("printed": )") + printed + ", " + cubic), Verdict::reproduced)
        << printed;
  const Claim wrong = settled(R"("printed": "C3", )" + cubic);
  EXPECT_EQ(wrong.verdict, Verdict::refuted);
  EXPECT_EQ(wrong.head.printed, "C3");
  EXPECT_EQ(wrong.note, "It is 2.");
}

TEST(OwnClaims, WithoutPrintedTextAreFindings) {
  const Claim claim = settled(R"("definition": {"name": "hoelder", "scheme": "four-point"})");
  EXPECT_EQ(claim.verdict, Verdict::established);
  EXPECT_EQ(claim.exact, "2");  // Dubuc 1986
  EXPECT_EQ(verdict(R"("definition": {"name": "smooth", "scheme": "four-point:w=w", "over": "w=0..1",
                       "continuity": 1})"),
            Verdict::established);
}

TEST(OwnClaims, DecimalsAreRoundedAndAllElseIsExact) {
  // Hechler, Moessner & Reif 2009: C1 for 0 < w < 0.19273.
  const std::string end =
      R"("definition": {"name": "smooth-range", "scheme": "four-point:w=w", "over": "w=-1..1",
                             "continuity": 1, "end": "upper"})";
  EXPECT_EQ(verdict(R"("printed": "0.19273", )" + end), Verdict::reproduced);
  EXPECT_EQ(verdict(R"("printed": "0.19272", )" + end), Verdict::refuted);
  EXPECT_EQ(verdict(R"("printed": "0.19273", "kind": "exact", )" + end), Verdict::refuted);
  EXPECT_EQ(verdict(R"("printed": "1/5", "kind": "at_most", )" + end), Verdict::reproduced);
  EXPECT_EQ(verdict(R"("printed": "1/5", "kind": "at_least", )" + end), Verdict::refuted);
}

TEST(OwnClaims, ClosedFormsAreComparedExactly) {
  // The retrofit range of J_s begins at (19 - sqrt(505))/4.
  const std::string lower =
      R"("definition": {"name": "retrofit-range", "scheme": "jspline:s=s", "end": "lower"})";
  EXPECT_EQ(verdict(R"("printed": "(19-sqrt(505))/4", )" + lower), Verdict::reproduced);
  EXPECT_EQ(verdict(R"("printed": "19/4-sqrt(505)/4", )" + lower), Verdict::reproduced);
  EXPECT_EQ(verdict(R"("printed": "(19-sqrt(506))/4", )" + lower), Verdict::refuted);
  EXPECT_EQ(verdict(R"("printed": "-0.86", )" + lower), Verdict::refuted);
}

TEST(OwnClaims, SetsAreCompared) {
  const std::string range =
      R"("definition": {"name": "smooth-range", "scheme": "four-point:w=w", "over": "w=-2..2",
                               "continuity": 0})";
  // The four-point scheme converges for -1/2 < w < 1/2 and no further.
  const Claim claim = settled(range);
  EXPECT_EQ(verdict("\"printed\": \"" + claim.exact + "\", " + range), Verdict::reproduced);
  EXPECT_EQ(verdict(R"("printed": "-3/8 < w <= 1/2", )" + range), Verdict::refuted);
  EXPECT_EQ(verdict(R"("printed": "[-3, 3]", "definition": {"name": "support", "scheme": "four-point"})"),
            Verdict::reproduced);
}

TEST(OwnClaims, MasksAreComparedOverTheirRing) {
  const std::string chaikin = R"("definition": {"name": "mask", "scheme": "bspline:degree=2"})";
  EXPECT_EQ(verdict(R"("printed": "{1/4, 3/4, 3/4, 1/4}", )" + chaikin), Verdict::reproduced);
  EXPECT_EQ(verdict(R"("printed": "1/4, 3/4, 1/4", )" + chaikin), Verdict::refuted);
  const std::string four = R"("definition": {"name": "mask", "scheme": "four-point:w=w"})";
  EXPECT_EQ(verdict(R"("printed": "-w, 0, (1+2*w)/2, 1, (1+2*w)/2, 0, -w", )" + four), Verdict::reproduced);
  EXPECT_EQ(
      verdict(
          R"("printed": "2/3", "definition": {"name": "limit-mask", "scheme": "bspline:degree=3", "index": 0})"),
      Verdict::reproduced);
  EXPECT_EQ(
      verdict(
          R"("printed": "1/6, 2/3, 1/6", "definition": {"name": "limit-mask", "scheme": "bspline:degree=3"})"),
      Verdict::reproduced);
  EXPECT_EQ(
      verdict(
          R"("printed": "-1/2, 0, 1/2", "definition": {"name": "tangent-mask", "scheme": "bspline:degree=3"})"),
      Verdict::reproduced);
}

TEST(OwnClaims, EveryOtherDefinitionAnswers) {
  // Cubic B-splines: eigenvalues 1, 1/2, 1/4, 1/8; 4 sum rules; lines are reproduced; norm 1/2 for C2 in one
  // step.
  const auto holds = [](const std::string& printed, const std::string& definition) {
    const std::string kind = printed.find('.') == std::string::npos ? "" : R"("kind": "rounded", )";
    EXPECT_EQ(verdict("\"printed\": \"" + printed + "\", " + kind + "\"definition\": {" + definition + "}"),
              Verdict::reproduced)
        << definition;
  };
  holds("1/4", R"("name": "eigenvalue", "scheme": "bspline:degree=3", "index": 2)");
  holds("4", R"("name": "sum-rules", "scheme": "bspline:degree=3")");
  holds("3", R"("name": "generation-degree", "scheme": "bspline:degree=3")");
  holds("1", R"("name": "reproduction-degree", "scheme": "bspline:degree=3")");
  holds("1/2", R"("name": "difference-norm", "scheme": "bspline:degree=3", "continuity": 2, "power": 1)");
  holds("1/4", R"("name": "difference-norm", "scheme": "bspline:degree=3", "continuity": 2, "power": 2)");
  holds("C2", R"("name": "continuity", "scheme": "bspline:degree=3", "of": "scheme")");
  holds("3.5", R"("name": "l2-exponent", "scheme": "bspline:degree=3")");
  holds("2", R"("name": "joint-spectral-radius", "scheme": "four-point")");  // 2^(4 - 1 - 2)
  holds("2", R"("name": "necessary-continuity", "scheme": "bspline:degree=3")");
  holds(
      "yes",
      R"("name": "smooth", "scheme": "four-point:w=w", "over": "w=0..1/8", "ends": "open", "continuity": 1)");
  holds(
      "0.46415",
      R"("name": "minimiser", "scheme": "jspline:s=s", "over": "s=-1..2", "objective": "area")");  // js-report
                                                                                                   // 8
  holds(
      "1/20",
      R"("name": "minimum", "scheme": "jspline:s=s", "over": "s=-1..2", "objective": "popping")");  // jsplines
                                                                                                    // 11
}

TEST(OwnClaims, EveryExampleOfTheListIsAClaim) {
  for (const Definition& definition : definitions()) {
    const OwnClaim claim = claim_with("\"definition\": " + definition.example);
    EXPECT_EQ(claim.call.definition->name, definition.name);
    expect_part(claim.head.definition, definition.summary);
    EXPECT_NE(settle_own(claim).verdict, Verdict::undecided) << definition.name;
  }
}

TEST(OwnClaims, FilesOfSchemesStandBesideTheFile) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "hat.json")
      << R"({"name": "hat", "arity": 2, "mask": {"first": -1, "coefficients": ["1/2", 1, "1/2"]}})";
  const OwnClaim claim =
      claim_with(R"("printed": "C0", "definition": {"name": "continuity", "scheme": "hat.json"})",
                 folder.path() / "mine.json");
  EXPECT_EQ(settle_own(claim).verdict, Verdict::reproduced);
}

TEST(OwnClaims, EveryMistakeIsNamedWithItsLine) {
  const std::string text = mistakes(R"({ "document": 7,
  "claims": [
    { "id": "a b", "definition": { "name": "continuty", "scheme": "four-point" } },
    { "id": "x", "printed": "2,1", "definition": { "name": "hoelder", "scheme": "four-point" } },
    { "id": "x", "definition": { "name": "smooth-range",
                                 "scheme": "four-point:w=w",
                                 "over": "v=0..1", "continuity": -1 } },
    { "definition": { "name": "hoelder", "scheme": "four-pint" } },
    { "id": "y", "kind": "bound", "printed": "1", "definition": { "name": "hoelder", "scheme": "four-point:w=w" } },
    { "id": "z", "kind": "exact", "definition": { "name": "eigenvalue", "scheme": "four-point" } },
    { "id": "u", "definition": { "name": "minimiser", "scheme": "four-point:w=w", "over": "w=0..1", "objectiv": "area" } },
    17 ] })");
  const auto named = [&](int line, const std::string& part) {
    const std::string place = "mine.json:" + std::to_string(line) + ": ";
    for (std::size_t at = text.find(place); at != std::string::npos; at = text.find(place, at + 1)) {
      if (text.substr(at, text.find('\n', at) - at).find(part) != std::string::npos) return true;
    }
    return false;
  };
  EXPECT_TRUE(named(1, "must be a text in quotes, not a number")) << text;
  EXPECT_TRUE(named(3, "'a b' must consist of letters")) << text;
  EXPECT_TRUE(named(3, "did you mean 'continuity'?")) << text;
  EXPECT_TRUE(named(4, "'2,1' is no number")) << text;
  EXPECT_TRUE(named(5, "'x' is taken already")) << text;
  EXPECT_TRUE(named(7, "\"continuity\" must be a whole number from 0")) << text;
  EXPECT_TRUE(named(8, "\"id\" is missing")) << text;
  EXPECT_TRUE(named(8, "did you mean 'four-point'?")) << text;
  EXPECT_TRUE(named(9, "leaves w free")) << text;
  EXPECT_TRUE(named(10, "needs the argument \"index\"")) << text;
  EXPECT_TRUE(named(11, "did you mean 'objective'?")) << text;
  EXPECT_TRUE(named(12, "must be an object")) << text;
}

TEST(OwnClaims, RangesKindsAndSetsAreChecked) {
  const auto wrong = [](const std::string& members) {
    return mistakes("{\"claims\": [{\"id\": \"m\", " + members + "}]}");
  };
  const std::string range =
      R"("definition": {"name": "smooth-range", "scheme": "four-point:w=w", "continuity": 1, )";
  expect_part(wrong(range + R"("over": "v=0..1"})"), "\"over\": the free parameter 'w' has no range");
  expect_part(wrong(range + R"("over": "w=1..0"})"), "the lower end must be below the upper end");
  expect_part(wrong(R"("printed": "[1; 2]", )" + range + R"("over": "w=0..1"
})"),
              "is no set of numbers");
  expect_part(wrong(R"("printed": "0.1", "kind": "rounded", )" + range + R"("over": "w=0..1"})"),
              "\"end\": \"lower\"");
  expect_part(wrong(R"("kind": "exact", )" + range + R"("over": "w=0..1"})"), "nothing is");
  expect_part(wrong(R"("printed": "1", "kind": "bound", )" + range + R"("over": "w=0..1", "end": "upper"})"),
              "The kinds are exact, rounded, at_most and at_least");
  expect_part(wrong(R"("definition": {"name": "mask", "scheme": "no.json"})"), "no such file");
  expect_part(wrong(R"("definition": "continuity")"), "must be an object such as");
  expect_part(
      wrong(
          R"("definition": {"name": "minimiser", "scheme": "jspline:s=s", "over": "s=0..1", "objective": "aera"})"),
      "did you mean 'area'?");
  expect_part(mistakes("{\"claims\": 3}"), "must be a list");
  expect_part(mistakes("[]"), "must hold an object");
  expect_part(mistakes("{}"), "\"claims\" is missing");
  expect_part(mistakes(" "), "is empty");
  expect_part(mistakes("{\"claims\": [}"), "mine.json:1");
}

TEST(OwnClaims, OneThatBreaksIsAnInputError) {
  const OwnClaim claim =
      claim_with(R"("definition": {"name": "eigenvalue", "scheme": "four-point", "index": 99})");
  EXPECT_THROW((void)settle_own(claim), InputError);
}

TEST(OwnClaims, EachIsAnExperiment) {
  const OwnClaims own = parse_own_claims(
      R"({"claims": [{"id": "a", "definition": {"name": "sum-rules", "scheme": "four-point"}}],
          "figures": [{"name": "basis", "scheme": "bspline:degree=3"}]})",
      "mine.json");
  const auto all = own_experiments(own);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].heads()[0].id, "a");
  EXPECT_EQ(all[0].run().claims.at(0).exact, "4");
  EXPECT_TRUE(all[1].heads().empty());
  const Results figure = all[1].run();
  ASSERT_EQ(figure.figures.size(), 1U);
  // The cubic B-spline at 0 is 2/3, its second derivative -2.
  const auto& rows = figure.series.at(0).rows;
  const auto middle = std::find_if(rows.begin(), rows.end(), [](const auto& row) { return row[0] == "0"; });
  ASSERT_NE(middle, rows.end());
  EXPECT_EQ((*middle)[1], "0.666666666666667");
  EXPECT_EQ((*middle)[3], "-2.00000000000000");
}

}  // namespace
}  // namespace subdiv
