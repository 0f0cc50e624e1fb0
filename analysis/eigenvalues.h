#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "schemes/algebra/field_polynomial.h"
#include "schemes/algebra/matrix.h"

namespace subdiv {

/// An eigenvalue with its algebraic multiplicity. Real ones have the imaginary part exactly 0; complex ones
/// come in conjugate pairs of equal multiplicity, each an entry of its own.
struct Eigenvalue {
  std::optional<Algebraic> exact;  ///< the value, of every real eigenvalue of a rational matrix
  Interval real;                   ///< encloses the real part
  Interval imaginary;              ///< exactly 0 for a real eigenvalue
  int multiplicity = 1;            ///< algebraic

  [[nodiscard]] bool is_real() const { return imaginary.is_exactly_zero(); }
  /// An enclosure of the absolute value.
  [[nodiscard]] Interval modulus() const;
  /// The exact value, or "0.25+-0.66i" to the given digits.
  [[nodiscard]] std::string to_string(int digits = 15) const;
};

/// All eigenvalues by decreasing modulus, positive before negative ones of the same modulus: roots of the
/// exact characteristic polynomial, factored over Q. Enclosures are isolating.
[[nodiscard]] std::vector<Eigenvalue> eigenvalues(const Matrix<Rational>& matrix);

/// The same for algebraic entries. Multiplicities are exact (square-free factorisation), and so are rational
/// eigenvalues; in a matrix with irrational entries, an irrational eigenvalue may be known by its enclosure
/// alone.
[[nodiscard]] std::vector<Eigenvalue> eigenvalues(const Matrix<Algebraic>& matrix);

/// The spectrum of a matrix over Q(x_0, x_1, ..) from its factored characteristic polynomial.
struct ParametricSpectrum {
  /// Eigenvalues that are rational functions of the parameters, with multiplicities.
  std::vector<std::pair<RationalFunction, int>> values;
  /// Irreducible factors of degree above 1 in x_7 = eigenvalue_variable: their roots are the other
  /// eigenvalues.
  std::vector<std::pair<Polynomial, int>> factors;
};

/// Constants come first, by decreasing modulus, then the rest in the order of their texts. Throws
/// std::domain_error when an entry uses x_7 or FLINT cannot factor.
[[nodiscard]] ParametricSpectrum eigenvalues(const Matrix<RationalFunction>& matrix);

/// A polynomial in x_7 with the roots of the characteristic polynomial, primitive: c(p) det(x_7 I - matrix),
/// where c vanishes at most at poles of the entries.
[[nodiscard]] Polynomial characteristic_equation(const Matrix<RationalFunction>& matrix);

/// "1, 1/2, (s-1)/16 (2), 0 (2)": every eigenvalue, multiplicities above 1 in parentheses; factors as "roots
/// of ..".
[[nodiscard]] std::string to_string(const ParametricSpectrum& spectrum, std::span<const std::string> names);

}  // namespace subdiv
