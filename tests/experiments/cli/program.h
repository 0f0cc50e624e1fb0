#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "tests/experiments/temporary_folder.h"

namespace subdiv {

/// What one call of the built program did.
struct ProgramRun {
  int exit_code = -1;
  std::string output;
  std::string errors;
};

inline std::string text_of(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

inline std::string shell_quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

/// Runs the program in `folder`; `prefix` stands before it, as in "timeout 1".
inline ProgramRun run_program(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                              const std::string& prefix = "") {
  const TemporaryFolder streams;
  std::string command =
      "cd " + shell_quoted(folder.string()) + " && " + prefix + " " + shell_quoted(SUBDIVLAB_PROGRAM);
  for (const std::string& argument : arguments) command += " " + shell_quoted(argument);
  command += " > " + shell_quoted((streams.path() / "output").string());
  command += " 2> " + shell_quoted((streams.path() / "errors").string());
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(streams.path() / "output"),
          text_of(streams.path() / "errors")};
}

inline ProgramRun run_program(const std::vector<std::string>& arguments) {
  return run_program(arguments, std::filesystem::temp_directory_path());
}

inline void expect_contains(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in:\n" << text;
}

/// Bad input: exit code 2, nothing on standard output, a message with these parts on standard error.
inline void expect_rejected(const ProgramRun& run, const std::vector<std::string>& parts) {
  EXPECT_EQ(run.exit_code, 2) << run.errors;
  EXPECT_EQ(run.output, "");
  for (const std::string& part : parts) expect_contains(run.errors, part);
}

}  // namespace subdiv
