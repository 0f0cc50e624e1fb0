#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace subdiv {

/// Whether text for this path goes to the program's standard output: "-", /dev/stdout, and others by which
/// the system knows the same stream, also by links. Not /dev/null, where nothing can be mixed up.
[[nodiscard]] bool is_standard_output(const std::filesystem::path& path);
/// Whether what is written to one path is replaced by, or mixed with, what is written to the other.
[[nodiscard]] bool have_same_target(const std::filesystem::path& a, const std::filesystem::path& b);

/// A file that appears whole or not at all: text goes to a temporary file beside the target, finish() gives
/// it its name. Without finish() nothing has changed. Memory does not grow with the text.
class OutputFile {
 public:
  /// Throws InputError that names the target when its folder takes no file.
  explicit OutputFile(std::filesystem::path target);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;
  ~OutputFile();

  /// Throws InputError that names the target when it cannot be written, as every call below.
  void write(std::string_view text);
  /// All that was written is in the temporary file, which is closed. write() may not follow.
  void close();
  /// The target has the new text. Closes first.
  void finish();

 private:
  void open_temporary(bool replaces);
  void flush();
  [[noreturn]] void reject(int error) const;

  std::filesystem::path target_;
  std::string temporary_;  // empty where the text goes to the target itself
  int file_ = -1;
  std::string buffer_;
};

}  // namespace subdiv
