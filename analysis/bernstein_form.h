#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "analysis/parameter_box.h"
#include "schemes/algebra/polynomial.h"

namespace subdiv {

/// A polynomial over Q in x_0, x_1 in Bernstein form on a cell [lower, upper] of the plane, exact: the sum of
/// c(i, j) B^m_i(u) B^n_j(v), u and v the coordinates in [0, 1] on the cell (Farin: Curves and Surfaces for
/// CAGD, chapters 5, 16). It lies between its smallest and its largest coefficient.
class BernsteinForm {
 public:
  /// The form of f, a polynomial in x_0 and x_1 alone, on a cell of the plane.
  BernsteinForm(const Polynomial& f, const ParameterBox& cell);

  [[nodiscard]] const std::vector<Rational>& coefficients() const { return c_; }
  /// Which coefficient is the value at a corner of the cell.
  [[nodiscard]] std::size_t corner_slot(bool upper0, bool upper1) const {
    return (upper0 ? degree_[0] : 0) * (degree_[1] + 1) + (upper1 ? degree_[1] : 0);
  }
  /// Every coefficient has this sign, 1 or -1, or is a value 0 at a corner that is free; free[2 k + l] is
  /// that of corner_slot(k, l). In a direction of degree 0 a coefficient is the value at several corners,
  /// which must all be free. For f != 0.
  [[nodiscard]] bool has_sign(int sign, const std::array<bool, 4>& free = {}) const;
  /// On the halves of the cell in x_0, or in x_1 (de Casteljau).
  [[nodiscard]] std::array<BernsteinForm, 2> halves(bool first) const;

 private:
  /// Number i on a line of coefficients along x_0, or along x_1.
  Rational& entry(bool first, std::size_t line, std::size_t i) {
    return first ? c_[i * (degree_[1] + 1) + line] : c_[line * (degree_[1] + 1) + i];
  }

  std::array<std::size_t, 2> degree_{};
  std::vector<Rational> c_;
};

}  // namespace subdiv
