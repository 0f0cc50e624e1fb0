#include "optimize/epigraph.h"

#include <algorithm>
#include <cmath>

#include <nlopt.hpp>

namespace subdiv {
namespace {

struct Epigraph {
  std::span<const CompiledResidual> residuals;
  std::size_t parameters;
  bool is_maximum;

  [[nodiscard]] std::size_t bounds() const { return is_maximum ? 1 : residuals.size(); }
  [[nodiscard]] std::size_t variables() const { return parameters + bounds(); }

  double objective(std::span<const double> x, double* gradient) const {
    double total = 0;
    for (std::size_t j = 0; j < x.size(); ++j) {
      if (gradient != nullptr) gradient[j] = j < parameters ? 0 : 1;
      if (j >= parameters) total += x[j];
    }
    return total;
  }

  /// Constraints 2i and 2i + 1: r_i - bound <= 0 and -r_i - bound <= 0.
  void constraints(std::span<const double> x, double* result, double* gradient) const {
    const std::span<const double> at = x.first(parameters);
    for (std::size_t i = 0; i < residuals.size(); ++i) {
      const std::size_t bound = parameters + (is_maximum ? 0 : i);
      const double value = residuals[i].value.evaluate(at);
      result[2 * i] = value - x[bound];
      result[2 * i + 1] = -value - x[bound];
      if (gradient == nullptr) continue;
      double* row = gradient + 2 * i * variables();
      std::fill_n(row, 2 * variables(), 0.0);
      for (std::size_t j = 0; j < parameters; ++j) {
        row[j] = residuals[i].gradient[j].evaluate(at);
        row[variables() + j] = -row[j];
      }
      row[bound] = row[variables() + bound] = -1;
    }
  }
};

double objective_at(Norm norm, std::span<const CompiledResidual> residuals, const std::vector<double>& x) {
  std::vector<double> values;
  for (const CompiledResidual& r : residuals) values.push_back(r.value.evaluate(x));
  return objective(norm, values);
}

}  // namespace

std::vector<double> descend_epigraph(const Problem& problem, std::span<const CompiledResidual> residuals,
                                     const std::vector<double>& x) {
  const bool is_maximum = problem.norm == Norm::linf;
  const std::size_t most = is_maximum ? 64 : 24;
  if (problem.norm == Norm::l2 || residuals.size() > most) return x;
  Epigraph epigraph{residuals, x.size(), is_maximum};
  std::vector<double> start(x);
  for (const CompiledResidual& r : residuals) start.push_back(std::abs(r.value.evaluate(x)));
  if (is_maximum) {
    start[x.size()] = *std::max_element(start.begin() + static_cast<std::ptrdiff_t>(x.size()), start.end());
    start.resize(x.size() + 1);
  }
  std::vector<double> low(start.size(), 0.0);
  std::vector<double> high(start.size(), HUGE_VAL);
  for (std::size_t j = 0; j < x.size(); ++j) {
    low[j] = problem.box[j].lower.to_double();
    high[j] = problem.box[j].upper.to_double();
  }
  nlopt::opt solver(nlopt::LD_SLSQP, static_cast<unsigned>(start.size()));
  solver.set_lower_bounds(low);
  solver.set_upper_bounds(high);
  solver.set_min_objective(
      [](unsigned n, const double* at, double* gradient, void* data) {
        return static_cast<const Epigraph*>(data)->objective({at, n}, gradient);
      },
      &epigraph);
  solver.add_inequality_mconstraint(
      [](unsigned, double* result, unsigned n, const double* at, double* gradient, void* data) {
        static_cast<const Epigraph*>(data)->constraints({at, n}, result, gradient);
      },
      &epigraph, std::vector<double>(2 * residuals.size(), 0.0));
  solver.set_xtol_rel(1e-14);
  solver.set_maxeval(300);
  double reached = 0;
  bool stopped_early = false;
  try {
    solver.optimize(start, reached);
  } catch (const std::runtime_error&) {
    stopped_early = true;  // `start` holds the best point so far; it is compared with x below
  }
  if (stopped_early && !std::isfinite(start.front())) return x;
  std::vector<double> end(start.begin(), start.begin() + static_cast<std::ptrdiff_t>(x.size()));
  for (std::size_t j = 0; j < end.size(); ++j) end[j] = std::clamp(end[j], low[j], high[j]);
  return objective_at(problem.norm, residuals, end) < objective_at(problem.norm, residuals, x) ? end : x;
}

}  // namespace subdiv
