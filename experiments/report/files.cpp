#include "experiments/report/files.h"

#include <cerrno>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

#include "experiments/report/output_file.h"
#include "schemes/input_error.h"

namespace subdiv {
namespace {

namespace fs = std::filesystem;

std::string reason(int error) { return std::generic_category().message(error); }

[[noreturn]] void reject(const fs::path& path, const std::string& what) {
  throw InputError(path.string() + ": " + what + "; name a folder that can be written with --out");
}

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
  const OutputFile probe(folder / "probe");  // gone at once: an interrupt finds hardly a moment to leave it
}

void write_files(const std::vector<NewFile>& files, const std::vector<fs::path>& obsolete) {
  std::vector<OutputFile> staged;
  for (const NewFile& file : files) {
    staged.emplace_back(file.path);
    staged.back().write(file.text);
    staged.back().close();
  }
  for (OutputFile& file : staged) file.finish();
  for (const fs::path& path : obsolete) {
    std::error_code ignored;  // a file that is gone already is what was wanted
    fs::remove(path, ignored);
  }
}

}  // namespace subdiv
