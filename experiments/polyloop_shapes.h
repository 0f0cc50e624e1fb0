#pragma once

#include <string>
#include <vector>

#include "experiments/simple_polygons.h"
#include "schemes/mask.h"

namespace subdiv {

/// A curve of polyloops 3.1 under its name there: J0 .. J8 by the old parameter, J(s) = *J_{1 - s/8}, and
/// Jm = J(2) J(0) J(-2) J(-2) J(-2), whose last step repeats.
struct PolyloopCurve {
  std::string name;  // "J5", "Jm"
  Scheme<Rational> scheme;
};

/// J0, J2, J4, J5, J6, J8, Jm.
[[nodiscard]] const std::vector<PolyloopCurve>& polyloop_curves();
/// One of them by its name; std::logic_error for another name.
[[nodiscard]] const Scheme<Rational>& polyloop_curve(const std::string& name);

/// A polygon of experiments/data in place of one of the chapter's figures, which are lost.
struct StoredPolyloop {
  std::string name;  // "square", "star", "non-convex", "crossing"
  PlanePolygon polygon;
};
[[nodiscard]] const std::vector<StoredPolyloop>& stored_polyloops();
[[nodiscard]] const PlanePolygon& stored_polyloop(const std::string& name);

/// How often the chapter's curves are refined where they are measured as polygons.
inline constexpr int measured_level = 5;

/// The polygon after `level` steps in doubles. Its coordinates are exact up to level 5 for integer
/// coordinates below 2^9: masks of these curves are multiples of 1/128, which takes 7 bits a level.
[[nodiscard]] Polyline refined(const Scheme<Rational>& scheme, const PlanePolygon& polygon,
                               int level = measured_level);

}  // namespace subdiv
