#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace subdiv {

/// The bytes of a file. Throws InputError that names it when it cannot be read.
[[nodiscard]] std::string read_file(const std::filesystem::path& path);

/// Makes the folder and those above it, and proves by a passing temporary file that it can be written. Throws
/// InputError that names the folder.
void prepare_folder(const std::filesystem::path& folder);

struct NewFile {
  std::filesystem::path path;
  std::string text;
};

/// Writes files whole: all of them to temporary files beside their targets first, then each renamed in the
/// given order, then `obsolete` removed. When a file cannot be written, the temporary files are removed,
/// nothing has changed, and InputError names the file.
void write_files(const std::vector<NewFile>& files, const std::vector<std::filesystem::path>& obsolete = {});

}  // namespace subdiv
