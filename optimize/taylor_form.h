#pragma once

#include <span>
#include <vector>

#include "schemes/algebra/interval.h"
#include "schemes/algebra/matrix.h"
#include "schemes/algebra/rational_function.h"

namespace subdiv {

/// A polynomial p in n parameters expanded about a point c: p(x) = sum over k of t_k (x - c)^k, k = (k_1 ..
/// k_n), stored densely. Enclosures of the t_k come from shifting exact coefficients in ball arithmetic, so
/// ranges over small boxes are sharp to second order.
class TaylorForm {
 public:
  /// About 0; parameters beyond `variables` must not occur (std::domain_error).
  TaylorForm(const Polynomial& p, int variables, long precision);

  /// About c + offset.
  [[nodiscard]] TaylorForm shifted(std::span<const Interval> offset) const;
  /// Of p(c + r y) in y: the box |x_j - c_j| <= r_j becomes the unit cube.
  [[nodiscard]] TaylorForm scaled(std::span<const Interval> radius) const;
  /// The derivative with respect to x_variable, about the same point.
  [[nodiscard]] TaylorForm derivative(int variable) const;
  /// Encloses p over |x_j - c_j| <= r_j.
  [[nodiscard]] Interval range(std::span<const Interval> radius) const;
  /// p(c).
  [[nodiscard]] const Interval& constant() const { return coefficients_.front(); }
  /// dp/dx_j at c.
  [[nodiscard]] Interval slope(int variable) const;

  /// Coefficients in the order in which the last parameter's power runs fastest.
  [[nodiscard]] const std::vector<Interval>& coefficients() const { return coefficients_; }
  /// One more than the largest power of each parameter.
  [[nodiscard]] const std::vector<std::size_t>& extents() const { return extents_; }
  /// Zeros added up to these extents (not below its own), so that several forms can be combined coefficient
  /// by coefficient.
  [[nodiscard]] TaylorForm padded(const std::vector<std::size_t>& extents) const;

  TaylorForm& operator+=(const TaylorForm& o);  ///< equal extents
  TaylorForm& operator*=(const Interval& factor);

  /// A lower bound of the scaled form over the unit cube: t_0 minus what the other terms can take away (an
  /// even power cannot take a positive coefficient away). Only the lower end of the result means anything.
  [[nodiscard]] Interval least_on_cube() const;
  /// What the terms with a power of this parameter can contribute on the unit cube, as a rounded number.
  [[nodiscard]] double influence(int variable) const;

 private:
  TaylorForm() = default;
  [[nodiscard]] std::size_t stride(std::size_t variable) const;
  template <class Visit>
  void for_each(Visit visit) const;

  std::vector<std::size_t> extents_;
  std::vector<Interval> coefficients_;
};

/// Value, gradient and Hessian of a function, enclosed over a box.
struct SecondOrder {
  Interval value;             ///< f
  Vector<Interval> gradient;  ///< the partial derivatives
  Matrix<Interval> hessian;   ///< the second ones
};

/// A rational function p/q prepared for SecondOrder enclosures.
class TaylorFunction {
 public:
  /// p/q in x_0 .. x_{variables-1}; enclosures are at the precision in bits.
  TaylorFunction(const Polynomial& numerator, const Polynomial& denominator, int variables, long precision);
  /// Of its numerator and denominator.
  TaylorFunction(const RationalFunction& f, int variables, long precision)
      : TaylorFunction(f.numerator(), f.denominator(), variables, precision) {}

  /// Over a box; not finite where the denominator may vanish.
  [[nodiscard]] SecondOrder over(std::span<const Interval> box) const;

 private:
  TaylorForm numerator_;
  TaylorForm denominator_;
  bool has_denominator_;
};

/// The box's centre, and its radii as balls without radius (rounded up).
[[nodiscard]] std::vector<Interval> centre_of(std::span<const Interval> box);
/// Half the widths of the sides.
[[nodiscard]] std::vector<Interval> radius_of(std::span<const Interval> box);

}  // namespace subdiv
