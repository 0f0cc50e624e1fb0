#include <algorithm>

#include <gtest/gtest.h>

#include "tests/experiments/cli/document.h"
#include "tests/experiments/cli/program.h"

namespace subdiv {
namespace {

const std::filesystem::path root = SUBDIVLAB_SOURCE_DIR;
const std::string tutorial = text_of(root / "experiments/docs/tutorial.md");

/// A command of a console block with the lines that it is said to print, "..." for any number of them.
struct ShownCommand {
  std::string command;
  std::vector<std::string> output;
};

std::vector<ShownCommand> commands_of(const FencedBlock& block) {
  std::vector<ShownCommand> commands;
  for (const std::string& line : lines_of(block.text)) {
    if (line.starts_with("$ "))
      commands.push_back({line.substr(2), {}});
    else
      commands.back().output.push_back(line);
  }
  return commands;
}

/// The first shown line that the output does not have in its place; empty when all are there.
std::string missing_line(const std::vector<std::string>& shown, const std::vector<std::string>& printed) {
  auto at = printed.begin();
  bool skips = false;
  for (const std::string& line : shown) {
    if (line == "...") {
      skips = true;
      continue;
    }
    const auto found = skips ? std::find(at, printed.end(), line) : at;
    if (found == printed.end() || *found != line) return line;
    at = found + 1;
    skips = false;
  }
  return skips || at == printed.end() ? "" : "the end, before: " + *at;
}

TEST(Tutorial, EveryCommandPrintsWhatIsShown) {
  const TemporaryFolder folder;
  std::size_t count = 0;
  for (const FencedBlock& block : fenced_blocks(tutorial)) {
    if (block.language == "json" || block.language == "csv") {
      std::ofstream(folder.path() / block.name) << block.text << "\n";
    } else if (block.language == "console") {
      for (const ShownCommand& shown : commands_of(block)) {
        std::vector<std::string> words = shell_words(shown.command);
        ASSERT_EQ(words.at(0), "subdivlab") << shown.command;
        words.erase(words.begin());
        const ProgramRun run = run_program(words, folder.path());
        const std::string printed = run.output + run.errors;
        EXPECT_EQ(missing_line(shown.output, lines_of(printed)), "") << shown.command << " prints\n"
                                                                     << printed;
        EXPECT_EQ(run.exit_code, printed.starts_with("subdivlab: ") ? 2 : 0) << shown.command;
        ++count;
      }
    }
  }
  EXPECT_GE(count, 20U);
  for (const char* figure :
       {"basis.svg", "smoothness.svg", "curve.svg", "results/figures/ternary-smoothness.svg"})
    expect_contains(text_of(folder.path() / figure), "</svg>");
}

/// What the ctest `install` builds and runs.
TEST(Tutorial, TheExampleIsTheOneThatIsBuilt) {
  std::size_t count = 0;
  for (const FencedBlock& block : fenced_blocks(tutorial)) {
    if (block.language != "cmake" && block.language != "cpp" && block.language != "text") continue;
    EXPECT_EQ(block.text + "\n", text_of(root / "experiments/example" / block.name));
    ++count;
  }
  EXPECT_EQ(count, 3U);
}

}  // namespace
}  // namespace subdiv
