#pragma once

#include <string>
#include <vector>

#include "experiments/experiment.h"
#include "experiments/report/figure_style.h"

namespace subdiv {

struct Spot {
  double x = 0;
  double y = 0;
};
[[nodiscard]] inline Spot operator+(Spot a, Spot b) { return {a.x + b.x, a.y + b.y}; }
[[nodiscard]] inline Spot operator*(double factor, Spot a) { return {factor * a.x, factor * a.y}; }

struct NamedSpot {
  std::string name;
  Spot spot;
};

/// A diagram in the plane that explains: lines, dots and names, part by part, in one scale. Every part is a
/// series "FIGURE-PART" of its own, the names of its dots included.
class PlaneDiagram {
 public:
  PlaneDiagram(std::string name, std::string title) : name_(std::move(name)), title_(std::move(title)) {}

  /// Polylines; columns x, y, lines end with an empty row.
  void add_lines(const std::string& part, const std::vector<std::vector<Spot>>& lines,
                 const std::string& style);
  /// Dots; columns name, x, y. Names that are not empty are written at `shift` (character widths and heights)
  /// from their dots.
  void add_dots(const std::string& part, const std::vector<NamedSpot>& dots, const std::string& style,
                Spot shift = {1.8, 0.3});
  /// A caption, centred.
  void add_text(const std::string& text, Spot spot);

  /// `claims` as in Figure.
  void add_to(Results& results, std::vector<std::string> claims);

 private:
  std::string name_;
  std::string title_;
  std::vector<Series> series_;
  std::vector<Curve> curves_;
  std::vector<FigureText> texts_;
};

}  // namespace subdiv
