#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/decision.h"
#include "analysis/transition_matrices.h"
#include "schemes/algebra/field_polynomial.h"

// The shifts phi(x - j) of a scheme's basis function are linearly dependent exactly when its symbol of arity
// m vanishes
//
//   at all m-th roots of some number, z e^(2 pi i k / m): then h(z^m) divides b(z) for some polynomial h; or
//   on a cycle: at w^(m^j) e^(2 pi i k / m), 0 < k < m, j >= 0, for a root of unity w != 1 of an order d
//   prime to m: then, over Q, Phi_d(z^m) / Phi_d(z) divides b(z), Phi_d the cyclotomic polynomial
//
// (Jia & Wang, Proc. AMS 117, 1993, for m = 2). Either way b(z) = c(z) t(z^m) / t(z), and phi is a
// combination, with the coefficients of t, of the shifts of the scheme with the symbol c, which can be
// smoother than the differences of b tell.

namespace subdiv {

/// b(z) = c(z) t(z^m) / t(z) up to a power of z: `form` has c in place of b, with all its factors sigma
/// divided out again, and t(1) = 1. Both are those of the scheme itself when its shifts are independent.
template <class R>
struct IndependentForm {
  NormalForm<R> form;  ///< with c in place of b
  Laurent<R> t{1};     ///< the factor t(z), t(1) = 1
  /// Whether the shifts of the scheme itself are linearly independent.
  Decision independent = Decision::undecided;
  /// Whether those of `form` are.
  Decision reduced_independent = Decision::undecided;
};

/// Phi_d, the polynomial whose roots are the primitive d-th roots of unity, d >= 1.
[[nodiscard]] Laurent<Rational> cyclotomic_polynomial(int d);

/// The d >= 2 prime to m for which Phi_d(z^m) / Phi_d(z) has at most the given degree.
[[nodiscard]] std::vector<int> cycle_orders(int arity, int degree);

/// yes when the shifts of all schemes within the intervals are proved to be linearly independent; else
/// undecided.
[[nodiscard]] Decision have_independent_shifts(const NormalForm<Interval>& form);

namespace detail {

/// The largest h with h(z^m) dividing p(z), h(0) != 0: the common divisor of the residue classes of p.
template <ExactRing R>
Laurent<R> common_class_divisor(const Laurent<R>& p, int arity) {
  FieldPolynomial<R> common;
  for (int r = 0; r < arity; ++r) {
    const Laurent<R> part = residue_class(p, r, arity);
    if (!part.is_zero()) common = gcd(std::move(common), FieldPolynomial<R>(part.coefficients()));
  }
  return Laurent<R>(0, common.coefficients());
}

/// t for one step of the reduction; 1 when there is none.
template <ExactRing R>
Laurent<R> next_divisor(const NormalForm<R>& form) {
  Laurent<R> h = common_class_divisor(form.b, form.arity);
  if (h.size() > 1) return h;
  for (const int d : cycle_orders(form.arity, form.degree())) {
    const Laurent<Rational> phi = cyclotomic_polynomial(d);
    const auto in_ring = [](const Rational& q) { return from_rational<R>(q); };
    const Laurent<Rational> cycle = divide_exactly(upsample(phi, form.arity), phi).value();
    if (divide_exactly(form.b, map_coefficients(cycle, in_ring))) return map_coefficients(phi, in_ring);
  }
  return Laurent<R>(1);
}

}  // namespace detail

/// For coefficients known as intervals, dependent shifts can be excluded but not divided out.
[[nodiscard]] inline IndependentForm<Interval> independent_form(const NormalForm<Interval>& form) {
  const Decision independent = have_independent_shifts(form);
  return {form, Laurent<Interval>(1), independent, independent};
}

/// Divides out t(z^m) / t(z) until no such factor is left. Over Q the result has independent shifts; over the
/// algebraic numbers, where a cycle need not contain all roots of its order, reduced_independent may stay
/// undecided.
template <ExactRing R>
IndependentForm<R> independent_form(const NormalForm<R>& form) {
  IndependentForm<R> result{form};
  while (true) {
    const Laurent<R> t = detail::next_divisor(result.form);
    if (t.size() == 1) break;
    const Laurent<R> normal = Laurent<R>::constant(R(1) / sum(t)) * t;
    const Laurent<R> rest = divide_exactly(result.form.b * normal, upsample(normal, form.arity)).value();
    NormalForm<R> reduced = normal_form(form.arity, 0, Laurent<R>(form.arity) * rest);
    reduced.factors += result.form.factors;
    result.form = std::move(reduced);
    result.t *= normal;
  }
  if constexpr (std::is_same_v<R, Rational>) {
    result.reduced_independent = Decision::yes;
  } else {
    result.reduced_independent = have_independent_shifts(enclose(result.form));
  }
  result.independent = result.t.size() > 1 ? Decision::no : result.reduced_independent;
  return result;
}

}  // namespace subdiv
