#pragma once

#include <string>
#include <vector>

#include "analysis/open_polygon.h"
#include "experiments/polygon_file.h"
#include "schemes/evaluate/control_polygon.h"
#include "schemes/instantiate.h"

namespace subdiv::cli {

/// The scheme without free parameters. InputError names those that are free.
[[nodiscard]] SchemeDescription evaluated_scheme(const std::string& text);

/// The control polygon of a curve from the points of a file: closed unless `open` says how the curve ends
/// (clamped or reflected; the scheme's added points). InputError when the file's line element is open and
/// nothing is said, or says otherwise.
[[nodiscard]] CoordinateArrays<double> control_curve(const PointList<double>& points, const std::string& open,
                                                     const SchemeDescription& scheme);

/// Throws InputError that begins with `where` and names the point (from 1) unless all coordinates lie within
/// 1e150 of 0, so that their products, and what is measured of them, stay within the doubles.
void require_measurable(const CoordinateArrays<double>& coordinates, const std::string& where);

/// "clamped" or "reflected".
[[nodiscard]] OpenEnd open_end(const std::string& name);

/// The masks, each coefficient the nearest double but for the last unit.
[[nodiscard]] Scheme<double> scheme_in_double(const SchemeDescription& scheme);

/// Calls action(scheme) with the masks over the rationals where they are, else over double.
template <class Action>
auto with_masks(const SchemeDescription& description, const Action& action) {
  if (smallest_field(description) == Field::rational) return action(instantiate<Rational>(description));
  return action(scheme_in_double(description));
}

}  // namespace subdiv::cli
