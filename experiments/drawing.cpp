#include "experiments/drawing.h"

#include <algorithm>

#include <fmt/format.h>

namespace subdiv {
namespace {

struct Extent {
  double left = 0;
  double right = 0;
  double bottom = 0;
  double top = 0;
};

Extent extent_of(const std::vector<Panel>& panels) {
  Extent extent;
  bool first = true;
  for (const Panel& panel : panels) {
    for (const Stroke& stroke : panel.strokes) {
      for (const auto& [x, y] : stroke.points) {
        const double at_x = x.to_double();
        const double at_y = y.to_double();
        if (first) extent = {at_x, at_x, at_y, at_y};
        first = false;
        extent = {std::min(extent.left, at_x), std::max(extent.right, at_x), std::min(extent.bottom, at_y),
                  std::max(extent.top, at_y)};
      }
    }
  }
  return extent;
}

void add_columns(Series& series, const std::string& name, const Stroke& stroke) {
  constexpr int digits = 12;
  PlanePoints points = stroke.points;
  if (stroke.closed && !points.empty()) points.push_back(points.front());
  const std::size_t before = series.columns.size();
  series.columns.push_back(name + " x");
  series.columns.push_back(name + " y");
  if (series.rows.size() < points.size()) series.rows.resize(points.size(), std::vector<std::string>(before));
  for (std::size_t i = 0; i < series.rows.size(); ++i) {
    const bool point = i < points.size();
    series.rows[i].push_back(point ? to_significant(points[i].first, digits) : "");
    series.rows[i].push_back(point ? to_significant(points[i].second, digits) : "");
  }
}

}  // namespace

namespace style {

std::string line(std::size_t i, double width) {
  return fmt::format("lines lw {} lc rgb '{}'", width, colours[i % colours.size()]);
}

}  // namespace style

void add_drawing(Results& results, const Drawing& drawing) {
  const Extent extent = extent_of(drawing.panels);
  constexpr double gap =
      0.12;  // beside a panel, in its width; below it, with the caption, twice in its height
  constexpr std::size_t most_in_row = 4;
  const double width = extent.right - extent.left;
  const double height = extent.top - extent.bottom;
  const std::size_t count = drawing.panels.size();
  const std::size_t rows = (count + most_in_row - 1) / most_in_row;
  const std::size_t columns = (count + rows - 1) / rows;
  Series series{drawing.name, {}, {}};
  Figure figure{drawing.name, drawing.title, "", "", {}, ""};
  for (std::size_t p = 0; p < count; ++p) {
    const Panel& panel = drawing.panels[p];
    const std::size_t row = p / columns;
    const double right = static_cast<double>(p - row * columns) * width * (1 + gap);
    const double up = -static_cast<double>(row) * height * (1 + 3 * gap);
    for (std::size_t k = 0; k < panel.strokes.size(); ++k) {
      const Stroke& stroke = panel.strokes[k];
      const std::string name =
          fmt::format("{}.{}{}{}", p + 1, k + 1, stroke.label.empty() ? "" : " ", stroke.label);
      add_columns(series, name, stroke);
      Curve curve{drawing.name, name + " x", name + " y", stroke.label, stroke.style};
      curve.right = right;
      curve.up = up;
      figure.curves.push_back(std::move(curve));
    }
    figure.setup += fmt::format("set label '{}' at {:.6g},{:.6g} center\n", panel.caption,
                                right + (extent.left + extent.right) / 2, up + extent.bottom - gap * height);
  }
  const auto last_column = static_cast<double>(columns - 1);
  const auto last_row = static_cast<double>(rows - 1);
  figure.setup += fmt::format(
      "set size ratio -1; set xrange [{:.6g}:{:.6g}]; set yrange [{:.6g}:{:.6g}]\n"
      "set key below center horizontal; unset grid; unset border; unset tics",
      extent.left - gap * width / 2, extent.right + gap * width / 2 + last_column * width * (1 + gap),
      extent.bottom - 2 * gap * height - last_row * height * (1 + 3 * gap), extent.top + gap * height);
  results.series.push_back(std::move(series));
  results.figures.push_back(std::move(figure));
}

}  // namespace subdiv
