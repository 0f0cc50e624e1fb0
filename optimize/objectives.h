#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "optimize/problem.h"
#include "schemes/mask.h"

namespace subdiv {

/// The named objectives: each makes of a scheme with free parameters a vector of residuals, rational
/// functions of the parameters, whose norm is to be minimised. On the command line an objective is
/// NAME[:option[=value],...], for example "fit-bspline:degree=2", "fit-bspline:degree=4,continuum", "vertex",
/// "popping:level=3".
///
/// - fit-bspline: the coefficients of the scheme's iterate of a level (level=8), minus B_d (degree=d, must be
///   given) at the same abscissae: coefficient i of k steps stands at (i - centre)/m^k, m the arity, centre
///   the mean of the coefficients' indices, and B_d is centred at 0 (js-report 4, jsplines 4). With the
///   option continuum: the limit function itself minus B_d over the real line; l2 for any scheme with a
///   centre at an integer or half an integer, l1 and linf for jspline:s=NAME alone.
/// - vertex: the limit mask at an old vertex minus the identity (js-report 6).
/// - edge: the limit mask at a new mid-edge vertex minus (1/2, 1/2) (js-report 7).
/// - area: the area mask minus that of polygons (js-report 8).
/// - popping: the coefficients of (L(z) - S(z)) P(z^2), L linear subdivision, S the scheme, P what the levels
///   before made of an impulse with the parameters that were best for each of them in turn (level=1)
///   (jsplines 11).
/// - difference-norm: of the scheme that refines the differences of the c-th divided differences
///   (continuity=c, must be given): the largest sum of absolute values in a residue class of its mask
///   (analysis/iterate_norm.h), which proves C^c below 1; in linf alone, where the residuals are the sums of
///   each class with all signs.
///
/// All but the last work in every norm; fit-bspline (without continuum), vertex, area and difference-norm for
/// schemes of any arity, the others for arity 2; for primal schemes in vertex, edge and popping, for
/// stationary ones in popping and difference-norm.
struct Objective {
  /// One of the names above.
  enum class Kind { fit_bspline, vertex, edge, area, popping, difference_norm };
  Kind kind = Kind::vertex;  ///< which of them
  int degree = 0;            ///< fit-bspline
  int level = 0;             ///< fit-bspline without continuum, popping
  bool continuum = false;    ///< the limit function in place of a level
  int continuity = -1;       ///< difference_norm
};

/// An option of an objective, for the list.
struct ObjectiveOption {
  std::string name;         ///< as it is written
  std::string description;  ///< with its range
};

/// An entry of the list of objectives.
struct ObjectiveDescription {
  std::string name;                      ///< as it is written
  std::string description;               ///< one line
  std::string norms;                     ///< which apply: "l1, l2, linf"
  std::vector<ObjectiveOption> options;  ///< those that it takes
  std::string example;                   ///< a command line
};

/// All of them, in the order of the documents.
[[nodiscard]] std::span<const ObjectiveDescription> objectives();

/// Throws InputError that lists the valid names, options or values.
[[nodiscard]] Objective parse_objective(std::string_view text);
/// As it is written on the command line.
[[nodiscard]] std::string to_string(const Objective& objective);

/// The residuals of an objective as a problem over the box, one range a parameter in the order of the
/// variables. The continuum fit in l2 becomes one residual, the squared distance, in norm l1. Throws
/// InputError when the scheme lacks what the objective needs, and for the continuum fit in l1 and linf, which
/// has no finite vector of residuals: minimise(scheme, ..) handles it.
[[nodiscard]] Problem make_problem(const Scheme<RationalFunction>& scheme, const Objective& objective,
                                   Norm norm, std::vector<Range> box, std::vector<std::string> names);

/// Minimises a named objective, certified, by the way that suits it.
[[nodiscard]] Summary minimise(const Scheme<RationalFunction>& scheme, const Objective& objective, Norm norm,
                               std::vector<Range> box, std::vector<std::string> names,
                               const Options& options = {});

}  // namespace subdiv
