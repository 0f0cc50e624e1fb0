#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/experiments/cli/program.h"

namespace subdiv {
namespace {

std::string run_shell(const std::string& command) {
  const TemporaryFolder folder;
  const std::string output = (folder.path() / "output").string();
  EXPECT_EQ(std::system((command + " > " + shell_quoted(output)).c_str()), 0) << command;
  return text_of(output);
}

bool has_shell(const std::string& name) {
  return std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) == 0;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// A folder with the script of a shell, two polygons, a scheme file and a folder.
class Completed : public testing::Test {
 protected:
  void load(const std::string& shell) {
    const ProgramRun script = run_program({"completion", shell});
    ASSERT_EQ(script.exit_code, 0) << script.errors;
    std::ofstream(folder_.path() / "script") << script.output;
    for (const char* name : {"square.csv", "star.csv", "mine.json"})
      std::ofstream(folder_.path() / name) << "\n";
    std::filesystem::create_directory(folder_.path() / "results");
  }

  /// What bash is offered at the end of the line; what it has parted off at = and : is not repeated.
  [[nodiscard]] std::vector<std::string> in_bash(const std::string& arguments) const {
    const std::string line = shell_quoted(std::string(SUBDIVLAB_PROGRAM) + " " + arguments);
    const std::string script = "cd " + shell_quoted(folder_.path().string()) +
                               "; source ./script; COMP_LINE=" + line +
                               "; COMP_POINT=${#COMP_LINE}; _subdivlab; printf '%s\\n' \"${COMPREPLY[@]}\"";
    return lines_of(run_shell("bash --norc -c " + shell_quoted(script)));
  }

  [[nodiscard]] std::vector<std::string> in_fish(const std::string& line) const {
    const std::string script = "cd " + shell_quoted(folder_.path().string()) +
                               "; source script; complete -C " + shell_quoted("subdivlab " + line);
    std::vector<std::string> lines = lines_of(run_shell("fish --no-config -c " + shell_quoted(script)));
    for (std::string& candidate : lines) candidate = candidate.substr(0, candidate.find('\t'));
    return lines;
  }

  TemporaryFolder folder_;
};

using Words = std::vector<std::string>;

TEST_F(Completed, BashKnowsEveryVerbAndTheOptionsOfEach) {
  load("bash");
  Words verbs = in_bash("");
  EXPECT_EQ(in_bash("rep"), Words{"reproduce"});
  verbs.resize(verbs.size() - 2);  // --help --version
  ASSERT_GE(verbs.size(), 14U);
  for (const std::string& verb : verbs) {
    const std::string help = run_program({verb, "--help"}).output;
    const Words options = in_bash(verb + " --");
    EXPECT_TRUE(std::find(options.begin(), options.end(), "--help") != options.end()) << verb;
    for (const std::string& option : options) expect_contains(help, option);
  }
  EXPECT_EQ(in_bash("analyze jspline:s=1 --b"), Words{"--budget"});
}

TEST_F(Completed, BashKnowsTheValuesOfOptions) {
  load("bash");
  EXPECT_EQ(in_bash("optimize jspline:s=s --norm l"), (Words{"l1", "l2", "linf"}));
  EXPECT_EQ(in_bash("optimize jspline:s=s --norm=l"), (Words{"l1", "l2", "linf"}));
  EXPECT_EQ(in_bash("refine jspline:s=1 star.csv --open "), (Words{"clamped", "reflected"}));
  EXPECT_EQ(in_bash("list s"), Words{"schemes"});
  EXPECT_EQ(in_bash("completion "), (Words{"bash", "zsh", "fish"}));
  EXPECT_EQ(in_bash("reproduce --out "), Words{"results"});
  EXPECT_EQ(in_bash("reproduce --out=re"), Words{"results"});
  EXPECT_EQ(in_bash("measure st"), Words{"star.csv"});
  EXPECT_EQ(in_bash("measure square.csv --against st"), Words{"star.csv"});
  EXPECT_EQ(in_bash("certify jspline:s=s --continuity "), Words{""});
}

TEST_F(Completed, BashKnowsSchemesClaimsAndObjectives) {
  load("bash");
  EXPECT_EQ(in_bash("analyze jsp"), (Words{"jspline:s=", "jspline:a="}));
  EXPECT_EQ(in_bash("analyze jspline:"), (Words{"s=", "a="}));
  EXPECT_EQ(in_bash("analyze jspline:s=1/2+bspl"), Words{"1/2+bspline:degree="});
  EXPECT_EQ(in_bash("analyze mi"), Words{"mine.json"});
  EXPECT_EQ(in_bash("eigen catm"), Words{"catmull-clark"});
  EXPECT_EQ(in_bash("analyze catm"), Words{""});
  EXPECT_EQ(in_bash("refine catm"), Words{"catmull-clark"});
  EXPECT_EQ(in_bash("refine --scheme loop squ"), Words{"square.csv"});
  EXPECT_EQ(in_bash("optimize jspline:s=s --objective fit-bspline:d"), Words{"degree="});
  EXPECT_EQ(in_bash("check area.exact.e"), Words{"area.exact.exists"});
  EXPECT_EQ(in_bash("check vertex.r area.exact.e"), Words{"area.exact.exists"});
  const auto claims = nlohmann::json::parse(run_program({"list", "claims", "--json"}).output)["claims"];
  EXPECT_EQ(in_bash("reproduce ").size(), claims.size());
}

TEST_F(Completed, SchemeBeginningsAreAllFamilies) {
  load("bash");
  std::set<std::string> names;
  for (const std::string& word : in_bash("refine ")) names.insert(word.substr(0, word.find(':')));
  const auto schemes = nlohmann::json::parse(run_program({"list", "schemes", "--json"}).output)["schemes"];
  for (const auto& scheme : schemes) {
    EXPECT_TRUE(names.contains(scheme["name"])) << scheme["name"];
    for (const auto& alias : scheme["aliases"]) EXPECT_TRUE(names.contains(alias)) << alias;
  }
}

TEST_F(Completed, FishOffersTheSame) {
  if (!has_shell("fish")) GTEST_SKIP() << "there is no fish";
  load("fish");
  EXPECT_EQ(in_fish("repr"), Words{"reproduce"});
  EXPECT_EQ(in_fish("optimize jspline:s=s --norm l"), (Words{"l1", "l2", "linf"}));
  EXPECT_EQ(in_fish("analyze jspline:s=1/2+bspl"), Words{"jspline:s=1/2+bspline:degree="});
  EXPECT_EQ(in_fish("measure st"), Words{"star.csv"});
  EXPECT_EQ(in_fish("completion "), (Words{"bash", "fish", "zsh"}));
}

TEST_F(Completed, ZshReadsItsScript) {
  if (!has_shell("zsh")) GTEST_SKIP() << "there is no zsh";
  load("zsh");
  run_shell("zsh -n " + shell_quoted((folder_.path() / "script").string()));
  const std::string script = text_of(folder_.path() / "script");
  for (const char* part : {"#compdef subdivlab", "'reproduce:Run experiments", "(l1 l2 linf)", "jspline:s="})
    expect_contains(script, part);
}

TEST(Completion, UnknownShellsAreRefused) {
  expect_rejected(run_program({"completion", "tcsh"}), {"tcsh", "bash"});
}

}  // namespace
}  // namespace subdiv
