#include "analysis/open_polygon.h"

#include <string>

namespace subdiv {
namespace {

/// A scheme with every real parameter left free, and the values that it had.
struct FreedScheme {
  SchemeDescription scheme;
  std::vector<Expression> values;
};

bool is_whole(const StepDescription& step, const std::string& name) {
  if (step.form == nullptr) return false;
  return std::ranges::any_of(step.form->parameters,
                             [&](const Parameter& p) { return p.whole && p.name == name; });
}

FreedScheme freed(SchemeDescription scheme) {
  FreedScheme result{std::move(scheme), {}};
  result.scheme.free_parameters.clear();
  for (StepDescription& step : result.scheme.steps) {
    for (Argument& argument : step.arguments) {
      if (is_whole(step, argument.name)) continue;
      const std::string name = "p" + std::to_string(result.values.size());
      result.values.push_back(argument.value);
      result.scheme.free_parameters.push_back(name);
      argument.value = Expression::parse(name);
    }
  }
  return result;
}

template <class R>
R value_of(const Expression& value, const SchemeDescription& scheme, std::span<const R> free_values) {
  return evaluate<R>(value, [&](const std::string& name, const Expression::Node&) {
    const auto place = std::ranges::find(scheme.free_parameters, name) - scheme.free_parameters.begin();
    return free_values[static_cast<std::size_t>(place)];
  });
}

/// Clamped ends as functions of all real parameters; nothing where there are too many of them or none, or
/// where they have no common formula.
std::optional<EndWeights<RationalFunction>> clamped_formulas(const FreedScheme& freed) {
  if (freed.values.empty() || freed.values.size() > max_free_parameters) return std::nullopt;
  try {
    return end_weights(symbolic_scheme(freed.scheme), OpenEnd::clamped);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

bool has_value(const Interval& x) { return x.is_finite(); }
template <ExactRing R>
bool has_value(const R& /*x*/) {
  return true;
}

/// `count` points from their formulas, the ones that have none reflected; nothing at a pole.
template <class R>
std::optional<std::vector<Laurent<R>>> evaluated(const std::vector<Laurent<RationalFunction>>& formulas,
                                                 std::span<const R> values, int count) {
  std::vector<Laurent<R>> points = reflected_end<R>(count);
  bool exists = true;
  try {
    for (std::size_t k = 0; k < std::min(points.size(), formulas.size()); ++k) {
      points[k] = map_coefficients(formulas[k], [&](const RationalFunction& f) {
        R value = f.evaluate(values);
        exists = exists && has_value(value);
        return value;
      });
    }
  } catch (const std::domain_error&) {
    return std::nullopt;
  }
  return exists ? std::optional(std::move(points)) : std::nullopt;
}

/// Clamped ends of a described scheme by the formulas; nothing where they have no value.
template <class R>
std::optional<EndWeights<R>> clamped_by_formulas(const SchemeDescription& description,
                                                 const Scheme<R>& scheme, std::span<const R> free_values) {
  const FreedScheme parameters = freed(description);
  const auto formulas = clamped_formulas(parameters);
  if (!formulas) return std::nullopt;
  std::vector<R> values;
  for (const Expression& value : parameters.values)
    values.push_back(value_of<R>(value, description, free_values));
  const IndexWindow window = vertex_reach(scheme);
  auto start = evaluated<R>(formulas->start, values, -window.first);
  auto finish = evaluated<R>(formulas->finish, values, window.last);
  if (!start || !finish) return std::nullopt;
  return EndWeights<R>{std::move(*start), std::move(*finish)};
}

template <class R, class Round>
EndWeights<double> rounded(const EndWeights<R>& weights, Round round) {
  EndWeights<double> result;
  for (const Laurent<R>& w : weights.start) result.start.push_back(map_coefficients(w, round));
  for (const Laurent<R>& w : weights.finish) result.finish.push_back(map_coefficients(w, round));
  return result;
}

double nearest(const Rational& x) { return x.to_double(); }
double nearest(const Interval& x) { return x.midpoint().to_double(); }
double nearest(const Algebraic& x) { return nearest(x.to_interval()); }

/// Masks over intervals: reflected ends need no division, clamped ones a formula.
EndWeights<double> weights_of_inexact_masks(const SchemeDescription& description, OpenEnd end) {
  const Scheme<Interval> scheme = interval_scheme(description);
  const auto round = [](const Interval& x) { return nearest(x); };
  if (end == OpenEnd::reflected) {
    const IndexWindow window = vertex_reach(scheme);
    return {reflected_end<double>(-window.first), reflected_end<double>(window.last)};
  }
  if (const auto weights = clamped_by_formulas<Interval>(description, scheme, {})) {
    return rounded(*weights, round);
  }
  throw InputError("clamped ends of " + description.text +
                   ": its masks are not known exactly; choose reflected ends");
}

}  // namespace

template <ExactRing R>
EndWeights<R> end_weights(const SchemeDescription& description, OpenEnd end, std::span<const R> free_values) {
  const Scheme<R> scheme = instantiate<R>(description, free_values);
  if (end == OpenEnd::clamped) {
    if (auto weights = clamped_by_formulas<R>(description, scheme, free_values)) return std::move(*weights);
  }
  return end_weights(scheme, end);
}

template EndWeights<Rational> end_weights(const SchemeDescription&, OpenEnd, std::span<const Rational>);
template EndWeights<Algebraic> end_weights(const SchemeDescription&, OpenEnd, std::span<const Algebraic>);
template EndWeights<RationalFunction> end_weights(const SchemeDescription&, OpenEnd,
                                                  std::span<const RationalFunction>);

EndWeights<double> end_weights_in_double(const SchemeDescription& scheme, OpenEnd end) {
  if (!scheme.free_parameters.empty()) {
    throw InputError(scheme.text + ": the ends of a curve need values for all parameters; give one for " +
                     scheme.free_parameters.front());
  }
  const auto round = [](const auto& x) { return nearest(x); };
  switch (scheme.rounded ? Field::inexact : smallest_field(scheme)) {
    case Field::rational:
      return rounded(end_weights<Rational>(scheme, end), round);
    case Field::algebraic:
      return rounded(end_weights<Algebraic>(scheme, end), round);
    case Field::rational_function:
    case Field::inexact:
      break;
  }
  return weights_of_inexact_masks(scheme, end);
}

}  // namespace subdiv
