#include "experiments/report/files.h"

#include <gtest/gtest.h>

#include "schemes/input_error.h"
#include "tests/experiments/temporary_folder.h"

namespace subdiv {
namespace {

using Names = std::set<std::string>;

TEST(WriteFiles, WritesWholeFilesAndRemovesObsoleteOnes) {
  const TemporaryFolder folder;
  write_files({{folder.path() / "a", "first"}, {folder.path() / "old", "x"}});
  write_files({{folder.path() / "a", "second"}, {folder.path() / "b", ""}},
              {folder.path() / "old", folder.path() / "never"});
  EXPECT_EQ(folder.files(), (Names{"a", "b"}));
  EXPECT_EQ(read_file(folder.path() / "a"), "second");
  EXPECT_EQ(read_file(folder.path() / "b"), "");
}

TEST(WriteFiles, ChangesNothingWhenOneFileCannotBeWritten) {
  const TemporaryFolder folder;
  write_files({{folder.path() / "a", "first"}});
  // No file can stand below a regular file, whoever asks.
  const auto below_a_file = folder.path() / "a" / "b";
  try {
    write_files({{folder.path() / "a", "second"}, {folder.path() / "c", "new"}, {below_a_file, ""}},
                {folder.path() / "a"});
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(below_a_file.string()), std::string::npos) << error.what();
  }
  EXPECT_EQ(folder.files(), Names{"a"});
  EXPECT_EQ(read_file(folder.path() / "a"), "first");
}

TEST(PrepareFolder, MakesItAndLeavesNothingBehind) {
  const TemporaryFolder folder;
  prepare_folder(folder.path() / "x" / "y");
  EXPECT_TRUE(std::filesystem::is_directory(folder.path() / "x" / "y"));
  EXPECT_TRUE(folder.files().empty());
}

TEST(PrepareFolder, RejectsWhatCannotBeAFolder) {
  const TemporaryFolder folder;
  write_files({{folder.path() / "a", ""}});
  EXPECT_THROW(prepare_folder(folder.path() / "a"), InputError);
  EXPECT_THROW(prepare_folder(folder.path() / "a" / "b"), InputError);
  EXPECT_THROW(prepare_folder("/proc/no-such-folder"), InputError);
}

TEST(ReadFile, NamesWhatCannotBeRead) {
  const TemporaryFolder folder;
  EXPECT_THROW((void)read_file(folder.path() / "nothing"), InputError);
  EXPECT_THROW((void)read_file(folder.path()), InputError);
}

}  // namespace
}  // namespace subdiv
