#pragma once

#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "schemes/input_error.h"

namespace subdiv::testing {

/// Runs an action that must throw InputError with a message that contains every one of the given pieces: the
/// place, what is wrong, what would be right.
template <class Action>
void expect_input_error(const Action& action, std::initializer_list<const char*> pieces) {
  try {
    static_cast<void>(action());
  } catch (const InputError& error) {
    for (const char* piece : pieces) {
      EXPECT_NE(std::string(error.what()).find(piece), std::string::npos)
          << "the message\n  " << error.what() << "\ndoes not contain\n  " << piece;
    }
    return;
  }
  ADD_FAILURE() << "no InputError";
}

/// A folder of its own for a test's files, removed at the end.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::random_device device;
    folder_ = std::filesystem::temp_directory_path() / ("subdivlab-test-" + std::to_string(device()));
    std::filesystem::create_directories(folder_);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
  /// Writes a file and returns its path.
  [[nodiscard]] std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

 private:
  std::filesystem::path folder_;
};

}  // namespace subdiv::testing
