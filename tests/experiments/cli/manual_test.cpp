#include <cstdlib>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/experiments/cli/program.h"

namespace subdiv {
namespace {

using Names = std::set<std::string>;

const std::filesystem::path docs = std::filesystem::path(SUBDIVLAB_SOURCE_DIR) / "experiments/docs";

/// What a line of a help begins with behind its indentation: names before the first gap.
Names names_in(const std::string& line) {
  Names names;
  const std::regex name("--?[A-Za-z][A-Za-z-]*");
  const std::string head = line.substr(0, line.find("  ", 2));
  for (std::sregex_iterator i(head.begin(), head.end(), name), end; i != end; ++i) names.insert(i->str());
  return names;
}

/// The options that `subdivlab VERB --help` lists.
Names options_of_help(const std::string& verb) {
  std::istringstream help(run_program({verb, "--help"}).output);
  Names options;
  bool listed = false;
  for (std::string line; std::getline(help, line);) {
    if (line == "Options:") listed = true;
    if (line.empty()) listed = false;
    if (listed && line.starts_with("  -")) options.merge(names_in(line));
  }
  options.erase("--help");  // said once for all verbs
  options.erase("-h");
  return options;
}

Names verbs_of_help() {
  std::istringstream help(run_program({"--help"}).output);
  Names verbs;
  bool listed = false;
  for (std::string line; std::getline(help, line);) {
    if (listed && line.starts_with("  ") && line[2] != ' ')
      verbs.insert(line.substr(2, line.find(' ', 2) - 2));
    if (line == "Subcommands:") listed = true;
    if (line.empty()) listed = false;
  }
  return verbs;
}

/// The verbs of the manual's section VERBS, each with the options that have an entry there.
std::map<std::string, Names> verbs_of_manual() {
  std::istringstream page(text_of(docs / "subdivlab.1"));
  std::map<std::string, Names> verbs;
  std::string verb;
  bool in_verbs = false;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with(".Sh ")) in_verbs = line == ".Sh VERBS";
    if (!in_verbs) continue;
    if (line.starts_with(".Ss ")) verbs[verb = line.substr(4)];
    if (!line.starts_with(".It Fl ")) continue;
    const std::regex flag("Fl (-?[A-Za-z][A-Za-z-]*)");
    for (std::sregex_iterator i(line.begin(), line.end(), flag), end; i != end; ++i)
      verbs[verb].insert("-" + (*i)[1].str());
  }
  return verbs;
}

TEST(Manual, SaysEveryVerbAndOptionThatTheHelpsName) {
  const std::map<std::string, Names> manual = verbs_of_manual();
  const Names verbs = verbs_of_help();
  ASSERT_GE(verbs.size(), 14U);
  for (const std::string& verb : verbs) {
    ASSERT_TRUE(manual.contains(verb)) << verb;
    EXPECT_EQ(manual.at(verb), options_of_help(verb)) << verb;
  }
  EXPECT_EQ(manual.size(), verbs.size());
}

/// Pages under experiments/docs are what the program prints: `cmake --build build --target pages` writes
/// them.
TEST(Manual, PagesInTheSourcesAreThoseOfTheProgram) {
  EXPECT_EQ(text_of(docs / "subdivlab.1"), run_program({"manual"}).output)
      << "run: cmake --build build --target pages";
  for (const std::string shell : {"bash", "zsh", "fish"}) {
    EXPECT_EQ(text_of(docs / ("completion." + shell)), run_program({"completion", shell}).output)
        << "run: cmake --build build --target pages";
  }
}

TEST(Manual, SaysExitCodesVerdictsAndEnvironment) {
  const std::string page = text_of(docs / "subdivlab.1");
  for (const char* section : {"SCHEMES", "VERDICTS", "ENVIRONMENT", "FILES", "EXIT STATUS", "EXAMPLES"})
    expect_contains(page, std::string("\n.Sh ") + section + "\n");
  for (const char* verdict : {"reproduced", "refuted", "established", "undecided", "consistent",
                              "inconsistent", "not-reproducible"})
    expect_contains(page, verdict);
  for (const char* code : {".It 0\n", ".It 1\n", ".It 2\n", ".It 3\n", ".It Ev SUBDIVLAB_DATA\n"})
    expect_contains(page, code);
}

TEST(Manual, IsProperMdoc) {
  if (std::system("command -v mandoc >/dev/null") != 0) GTEST_SKIP() << "there is no mandoc";
  const std::string command = "mandoc -T lint -W style " + shell_quoted((docs / "subdivlab.1").string()) +
                              " | grep -v 'outdated mandoc.db\\|referenced manual not found'";
  EXPECT_NE(std::system(command.c_str()), 0) << "mandoc complains";
}

}  // namespace
}  // namespace subdiv
