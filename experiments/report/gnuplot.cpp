#include "experiments/report/gnuplot.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string_view>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include "experiments/report/figure_script.h"
#include "experiments/report/figure_text.h"
#include "experiments/report/svg.h"
#include "experiments/report/utf8.h"
#include "schemes/input_error.h"

namespace subdiv {
namespace {

using File = std::unique_ptr<FILE, int (*)(FILE*)>;

File temporary_file() {
  File file(std::tmpfile(), &std::fclose);
  if (!file)
    throw std::runtime_error("cannot make a temporary file for gnuplot: is the temporary folder full?");
  return file;
}

std::string content(FILE* file) {
  std::rewind(file);
  std::string text;
  std::array<char, 4096> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file)) {
    text.append(buffer.data(), count);
  }
  return text;
}

/// The PATH, and a fixed locale: decimal points, no settings of the user's own.
std::array<std::string, 2> environment() {
  const char* path = std::getenv("PATH");
  return {"PATH=" + std::string(path != nullptr ? path : "/usr/bin:/bin"), "LC_ALL=C.UTF-8"};
}

/// Runs gnuplot on the script: exit status 0 and its standard output, or its standard error.
std::pair<bool, std::string> run_gnuplot(const std::string& script) {
  const File input = temporary_file();
  const File output = temporary_file();
  const File errors = temporary_file();
  if (std::fwrite(script.data(), 1, script.size(), input.get()) != script.size() ||
      std::fflush(input.get()) != 0) {
    throw std::runtime_error("cannot write a temporary file for gnuplot: is the temporary folder full?");
  }
  std::rewind(input.get());

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(input.get()), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(output.get()), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(errors.get()), STDERR_FILENO);
  std::array<std::string, 2> arguments{"gnuplot", "--default-settings"};
  std::array<std::string, 2> variables = environment();
  std::array<char*, 3> argv{arguments[0].data(), arguments[1].data(), nullptr};
  std::array<char*, 3> env{variables[0].data(), variables[1].data(), nullptr};
  pid_t child = 0;
  const int failure = posix_spawnp(&child, "gnuplot", &actions, nullptr, argv.data(), env.data());
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) throw std::runtime_error("cannot start gnuplot");
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw std::runtime_error("lost track of gnuplot");
  }
  const bool done = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  return {done, content(done ? output.get() : errors.get())};
}

}  // namespace

void require_gnuplot() {
  const std::string path = environment()[0].substr(std::string_view("PATH=").size());
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find(':', begin), path.size());
    const std::string folder = end == begin ? "." : path.substr(begin, end - begin);
    if (access((folder + "/gnuplot").c_str(), X_OK) == 0) return;
    begin = end + 1;
  }
  throw InputError("gnuplot, which draws the figures, is not installed: apt-get install gnuplot-nox");
}

std::string draw_svg(const Figure& figure, std::span<const Series> series) {
  const std::string script = figure_script(figure, series);
  require_gnuplot();
  auto [done, text] = run_gnuplot(script);
  if (!done || text.find("</svg>") == std::string::npos) {
    throw std::runtime_error("figure '" + figure.name + "': gnuplot failed: " + clipped(text, 400));
  }
  return finished_svg(text, figure.name, plain_text(figure.title), figure_description(figure));
}

}  // namespace subdiv
