#include "experiments/report/output_file.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "schemes/input_error.h"

namespace subdiv {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t buffer_size = std::size_t{1} << 20U;

/// Files there are devices or stand for streams: they are written, never replaced.
bool in_system_folder(const fs::path& path) {
  const std::string text = path.string();
  return text.starts_with("/dev/") || text.starts_with("/proc/");
}

/// The file that a link leads to is written, whether it exists or not, and not the link; /dev/stdout stays
/// what it says.
fs::path without_links(fs::path path) {
  constexpr int most_links = 40;
  std::error_code ignored;
  for (int i = 0; i < most_links && !in_system_folder(path) && fs::is_symlink(path, ignored); ++i)
    path = path.parent_path() / fs::read_symlink(path, ignored);
  return path;
}

}  // namespace

bool is_standard_output(const fs::path& path) {
  const fs::path target = without_links(path);
  if (target == "-" || target == "/dev/stdout") return true;
  struct stat named{};
  struct stat output{};
  struct stat nowhere{};
  if (stat(target.c_str(), &named) != 0 || fstat(STDOUT_FILENO, &output) != 0) return false;
  // A regular file is replaced, so that text already on its way into the old one stays there.
  if (S_ISREG(named.st_mode) && !in_system_folder(target)) return false;
  const auto same = [](const struct stat& a, const struct stat& b) {
    return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
  };
  return same(named, output) && !(stat("/dev/null", &nowhere) == 0 && same(named, nowhere));
}

bool have_same_target(const fs::path& a, const fs::path& b) {
  if (is_standard_output(a) || is_standard_output(b)) return is_standard_output(a) && is_standard_output(b);
  const auto target = [](const fs::path& path) {
    std::error_code error;
    const fs::path named = without_links(path);
    const fs::path whole = fs::weakly_canonical(fs::absolute(named, error), error);
    return error ? named : whole;
  };
  return target(a) == target(b);
}

OutputFile::OutputFile(std::filesystem::path target) : target_(without_links(std::move(target))) {
  std::error_code ignored;  // a target that does not exist yet is the usual one
  const fs::file_status status = fs::status(target_, ignored);
  if (is_standard_output(target_)) {
    file_ = dup(STDOUT_FILENO);
  } else if (fs::is_character_file(status) || fs::is_fifo(status) || in_system_folder(target_)) {
    file_ = open(target_.c_str(), O_WRONLY | O_CLOEXEC);
  } else if (fs::is_directory(status)) {
    reject(EISDIR);
  } else {
    open_temporary(fs::is_regular_file(status));
  }
  if (file_ < 0) reject(errno);
}

/// A new file beside the target, with the target's permissions or those that new files have.
void OutputFile::open_temporary(bool replaces) {
  constexpr int attempts = 1000;
  constexpr mode_t new_file = 0666;  // less the user's mask
  errno = EEXIST;
  for (int i = 0; file_ < 0 && errno == EEXIST && i < attempts; ++i) {
    const std::string name = ".subdivlab-" + std::to_string(getpid()) + "-" + std::to_string(i);
    temporary_ = (target_.parent_path() / name).string();
    file_ = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, new_file);
  }
  struct stat old{};
  const bool known = file_ >= 0 && replaces && stat(target_.c_str(), &old) == 0;
  if (known && fchmod(file_, old.st_mode) != 0) {
    const int error = errno;
    unlink(temporary_.c_str());
    reject(error);
  }
  if (file_ < 0) temporary_.clear();
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})),
      file_(std::exchange(other.file_, -1)),
      buffer_(std::move(other.buffer_)) {}

OutputFile::~OutputFile() {
  if (file_ >= 0) ::close(file_);
  if (!temporary_.empty()) unlink(temporary_.c_str());
}

void OutputFile::write(std::string_view text) {
  buffer_ += text;
  if (buffer_.size() >= buffer_size) flush();
}

void OutputFile::flush() {
  for (std::size_t written = 0; written < buffer_.size();) {
    const ssize_t count = ::write(file_, buffer_.data() + written, buffer_.size() - written);
    if (count < 0 && errno != EINTR) reject(errno);
    if (count > 0) written += static_cast<std::size_t>(count);
  }
  buffer_.clear();
}

void OutputFile::close() {
  if (file_ < 0) return;
  flush();
  if (!temporary_.empty() && fsync(file_) != 0) reject(errno);
  if (::close(std::exchange(file_, -1)) != 0) reject(errno);
}

void OutputFile::finish() {
  close();
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) reject(errno);
  temporary_.clear();
}

void OutputFile::reject(int error) const {
  throw InputError(target_.string() + ": cannot be written: " + std::generic_category().message(error) +
                   "; name a place that can be written");
}

}  // namespace subdiv
