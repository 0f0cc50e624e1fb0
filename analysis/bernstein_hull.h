#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analysis/parameter_box.h"
#include "schemes/algebra/matrix.h"

namespace subdiv {

/// Encloses the values of matrices T_0(x), T_1(x), .. over boxes of the parameters x_0 .. x_{d-1} in convex
/// hulls. With one common denominator D(x) > 0 of all entries, Bernstein's form over a box is
///
///     T_r(x) = (sum over i of B_i(x) N_{r,i}) / (sum over i of B_i(x) d_i),    B_i >= 0.
///
/// Where all d_i have one strict sign, T_r(x) is the convex combination with the weights B_i(x) d_i / D(x) of
/// the matrices N_{r,i} / d_i, the same weights for all r. For entries of degree at most 1 in each parameter
/// these are the values at the corners of the box (Farin, Curves and Surfaces for CAGD, section 6, for
/// Bernstein's form).
class BernsteinHull {
 public:
  /// Entries are rational functions of x_0 .. x_{d-1}, d = dimension >= 1 (std::domain_error otherwise).
  BernsteinHull(const std::vector<Matrix<RationalFunction>>& family, std::size_t dimension);

  /// One family for each i: N_{0,i} / d_i, N_{1,i} / d_i, .. Nothing when the d_i have no strict sign, which
  /// is so for every box that contains a pole.
  [[nodiscard]] std::optional<std::vector<std::vector<Matrix<Rational>>>> families(
      const ParameterBox& box) const;

 private:
  std::size_t letters_;
  Eigen::Index rows_;
  std::vector<std::size_t> degrees_;  // one for each parameter
  /// Coefficients of the powers prod x_k^(j_k), the last parameter running fastest: the denominator's, then
  /// those of all entries' numerators.
  std::vector<std::vector<Rational>> coefficients_;
};

}  // namespace subdiv
