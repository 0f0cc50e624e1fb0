#include "experiments/smoothness_maps.h"

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "analysis/radius_map.h"
#include "analysis/three_tap_smoothness.h"
#include "experiments/report/figure_style.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

constexpr int depth = 9;  // of the maps whose areas are claimed
constexpr int drawn = 8;  // of the cells in the figures
constexpr int digits = 15;

/// A map of C^order over (a, b) in [a_lower, a_upper] x [b_lower, b_upper].
struct MapPlan {
  int order;
  int a_lower;
  int a_upper;
  int b_lower;
  int b_upper;

  [[nodiscard]] ParameterBox box() const { return {{a_lower, b_lower}, {a_upper, b_upper}}; }
  [[nodiscard]] std::string text() const {
    return fmt::format("{} <= a <= {}, {} <= b <= {}", a_lower, a_upper, b_lower, b_upper);
  }
};

const std::array<MapPlan, 2> plans{MapPlan{0, -7, 10, -10, 11}, MapPlan{1, -4, 7, -5, 10}};

std::vector<ClaimHead> make_heads() {
  std::vector<ClaimHead> heads;
  const auto add = [&](const std::string& id, const std::string& definition) {
    heads.push_back(finding(id, "jsplines 6", definition));
  };
  for (const MapPlan& plan : plans) {
    const std::string id = fmt::format("smooth.map.c{}.", plan.order);
    const std::string where = fmt::format(" in the rectangle {}, halved {} times.", plan.text(), depth);
    add(id + "in",
        fmt::format("Area of the cells in which *J_{{a,b}} is proved to be C{}", plan.order) + where);
    add(id + "out",
        fmt::format("Area of the cells in which the scheme *J_{{a,b}} is proved not to be C{}", plan.order) +
            where);
    add(id + "undecided", "Area of the cells that are neither" + where);
  }
  add("smooth.map.depth", "Do the undecided areas of both maps fall with every halving of the cells?");
  return heads;
}

const std::vector<ClaimHead>& table() {
  static const std::vector<ClaimHead> heads = make_heads();
  return heads;
}

const std::string& name_of(Decision decision) {
  static const std::map<Decision, std::string> names{
      {Decision::yes, "in"}, {Decision::no, "out"}, {Decision::undecided, "undecided"}};
  return names.at(decision);
}

constexpr std::array decisions{Decision::yes, Decision::no, Decision::undecided};

/// How often the map's box was halved to make the cell.
int level_of(const MapCell& cell, const MapPlan& plan) {
  int level = 0;
  Rational width = Rational(plan.a_upper - plan.a_lower);
  for (; width > cell.box.upper[0] - cell.box.lower[0]; ++level) width /= Rational(2);
  return level;
}

/// The areas decided when cells are halved at most `levels` times: a cell that is decided at its own level is
/// decided there in every deeper map.
std::map<Decision, Rational> areas_at(const RadiusMap& map, const MapPlan& plan, int levels) {
  std::map<Decision, Rational> areas;
  for (const MapCell& cell : map.cells) {
    const bool known = cell.below != Decision::undecided && level_of(cell, plan) <= levels;
    areas[known ? cell.below : Decision::undecided] += cell.box.volume();
  }
  return areas;
}

// ---- A second route --------------------------------------------------------------------------------------

/// A line (a, b) = (intercept + slope t, t) on which the scheme is C^m exactly for t in a known set: taps
/// p = (t - 1) / scale.
struct KnownLine {
  Rational intercept;
  Rational slope;
  int factors;
  int scale;
};

const std::array<KnownLine, 3> known_lines{KnownLine{0, 1, 4, 2}, KnownLine{2, 0, 3, 4},
                                           KnownLine{-1, 1, 2, 8}};

/// Cells that meet such a line agree with what is known there.
void check_on_lines(const RadiusMap& map, const MapPlan& plan) {
  constexpr int steps = 60;
  for (const KnownLine& line : known_lines) {
    const RealSet taps = three_tap_continuity_set(line.factors, plan.order);
    for (int i = 0; i <= steps; ++i) {
      const Rational b = Rational(plan.b_lower) + Rational(plan.b_upper - plan.b_lower) * Rational(i, steps);
      const std::array<Rational, 2> at{line.intercept + line.slope * b, b};
      const bool smooth = taps.contains(Algebraic((b - Rational(1)) / Rational(line.scale)));
      for (const MapCell& cell : map.cells) {
        bool inside = cell.below != Decision::undecided;
        for (std::size_t k = 0; k < at.size(); ++k) {
          inside = inside && cell.box.lower[k] <= at[k] && at[k] <= cell.box.upper[k];
        }
        if (inside && (cell.below == Decision::yes) != smooth) {
          throw std::logic_error("the map contradicts the exact range on a line at b = " + b.to_string());
        }
      }
    }
  }
}

// ---- Figures ---------------------------------------------------------------------------------------------

/// Equal neighbours of the grid of smallest cells merged into rectangles, one series for each decision.
std::map<Decision, Series> rectangles(const RadiusMap& map, const MapPlan& plan) {
  constexpr int size = 1 << drawn;
  std::vector<std::vector<Decision>> grid(size, std::vector<Decision>(size, Decision::undecided));
  const auto at = [&](int i, int j) -> Decision& {
    return grid[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  };
  const ParameterBox box = plan.box();
  const auto index = [&](const Rational& x, std::size_t k) {
    return static_cast<int>(
        ((x - box.lower[k]) * Rational(size) / (box.upper[k] - box.lower[k])).to_integer());
  };
  for (const MapCell& cell : map.cells) {
    if (cell.below == Decision::undecided || level_of(cell, plan) > drawn) continue;
    for (int i = index(cell.box.lower[0], 0); i < index(cell.box.upper[0], 0); ++i) {
      for (int j = index(cell.box.lower[1], 1); j < index(cell.box.upper[1], 1); ++j) at(i, j) = cell.below;
    }
  }

  std::map<Decision, Series> result;
  for (const Decision decision : decisions) {
    result[decision] = {fmt::format("smooth-map-c{}-{}", plan.order, name_of(decision)),
                        {"a lower", "a upper", "b lower", "b upper"},
                        {}};
  }
  const auto place = [&](int i, std::size_t k) {
    return to_significant(box.lower[k] + (box.upper[k] - box.lower[k]) * Rational(i, size), digits);
  };
  using Run = std::tuple<Decision, int, int>;  // of cells in one column
  std::map<Run, int> open;                     // with the column in which it begins
  for (int i = 0; i <= size; ++i) {
    std::map<Run, int> here;
    for (int j = 0; i < size && j < size;) {
      int end = j + 1;
      while (end < size && at(i, end) == at(i, j)) ++end;
      const Run run{at(i, j), j, end};
      const auto before = open.find(run);
      here[run] = before == open.end() ? i : before->second;
      j = end;
    }
    for (const auto& [run, begin] : open) {
      const auto& [decision, low, high] = run;
      if (here.contains(run)) continue;
      result[decision].rows.push_back({place(begin, 0), place(i, 0), place(low, 1), place(high, 1)});
    }
    open = std::move(here);
  }
  return result;
}

void add_map_figure(Results& results, const RadiusMap& map, const MapPlan& plan) {
  for (auto& [decision, series] : rectangles(map, plan)) results.series.push_back(std::move(series));
  const std::string name = fmt::format("smooth-map-c{}", plan.order);
  Figure figure{name,
                fmt::format("Where the scheme *J_{{a,b}} is C^{}", plan.order),
                "parameter a",
                "parameter b",
                {},
                fmt::format("set xrange [{}:{}]; set yrange [{}:{}]; set clip two; unset grid; "
                            "set style fill solid 1 noborder",
                            plan.a_lower, plan.a_upper, plan.b_lower, plan.b_upper),
                {fmt::format("smooth.map.c{}.", plan.order), "smooth.ab."}};
  const std::array<std::tuple<Decision, std::string, std::string_view>, 3> colours{
      std::tuple{Decision::yes, fmt::format("proved C^{}", plan.order), style::blue},
      std::tuple{Decision::no, std::string("proved not"), style::yellow},
      std::tuple{Decision::undecided, std::string("undecided"), style::black}};
  for (const auto& [decision, label, colour] : colours) {
    figure.curves.push_back({name + "-" + name_of(decision),
                             "a lower",
                             "b lower",
                             label,
                             fmt::format("boxxyerror lc rgb '{}'", colour),
                             {"a lower", "a upper", "b lower", "b upper"}});
  }
  const std::array<const char*, 4> lines{"a = b", "a = 2", "a = b-1", "2a+b = 9"};
  for (std::size_t i = 0; i < lines.size(); ++i)
    figure.curves.push_back({"smooth-map-lines", "a", lines.at(i), lines.at(i),
                             style::dashed(i, i == 0 ? style::vermilion : style::black, i == 0 ? 2 : 1.5)});
  results.figures.push_back(std::move(figure));
}

/// The diagonal and the three lines on which shifts are dependent, beyond both boxes.
Series lines_series() {
  return {"smooth-map-lines",
          {"a", "a = b", "a = 2", "a = b-1", "2a+b = 9"},
          {{"-20", "-20", "", "-19", "49"},
           {"20", "20", "", "21", "-31"},
           {"2", "", "-20", "", ""},
           {"2", "", "20", "", ""}}};
}

void add_area_figure(Results& results, const std::vector<RadiusMap>& maps) {
  Series series{"smooth-map-area", {"depth"}, {}};
  for (const MapPlan& plan : plans) {
    for (const Decision decision : decisions) {
      series.columns.push_back(fmt::format("C{} {}", plan.order, name_of(decision)));
    }
  }
  bool falls = true;
  std::array<Rational, 2> before{plans[0].box().volume(), plans[1].box().volume()};
  constexpr int first = 3;
  for (int levels = first; levels <= depth; ++levels) {
    std::vector<std::string> row{std::to_string(levels)};
    for (std::size_t i = 0; i < plans.size(); ++i) {
      std::map<Decision, Rational> areas = areas_at(maps[i], plans[i], levels);
      for (const Decision decision : decisions) row.push_back(to_significant(areas[decision], digits));
      falls = falls && areas[Decision::undecided] < before[i];
      before[i] = areas[Decision::undecided];
    }
    series.rows.push_back(std::move(row));
  }
  results.claims.push_back(
      settle_statement(head(table(), "smooth.map.depth"), falls, "true",
                       fmt::format("At every depth from {} to {}: series smooth-map-area.", first, depth)));
  results.series.push_back(std::move(series));
  results.figures.push_back({"smooth-map-area",
                             "What is left undecided in the maps of *J_{a,b} as their cells shrink",
                             "halvings of the cells",
                             "area in the (a, b) plane",
                             {{"smooth-map-area", "depth", "C0 undecided", "C^0, of 357", style::marked(0)},
                              {"smooth-map-area", "depth", "C1 undecided", "C^1, of 165", style::marked(1)}},
                             "set logscale y; set xtics 1",
                             {"smooth.map.depth", "smooth.map.c0.undecided", "smooth.map.c1.undecided"}});
}

void add_areas(Results& results, const RadiusMap& map, const MapPlan& plan) {
  const Rational total = plan.box().volume();
  for (const Decision decision : decisions) {
    constexpr int shown = 3;
    const Rational area = map.volume(decision);
    std::string note = fmt::format("{}% of the area.", to_significant(area * Rational(100) / total, shown));
    if (decision == Decision::no) {
      note += " On parts of the line 2a+b = 9 limits are smoother than the scheme (smooth.ab.line.cycle).";
    }
    results.claims.push_back(settle(
        head(table(), fmt::format("smooth.map.c{}.{}", plan.order, name_of(decision))),
        exact(area, decision == Decision::yes ? "polytopes for whole cells" : "conditions on whole cells"),
        note));
  }
}

}  // namespace

std::span<const ClaimHead> smoothness_map_heads() { return table(); }

Results run_smoothness_maps() {
  Results results;
  const Mask<RationalFunction> mask = jspline(RationalFunction::variable(0), RationalFunction::variable(1));
  RadiusMapOptions options;
  options.depth = depth;
  std::vector<RadiusMap> maps;
  results.series.push_back(lines_series());
  for (const MapPlan& plan : plans) {
    maps.push_back(continuity_map(mask, plan.order, plan.box(), options));
    check_on_lines(maps.back(), plan);
    add_areas(results, maps.back(), plan);
    add_map_figure(results, maps.back(), plan);
  }
  add_area_figure(results, maps);
  return results;
}

}  // namespace subdiv
