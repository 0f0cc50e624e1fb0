#include "experiments/drawing.h"

#include <algorithm>

#include <fmt/format.h>

#include "experiments/report/figure_text.h"

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

void add_drawing(Results& results, const Drawing& drawing) {
  const Extent extent = extent_of(drawing.panels);
  constexpr double between = 14;       // panels, in units of the canvas
  constexpr double with_caption = 44;  // below a panel
  constexpr double tallest = 380;      // all rows
  constexpr std::size_t most_in_row = 4;
  const double width = extent.right - extent.left;
  const double height = extent.top - extent.bottom;
  const std::size_t count = drawing.panels.size();
  constexpr double caption_character = 8;  // most have indices
  double widest = 0;
  for (const Panel& panel : drawing.panels)
    widest = std::max(widest, caption_character * static_cast<double>(plain_text(panel.caption).size()));
  const auto fitting = static_cast<std::size_t>(style::canvas_width / std::max(widest + between, 1.0));
  const std::size_t columns_at_most = std::clamp<std::size_t>(fitting, 1, most_in_row);
  const std::size_t rows = (count + columns_at_most - 1) / columns_at_most;
  const std::size_t columns = (count + rows - 1) / rows;
  const double scale = std::min((style::canvas_width / static_cast<double>(columns) - between) / width,
                                (tallest / static_cast<double>(rows) - with_caption) / height);
  const double to_right = std::max(width + between / scale, (widest + between) / scale);
  const double downwards = height + with_caption / scale;
  Series series{drawing.name, {}, {}};
  Figure figure{drawing.name, drawing.title, "", "", {}, "", drawing.claims};
  figure.picture = true;
  for (std::size_t p = 0; p < count; ++p) {
    const Panel& panel = drawing.panels[p];
    const std::size_t row = p / columns;
    const double right = static_cast<double>(p - row * columns) * to_right;
    const double up = -static_cast<double>(row) * downwards;
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
    for (FigureText text : panel.texts) {
      text.x += right;
      text.y += up;
      figure.texts.push_back(std::move(text));
    }
    constexpr double below = 20;
    if (!panel.caption.empty())
      figure.texts.push_back(
          {panel.caption, right + (extent.left + extent.right) / 2, up + extent.bottom - below / scale});
  }
  results.series.push_back(std::move(series));
  results.figures.push_back(std::move(figure));
}

}  // namespace subdiv
