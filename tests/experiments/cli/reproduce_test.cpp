#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/experiments/cli/program.h"

namespace subdiv {
namespace {

using Json = nlohmann::ordered_json;

void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// A verb with the claims of the experiment "family", one of the fastest, as patterns: family.area-usually
/// belongs to another one.
std::vector<std::string> of_family(const std::string& verb, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{verb};
  for (const char* begin : {"af", "an", "b", "e", "l", "m", "n", "p", "s"})
    arguments.push_back(std::string("family.") + begin + "*");
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/// results/ in a folder of its own, with the claims of the family.
struct Reproduced {
  TemporaryFolder folder;
  ProgramRun run = run_program(of_family("reproduce"), folder.path());

  [[nodiscard]] std::filesystem::path results() const { return folder.path() / "results"; }
  [[nodiscard]] Json claims() const { return Json::parse(text_of(results() / "claims.json")); }
  void replace(const Json& claims) const { write(results() / "claims.json", claims.dump(2)); }
  [[nodiscard]] ProgramRun check() const { return run_program(of_family("check"), folder.path()); }
};

/// The text of every file below.
std::map<std::string, std::string> contents(const TemporaryFolder& folder) {
  std::map<std::string, std::string> result;
  for (const std::string& file : folder.files()) result[file] = text_of(folder.path() / file);
  return result;
}

TEST(Reproduce, PrintsTheTableAndCountsVerdictsLast) {
  const Reproduced reproduced;
  EXPECT_EQ(reproduced.run.exit_code, 0) << reproduced.run.errors;
  EXPECT_EQ(reproduced.run.errors, "") << "progress is for terminals";
  const std::string& output = reproduced.run.output;
  expect_contains(output, "family.members.four-point");
  EXPECT_TRUE(output.ends_with("\n19 claims: 16 reproduced, 1 refuted, 2 established, 0 undecided\n"))
      << output;
  EXPECT_EQ(reproduced.claims()["claims"].size(), 19U);
  expect_contains(text_of(reproduced.results() / "README.md"),
                  "*J\\_2 is a quartic B-spline scheme in disguise");
}

TEST(Reproduce, GivesTheSameBytesForAnyNumberOfJobs) {
  const TemporaryFolder one;
  const TemporaryFolder four;
  EXPECT_EQ(run_program(of_family("reproduce", {"vertex.*", "--jobs", "1"}), one.path()).exit_code, 0);
  EXPECT_EQ(run_program(of_family("reproduce", {"vertex.*", "--jobs", "4"}), four.path()).exit_code, 0);
  EXPECT_EQ(contents(one), contents(four));
}

TEST(Reproduce, ASubsetKeepsTheOtherClaims) {
  const Reproduced reproduced;
  const ProgramRun run = run_program({"reproduce", "vertex.r"}, reproduced.folder.path());
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_EQ(run.output.find("family"), std::string::npos) << "only matching claims are printed";
  expect_contains(run.output, "1 claim: 1 reproduced");
  EXPECT_GT(reproduced.claims()["claims"].size(), 19U);
  EXPECT_EQ(reproduced.claims()["claims"][0]["id"], "family.members.four-point");
  EXPECT_EQ(reproduced.check().exit_code, 0);
}

TEST(Reproduce, AChangedVerdictEndsWith1AndIsWritten) {
  const Reproduced reproduced;
  Json claims = reproduced.claims();
  claims["claims"][0]["verdict"] = "refuted";
  reproduced.replace(claims);
  const ProgramRun again = run_program(of_family("reproduce"), reproduced.folder.path());
  EXPECT_EQ(again.exit_code, 1);
  expect_contains(again.errors, "family.members.four-point: the verdict was refuted, it is now reproduced");
  EXPECT_EQ(reproduced.claims()["claims"][0]["verdict"], "reproduced");
}

TEST(Reproduce, RejectsBadPatternsAndFoldersBeforeAnythingIsWritten) {
  const TemporaryFolder folder;
  expect_rejected(run_program({"reproduce", "famly.linear"}, folder.path()),
                  {"'famly.linear'", "family.linear"});
  write(folder.path() / "file", "");
  expect_rejected(run_program(of_family("reproduce", {"--out", "file/results"}), folder.path()),
                  {"file/results", "--out"});
  expect_rejected(run_program(of_family("reproduce", {"--out", "file"}), folder.path()), {"file"});
  EXPECT_EQ(folder.files(), std::set<std::string>{"file"});
}

TEST(Reproduce, SaysSoWhenGnuplotIsMissing) {
  const TemporaryFolder folder;
  expect_rejected(run_program(of_family("reproduce"), folder.path(), "PATH=/nonexistent"),
                  {"gnuplot", "apt-get install gnuplot-nox"});
  EXPECT_TRUE(folder.files().empty());
}

TEST(Reproduce, ResultsThatDoNotParseAreKeptByASubset) {
  const Reproduced reproduced;
  write(reproduced.results() / "claims.json", "{\"claims\": [\n  oops");
  expect_rejected(run_program({"reproduce", "family.linear"}, reproduced.folder.path()),
                  {"claims.json:2:3:"});
  EXPECT_EQ(text_of(reproduced.results() / "claims.json"), "{\"claims\": [\n  oops");
}

TEST(Reproduce, AnInterruptedRunLeavesTheOldResults) {
  const Reproduced reproduced;
  const auto before = contents(reproduced.folder);
  // Every experiment takes longer than this; if not, the new claims are a superset and the test still holds
  // below.
  const ProgramRun run = run_program({"reproduce"}, reproduced.folder.path(), "timeout -s INT 0.05");
  if (run.exit_code == 0) GTEST_SKIP() << "this machine finished everything before it could be interrupted";
  EXPECT_EQ(contents(reproduced.folder), before);
}

TEST(Check, PassesOnWhatReproduceWroteAndWritesNothing) {
  const Reproduced reproduced;
  const auto before = contents(reproduced.folder);
  const ProgramRun check = reproduced.check();
  EXPECT_EQ(check.exit_code, 0);
  EXPECT_TRUE(check.output.ends_with("19 claims checked against results: 0 differences\n")) << check.output;
  EXPECT_EQ(contents(reproduced.folder), before);
}

TEST(Check, DetectsTampering) {
  const auto expect_difference = [](const std::string& message, auto tamper) {
    const Reproduced reproduced;
    Json claims = reproduced.claims();
    tamper(claims["claims"]);
    reproduced.replace(claims);
    const ProgramRun check = reproduced.check();
    EXPECT_EQ(check.exit_code, 1) << message;
    expect_contains(check.output, message);
    expect_contains(check.output, ": 1 difference\n");
  };
  expect_difference("family.linear: verdict: 'refuted' is committed, 'reproduced' is found",
                    [](Json& claims) {
                      for (Json& claim : claims) {
                        if (claim["id"] == "family.linear") claim["verdict"] = "refuted";
                      }
                    });
  expect_difference("family.members.four-point: exact value",
                    [](Json& claims) { claims[0]["value"]["exact"] = "(1)"; });
  expect_difference("family.members.four-point: is missing in claims.json",
                    [](Json& claims) { claims.erase(claims.begin()); });
  expect_difference("family.extra: stands in claims.json, but no experiment has such a claim",
                    [](Json& claims) {
                      claims.push_back(claims[0]);
                      claims.back()["id"] = "family.extra";
                    });
}

TEST(Check, RejectsResultsThatAreMissingOrDoNotParse) {
  const Reproduced reproduced;
  expect_rejected(run_program({"check", "--against", "nowhere"}, reproduced.folder.path()),
                  {"nowhere/claims.json", "subdivlab reproduce"});
  const std::string whole = text_of(reproduced.results() / "claims.json");
  write(reproduced.results() / "claims.json", whole.substr(0, whole.size() / 2));
  expect_rejected(reproduced.check(), {"claims.json:", "not valid JSON"});
  Json claims = Json::parse(whole);
  claims["claims"][2].erase("rigour");
  reproduced.replace(claims);
  expect_rejected(reproduced.check(), {"claim 3 ('family.members.quintic')", "'rigour' is missing"});
}

}  // namespace
}  // namespace subdiv
