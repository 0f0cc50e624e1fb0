#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "analysis/iterate_norm.h"
#include "schemes/algebra/interval.h"
#include "schemes/algebra/laurent.h"
#include "schemes/algebra/matrix.h"
#include "schemes/mask.h"

namespace subdiv {

/// The symbol of arity m in the form
///
///   a(z) = m z^shift (sigma(z) / m)^factors b(z),   sigma(z) = 1 + z + .. + z^(m-1),
///   b(z) = b_0 + .. + b_N z^N,   b(1) = 1.
///
/// The growth of the iterates b(z) b(z^m) .. b(z^(m^(k-1))) decides the smoothness of the scheme. Over an
/// exact ring the number of factors is maximal and b_0, b_N are not zero.
template <class R>
struct NormalForm {
  int arity = 2;    ///< m
  int factors = 0;  ///< n, of sigma(z)/m
  int shift = 0;    ///< the lowest power of z
  Laurent<R> b;     ///< b(z), indices 0 .. N

  [[nodiscard]] int degree() const { return b.size() - 1; }
};

namespace detail {

/// The smoothing factors still in a symbol, and what is left: all of them over an exact ring, none elsewhere.
template <class R>
std::pair<int, Laurent<R>> strip_factors(int arity, const Laurent<R>& symbol) {
  if constexpr (ExactRing<R>) {
    return divide_out(symbol, smoothing_factor<R>(arity));
  } else {
    return {0, symbol};
  }
}

}  // namespace detail

/// From a(z) = sigma(z)^factors written(z). Over an exact ring further factors are divided out, and
/// std::domain_error is thrown when `written` is zero or a(1) is not m; over intervals when that is
/// certain.
template <class R>
NormalForm<R> normal_form(int arity, int factors, const Laurent<R>& written) {
  if (written.is_zero()) throw std::domain_error("the symbol is zero");
  const auto [more, cofactor] = detail::strip_factors(arity, written);
  factors += more;
  R scale = fraction<R>(1, arity);
  for (int i = 0; i < factors; ++i) scale = scale * R(arity);
  const int lowest = cofactor.first();
  Laurent<R> b = scale * shift(cofactor, -lowest);
  const R total = sum(b);
  if constexpr (ExactRing<R>) {
    if (!(total == R(1)))
      throw std::domain_error("the coefficients of the symbol do not add up to its arity");
  } else if constexpr (std::is_same_v<R, Interval>) {
    if (!total.contains(Rational(1))) {
      throw std::domain_error("the coefficients of the symbol do not add up to its arity");
    }
  }
  return {arity, factors, lowest, std::move(b)};
}

/// The form of a mask over an exact ring; throws std::domain_error when coefficients do not add up to m.
template <ExactRing R>
NormalForm<R> normal_form(const Mask<R>& mask) {
  return normal_form(mask.arity, 0, mask.symbol);
}

/// For coefficients known only as intervals, of which the first `factors` sum rules are assumed: enclosures
/// of b for all masks within the intervals that obey them. Throws std::domain_error when no mask does.
[[nodiscard]] NormalForm<Interval> normal_form(const Mask<Interval>& mask, int factors);

/// Whether b may have further factors sigma(z) / m: those of intervals whose residue sums may all be 1/m.
/// Never over an exact ring, where the number of factors is maximal.
template <class R>
bool may_have_more_factors(const NormalForm<R>& form) {
  if constexpr (ExactRing<R>) {
    return false;
  } else {
    for (int r = 0; r < form.arity; ++r) {
      if (!sum(residue_class(form.b, r, form.arity)).contains(Rational(1, form.arity))) return false;
    }
    return form.degree() >= form.arity - 1;
  }
}

/// The same form with enclosures of the coefficients.
template <ExactRing R>
NormalForm<Interval> enclose(const NormalForm<R>& form, long precision = Interval::default_precision) {
  const auto ball = [&](const R& x) {
    if constexpr (std::is_same_v<R, Rational>) {
      return Interval(x, precision);
    } else {
      return x.to_interval(precision);
    }
  };
  return {form.arity, form.factors, form.shift, map_coefficients(form.b, ball)};
}

/// T_0 .. T_{m-1}, L x L with L = max(1, ceil(N / (m-1))): (T_r)_{ij} = b_{r + m i - j}. The coefficients of
/// the k-th iterate of b in one residue class modulo m^k are those of T_{e_k} .. T_{e_1} (1, 0, .., 0)
/// (iterate_norm.h).
template <class R>
std::vector<Matrix<R>> transition_matrices(const NormalForm<R>& form) {
  return class_matrices(form.b, form.arity);
}

}  // namespace subdiv
