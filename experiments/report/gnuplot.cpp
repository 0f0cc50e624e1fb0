#include "experiments/report/gnuplot.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string_view>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include "experiments/report/utf8.h"
#include "schemes/input_error.h"

namespace subdiv {
namespace {

std::string quoted_for_gnuplot(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("''") : std::string(1, c);
  return result + "'";
}

const Series& series_named(std::span<const Series> series, const Figure& figure, const std::string& name) {
  const auto found =
      std::find_if(series.begin(), series.end(), [&](const Series& s) { return s.name == name; });
  if (found == series.end()) {
    throw std::logic_error("figure '" + figure.name + "': there is no series '" + name + "'");
  }
  return *found;
}

std::size_t column_named(const Series& series, const std::string& name) {
  const auto found = std::find(series.columns.begin(), series.columns.end(), name);
  if (found == series.columns.end()) {
    throw std::logic_error("series '" + series.name + "': there is no column '" + name + "'");
  }
  return static_cast<std::size_t>(found - series.columns.begin());
}

void require_decimal(const Series& series, const std::string& cell) {
  try {
    if (cell.find('/') != std::string::npos) throw std::invalid_argument("'" + cell + "' is a fraction");
    (void)Rational::parse(cell);
  } catch (const std::invalid_argument& error) {
    throw std::logic_error("series '" + series.name + "': " + error.what() + "; figures need decimals");
  }
}

std::vector<std::size_t> columns_of(const Series& series, const Curve& curve) {
  std::vector<std::size_t> columns{column_named(series, curve.x), column_named(series, curve.y)};
  for (const std::string& name : curve.more) columns.push_back(column_named(series, name));
  return columns;
}

std::string data_block(const Series& series, const Curve& curve, std::size_t index) {
  const std::vector<std::size_t> columns = columns_of(series, curve);
  std::string text = "$data" + std::to_string(index) + " << end_of_data\n";
  for (const auto& row : series.rows) {
    const bool complete = std::ranges::none_of(columns, [&](std::size_t c) { return row.at(c).empty(); });
    for (std::size_t i = 0; complete && i < columns.size(); ++i) {
      require_decimal(series, row[columns[i]]);
      text += (i == 0 ? "" : " ") + row[columns[i]];
    }
    text += '\n';
  }
  return text + "end_of_data\n";
}

/// "1:2", and so on for more columns; "($1+5):($2+0)" for a curve that is moved.
std::string using_clause(const Curve& curve) {
  const bool moved = curve.right != 0 || curve.up != 0;
  std::string text = moved ? fmt::format("(${}+{}):(${}+{})", 1, curve.right, 2, curve.up) : "1:2";
  for (std::size_t i = 0; i < curve.more.size(); ++i) text += ":" + std::to_string(i + 3);
  return text;
}

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

std::string figure_script(const Figure& figure, std::span<const Series> series) {
  std::string script =
      "set encoding utf8\n"
      "set terminal svg size 800,500 fixed font 'Helvetica,14' noenhanced background '#ffffff' name "
      "'subdivlab'\n"
      "set border 3\nset tics nomirror\n"
      "set grid lc rgb '#dddddd'\n"
      "set key top right\n"
      "set title " +
      quoted_for_gnuplot(figure.title) + "\n" + "set xlabel " + quoted_for_gnuplot(figure.x_label) + "\n" +
      "set ylabel " + quoted_for_gnuplot(figure.y_label) + "\n";
  std::string plots;
  for (std::size_t i = 0; i < figure.curves.size(); ++i) {
    const Curve& curve = figure.curves[i];
    script += data_block(series_named(series, figure, curve.series), curve, i);
    plots += (i == 0 ? "plot " : ", ") + ("$data" + std::to_string(i)) + " using " + using_clause(curve) +
             " with " + curve.style +
             (curve.label.empty() ? " notitle" : " title " + quoted_for_gnuplot(curve.label));
  }
  if (!figure.setup.empty()) script += figure.setup + "\n";
  return script + plots + "\n";
}

std::string draw_svg(const Figure& figure, std::span<const Series> series) {
  const std::string script = figure_script(figure, series);
  require_gnuplot();
  auto [done, text] = run_gnuplot(script);
  if (!done || text.find("</svg>") == std::string::npos) {
    throw std::runtime_error("figure '" + figure.name + "': gnuplot failed: " + clipped(text, 400));
  }
  return text;
}

}  // namespace subdiv
