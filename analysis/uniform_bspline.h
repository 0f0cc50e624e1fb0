#pragma once

#include <cstddef>
#include <vector>

#include "schemes/algebra/rational.h"
#include "schemes/algebra/univariate.h"

namespace subdiv {

/// The centred uniform B-spline B_d: support [-(d+1)/2, (d+1)/2], integral 1, knots at the integers plus
/// (d+1)/2,
///     B_d(t) = (1/d!) sum over j of (-1)^j binomial(d+1, j) max(0, t + (d+1)/2 - j)^d
/// (de Boor, A Practical Guide to Splines, chapter IX). d = 0 is the box, 1 the hat. Everything is exact.
/// Throws std::domain_error for d < 0.
class UniformBspline {
 public:
  /// B_d.
  explicit UniformBspline(int degree);

  [[nodiscard]] int degree() const { return degree_; }
  /// Half the support's width, (d+1)/2.
  [[nodiscard]] Rational half_width() const { return Rational(degree_ + 1, 2); }

  /// The polynomial in t that B_d is on [lower, upper], lower < upper (zero outside the support). Throws
  /// std::domain_error when a knot of the support lies inside.
  [[nodiscard]] const UnivariatePolynomial& piece(const Rational& lower, const Rational& upper) const;
  /// B_d(t); at the jumps of B_0 the value from the right.
  [[nodiscard]] Rational value(const Rational& t) const;
  /// The integral of B_d from -infinity to t.
  [[nodiscard]] Rational integral(const Rational& t) const;

 private:
  struct Piece {
    UnivariatePolynomial value;
    UnivariatePolynomial integral;  // from -infinity
  };
  /// The index of the piece that holds at t and to its right.
  [[nodiscard]] std::size_t piece_from(const Rational& t) const;

  int degree_;
  std::vector<Piece>
      pieces_;  // 0: left of the support; j = 1 .. d+1: on [j-1, j] - (d+1)/2; d+2: right of it
};

}  // namespace subdiv
