#pragma once

#include <optional>
#include <vector>

#include "analysis/difference_family.h"
#include "analysis/enclosure.h"

namespace subdiv {

/// One end of a certified interval. The proof reaches to the inner side of the enclosure, and at its outer
/// side norm_k >= 1 is proved, if the status is closed. out_of_depth: proved up to the end of the search.
/// out_of_precision: the end lies in the enclosure or beyond.
struct RangeEnd {
  Enclosure value;  ///< of the end
  /// norm_k < 1 is proved right up to the end itself, where norm_k >= 1: the interval is open there.
  bool sharp = false;
};

/// The largest interval around an interior point on which norm_k(s) < 1: proved for every s strictly between
/// the ends (between their enclosures where an end is not sharp).
struct NormRange {
  int power = 0;   ///< k
  RangeEnd lower;  ///< the left end
  RangeEnd upper;  ///< the right end

  /// norm_k < 1 is proved at s.
  [[nodiscard]] bool contains(const Rational& s) const;
};

/// Where the intervals are looked for, and how closely.
struct NormRangeOptions {
  Rational interior;  ///< where the intervals are looked for
  /// Where the ends are looked for.
  Rational search_lower = Rational(-64);
  Rational search_upper = Rational(64);
  int max_power = 20;  ///< k, the number of steps taken together, is at most this
  /// Width of an end's enclosure; a sharp end is enclosed much closer.
  Rational tolerance = Rational(1, 1'000'000'000);
};

/// The certified intervals of s against k = 1 .. max_power; powers whose norm at the interior point is not
/// proved to be below 1 are left out.
///
/// Boxes of s are proved by mean-value bounds on a pruned tree of residue classes (norm_box.h), outwards from
/// the interval that submultiplicativity gives: norm_k <= norm_i norm_{k-i}. At the end the few classes that
/// can reach 1 are followed as polynomials over Q, and the end is isolated as a root.
[[nodiscard]] std::vector<NormRange> iterate_norm_ranges(const DifferenceFamily& family,
                                                         const NormRangeOptions& options);

/// The least power whose interval contains s.
[[nodiscard]] std::optional<int> first_power_containing(const std::vector<NormRange>& ranges,
                                                        const Rational& s);

}  // namespace subdiv
