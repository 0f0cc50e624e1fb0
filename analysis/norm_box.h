#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analysis/difference_family.h"

namespace subdiv {

/// Bounds of norm_k(s) for all s of an interval at once, in double arithmetic with proven error bounds.
///
/// Along a path of the tree of classes (iterate_norm.h) the vectors v(s), s = center + t, |t| <= radius, are
/// followed as v0 + t v1 + rest. With A(s) = A0 + t A1 + t^2 (..), a step takes v0 to A0 v0 and v1 to A0 v1 +
/// A1 v0, and leaves a defect (the terms from t^2 on, the rounding of A0 and A1, the rounding of the
/// products) of 1-norm at most defect_value |v0| + defect_slope |v1|. The defect of step i is at most
/// norm_{j-i}(s) times as large at step j, hence |rest| <= sum of defect_i norm_{j-i}. And |v0 + t v1| is
/// convex in t: it is largest at an end of the box. No class `left` levels below v passes |v| norm_left, so
/// that few paths need be followed.
struct NormBox {
  int arity = 2;                    ///< m
  std::size_t n = 1;                ///< of entries of the vectors v
  double radius = 0;                ///< half the width of the interval of s
  std::vector<double> value;        ///< A_e(center), e after e, row by row
  std::vector<double> slope;        ///< its derivative
  double defect_value = 0;          ///< of a step, for each unit of |v0|
  double defect_slope = 0;          ///< of a step, for each unit of |v1|
  std::vector<double> bounds{1.0};  ///< bounds[i] >= norm_i(s) for all s of the box
};

/// The box lower <= s <= upper, finite doubles; bounds of no level yet.
[[nodiscard]] NormBox norm_box(const DifferenceFamily& family, double lower, double upper);

/// Extends box.bounds to level k, 0 <= k <= 64 (std::domain_error). The bounds of a box of width 0 exceed the
/// norms by a relative 1e-10 at most, as long as the mask's rounding errors do.
void bound_norms(NormBox& box, int k);

/// A class of level k, its norm and the norm's derivative with respect to s, as computed at the center.
struct ClassValue {
  ClassWord word;    ///< which residue class
  double norm = 0;   ///< at the center
  double slope = 0;  ///< of the norm with respect to s, at the center
};

/// A class whose bound on the box is the largest of level k, 1 <= k <= 64, up to a relative 1e-10. Here and
/// below, box.bounds is extended to level k - 1.
[[nodiscard]] ClassValue largest_class(NormBox& box, int k);

/// Whether norm_k(s) < 1 is proved for the whole box; false means "not proved".
[[nodiscard]] bool proves_contraction(NormBox& box, int k);

/// All classes of level k that may reach 1 somewhere on the box; nothing when there are more than `most`.
[[nodiscard]] std::optional<std::vector<ClassWord>> critical_classes(NormBox& box, int k, std::size_t most);

/// The least k <= max_power for which norm_k < 1 is proved for a single difference symbol: then the scheme is
/// C^c.
[[nodiscard]] std::optional<int> contraction_power(const Laurent<Rational>& d, int arity, int max_power);

}  // namespace subdiv
