#include "experiments/report/files.h"

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>

#include <sys/stat.h>
#include <unistd.h>

#include "schemes/input_error.h"

namespace subdiv {
namespace {

namespace fs = std::filesystem;

std::string reason(int error) { return std::generic_category().message(error); }

[[noreturn]] void reject(const fs::path& path, const std::string& what) {
  throw InputError(path.string() + ": " + what + "; name a folder that can be written with --out");
}

/// Temporary files that vanish unless they are renamed.
class Staging {
 public:
  Staging() = default;
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;
  ~Staging() {
    for (const auto& [temporary, target] : files_) unlink(temporary.c_str());
  }

  void add(const fs::path& target, const std::string& text) {
    std::string name =
        (target.parent_path() / (".subdivlab-" + target.filename().string() + "-XXXXXX")).string();
    const int file = mkstemp(name.data());
    if (file < 0) reject(target, "cannot be written: " + reason(errno));
    files_.emplace_back(name, target);
    std::size_t written = 0;
    while (written < text.size()) {
      const ssize_t count = write(file, text.data() + written, text.size() - written);
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) break;
      written += static_cast<std::size_t>(count);
    }
    const int error = errno;
    constexpr mode_t readable_by_all = 0644;
    const bool done = written == text.size() && fchmod(file, readable_by_all) == 0 && fsync(file) == 0;
    if (close(file) != 0 || !done) reject(target, "cannot be written: " + reason(error));
  }

  void rename_all() {
    for (auto& [temporary, target] : files_) {
      if (std::rename(temporary.c_str(), target.c_str()) != 0)
        reject(target, "cannot be written: " + reason(errno));
      temporary.clear();
    }
  }

 private:
  std::vector<std::pair<std::string, fs::path>> files_;
};

}  // namespace

std::string read_file(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) throw InputError(path.string() + ": is a folder, not a file");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw InputError(path.string() + ": cannot be read: " + reason(errno));
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (stream.bad()) throw InputError(path.string() + ": cannot be read to its end");
  return text;
}

void prepare_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) reject(folder, "cannot be made: " + error.message());
  if (!fs::is_directory(folder, error)) reject(folder, "is no folder");
  Staging().add(folder / "probe", "");
}

void write_files(const std::vector<NewFile>& files, const std::vector<fs::path>& obsolete) {
  Staging staging;
  for (const NewFile& file : files) staging.add(file.path, file.text);
  staging.rename_all();
  for (const fs::path& path : obsolete) {
    std::error_code ignored;  // a file that is gone already is what was wanted
    fs::remove(path, ignored);
  }
}

}  // namespace subdiv
