#pragma once

#include <cstddef>

#include "analysis/curve_measures.h"
#include "schemes/algebra/interval.h"
#include "schemes/mask.h"

namespace subdiv {

/// Retrofitting (js-report 5; jsplines 5): the closed polygon P whose limit points L P are the points C of a
/// given one, of any dimension. The mathematics stands in analysis/retrofit.h; here are solvers over double
/// for polygons of any size. L is the limit mask of the whole scheme, mixed schemes included
/// (vertex_limit_mask), as intervals, so that convergence and solvability are decided with certainty.

/// What the matrices L and I - L do to closed loops of n points: both are circulant, so that these numbers
/// over the frequencies w = 2 pi k / n are their spectral radii and norms.
struct LoopSpectrum {
  Interval rate;      ///< the largest |1 - L(e^{iw})|: errors shrink by it a step
  Interval smallest;  ///< the least |L(e^{iw})|: 0 where the direct system is singular
  Interval largest;   ///< the largest |L(e^{iw})|

  [[nodiscard]] bool converges() const { return certainly_less(rate, Interval(1)); }
  [[nodiscard]] bool solvable() const { return certainly_positive(smallest); }
};

/// Throws std::domain_error for n = 0.
[[nodiscard]] LoopSpectrum loop_spectrum(const Laurent<Interval>& limit_mask, std::size_t n);

/// When the iteration is content, and when it gives up.
struct RetrofitOptions {
  double tolerance = 1e-9;        ///< of the largest distance |*P_j - C_j|
  long max_iterations = 1000000;  ///< at most so many are taken
};

/// The polygon whose limit passes through the given points.
struct Retrofit {
  Polyline polygon;       ///< P
  long iterations = 0;    ///< 0 for the direct solution
  double residual = 0;    ///< the largest |*P_j - C_j|, j over all points
  LoopSpectrum spectrum;  ///< of the limit mask, for this number of points
};

/// The papers' iteration P <- P + (C - L P) from P = C until the residual is at most the tolerance; 0
/// iterations when C itself will do. In exact arithmetic it takes at most log(tolerance / (sqrt(n) r_0)) /
/// log(rate) steps, r_0 the first residual. Throws InputError when the rate for this number of points is not
/// below 1 (it says whether the direct solution exists), for more than max_iterations steps, and for a
/// tolerance that rounding does not let it reach; for open or empty polygons and points that are not finite.
[[nodiscard]] Retrofit retrofit_by_iteration(const Laurent<Interval>& limit_mask, const Polyline& target,
                                             const RetrofitOptions& options = {});

/// The solution of L P = C by a sparse LU factorisation of the cyclic banded matrix, in time and memory
/// proportional to n. Its relative error is about 1e-16 times the condition number spectrum.largest /
/// spectrum.smallest. Throws InputError when the system is singular or not known to be regular, and for
/// polygons as above.
[[nodiscard]] Retrofit retrofit_directly(const Laurent<Interval>& limit_mask, const Polyline& target);

}  // namespace subdiv
