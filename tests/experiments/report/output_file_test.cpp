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

TEST(OutputFile, LinksLeadToTheFileThatIsWritten) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "curve.csv";
  const auto link = folder.path() / "link.csv";
  std::filesystem::create_symlink(path, link);
  OutputFile file(link);
  file.write("text");
  file.finish();
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(read_file(path), "text");
}

TEST(OutputFile, AReplacedFileKeepsItsPermissions) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "curve.csv";
  constexpr auto owner_only = std::filesystem::perms::owner_read | std::filesystem::perms::owner_write;
  for (const char* text : {"first", "second"}) {
    OutputFile file(path);
    file.write(text);
    file.finish();
    std::filesystem::permissions(path, owner_only);
  }
  OutputFile file(path);
  file.finish();
  EXPECT_EQ(std::filesystem::status(path).permissions(), owner_only);
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
