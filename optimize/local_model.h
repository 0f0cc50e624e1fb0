#pragma once

#include <optional>
#include <vector>

#include "optimize/boxes.h"
#include "optimize/krawczyk.h"
#include "optimize/taylor_form.h"

namespace subdiv {

/// How a function u enters an objective near a point where u vanishes: as |u|; as one of the u_i in max(0,
/// u_1, u_2, ..); or as a constraint u <= 0 of the box.
enum class KinkKind { absolute, maximum, bound };

/// A function that vanishes at the point, and how it enters.
struct Kink {
  RationalFunction function;           ///< u
  KinkKind kind = KinkKind::absolute;  ///< as |u|, as a member of the maximum, or as a bound
};

/// A non-smooth function near a point x* where all u_i vanish:
///   F(x) = g(x) + sum over absolute kinks of |u_i(x)| + max(0, u_i(x) over maximum kinks), where u_i(x) <= 0
///   for bounds.
/// A maximum of residuals is one of them plus the others' differences to it; a sum of absolute values is its
/// smooth part plus the terms that vanish; a smooth function has no kinks.
struct LocalModel {
  RationalFunction base;    ///< g
  std::vector<Kink> kinks;  ///< the u_i
  int variables = 0;        ///< n, the number of parameters
};

/// A point x* with multipliers m_i: u_i(x*) = 0, grad g + sum of m_i grad u_i = 0, and strictly |m_i| < 1
/// (absolute), m_i > 0 and sum < 1 (maximum), m_i > 0 (bound). `region` encloses (x, m) and holds exactly one
/// solution of the equations.
struct CriticalPoint {
  std::vector<Interval> x;            ///< the point
  std::vector<Interval> multipliers;  ///< m_i, in the order of the kinks
  Vector<Interval> region;            ///< around x and the multipliers
};

/// A model prepared for enclosures at one precision.
class CompiledModel {
 public:
  /// For enclosures at the precision in bits.
  CompiledModel(const LocalModel& model, long precision);

  /// The equations of a critical point in the unknowns (x, m).
  [[nodiscard]] SquareSystem critical_system() const;
  /// Newton and Krawczyk from a point near; nothing when no critical point is found there or a multiplier's
  /// condition is not certain.
  [[nodiscard]] std::optional<CriticalPoint> critical_point(const std::vector<double>& near) const;
  /// Is F(x) > F(x*) proved for all x != x* of the neighbourhood (within the bounds), which must contain the
  /// point? The point's own equations are proved again. Two proofs are tried. With as many kinks as
  /// parameters: the multipliers solve A' m = -grad g for gradients A of the u_i, grad g taken independently
  /// anywhere in the neighbourhood, and keep their conditions; then F - F(x*) >= sum of (slack of the
  /// conditions) |u_i| > 0. Otherwise: F >= G = g + sum of m_i u_i + 1/2 sum of rho_i u_i^2 wherever the u_i
  /// are small against the slack, G = F at x*, grad G(x*) = 0 and the Hessian of G is positive definite on
  /// the neighbourhood.
  [[nodiscard]] bool is_minimum_over(const CriticalPoint& point, const Box& neighbourhood) const;

  [[nodiscard]] Interval base_value(const std::vector<Interval>& x) const { return base_.over(x).value; }

 private:
  struct Local;
  [[nodiscard]] Local over(std::span<const Interval> box) const;
  [[nodiscard]] bool conditions_hold(const Vector<Interval>& multipliers) const;
  [[nodiscard]] bool is_vertex_over(const Box& neighbourhood) const;
  [[nodiscard]] bool is_convex_over(const CriticalPoint& point, const std::vector<Interval>& penalties,
                                    const Box& neighbourhood) const;
  [[nodiscard]] bool majorises(const Local& local, const CriticalPoint& point,
                               const std::vector<Interval>& penalties) const;
  [[nodiscard]] std::vector<Interval> natural_penalties(const CriticalPoint& point) const;

  long precision_;
  int variables_;
  TaylorFunction base_;
  std::vector<TaylorFunction> kinks_;
  std::vector<KinkKind> kinds_;
};

/// Is every symmetric matrix in the enclosure positive definite? By the pivots of an interval LDL'
/// factorisation.
[[nodiscard]] bool is_positive_definite(Matrix<Interval> a);

}  // namespace subdiv
