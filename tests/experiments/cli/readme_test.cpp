#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "experiments/report/json.h"
#include "tests/experiments/cli/document.h"
#include "tests/experiments/cli/program.h"

namespace subdiv {
namespace {

const std::filesystem::path root = SUBDIVLAB_SOURCE_DIR;

const std::string readme = text_of(root / "README.md");

/// The commands "    build/subdivlab ..." of README.md that speak of a file, as arguments.
std::vector<std::vector<std::string>> commands_about(const std::string& file) {
  std::vector<std::vector<std::string>> commands;
  for (const std::string& line : lines_of(readme)) {
    const std::string prompt = "    build/subdivlab ";
    if (!line.starts_with(prompt) || line.find(file) == std::string::npos) continue;
    commands.push_back(shell_words(line.substr(prompt.size())));
  }
  return commands;
}

TEST(Readme, TheExampleSchemeWorksWithItsCommands) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "corner.json") << fenced_block(readme, "json");
  const auto commands = commands_about("corner.json");
  EXPECT_GE(commands.size(), 2U);
  for (const auto& command : commands) {
    const ProgramRun run = run_program(command, folder.path());
    EXPECT_EQ(run.exit_code, 0) << command[0] << ": " << run.errors;
  }
}

TEST(Readme, TheCertificateIsWhatTheProgramSays) {
  const auto commands = commands_about("certify");
  ASSERT_EQ(commands.size(), 1U);
  const ProgramRun run = run_program(commands[0]);
  EXPECT_EQ(run.exit_code, 0);
  int shown = 0;
  for (const std::string& line : lines_of(run.output)) {
    if (!line.starts_with("proved ") && !line.starts_with("refuted ")) continue;
    expect_contains(readme, "\n" + line + "\n");
    ++shown;
  }
  EXPECT_EQ(shown, 3);
}

TEST(Readme, CurvesAndSurfacesAreEvaluated) {
  const TemporaryFolder folder;
  std::size_t outputs = 0;
  for (std::vector<std::string> command : commands_about("experiments/data/")) {
    for (std::string& word : command) {
      if (word.starts_with("experiments/")) word.insert(0, root.string() + "/");
    }
    const ProgramRun run = run_program(command, folder.path());
    EXPECT_EQ(run.exit_code, 0) << command[0] << ": " << run.errors;
    for (const std::string& word : command)
      outputs += word == "-o" || word == "--out" || word == "--control-points" ? 1 : 0;
  }
  EXPECT_GE(outputs, 3U);
  EXPECT_EQ(folder.files().size(), outputs);
}

TEST(Readme, TheExcerptIsWhatTheResultsSay) {
  const auto claims = claims_from_json(text_of(root / "results" / "claims.json"), "results/claims.json");
  std::istringstream excerpt(fenced_block(readme, ""));
  std::string line;
  std::getline(excerpt, line);  // the header
  int rows = 0;
  while (std::getline(excerpt, line) && !line.empty()) {
    const std::string id = line.substr(0, line.find(' '));
    const auto claim =
        std::find_if(claims.begin(), claims.end(), [&](const ClaimRecord& c) { return c.id == id; });
    ASSERT_NE(claim, claims.end()) << id;
    EXPECT_TRUE(line.ends_with(" " + claim->verdict)) << line;
    expect_contains(line, value_text(*claim, 24));
    ++rows;
  }
  EXPECT_GE(rows, 5);
}

}  // namespace
}  // namespace subdiv
