#include "experiments/report/figure_style.h"

#include <fmt/format.h>

namespace subdiv::style {
namespace {

struct Look {
  std::string_view colour;
  const char* dash;  // of width 2; gnuplot scales it with the width
  int marker;
};

constexpr std::array looks{Look{blue, "1", 7},        Look{vermilion, "(9,3)", 5},
                           Look{green, "(2,3)", 9},   Look{purple, "(9,3,2,3)", 13},
                           Look{orange, "(5,2)", 11}, Look{black, "(9,2,2,2,2,2)", 6},
                           Look{sky, "(14,4)", 4}};

const Look& look(std::size_t i) { return looks.at(i % looks.size()); }

}  // namespace

std::string curve(std::size_t i, double width) { return dashed(i, look(i).colour, width); }

std::string dashed(std::size_t i, std::string_view colour, double width) {
  return fmt::format("lines lw {} dt {} lc rgb '{}'", width, look(i).dash, colour);
}

std::string marked(std::size_t i, double size) {
  return fmt::format("linespoints lw 1.3 pt {} ps {} lc rgb '{}'", look(i).marker, size, look(i).colour);
}

std::string points(std::size_t i, double size) {
  return fmt::format("points pt {} ps {} lc rgb '{}'", look(i).marker, size, look(i).colour);
}

std::string in_colour(std::string_view colour, double width) {
  return fmt::format("lines lw {} lc rgb '{}'", width, colour);
}

std::string region(std::string_view colour) {
  return fmt::format("filledcurves closed fs solid noborder fc rgb '{}'", colour);
}

std::string glass(std::string_view colour) {
  return fmt::format("filledcurves closed fs transparent solid 0.25 border lc rgb '{0}' fc rgb '{0}'",
                     colour);
}

std::string across(const std::string& y) {
  return fmt::format(
      "set arrow from graph 0, first {0} to graph 1, first {0} nohead lw 1 dt (4,4) lc rgb '#000000'\n", y);
}

std::string upright(const std::string& x) {
  return fmt::format(
      "set arrow from first {0}, graph 0 to first {0}, graph 1 nohead lw 1 dt (4,4) lc rgb '#000000'\n", x);
}

}  // namespace subdiv::style
