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

constexpr std::size_t buffer_size = std::size_t{1} << 20U;

}  // namespace

OutputFile::OutputFile(std::filesystem::path target) : target_(std::move(target)) {
  namespace fs = std::filesystem;
  std::error_code ignored;  // a target that does not exist yet is the usual one
  const fs::file_status status = fs::status(target_, ignored);
  if (target_ == "-") {
    file_ = dup(STDOUT_FILENO);
  } else if (fs::is_character_file(status) || fs::is_fifo(status)) {
    file_ = open(target_.c_str(), O_WRONLY | O_CLOEXEC);
  } else if (fs::is_directory(status)) {
    reject(EISDIR);
  } else {
    temporary_ = (target_.parent_path() / (".subdivlab-" + target_.filename().string() + "-XXXXXX")).string();
    file_ = mkstemp(temporary_.data());
    if (file_ < 0) temporary_.clear();
  }
  if (file_ < 0) reject(errno);
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
  constexpr mode_t readable_by_all = 0644;
  const bool kept = temporary_.empty() || (fchmod(file_, readable_by_all) == 0 && fsync(file_) == 0);
  if (!kept) reject(errno);
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
                   "; name a place that can be written with --out");
}

}  // namespace subdiv
