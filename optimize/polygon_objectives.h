#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "optimize/objectives.h"
#include "optimize/problem.h"
#include "schemes/mask.h"

namespace subdiv {

/// Data-dependent optimisation (jsplines abstract, 8; js-report 14): objectives on the curve of one given
/// closed control polygon. On the command line NAME[:option=value], with --polygon.
///
/// - vertex-distance: the vectors from the control vertices to their limit points.
/// - edge-distance: the vectors from the middles of the edges to the limit points of their parameters.
/// - polygon-distance: the Hausdorff distance between the limit curve and the control polygon.
/// - area: what the limit curve's area misses of the polygon's, in the plane.
/// - popping: the vectors by which the points of each level 1 .. L are off the linear refinement J_{0,1} of
///   the level before (level=L; 1 when not given).
///
/// Norms of vectors: l2 is the sum of their squared lengths, linf the largest length, l1 the sum of lengths.
/// l2 and linf are rational (linf: its square) and minimised with proof over the whole box, and so is l1 of
/// points of one coordinate; otherwise l1 is local. area is one number, the norm does not matter: over one
/// parameter all values that preserve it are exact algebraic numbers, all of them listed (Summary::zeros).
/// polygon-distance is linf alone, and local.
struct PolygonObjective {
  /// One of the names above.
  enum class Kind { vertex_distance, edge_distance, polygon_distance, area, popping };
  Kind kind = Kind::vertex_distance;  ///< which of them
  int level = 1;                      ///< popping
};

/// All of them, in the order of the enumeration.
[[nodiscard]] std::span<const ObjectiveDescription> polygon_objectives();

/// Whether a text names one of them, whatever its options.
[[nodiscard]] bool names_polygon_objective(std::string_view text);
/// Throws InputError that lists the valid names, options or values.
[[nodiscard]] PolygonObjective parse_polygon_objective(std::string_view text);
/// As it is written on the command line.
[[nodiscard]] std::string to_string(const PolygonObjective& objective);

/// Minimises an objective over a box of parameters, one range a parameter in the order of the variables.
/// coordinates[c][i] is coordinate c of point i of the closed polygon. The minimum is the objective itself
/// (linf: the length). Termination::local: found by local searches from several starts, all approximate.
/// Throws InputError when the scheme or the polygon lack what the objective needs: arity 2, a primal scheme,
/// points in the plane for areas, limit masks; and when box and parameters do not match.
[[nodiscard]] Summary minimise_on_polygon(const Scheme<RationalFunction>& scheme,
                                          const PolygonObjective& objective, Norm norm,
                                          const std::vector<std::vector<Rational>>& coordinates,
                                          std::vector<Range> box, std::vector<std::string> names,
                                          const Options& options = {});

}  // namespace subdiv
