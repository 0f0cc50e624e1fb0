#pragma once

#include <span>
#include <vector>

#include "optimize/problem.h"

namespace subdiv {

/// A function linearised on the unit cube: constant + slope . y, |y_j| <= 1.
struct AffinePiece {
  double constant = 0;        ///< c_p
  std::vector<double> slope;  ///< g_p
};

/// Weights w of residuals t_i(y) = constant_i + slope_i . y such that the affine function sum of w_i t_i +
/// offset(y) has a large minimum over the unit cube, where linf: sum of |w_i| <= 1; l1: |w_i| <= 1. They are
/// the multipliers of the linearised problem, found in double arithmetic by cutting planes: any w gives a
/// valid lower bound of norm + offset, so nothing here is trusted.
[[nodiscard]] std::vector<double> dual_weights(Norm norm, std::span<const AffinePiece> residuals,
                                               const AffinePiece& offset);

/// Weights lambda_p >= 0 of sum 1 that maximise sum of lambda_p c_p - sum over j of |sum of lambda_p g_pj|,
/// and the point y of the unit cube where the largest piece is least: both sides of one linear program, by
/// the simplex method.
struct LeastMaximum {
  std::vector<double> weights;  ///< lambda_p
  std::vector<double> point;    ///< y
  double value = 0;             ///< the common value of both sides
};
/// Of at least one piece.
[[nodiscard]] LeastMaximum least_maximum(std::span<const AffinePiece> pieces);

}  // namespace subdiv
