#pragma once

#include <span>
#include <string>

#include "experiments/cli/scheme_analysis.h"
#include "schemes/algebra/algebraic.h"
#include "schemes/algebra/interval.h"
#include "schemes/algebra/rational_function.h"
#include "schemes/mask.h"
#include "schemes/symbol_expression.h"

namespace subdiv::cli {

/// What is asked of a mask besides its continuity by the joint spectral radius.
struct RegularityOptions {
  double seconds = 30;  // for the joint spectral radius
  /// Exact eigenvalues and powers as second routes: too slow for long masks.
  bool second_routes = true;
};

/// Continuity and Hoelder exponents of a repeated step and of its limits, by the joint spectral radius; and
/// by second routes: a power of the c-th difference scheme with a norm below 1 certifies C^c, Reif's
/// condition is necessary for it, the L2 exponent bounds the Hoelder exponent, and symbols that are not
/// negative have a single matrix. std::logic_error when the routes contradict each other. With one free
/// parameter, powers and Reif's condition for all its values at once; with several, or with coefficients that
/// are no polynomials, only what can be had.
[[nodiscard]] RegularityText regularity(const Mask<Rational>& mask, std::span<const std::string> names,
                                        const RegularityOptions& options);
[[nodiscard]] RegularityText regularity(const Mask<Algebraic>& mask, std::span<const std::string> names,
                                        const RegularityOptions& options);
[[nodiscard]] RegularityText regularity(const Mask<RationalFunction>& mask,
                                        std::span<const std::string> names, const RegularityOptions& options);

/// The number of smoothing factors of a symbol whose coefficients are known as intervals: those counted
/// exactly and as many more as some symbol within the intervals has.
[[nodiscard]] int allowed_sum_rules(const FactoredSymbol<Interval>& symbol, int arity);

/// Of a symbol whose coefficients are known as intervals, `factors` of its smoothing factors exactly: further
/// sum rules that the intervals allow are assumed, and listed. Throws InputError when they do not allow the
/// first.
[[nodiscard]] RegularityText regularity(const FactoredSymbol<Interval>& symbol, int arity,
                                        const RegularityOptions& options);

}  // namespace subdiv::cli
