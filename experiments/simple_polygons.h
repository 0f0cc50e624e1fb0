#pragma once

#include <utility>
#include <vector>

#include "analysis/curve_measures.h"
#include "experiments/claim.h"

namespace subdiv {

/// A closed polygon in the plane with exact vertices.
using PlanePolygon = std::vector<std::pair<Rational, Rational>>;

/// The family on which tendencies are measured: the 200 simple polygons of data/simple-polygons.csv, of 4 to
/// 12 vertices with integer coordinates, half of them star-shaped and half scattered (data/README.md gives
/// the rule). Throws InputError that names the file where it is not as it should be.
[[nodiscard]] const std::vector<PlanePolygon>& simple_polygons();

/// A polygon's vertices rounded to double.
[[nodiscard]] Polyline in_double(const PlanePolygon& polygon);

/// How that family is named in definitions: "the 200 simple polygons of ..".
[[nodiscard]] const std::string& simple_polygons_text();

/// Settles a claim about a share: on `count` of `total` cases the statement holds. A printed claim
/// ("usually", "tends to", "works well") is reproduced when they are more than half of all; approximate
/// decisions make it consistent at most.
[[nodiscard]] Claim settle_share(const ClaimHead& head, int count, int total, std::string note = "",
                                 Rigour rigour = Rigour::exact);

}  // namespace subdiv
