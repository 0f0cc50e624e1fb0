#include "experiments/report/output_file.h"

#include <gtest/gtest.h>

#include "experiments/report/files.h"
#include "tests/experiments/temporary_folder.h"
#include "tests/schemes/input_errors.h"

namespace subdiv {
namespace {

using Names = std::set<std::string>;

TEST(OutputFile, AppearsWholeOrNotAtAll) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "curve.csv";
  {
    OutputFile file(path);
    file.write("half");
  }
  EXPECT_EQ(folder.files(), Names{});
  const std::string long_text(std::size_t{3} << 20U, 'x');
  OutputFile file(path);
  file.write(long_text);
  file.write("end");
  EXPECT_FALSE(std::filesystem::exists(path));
  file.finish();
  EXPECT_EQ(read_file(path), long_text + "end");
  EXPECT_EQ(folder.files(), Names{"curve.csv"});
}

TEST(OutputFile, AnOldFileSurvivesWhatIsNotFinished) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "curve.csv";
  OutputFile first(path);
  first.write("old");
  first.finish();
  {
    OutputFile second(path);
    second.write("new");
    second.close();
  }
  EXPECT_EQ(read_file(path), "old");
  EXPECT_EQ(folder.files(), Names{"curve.csv"});
}

TEST(OutputFile, MovedFilesAreFinishedOnce) {
  const TemporaryFolder folder;
  std::vector<OutputFile> files;
  for (const char* name : {"a", "b", "c"}) {
    files.emplace_back(folder.path() / name);
    files.back().write(name);
  }
  for (OutputFile& file : files) file.finish();
  EXPECT_EQ(folder.files(), (Names{"a", "b", "c"}));
}

TEST(OutputFile, DevicesAreWrittenDirectly) {
  OutputFile file("/dev/null");
  file.write("gone");
  file.finish();
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(OutputFile, WhatCannotBeWrittenIsNamed) {
  const TemporaryFolder folder;
  testing::expect_input_error([&] { OutputFile file(folder.path() / "absent" / "curve.csv"); },
                              {"absent/curve.csv", "cannot be written", "--out"});
  testing::expect_input_error([&] { OutputFile file(folder.path()); }, {"directory", "--out"});
  testing::expect_input_error(
      [] {
        OutputFile file("/dev/full");
        file.write("text");
        file.finish();
      },
      {"/dev/full", "No space"});
}

}  // namespace
}  // namespace subdiv
