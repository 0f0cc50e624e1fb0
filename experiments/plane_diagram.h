#pragma once

#include <string>
#include <vector>

#include "experiments/experiment.h"

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
  void add_text(const std::string& text, Spot spot, int size = 14);

  /// The frame is (lower, upper).
  void add_to(Results& results, Spot lower, Spot upper);

 private:
  std::string name_;
  std::string title_;
  std::vector<Series> series_;
  std::vector<Curve> curves_;
  std::string setup_;
};

namespace diagram_style {
inline const std::string thin = "lines lw 0.8 lc rgb '#bbbbbb'";
inline const std::string line = "lines lw 1.2 lc rgb '#555555'";
inline const std::string thick = "lines lw 2 lc rgb '#0072b2'";
inline const std::string dot = "points pt 7 ps 0.6 lc rgb '#000000'";
inline const std::string pale_dot = "points pt 7 ps 0.6 lc rgb '#aaaaaa'";
inline const std::string bright_dot = "points pt 7 ps 0.7 lc rgb '#d55e00'";
}  // namespace diagram_style

}  // namespace subdiv
