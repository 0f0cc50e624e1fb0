#pragma once

#include <functional>
#include <optional>
#include <span>

#include "schemes/algebra/interval.h"
#include "schemes/algebra/matrix.h"
#include "schemes/algebra/rational_function.h"

namespace subdiv {

/// f: R^n -> R^n with its Jacobian (row i: gradient of f_i), both enclosed over boxes.
struct SquareSystem {
  std::function<Vector<Interval>(const Vector<Interval>&)> value;     ///< f over a box
  std::function<Matrix<Interval>(const Vector<Interval>&)> jacobian;  ///< the Jacobian over a box
};

/// n rational functions of x_0 .. x_{n-1}, with exact derivatives, evaluated at this precision in bits.
[[nodiscard]] SquareSystem square_system(std::span<const RationalFunction> f, long precision);

/// Krawczyk's operator K(X) = m - C f(m) + (I - C f'(X)) (X - m), m the centre of X, C an approximate inverse
/// of f'(m). Every zero of f in X lies in K(X); when K(X) lies in the interior of X, f has exactly one zero
/// in X, and f'(X) is regular (Neumaier, Interval Methods for Systems of Equations, theorem 5.1.8). Nothing
/// when f'(m) is numerically singular.
[[nodiscard]] std::optional<Vector<Interval>> krawczyk(const SquareSystem& system,
                                                       const Vector<Interval>& box);

/// f has exactly one zero in `region`, and it lies in `enclosure`.
struct IsolatedZero {
  Vector<Interval> enclosure;  ///< narrow
  Vector<Interval> region;     ///< wide: no other zero in it
};

/// Newton's iteration from `near`, then Krawczyk's test on growing boxes about its end, then contraction as
/// far as the system's precision goes. Nothing when Newton does not settle or no box passes the test. Proves
/// nothing about other zeros.
[[nodiscard]] std::optional<IsolatedZero> isolate_zero(const SquareSystem& system,
                                                       const Vector<Interval>& near);

/// b with |x_j - x'_j| <= b_j max_i |f_i(x) - f_i(x')| for all x, x' in the box: f determines its argument
/// there. Nothing when C f'(X), C an approximate inverse, is not certainly within 1 of the identity in the
/// maximum norm.
[[nodiscard]] std::optional<Vector<Interval>> inverse_bounds(const SquareSystem& system,
                                                             const Vector<Interval>& box);

/// An approximate inverse: balls without radius. Nothing for a numerically singular matrix.
[[nodiscard]] std::optional<Matrix<Interval>> approximate_inverse(const Matrix<Interval>& a);

/// The widest of the enclosures.
[[nodiscard]] Rational largest_width(const Vector<Interval>& box);

}  // namespace subdiv
