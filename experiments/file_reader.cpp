#include "experiments/file_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "experiments/report/files.h"
#include "schemes/input_error.h"
#include "schemes/text.h"

namespace subdiv {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t block_size = std::size_t{1} << 20U;

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

}  // namespace

FileReader::FileReader(fs::path path) : path_(std::move(path)) {
  std::error_code error;
  if (!fs::exists(path_, error) || fs::is_directory(path_, error))
    (void)read_file(path_);  // says why it fails
  if (!fs::is_regular_file(path_, error))
    throw InputError(path_.string() + ": is no regular file; meshes are read from files on disk");
  size_ = fs::file_size(path_, error);
  stream_.open(path_, std::ios::binary);
  if (!stream_) (void)read_file(path_);
}

/// Keeps what is read ahead, at the front of the buffer, which doubles when it is full: linear in total.
bool FileReader::read_more() {
  if (begin_ > 0) {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    before_ += begin_;
    end_ -= begin_;
    begin_ = 0;
  }
  if (end_ == buffer_.size()) buffer_.resize(std::max(block_size, 2 * buffer_.size()));
  stream_.read(buffer_.data() + end_, static_cast<std::streamsize>(buffer_.size() - end_));
  if (stream_.bad()) throw InputError(path_.string() + ": cannot be read to its end");
  const auto count = static_cast<std::size_t>(stream_.gcount());
  end_ += count;
  return count > 0;
}

bool FileReader::next_line(std::string_view& line) {
  std::size_t searched = 0;
  const char* found = nullptr;
  while (true) {
    const std::size_t ahead = end_ - begin_;
    if (ahead > searched) {
      found =
          static_cast<const char*>(std::memchr(buffer_.data() + begin_ + searched, '\n', ahead - searched));
    }
    if (found != nullptr) break;
    searched = ahead;
    if (!read_more()) break;
  }
  if (begin_ == end_) return false;
  ++line_;
  const char* first = buffer_.data() + begin_;
  const char* last = found != nullptr ? found : buffer_.data() + end_;
  line = {first, static_cast<std::size_t>(last - first)};
  begin_ += line.size() + (found != nullptr ? 1 : 0);
  if (line.ends_with('\r')) line.remove_suffix(1);
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (line_ == 1 && line.starts_with(byte_order_mark)) line.remove_prefix(byte_order_mark.size());
  if (!line.empty() && std::memchr(line.data(), 0, line.size()) != nullptr)
    reject("a NUL byte; expected text");
  return true;
}

std::string_view FileReader::next_bytes(std::size_t n) {
  if (n > left()) reject_byte(size_, fmt::format("the file ends here, {} bytes too early", n - left()));
  while (end_ - begin_ < n) {
    if (!read_more()) throw InputError(path_.string() + ": cannot be read to its end");
  }
  const std::string_view bytes(buffer_.data() + begin_, n);
  begin_ += n;
  return bytes;
}

void FileReader::skip_bytes(std::size_t n) {
  for (std::size_t rest = n; rest > 0;) {
    const std::size_t part = std::min(rest, block_size);
    (void)next_bytes(part);
    rest -= part;
  }
}

void FileReader::reject(const std::string& what) const {
  throw InputError(fmt::format("{}:{}: {}", path_.string(), line_, what));
}

void FileReader::reject_byte(std::size_t byte, const std::string& what) const {
  throw InputError(fmt::format("{}: byte {}: {}", path_.string(), byte, what));
}

std::string_view next_word(std::string_view& text) {
  std::size_t begin = 0;
  while (begin < text.size() && is_space(text[begin])) ++begin;
  std::size_t end = begin;
  while (end < text.size() && !is_space(text[end])) ++end;
  const std::string_view word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

double to_coordinate(const FileReader& reader, std::string_view word) {
  const bool plus = word.starts_with('+');
  const std::string_view digits = plus ? word.substr(1) : word;
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::result_out_of_range) reader.reject(in_quotes(word) + " does not fit a double");
  if (error != std::errc() || end != digits.data() + digits.size() || (plus && digits.starts_with('-')))
    reader.reject(in_quotes(word) + " is no number; expected a decimal such as -0.25 or 1e-3");
  if (!std::isfinite(value)) reader.reject(in_quotes(word) + " is not finite");
  return value;
}

long long to_integer(const FileReader& reader, std::string_view word) {
  long long value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc::result_out_of_range) reader.reject(in_quotes(word) + " is too large a number");
  if (error != std::errc() || end != word.data() + word.size())
    reader.reject(in_quotes(word) + " is no integer");
  return value;
}

}  // namespace subdiv
