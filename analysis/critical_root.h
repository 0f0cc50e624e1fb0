#pragma once

#include <optional>
#include <vector>

#include "analysis/difference_family.h"

namespace subdiv {

/// A root of a polynomial, isolated in [lower, upper]; exact when it is rational or a quadratic surd.
struct IsolatedRoot {
  Rational lower;                  ///< the left end
  Rational upper;                  ///< the right end
  std::optional<Algebraic> exact;  ///< when it has a closed form of degree 1 or 2
  long degree = 0;                 ///< of the polynomial
};

/// The least s in [inside, outside] at which one of the classes reaches the norm 1, when it is proved that
/// all of them stay below 1 before it: on the interval their coefficients keep their signs, so that each norm
/// is a polynomial over Q, and each of those that do not stay below 1 increases. Nothing when that is not so,
/// or when no class reaches 1.
[[nodiscard]] std::optional<IsolatedRoot> first_critical_root(const DifferenceFamily& family,
                                                              const std::vector<ClassWord>& classes,
                                                              const Rational& inside,
                                                              const Rational& outside);

/// Whether root, inside < root, is proved to be the first s from `inside` on at which one of the classes has
/// the norm 1. Coefficients may vanish there, and norms may touch 1.
[[nodiscard]] bool reaches_one_first_at(const DifferenceFamily& family, const std::vector<ClassWord>& classes,
                                        const Rational& inside, const Rational& root);

}  // namespace subdiv
