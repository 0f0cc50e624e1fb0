#pragma once

#include <string>

#include "schemes/algebra/rational_function.h"
#include "schemes/mask.h"

namespace subdiv {

/// What objectives ask of a scheme. All throw InputError "objective NAME and scheme TEXT: what is missing".

/// Throws the error: the scheme has not what the objective asks for.
[[noreturn]] void lacks(const std::string& objective, const Scheme<RationalFunction>& scheme,
                        const std::string& what);

/// Arity 2.
void require_binary(const std::string& objective, const Scheme<RationalFunction>& scheme);

/// Steps whose coefficients add up to the arity.
void require_steps(const std::string& objective, const Scheme<RationalFunction>& scheme);

/// The mean of the limit of a unit impulse: the sum of mean_k / m^(k+1) over the steps, m the arity and
/// mean_k the mean index of step k's coefficients.
[[nodiscard]] RationalFunction limit_mean(const Scheme<RationalFunction>& scheme);

/// A centre that does not move with the parameters.
[[nodiscard]] Rational constant_centre(const std::string& objective, const Scheme<RationalFunction>& scheme,
                                       const RationalFunction& centre);

/// Centred at index 0.
void require_primal(const std::string& objective, const Scheme<RationalFunction>& scheme);

}  // namespace subdiv
