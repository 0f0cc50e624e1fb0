#pragma once

#include "schemes/mask.h"

namespace subdiv {

/// The four-point scheme with tension w: (-w, 0, 1/2+w, 1, 1/2+w, 0, -w), indices -3 .. 3; w = 1/16
/// reproduces cubics (Dyn, Levin & Gregory 1987, equation 1).
template <class R>
Mask<R> four_point(const R& w) {
  const R inner = fraction<R>(1, 2) + w;
  return {2, Laurent<R>(-3, {R(0) - w, R(0), inner, R(1), inner, R(0), R(0) - w})};
}

}  // namespace subdiv
