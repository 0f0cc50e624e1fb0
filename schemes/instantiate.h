#pragma once

#include <span>
#include <variant>
#include <vector>

#include "schemes/mask.h"
#include "schemes/mask_evaluator.h"
#include "schemes/scheme_description.h"
#include "schemes/symbol_expression.h"

namespace subdiv {

/// The masks of a described scheme over a ring R; free_values[i] stands for the free parameter i
/// (std::domain_error unless there is one for each). R is any field of schemes/algebra, double, or a Ceres
/// Jet. Throws InputError where a value does not exist: division by zero, a root of a negative number, a mask
/// that does not sum to its arity; OutsideRingError for a root that R does not hold. The sum is checked over
/// exact rings only, and over Interval as far as an interval can tell.
template <class R>
Scheme<R> instantiate(const SchemeDescription& scheme, std::span<const R> free_values = {});

/// The masks over the rational functions of the free parameters, x_i for free parameter i.
[[nodiscard]] Scheme<RationalFunction> symbolic_scheme(const SchemeDescription& scheme);

/// The masks as intervals at a working precision in bits. In a rounded scheme every decimal of a scheme file
/// is an interval of half a unit of its last digit on both sides.
[[nodiscard]] Scheme<Interval> interval_scheme(const SchemeDescription& scheme,
                                               std::span<const Interval> free_values = {},
                                               long precision = Interval::default_precision);

/// The same with the symbols as they are written: for scheme files with a symbol, the smoothing factors that
/// stand in its top-level product are counted exactly, whatever the other factors are. Steps of other origin
/// count none.
[[nodiscard]] std::vector<FactoredSymbol<Interval>> factored_interval_symbols(
    const SchemeDescription& scheme, std::span<const Interval> free_values = {},
    long precision = Interval::default_precision);

/// The smallest ring that holds the masks: rationals; real algebraic numbers (roots occur, nothing is free);
/// rational functions of the free parameters; none, when roots meet free parameters or numbers of too high a
/// degree: then only inexact rings do.
enum class Field { rational, algebraic, rational_function, inexact };
/// The field for the scheme's coefficients, its free parameters included.
[[nodiscard]] Field smallest_field(const SchemeDescription& scheme);

/// The masks over the smallest exact ring that holds them. InputError when none does.
using ExactScheme = std::variant<Scheme<Rational>, Scheme<Algebraic>, Scheme<RationalFunction>>;
/// The scheme over that field.
[[nodiscard]] ExactScheme exact_scheme(const SchemeDescription& scheme);

namespace detail {

template <class R, class Literal>
Scheme<R> instantiate_with(const SchemeDescription& scheme, std::span<const R> free_values, Literal literal) {
  const Evaluator<R, Literal> evaluator(scheme, free_values, literal);
  Scheme<R> result{scheme.text, {}};
  for (const StepDescription& step : scheme.steps) result.steps.push_back(evaluator.mask(step));
  return result;
}

}  // namespace detail

template <class R>
Scheme<R> instantiate(const SchemeDescription& scheme, std::span<const R> free_values) {
  return detail::instantiate_with(scheme, free_values, ExactLiteral<R>{});
}

}  // namespace subdiv
