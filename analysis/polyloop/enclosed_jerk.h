#pragma once

#include "analysis/curve_measures.h"
#include "schemes/algebra/interval.h"

namespace subdiv {

/// The largest and the mean absolute normal jerk (curve_measures.h) of a closed plane polyline whose doubles
/// are its exact coordinates, enclosed. Throws std::invalid_argument for others, and for edges of length 0.
struct EnclosedNormalJerk {
  Interval largest;  ///< of the absolute values
  Interval mean;     ///< of the absolute values
};
/// Both for one polyline.
[[nodiscard]] EnclosedNormalJerk enclosed_normal_jerk(const Polyline& polyline);

}  // namespace subdiv
