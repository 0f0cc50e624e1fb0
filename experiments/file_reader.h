#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace subdiv {

/// Reads a file from its beginning, by lines or by bytes, in memory that does not grow with it but for the
/// longest line. Every error is an InputError that names the file and the line, or the byte.
class FileReader {
 public:
  /// Throws InputError when there is no such file, or no regular one.
  explicit FileReader(std::filesystem::path path);

  /// The next line without its end (LF or CR LF) and without a byte order mark; false past the last one.
  /// The text lives until the next call. A line with a NUL byte is an error: the file is no text.
  [[nodiscard]] bool next_line(std::string_view& line);
  /// The next n bytes, which live until the next call; rejects when the file ends before.
  [[nodiscard]] std::string_view next_bytes(std::size_t n);
  void skip_bytes(std::size_t n);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// The number of the line read last, from 1.
  [[nodiscard]] std::size_t line() const { return line_; }
  /// The number of bytes read, and left.
  [[nodiscard]] std::size_t offset() const { return before_ + begin_; }
  [[nodiscard]] std::size_t left() const { return size_ - offset(); }
  [[nodiscard]] std::size_t size() const { return size_; }

  /// Throws InputError "FILE:LINE: what", of the line read last.
  [[noreturn]] void reject(const std::string& what) const;
  /// Throws InputError "FILE: byte N: what".
  [[noreturn]] void reject_byte(std::size_t byte, const std::string& what) const;

 private:
  bool read_more();

  std::filesystem::path path_;
  std::ifstream stream_;
  std::size_t size_ = 0;
  std::string buffer_;  // buffer_[begin_, end_) is read ahead
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  std::size_t before_ = 0;  // bytes of the file before buffer_[0]
  std::size_t line_ = 0;
};

/// The text up to a comment.
[[nodiscard]] inline std::string_view without_comment(std::string_view text) {
  return text.substr(0, text.find('#'));
}

/// Takes the next word, between white space, off the text; empty at its end.
[[nodiscard]] std::string_view next_word(std::string_view& text);

/// The word as a finite double, or as an integer. Rejects at the line read last.
[[nodiscard]] double to_coordinate(const FileReader& reader, std::string_view word);
[[nodiscard]] long long to_integer(const FileReader& reader, std::string_view word);

}  // namespace subdiv
