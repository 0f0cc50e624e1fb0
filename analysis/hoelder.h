#pragma once

#include <optional>

#include "analysis/decision.h"
#include "analysis/enclosure.h"
#include "analysis/joint_spectral_radius.h"
#include "analysis/unstable_shifts.h"

namespace subdiv {

/// The smoothness of a stationary scheme with the symbol a(z) = m (sigma(z)/m)^n b(z)
/// (transition_matrices.h), from the joint spectral radius rho of the transition matrices of b:
///
///   exponent = n - 1 - log_m rho.
///
/// The scheme is C^k, in the sense that its (k+1)-th differences times m^(k level) tend to zero, exactly when
/// k < exponent (Daubechies & Lagarias, SIAM J. Math. Anal. 23, 1992; Rioul, same volume). It converges when
/// it is C^0.
struct Smoothness {
  int factors = 0;             ///< n
  JointSpectralRadius radius;  ///< of the transition matrices of b
  /// At most n, because rho >= 1/m. Not positive for a scheme that diverges. Where coefficients are
  /// intervals that do not exclude further factors, a radius that may be 1/m leaves every exponent above
  /// open, up to the number of factors that the degree allows.
  Enclosure exponent;
  Decision converges = Decision::undecided;  ///< C^0: whether limits exist for all data
  /// C^k is proved for k up to `continuity` (-1: not even C^0), and excluded above `continuity_limit`.
  int continuity = -1;
  int continuity_limit = -1;  ///< the largest k that is not excluded
  /// Whether derivatives of the order floor(exponent) (one less for an integer) satisfy a Hoelder condition
  /// (Lipschitz for an integer) with this very exponent: whether the iterates divided by rho^k stay bounded,
  /// for an integer exponent j those of the j-th divided differences.
  Decision attained = Decision::undecided;
};

/// Smoothness of a scheme and of its limits. They differ where the shifts of the basis function are
/// dependent: then the limits are those of a scheme with another symbol (unstable_shifts.h).
template <class R>
struct SmoothnessReport {
  Smoothness scheme;             ///< in the sense of its differences
  Smoothness limits;             ///< of the limits
  IndependentForm<R> reduction;  ///< the symbol that the limits have
};

/// The smoothness of a scheme in the sense of its differences.
[[nodiscard]] Smoothness smoothness(const NormalForm<Rational>& form,
                                    const JointSpectralRadiusBudget& budget = {});
/// The same over the real algebraic numbers.
[[nodiscard]] Smoothness smoothness(const NormalForm<Algebraic>& form,
                                    const JointSpectralRadiusBudget& budget = {});
/// The same for symbols known as intervals: encloses the answers for all symbols in them.
[[nodiscard]] Smoothness smoothness(const NormalForm<Interval>& form,
                                    const JointSpectralRadiusBudget& budget = {});

/// Where dependent shifts of the reduced symbol are not excluded, the limits are at least as smooth as its
/// scheme, and nothing more is claimed: exponents then reach up to the degree of the symbol over m - 1.
[[nodiscard]] Smoothness at_least(const Smoothness& scheme, int degree, int arity);

/// Of scheme and limits.
template <class R>
SmoothnessReport<R> smoothness_report(const NormalForm<R>& form,
                                      const JointSpectralRadiusBudget& budget = {}) {
  SmoothnessReport<R> result{{}, {}, independent_form(form)};
  const NormalForm<R>& reduced = result.reduction.form;
  const bool same = result.reduction.t.size() == 1;
  JointSpectralRadiusBudget each = budget;
  if (!same) each.seconds /= 2;
  result.scheme = smoothness(form, each);
  result.limits = same ? result.scheme : smoothness(reduced, each);
  if (result.reduction.reduced_independent != Decision::yes) {
    const int degree = reduced.degree() + reduced.factors * (reduced.arity - 1);
    result.limits = at_least(result.limits, degree, reduced.arity);
  }
  return result;
}

}  // namespace subdiv
