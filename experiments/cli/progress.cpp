#include "experiments/cli/progress.h"

#include <cstdio>

#include <unistd.h>

#include "experiments/report/utf8.h"

namespace subdiv::cli {

Progress::Progress(std::size_t total) : total_(total), shown_(isatty(STDERR_FILENO) != 0 && total > 0) {
  draw("");
}

Progress::~Progress() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void Progress::finished(const std::string& name) {
  ++done_;
  draw(name);
}

void Progress::draw(const std::string& name) const {
  if (!shown_) return;
  constexpr std::size_t width = 30;
  constexpr std::size_t name_width = 30;
  const std::size_t filled = done_ * width / total_;
  std::string bar = "[" + std::string(filled, '=') + std::string(width - filled, ' ') + "] ";
  bar += std::to_string(done_) + "/" + std::to_string(total_) + " " + clipped(name, name_width);
  std::fprintf(stderr, "\r\033[K%s", bar.c_str());
  std::fflush(stderr);
}

}  // namespace subdiv::cli
