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

TEST(OutputFile, StandardOutputHasManyNames) {
  const TemporaryFolder folder;
  for (const char* name : {"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"}) {
    EXPECT_TRUE(is_standard_output(name) || std::filesystem::equivalent("/dev/fd/1", "/dev/null")) << name;
  }
  std::filesystem::create_symlink("/dev/stdout", folder.path() / "link.obj");
  EXPECT_TRUE(is_standard_output(folder.path() / "link.obj"));
  EXPECT_FALSE(is_standard_output("/dev/null"));
  EXPECT_FALSE(is_standard_output(folder.path() / "curve.csv"));
  EXPECT_TRUE(have_same_target("-", folder.path() / "link.obj"));
  EXPECT_FALSE(have_same_target("-", folder.path() / "curve.csv"));
}

TEST(OutputFile, OnePlaceHasManyPaths) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "curve.csv";
  std::filesystem::create_directory(folder.path() / "inside");
  std::filesystem::create_symlink("curve.csv", folder.path() / "link.csv");
  std::filesystem::create_directory_symlink(folder.path(), folder.path() / "inside" / "out");
  // Before there is such a file, and after.
  for (const bool exists : {false, true}) {
    if (exists) OutputFile(path).finish();
    for (const char* other :
         {"./curve.csv", "inside/../curve.csv", "link.csv", "inside/out/curve.csv", "inside/out/link.csv"})
      EXPECT_TRUE(have_same_target(path, folder.path() / other)) << other << exists;
    EXPECT_TRUE(have_same_target(std::filesystem::relative(path), path));
    EXPECT_FALSE(have_same_target(path, folder.path() / "inside" / "curve.csv"));
  }
  // Hard links part when one of them is replaced.
  std::filesystem::create_hard_link(path, folder.path() / "hard.csv");
  EXPECT_FALSE(have_same_target(path, folder.path() / "hard.csv"));
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
                              {"absent/curve.csv", "cannot be written", "a place that can"});
  testing::expect_input_error([&] { OutputFile file(folder.path()); }, {"directory", "a place that can"});
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
