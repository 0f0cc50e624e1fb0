#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "analysis/area_mask.h"
#include "analysis/iterate_norm.h"
#include "analysis/limit_mask.h"
#include "analysis/uniform_bspline.h"
#include "optimize/continuum_fit.h"
#include "optimize/objectives.h"
#include "optimize/popping_schedule.h"
#include "optimize/scheme_requirements.h"
#include "schemes/input_error.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

std::vector<Function> coefficients(const Laurent<Function>& difference) {
  return difference.is_zero() ? std::vector<Function>{Function(0)} : difference.coefficients();
}

std::vector<Function> fit_residuals(const Objective& objective, const Scheme<Function>& scheme) {
  const UniformBspline target(objective.degree);
  if (objective.continuum) {
    const Rational centre = constant_centre(to_string(objective), scheme, limit_mean(scheme));
    if (!(centre * Rational(2)).is_integer()) {
      lacks(to_string(objective), scheme,
            "the centre must be an integer or half an integer, it is " + centre.to_string());
    }
    return {squared_distance(scheme, objective.degree, centre)};
  }
  const Laurent<Function> iterate = iterated_symbol(scheme, objective.level);
  const Function mean = sum(euler_derivative(iterate)) / sum(iterate);
  const Rational centre = constant_centre(to_string(objective), scheme, mean);
  const Rational spacing = pow(Rational(scheme.arity()), -objective.level);
  // Where the iterate has no coefficient but the B-spline a value, the residual is the value.
  const Rational reach = target.half_width() / spacing;
  const int first = std::min(iterate.first(), static_cast<int>((-floor(reach - centre)).to_integer()));
  const int last = std::max(iterate.last(), static_cast<int>(floor(reach + centre).to_integer()));
  std::vector<Function> residuals;
  for (int i = first; i <= last; ++i) {
    residuals.push_back(iterate[i] - Function(target.value((Rational(i) - centre) * spacing)));
  }
  return residuals;
}

/// The mask of the step at the exact minimiser of a problem in its parameters.
Mask<Function> at_minimiser(const Objective& objective, const Scheme<Function>& scheme,
                            const Problem& problem, int level, const Options& options) {
  const Summary summary = minimise(problem, options);
  std::vector<Function> point;
  if (summary.termination == Termination::proved) {
    for (const Enclosure& x : summary.minimiser) {
      if (x.rigour == Rigour::exact && x.lower == x.upper) point.emplace_back(x.lower);
    }
  }
  if (point.size() != problem.box.size()) {
    lacks(
        to_string(objective), scheme,
        fmt::format("the best parameters of level {} are not unique rational numbers, so that the next level "
                    "has no residuals over Q",
                    level));
  }
  return map_coefficients(scheme.last(), [&](const Function& f) { return f.evaluate<Function>(point); });
}

std::vector<Function> popping_residuals(const Objective& objective, const Scheme<Function>& scheme,
                                        Problem problem) {
  if (!scheme.is_stationary()) lacks(to_string(objective), scheme, "the objective needs a stationary scheme");
  Laurent<Function> before(1);
  for (int level = 1;; ++level) {
    problem.residuals = coefficients(popping_difference(scheme.last(), before));
    if (level == objective.level) return problem.residuals;
    const Mask<Function> best = at_minimiser(objective, scheme, problem, level, Options{});
    before = best.symbol * upsample(before, 2);
  }
}

/// For each residue class of the difference scheme the sums of its coefficients with all signs, up to a
/// common one: the largest absolute value of all is the norm.
std::vector<Function> difference_residuals(const Objective& objective, const Scheme<Function>& scheme) {
  constexpr int most = 10;  // coefficients of a class
  if (!scheme.is_stationary()) lacks(to_string(objective), scheme, "the objective needs a stationary scheme");
  const auto difference = difference_symbol(scheme.last(), objective.continuity);
  if (!difference) {
    lacks(to_string(objective), scheme,
          fmt::format("the scheme has fewer than {} smoothing factors for all values of its parameters",
                      objective.continuity + 1));
  }
  std::vector<Function> residuals;
  for (int r = 0; r < scheme.arity(); ++r) {
    std::vector<Function> sums{Function(0)};
    const Laurent<Function> members = residue_class(*difference, r, scheme.arity());
    if (members.size() > most) {
      lacks(to_string(objective), scheme,
            fmt::format("a residue class of the difference scheme has {} coefficients, more than {}",
                        members.size(), most));
    }
    for (const Function& c : members.coefficients()) {
      const std::size_t before = sums.size();
      const bool is_first = before == 1 && sums.front().is_zero();
      for (std::size_t i = 0; i < before; ++i) {
        if (!is_first) sums.push_back(sums[i] - c);
        sums[i] += c;
      }
    }
    residuals.insert(residuals.end(), sums.begin(), sums.end());
  }
  return residuals;
}

std::vector<Function> residuals_of(const Scheme<Function>& scheme, const Objective& objective,
                                   const Problem& problem) {
  const Function half = fraction<Function>(1, 2);
  switch (objective.kind) {
    case Objective::Kind::fit_bspline:
      return fit_residuals(objective, scheme);
    case Objective::Kind::vertex:
      require_primal(to_string(objective), scheme);
      return coefficients(vertex_limit_mask(scheme) - Laurent<Function>(1));
    case Objective::Kind::edge:
      require_primal(to_string(objective), scheme);
      return coefficients(edge_limit_mask(scheme) - Laurent<Function>(0, {half, half}));
    case Objective::Kind::area:
      return coefficients(area_mask(scheme) - polygon_area_mask<Function>());
    case Objective::Kind::popping:
      require_primal(to_string(objective), scheme);
      return popping_residuals(objective, scheme, problem);
    case Objective::Kind::difference_norm:
      return difference_residuals(objective, scheme);
  }
  throw std::logic_error("no such objective");
}

/// The others speak of old points and new ones between two of them, or of integrals that are known for two
/// steps a level.
bool takes_any_arity(const Objective& objective) {
  return objective.kind == Objective::Kind::vertex || objective.kind == Objective::Kind::area ||
         objective.kind == Objective::Kind::difference_norm ||
         (objective.kind == Objective::Kind::fit_bspline && !objective.continuum);
}

bool is_jspline_family(const Scheme<Function>& scheme) {
  return scheme.is_stationary() && scheme.last() == jspline(Function::variable(0));
}

bool is_continuum(const Objective& objective) {
  return objective.kind == Objective::Kind::fit_bspline && objective.continuum;
}

}  // namespace

Problem make_problem(const Scheme<Function>& scheme, const Objective& objective, Norm norm,
                     std::vector<Range> box, std::vector<std::string> names) {
  if (!takes_any_arity(objective)) require_binary(to_string(objective), scheme);
  require_steps(to_string(objective), scheme);
  if (objective.kind == Objective::Kind::difference_norm && norm != Norm::linf) {
    lacks(to_string(objective), scheme, "the norm of a difference scheme is linf, not " + to_string(norm));
  }
  const bool squared = is_continuum(objective);
  if (squared && norm != Norm::l2) {
    lacks(to_string(objective), scheme,
          fmt::format("the continuum fit in {} is known for jspline:s=NAME alone", to_string(norm)));
  }
  Problem problem{{}, norm, std::move(box), std::move(names)};
  try {
    problem.residuals = residuals_of(scheme, objective, problem);
  } catch (const std::domain_error& error) {
    lacks(to_string(objective), scheme, error.what());
  }
  if (squared) problem.norm = Norm::l1;  // one residual that is not negative
  return problem;
}

Summary minimise(const Scheme<Function>& scheme, const Objective& objective, Norm norm,
                 std::vector<Range> box, std::vector<std::string> names, const Options& options) {
  if (is_continuum(objective) && norm != Norm::l2 && is_jspline_family(scheme) && box.size() == 1) {
    return minimise_continuum_fit(objective.degree, norm, box[0], options);
  }
  const Problem problem = make_problem(scheme, objective, norm, std::move(box), std::move(names));
  if (is_continuum(objective) && problem.box.size() == 1) {
    if (auto zero = only_zero(problem.residuals[0], problem.box[0])) return *zero;
  }
  return minimise(problem, options);
}

}  // namespace subdiv
