#include "optimize/local_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <ceres/ceres.h>
#include <nlopt.hpp>

#include "optimize/epigraph.h"
#include "optimize/residual_functions.h"

namespace subdiv {
namespace {

using Point = std::vector<double>;

constexpr long double_precision = 64;

/// Element n of the van der Corput sequence in a base.
double van_der_corput(int n, int base) {
  double value = 0;
  double digit = 1;
  for (; n > 0; n /= base) {
    digit /= base;
    value += digit * (n % base);
  }
  return value;
}

Point start_point(const std::vector<Range>& box, int n) {
  constexpr int bases[] = {2, 3, 5, 7, 11, 13};
  Point x;
  for (std::size_t i = 0; i < box.size(); ++i) {
    const double low = box[i].lower.to_double();
    const double high = box[i].upper.to_double();
    x.push_back(low + (high - low) * van_der_corput(n + 1, bases[i]));
  }
  return x;
}

double evaluate(Norm norm, const std::vector<CompiledResidual>& residuals, const Point& x) {
  Point values;
  values.reserve(residuals.size());
  for (const CompiledResidual& r : residuals) values.push_back(r.value.evaluate(x));
  const double result = objective(norm, values);
  return std::isfinite(result) ? result : std::numeric_limits<double>::max();
}

/// One residual for Ceres, with its exact gradient.
class ResidualCost : public ceres::CostFunction {
 public:
  ResidualCost(const CompiledResidual& residual, int variables) : residual_(residual) {
    set_num_residuals(1);
    mutable_parameter_block_sizes()->push_back(variables);
  }
  bool Evaluate(double const* const* parameters, double* value, double** jacobians) const override {
    const std::span<const double> x(parameters[0], residual_.gradient.size());
    value[0] = residual_.value.evaluate(x);
    if (jacobians != nullptr && jacobians[0] != nullptr) {
      for (std::size_t i = 0; i < x.size(); ++i) jacobians[0][i] = residual_.gradient[i].evaluate(x);
    }
    return std::isfinite(value[0]);
  }

 private:
  const CompiledResidual& residual_;
};

bool search_least_squares(const Problem& problem, const std::vector<CompiledResidual>& residuals, Point& x) {
  ceres::Problem least_squares;
  const int variables = static_cast<int>(x.size());
  for (const CompiledResidual& r : residuals) {
    least_squares.AddResidualBlock(new ResidualCost(r, variables), nullptr, x.data());
  }
  for (int i = 0; i < variables; ++i) {
    least_squares.SetParameterLowerBound(x.data(), i,
                                         problem.box[static_cast<std::size_t>(i)].lower.to_double());
    least_squares.SetParameterUpperBound(x.data(), i,
                                         problem.box[static_cast<std::size_t>(i)].upper.to_double());
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.function_tolerance = 1e-16;
  options.parameter_tolerance = 1e-14;
  options.gradient_tolerance = 1e-16;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &least_squares, &summary);
  return summary.IsSolutionUsable();
}

/// Improves x by Sbplx; false when the solver fails.
template <class Value>
bool search_by_sbplx(const Value& value, const std::vector<Range>& box, double tolerance, int most_values,
                     Point& x) {
  nlopt::opt solver(nlopt::LN_SBPLX, static_cast<unsigned>(x.size()));
  Point low;
  Point high;
  for (const Range& range : box) {
    low.push_back(range.lower.to_double());
    high.push_back(range.upper.to_double());
  }
  solver.set_lower_bounds(low);
  solver.set_upper_bounds(high);
  solver.set_min_objective(
      [](const Point& at, Point&, void* data) { return (*static_cast<const Value*>(data))(at); },
      const_cast<void*>(static_cast<const void*>(&value)));
  solver.set_xtol_rel(tolerance);
  solver.set_maxeval(most_values);
  double reached = 0;
  try {
    solver.optimize(x, reached);
  } catch (const nlopt::roundoff_limited&) {
    return true;  // x holds the best point so far
  } catch (const std::runtime_error&) {
    return false;
  }
  return true;
}

bool search_with_kinks(const Problem& problem, const std::vector<CompiledResidual>& residuals, Point& x) {
  const auto value = [&](const Point& at) { return evaluate(problem.norm, residuals, at); };
  // Over several parameters this only finds the valley: descend_epigraph finds its bottom.
  const bool is_final = x.size() == 1;
  const int most_values = is_final ? 20000 : 500 * static_cast<int>(x.size());
  if (!search_by_sbplx(value, problem.box, is_final ? 1e-13 : 1e-9, most_values, x)) return false;
  if (!is_final) x = descend_epigraph(problem, residuals, x);
  return true;
}

std::optional<LocalMinimum> descend(const Problem& problem, const std::vector<CompiledResidual>& residuals,
                                    Point x) {
  const bool usable = problem.norm == Norm::l2 ? search_least_squares(problem, residuals, x)
                                               : search_with_kinks(problem, residuals, x);
  if (!usable) return std::nullopt;
  return LocalMinimum{x, evaluate(problem.norm, residuals, x)};
}

bool same_point(const Point& a, const Point& b) {
  constexpr double tolerance = 1e-7;
  return std::equal(a.begin(), a.end(), b.begin(),
                    [](double x, double y) { return std::abs(x - y) <= tolerance * (1 + std::abs(x)); });
}

/// Best first, points that agree once.
std::vector<LocalMinimum> distinct_minima(std::vector<LocalMinimum> found) {
  std::stable_sort(found.begin(), found.end(),
                   [](const LocalMinimum& a, const LocalMinimum& b) { return a.objective < b.objective; });
  std::vector<LocalMinimum> distinct;
  for (LocalMinimum& candidate : found) {
    const bool known = std::any_of(distinct.begin(), distinct.end(),
                                   [&](const LocalMinimum& d) { return same_point(d.x, candidate.x); });
    if (!known) distinct.push_back(std::move(candidate));
  }
  return distinct;
}

}  // namespace

std::optional<LocalMinimum> improve(const Problem& problem, const std::vector<double>& start) {
  return descend(problem, compile(problem, double_precision), start);
}

std::vector<LocalMinimum> local_minima(const Problem& problem, const Options& options) {
  const std::vector<CompiledResidual> residuals = compile(problem, double_precision);
  std::vector<LocalMinimum> found;
  for (int n = 0; n < options.starts; ++n) {
    if (auto minimum = descend(problem, residuals, start_point(problem.box, n)))
      found.push_back(std::move(*minimum));
  }
  return distinct_minima(std::move(found));
}

std::vector<LocalMinimum> local_minima(const std::function<double(const std::vector<double>&)>& function,
                                       const std::vector<Range>& box, int starts, double tolerance) {
  const auto value = [&](const Point& x) {
    const double result = function(x);
    return std::isfinite(result) ? result : std::numeric_limits<double>::max();
  };
  std::vector<LocalMinimum> found;
  for (int n = 0; n < starts; ++n) {
    Point x = start_point(box, n);
    if (!search_by_sbplx(value, box, tolerance, 1000 * static_cast<int>(x.size()), x)) continue;
    const double reached = value(x);
    if (reached < std::numeric_limits<double>::max()) found.push_back({std::move(x), reached});
  }
  return distinct_minima(std::move(found));
}

}  // namespace subdiv
