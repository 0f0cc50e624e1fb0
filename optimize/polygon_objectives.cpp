#include "optimize/polygon_objectives.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "analysis/area_mask.h"
#include "analysis/hausdorff_distance.h"
#include "analysis/limit_points.h"
#include "optimize/local_search.h"
#include "optimize/residual_functions.h"
#include "optimize/scheme_requirements.h"
#include "schemes/algebra/univariate.h"
#include "schemes/evaluate/level_by_level.h"
#include "schemes/input_error.h"
#include "schemes/text.h"

namespace subdiv {
namespace {

using Function = RationalFunction;
using Kind = PolygonObjective::Kind;
using Coordinates = std::vector<std::vector<Rational>>;
/// For every point a vector of functions of the parameters.
using Offsets = std::vector<std::vector<Function>>;

constexpr int greatest_level = 6;
constexpr std::size_t most_residuals = 4000;
constexpr int believed_decimals = 6;  // of what local searches find

const std::array table{
    ObjectiveDescription{"vertex-distance",
                         "with --polygon: from the control vertices to their limit points",
                         "l1 (local), l2, linf",
                         {},
                         "vertex-distance"},
    ObjectiveDescription{"edge-distance",
                         "with --polygon: from the middles of the edges to the limit points",
                         "l1 (local), l2, linf",
                         {},
                         "edge-distance"},
    ObjectiveDescription{"polygon-distance",
                         "with --polygon: Hausdorff distance between limit curve and polygon (local)",
                         "linf",
                         {},
                         "polygon-distance"},
    ObjectiveDescription{"area",
                         "with --polygon: area of the limit curve minus that of the polygon",
                         "any, all the same",
                         {},
                         "area"},
    ObjectiveDescription{
        "popping",
        "with --polygon: from the linear refinement of each level to the next level",
        "l1 (local), l2, linf",
        {{"level=K", fmt::format("levels 1 to K, K from 1 to {}; 1 when not given", greatest_level)}},
        "popping:level=3"},
};

std::string_view name_of(std::string_view text) { return trimmed(text.substr(0, text.find(':'))); }

std::vector<std::string> names() {
  std::vector<std::string> result;
  for (const ObjectiveDescription& entry : table) result.push_back(entry.name);
  return result;
}

/// One objective on one polygon, as functions of the parameters.
class PolygonProblem {
 public:
  PolygonProblem(const Scheme<Function>& scheme, const PolygonObjective& objective, Norm norm,
                 const Coordinates& coordinates, std::vector<Range> box, std::vector<std::string> names,
                 const Options& options)
      : scheme_(scheme),
        objective_(objective),
        norm_(norm),
        coordinates_(coordinates),
        box_(std::move(box)),
        names_(std::move(names)),
        options_(options) {}

  Summary minimise() const {
    require_polygon();
    require_binary(to_string(objective_), scheme_);
    require_steps(to_string(objective_), scheme_);
    require_primal(to_string(objective_), scheme_);
    if (box_.empty()) {
      throw InputError("nothing to optimise: name a parameter and its range, for example s=-2..6");
    }
    try {
      switch (objective_.kind) {
        case Kind::area:
          return minimise_area();
        case Kind::polygon_distance:
          return minimise_distance();
        case Kind::vertex_distance:
          return minimise_lengths(limit_offsets(vertex_limit_mask(scheme_) - Laurent<Function>(1)));
        case Kind::edge_distance:
          return minimise_lengths(limit_offsets(edge_limit_mask(scheme_) - middle()));
        case Kind::popping:
          break;
      }
      return minimise_lengths(level_offsets());
    } catch (const std::domain_error& error) {
      missing(error.what());
    }
  }

 private:
  [[noreturn]] void missing(const std::string& what) const { lacks(to_string(objective_), scheme_, what); }
  [[nodiscard]] std::size_t points() const { return coordinates_.front().size(); }
  [[nodiscard]] int variables() const { return static_cast<int>(box_.size()); }
  [[nodiscard]] Problem problem(std::vector<Function> residuals, Norm norm) const {
    return {std::move(residuals), norm, box_, names_};
  }
  static Laurent<Function> middle() {
    return Laurent<Function>(0, {fraction<Function>(1, 2), fraction<Function>(1, 2)});
  }

  void require_polygon() const {
    const std::string place = "objective " + to_string(objective_) + ": ";
    if (coordinates_.empty() || points() == 0) throw InputError(place + "the polygon has no points");
    if (objective_.kind != Kind::area) return;
    if (coordinates_.size() != 2) {
      throw InputError(fmt::format("{}areas need points x,y of two coordinates, these have {}", place,
                                   coordinates_.size()));
    }
  }

  /// A mask applied at every vertex.
  [[nodiscard]] Offsets limit_offsets(const Laurent<Function>& mask) const {
    Offsets result(points(), std::vector<Function>(coordinates_.size()));
    for (std::size_t c = 0; c < coordinates_.size() && !mask.is_zero(); ++c) {
      const ControlPolygon<Function> values = closed_polygon(functions(coordinates_[c]));
      for (std::size_t i = 0; i < points(); ++i)
        result[i][c] = apply_mask(mask, values, static_cast<long long>(i));
    }
    return result;
  }

  static std::vector<Function> functions(const std::vector<Rational>& values) {
    return {values.begin(), values.end()};
  }

  /// Of the points of levels 1 .. objective.level.
  [[nodiscard]] Offsets level_offsets() const {
    Offsets result;
    for (int k = 1; k <= objective_.level; ++k) result.resize(result.size() + (points() << k));
    if (result.size() * coordinates_.size() > most_residuals) {
      missing(fmt::format("{} points of levels 1 to {} are too many; at most {} numbers", result.size(),
                          objective_.level, most_residuals));
    }
    for (const std::vector<Rational>& values : coordinates_) {
      ControlPolygon<Function> parent = closed_polygon(functions(values));
      std::size_t next = 0;
      for (int k = 0; k < objective_.level; ++k) {
        ControlPolygon<Function> fine = refine_once(scheme_.step(static_cast<std::size_t>(k)), parent);
        for (std::size_t i = 0; i < fine.points.size(); ++i) {
          const auto j = static_cast<long long>(i / 2);
          const Function linear =
              i % 2 == 0 ? parent.at(j) : apply_mask(middle(), parent, static_cast<long long>(j));
          result[next++].push_back(fine.points[i] - linear);
        }
        parent = std::move(fine);
      }
    }
    return result;
  }

  [[nodiscard]] Summary minimise_area() const {
    std::vector<std::pair<Rational, Rational>> polygon;
    for (std::size_t i = 0; i < points(); ++i) polygon.emplace_back(coordinates_[0][i], coordinates_[1][i]);
    const std::span<const std::pair<Rational, Rational>> view(polygon);
    const Laurent<Function> difference = area_mask(scheme_) - polygon_area_mask<Function>();
    Function change;
    for (int k = difference.first(); k <= difference.last(); ++k)
      change += difference[k] * Function(cross_sum(view, k) * Rational(1, 2));
    if (change.is_zero()) return zero_everywhere();
    if (auto zeros = zeros_or_pole({change}, "real roots of the exact area")) return std::move(*zeros);
    return subdiv::minimise(problem({change}, Norm::l1), options_);
  }

  /// The objective vanishes identically.
  [[nodiscard]] Summary zero_everywhere() const {
    Summary summary;
    summary.termination = Termination::not_unique;
    summary.method = "identity of rational functions";
    summary.message = "the objective is 0 for all values of the parameters; those given are the box's centre";
    summary.minimum = exact(Rational(0), summary.method);
    for (const Range& range : box_)
      summary.minimiser.push_back(exact((range.lower + range.upper) / Rational(2), summary.method));
    return summary;
  }

  /// Over one parameter, decided exactly; false over several.
  [[nodiscard]] bool has_pole(const std::vector<Function>& residuals) const {
    return variables() == 1 && std::ranges::any_of(residuals, [&](const Function& f) {
             return count_roots(UnivariatePolynomial(f.denominator(), 0), box_[0].lower, box_[0].upper) > 0;
           });
  }

  /// Over one parameter: where all residuals vanish together, or that one has a pole; nothing when they do
  /// not, or over several parameters.
  [[nodiscard]] std::optional<Summary> zeros_or_pole(const std::vector<Function>& residuals,
                                                     const std::string& method) const {
    if (variables() != 1 || !(box_[0].lower < box_[0].upper)) return std::nullopt;
    Summary summary;
    if (has_pole(residuals)) {
      summary.termination = Termination::pole_in_box;
      summary.message = "the objective has a pole in the range";
      return summary;
    }
    UnivariatePolynomial common;
    for (const Function& f : residuals) common = gcd(common, UnivariatePolynomial(f.numerator(), 0));
    for (const RealRoot& root : real_roots(common)) {
      if (root.value < Algebraic(box_[0].lower) || Algebraic(box_[0].upper) < root.value) continue;
      summary.zeros.push_back(exact(root.value, method));
    }
    if (summary.zeros.empty()) return std::nullopt;
    const bool unique = summary.zeros.size() == 1;
    summary.termination = unique ? Termination::proved : Termination::not_unique;
    summary.minimiser = {summary.zeros.front()};
    summary.minimum = exact(Rational(0), method);
    summary.method = method;
    summary.message = unique ? "the objective is 0 there, and nowhere else in the range"
                             : fmt::format("the objective is 0 at {} values", summary.zeros.size());
    return summary;
  }

  /// A norm of vectors' lengths.
  [[nodiscard]] Summary minimise_lengths(const Offsets& offsets) const {
    std::vector<Function> components;
    std::vector<Function> squares;
    for (const std::vector<Function>& offset : offsets) {
      Function square;
      for (const Function& f : offset) {
        if (f.is_zero()) continue;
        components.push_back(f);
        square += f * f;
      }
      if (!square.is_zero()) squares.push_back(std::move(square));
    }
    if (components.empty()) return zero_everywhere();
    if (auto zeros = zeros_or_pole(components, "common real roots of all offsets")) return std::move(*zeros);
    if (norm_ == Norm::l2 || coordinates_.size() == 1)
      return or_zero(subdiv::minimise(problem(components, norm_), options_), components);
    if (norm_ == Norm::l1) return minimise_sum_of_lengths(squares);
    Summary summary = or_zero(subdiv::minimise(problem(squares, Norm::linf), options_), components);
    summary.minimum = root(summary.minimum);
    return summary;
  }

  /// Over several parameters a minimum of squares that may be 0 is decided by the offsets themselves.
  [[nodiscard]] Summary or_zero(Summary summary, const std::vector<Function>& components) const {
    const bool may_vanish = summary.minimiser.empty() || summary.minimum.lower.sign() <= 0;
    if (variables() == 1 || !may_vanish || summary.termination == Termination::pole_in_box) return summary;
    Summary zero = subdiv::minimise(problem(components, Norm::linf), options_);
    const bool vanishes =
        !zero.minimiser.empty() && zero.minimum.rigour == Rigour::exact && zero.minimum.upper.sign() == 0;
    return vanishes ? zero : summary;
  }

  /// The square root of a number that is not negative.
  static Enclosure root(const Enclosure& square) {
    const Rational lower = std::max(Rational(0), square.lower);
    if (square.rigour == Rigour::exact && square.lower == square.upper)
      return exact(sqrt(Algebraic(lower)), square.method);
    const Interval bounds = sqrt(Interval::hull(lower, std::max(lower, square.upper)));
    Enclosure result = certified(std::max(Rational(0), bounds.lower()), bounds.upper(), square.method);
    result.rigour = square.rigour == Rigour::exact ? Rigour::certified : square.rigour;
    result.status = square.status;
    return result;
  }

  [[nodiscard]] Summary minimise_sum_of_lengths(const std::vector<Function>& squares) const {
    constexpr long double_precision = 64;
    std::vector<CompiledFunction> compiled;
    for (const Function& f : squares) compiled.emplace_back(f, variables(), double_precision);
    const auto sum = [&](const std::vector<double>& x) {
      double total = 0;
      for (const CompiledFunction& f : compiled) total += std::sqrt(std::max(0.0, f.evaluate(x)));
      return total;
    };
    return local_summary(sum, options_.starts, believed_decimals);
  }

  [[nodiscard]] Summary minimise_distance() const {
    if (norm_ != Norm::linf) {
      throw InputError("objective polygon-distance is a Hausdorff distance: its norm is linf, not " +
                       to_string(norm_));
    }
    constexpr int starts = 8;  // each value of the objective takes a millisecond or more
    std::vector<std::vector<double>> values;
    for (const std::vector<Rational>& c : coordinates_) {
      values.emplace_back();
      for (const Rational& x : c) values.back().push_back(x.to_double());
    }
    const Polyline controls = make_polyline(std::move(values), true);
    constexpr double part = 1e-9;
    const double tolerance = std::max(part * length(controls), std::numeric_limits<double>::min());
    const auto distance = [&](const std::vector<double>& x) {
      try {
        return hausdorff_distance(limit_curve(controls, x), controls, tolerance).upper;
      } catch (const std::logic_error&) {  // no limit mask, or no finite points, for these parameters
        return std::numeric_limits<double>::infinity();
      }
    };
    // The curve is a polygon of level 6, within about 1/10000 of its extent.
    constexpr double relative_decimals = 3;
    const int decimals = static_cast<int>(relative_decimals - std::floor(std::log10(length(controls))));
    return local_summary(distance, std::min(starts, options_.starts),
                         std::clamp(decimals, 0, believed_decimals));
  }

  /// The limit points of level 6, or of the level at which the last step has begun.
  [[nodiscard]] Polyline limit_curve(const Polyline& controls, const std::vector<double>& x) const {
    constexpr int fine = 6;
    const Scheme<double> scheme =
        map_coefficients(scheme_, [&](const Function& f) { return f.evaluate(std::span<const double>(x)); });
    const Laurent<double> mask = limit_mask(scheme.last());
    Polyline curve = refine(scheme, controls, std::max(fine, static_cast<int>(scheme.steps.size()) - 1));
    for (std::vector<double>& c : curve.coordinates) {
      const ControlPolygon<double> level = closed_polygon(std::move(c));
      c.clear();
      for (std::size_t i = 0; i < level.points.size(); ++i)
        c.push_back(apply_mask(mask, level, static_cast<long long>(i)));
    }
    return curve;
  }

  template <class Value>
  [[nodiscard]] Summary local_summary(const Value& value, int starts, int decimals) const {
    for (std::size_t i = 0; i < box_.size(); ++i) {
      if (!(box_[i].lower < box_[i].upper))
        throw InputError(names_[i] + ": the range is empty; its lower end must be below its upper end");
    }
    constexpr double tolerance = 1e-9;
    const std::vector<LocalMinimum> found = local_minima(value, box_, starts, tolerance);
    Summary summary;
    summary.method = fmt::format("Sbplx from {} starts", starts);
    if (found.empty()) {
      summary.message = "no start of the local solver converged";
      return summary;
    }
    summary.termination = Termination::local;
    for (const double x : found.front().x)
      summary.minimiser.push_back(approximate(x, decimals, summary.method));
    summary.minimum = approximate(found.front().objective, decimals, summary.method);
    summary.message = found.size() == 1
                          ? "all local searches end there; nothing is proved"
                          : fmt::format("the best of {} local minima; nothing is proved", found.size());
    return summary;
  }

  const Scheme<Function>& scheme_;
  const PolygonObjective& objective_;
  Norm norm_;
  const Coordinates& coordinates_;
  std::vector<Range> box_;
  std::vector<std::string> names_;
  const Options& options_;
};

}  // namespace

std::span<const ObjectiveDescription> polygon_objectives() { return table; }

bool names_polygon_objective(std::string_view text) { return std::ranges::count(names(), name_of(text)) > 0; }

PolygonObjective parse_polygon_objective(std::string_view text) {
  const std::vector<std::string> known = names();
  const std::string_view name = name_of(text);
  const auto found = std::ranges::find(known, name);
  if (found == known.end()) {
    throw InputError(fmt::format("objective {}: unknown{} The objectives of a polygon are {}.",
                                 in_quotes(name), suggestion(name, known), joined(known, "and")));
  }
  PolygonObjective objective{static_cast<Kind>(found - known.begin()), 1};
  const auto colon = text.find(':');
  if (colon == std::string_view::npos) return objective;
  const std::string_view option = trimmed(text.substr(colon + 1));
  constexpr std::string_view level = "level=";
  if (objective.kind != Kind::popping || !option.starts_with(level)) {
    throw InputError(fmt::format("objective {}: unknown option {}; {}", name, in_quotes(option),
                                 objective.kind == Kind::popping ? "it takes level" : "it takes none"));
  }
  const std::string_view digits = option.substr(level.size());
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), objective.level);
  if (error != std::errc() || end != digits.data() + digits.size() || objective.level < 1 ||
      objective.level > greatest_level) {
    throw InputError(fmt::format("objective {}: level: expected a whole number from 1 to {}, found {}", name,
                                 greatest_level, in_quotes(digits)));
  }
  return objective;
}

std::string to_string(const PolygonObjective& objective) {
  const std::string& name = table[static_cast<std::size_t>(objective.kind)].name;
  return objective.kind == Kind::popping ? fmt::format("{}:level={}", name, objective.level) : name;
}

Summary minimise_on_polygon(const Scheme<Function>& scheme, const PolygonObjective& objective, Norm norm,
                            const std::vector<std::vector<Rational>>& coordinates, std::vector<Range> box,
                            std::vector<std::string> names, const Options& options) {
  return PolygonProblem(scheme, objective, norm, coordinates, std::move(box), std::move(names), options)
      .minimise();
}

}  // namespace subdiv
