#pragma once

#include "schemes/mask.h"

namespace subdiv {

/// The dual four-point scheme of Dyn, Floater & Hormann (2005) with tension w: local cubic interpolation at
/// 1/4 and 3/4 blended with Chaikin's corner cutting. Rule at 1/4: (-7w, 3/4+9w, 1/4+3w, -5w); at 3/4 its
/// mirror image. w = 0 is Chaikin, w = 1/128 reproduces cubics. Mask indices -4 .. 3: refined points 2j and
/// 2j+1 stand at j + 1/4 and j + 3/4 when index i stands at i / 2 + 1/4.
template <class R>
Mask<R> dyn_floater_hormann(const R& w) {
  const R far = fraction<R>(-5, 1) * w;
  const R near = fraction<R>(-7, 1) * w;
  const R low = fraction<R>(1, 4) + fraction<R>(3, 1) * w;
  const R high = fraction<R>(3, 4) + fraction<R>(9, 1) * w;
  return {2, Laurent<R>(-4, {far, near, low, high, high, low, near, far})};
}

}  // namespace subdiv
