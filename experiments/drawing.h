#pragma once

#include <string>
#include <utility>
#include <vector>

#include "experiments/experiment.h"

namespace subdiv {

using PlanePoints = std::vector<std::pair<Rational, Rational>>;

/// A polygon, curve or set of points in a drawing.
struct Stroke {
  std::string label;  // in the key; empty hides it
  PlanePoints points;
  bool closed = true;
  std::string style;  // gnuplot "with" clause
};

struct Panel {
  std::string caption;
  std::vector<Stroke> strokes;
};

/// Plane curves in panels side by side, in one scale, a few to a row.
struct Drawing {
  std::string name;  // of the figure and of the series with its numbers
  std::string title;
  std::vector<Panel> panels;
};

/// Colours that colour-blind readers tell apart (Okabe & Ito), and the styles of drawings.
namespace style {
inline const std::string polygon = "lines lw 1.2 lc rgb '#999999'";
inline const std::string dots = "points pt 7 ps 0.5 lc rgb '#555555'";
inline const std::vector<std::string> colours{"#d55e00", "#009e73", "#0072b2", "#cc79a7",
                                              "#e69f00", "#56b4e9", "#000000"};
/// A line in colour i, modulo their number.
[[nodiscard]] std::string line(std::size_t i, double width = 2);
}  // namespace style

/// Adds the figure and its series: columns "PANEL.STROKE LABEL x" and ".. y" from 1, in coordinates of the
/// panel; a closed stroke returns to its first point.
void add_drawing(Results& results, const Drawing& drawing);

}  // namespace subdiv
