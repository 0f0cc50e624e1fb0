#include "experiments/plane_diagram.h"

#include <utility>

#include <fmt/format.h>

#include "experiments/surface_pictures.h"

namespace subdiv {
namespace {

constexpr int digits = 4;

std::string decimal(double x) { return to_decimal(Rational::from_double(x), digits); }

}  // namespace

void PlaneDiagram::add_lines(const std::string& part, const std::vector<std::vector<Spot>>& lines,
                             const std::string& style) {
  Series series{name_ + "-" + part, {"x", "y"}, {}};
  for (const std::vector<Spot>& line : lines) {
    for (const Spot& p : line) series.rows.push_back({decimal(p.x), decimal(p.y)});
    series.rows.push_back({"", ""});
  }
  curves_.push_back(drawn(series, "", style));
  series_.push_back(std::move(series));
}

void PlaneDiagram::add_dots(const std::string& part, const std::vector<NamedSpot>& dots,
                            const std::string& style, Spot shift) {
  Series series{name_ + "-" + part, {"name", "x", "y"}, {}};
  for (const auto& [name, p] : dots) {
    series.rows.push_back({name, decimal(p.x), decimal(p.y)});
    if (!name.empty())
      texts_.push_back({name, p.x, p.y, fmt::format("center offset {:.2f},{:.2f}", shift.x, shift.y)});
  }
  curves_.push_back(drawn(series, "", style));
  series_.push_back(std::move(series));
}

void PlaneDiagram::add_text(const std::string& text, Spot spot) { texts_.push_back({text, spot.x, spot.y}); }

void PlaneDiagram::add_to(Results& results, std::vector<std::string> claims) {
  results.figures.push_back(
      bare_figure(name_, title_, std::move(curves_), std::move(texts_), std::move(claims)));
  for (Series& series : series_) results.series.push_back(std::move(series));
}

}  // namespace subdiv
