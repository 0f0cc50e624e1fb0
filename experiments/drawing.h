#pragma once

#include <string>
#include <utility>
#include <vector>

#include "experiments/experiment.h"
#include "experiments/report/figure_style.h"

namespace subdiv {

using PlanePoints = std::vector<std::pair<Rational, Rational>>;

/// A polygon, curve or set of points in a drawing.
struct Stroke {
  std::string label;  // in the key; empty hides it
  PlanePoints points;
  bool closed = true;
  std::string style;  // from figure_style.h
};

struct Panel {
  std::string caption;
  std::vector<Stroke> strokes;
  std::vector<FigureText> texts = {};  // in coordinates of the panel
};

/// Plane curves in panels side by side, in one scale, as many to a row as their captions allow.
struct Drawing {
  std::string name;  // of the figure and of the series with its numbers
  std::string title;
  std::vector<Panel> panels;
  std::vector<std::string> claims = {};  // as in Figure
};

/// Adds the figure and its series: columns "PANEL.STROKE LABEL x" and ".. y" from 1, in coordinates of the
/// panel; a closed stroke returns to its first point.
void add_drawing(Results& results, const Drawing& drawing);

}  // namespace subdiv
