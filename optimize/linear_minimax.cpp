#include "optimize/linear_minimax.h"

#include "optimize/linear_program.h"

namespace subdiv {
namespace {

/// r_i(x) = constant_i + sum_j slope_ij x_j.
struct AffineResiduals {
  Vector<Rational> constant;
  Matrix<Rational> slope;
};

std::optional<AffineResiduals> affine_residuals(const Problem& problem) {
  const auto rows = static_cast<Eigen::Index>(problem.residuals.size());
  const auto columns = static_cast<Eigen::Index>(problem.box.size());
  AffineResiduals result{Vector<Rational>(rows), zero_matrix<Rational>(rows, columns)};
  for (Eigen::Index i = 0; i < rows; ++i) {
    const RationalFunction& r = problem.residuals[static_cast<std::size_t>(i)];
    const Polynomial numerator = r.numerator();
    const Polynomial denominator = r.denominator();
    if (!denominator.is_constant()) return std::nullopt;
    for (const Polynomial::Term& term : numerator.terms()) {
      const Rational value = term.coefficient / denominator.constant();
      Eigen::Index variable = -1;
      for (std::size_t j = 0; j < term.exponents.size(); ++j) {
        if (term.exponents[j] == 0) continue;
        if (term.exponents[j] > 1 || variable >= 0) return std::nullopt;
        variable = static_cast<Eigen::Index>(j);
      }
      if (variable >= columns) return std::nullopt;
      (variable < 0 ? result.constant(i) : result.slope(i, variable)) = value;
    }
  }
  return result;
}

/// Constraints over (x, e): linf has one bound e for all residuals, l1 one e_i for each; maximise -sum e.
LinearProgram epigraph(const Problem& problem, const AffineResiduals& r) {
  const auto rows = r.constant.size();
  const auto parameters = static_cast<Eigen::Index>(problem.box.size());
  const Eigen::Index bounds = problem.norm == Norm::linf ? 1 : rows;
  LinearProgram p{zero_matrix<Rational>(2 * rows + 2 * parameters, parameters + bounds),
                  Vector<Rational>::Constant(2 * rows + 2 * parameters, Rational(0)),
                  Vector<Rational>::Constant(parameters + bounds, Rational(0))};
  for (Eigen::Index i = 0; i < rows; ++i) {
    for (Eigen::Index sign = 0; sign < 2; ++sign) {
      const Eigen::Index row = 2 * i + sign;
      const Rational factor(sign == 0 ? -1 : 1);
      p.b(row) = factor * r.constant(i);
      for (Eigen::Index j = 0; j < parameters; ++j) p.a(row, j) = factor * r.slope(i, j);
      p.a(row, parameters + (bounds == 1 ? 0 : i)) = Rational(1);
    }
  }
  for (Eigen::Index j = 0; j < parameters; ++j) {
    const Range& range = problem.box[static_cast<std::size_t>(j)];
    const Eigen::Index row = 2 * rows + 2 * j;
    p.a(row, j) = Rational(1);
    p.b(row) = -range.lower;
    p.a(row + 1, j) = Rational(-1);
    p.b(row + 1) = range.upper;
  }
  for (Eigen::Index k = 0; k < bounds; ++k) p.c(parameters + k) = Rational(-1);
  return p;
}

/// Is x_j the same at all optima? Minimise and maximise it subject to sum e <= minimum.
bool parameter_is_unique(LinearProgram program, Eigen::Index j, const Rational& minimum) {
  const Eigen::Index rows = program.a.rows();
  program.a.conservativeResize(rows + 1, program.a.cols());
  program.b.conservativeResize(rows + 1);
  for (Eigen::Index k = 0; k < program.a.cols(); ++k) program.a(rows, k) = program.c(k);
  program.b(rows) = minimum;
  Rational values[2];
  for (int sign = 0; sign < 2; ++sign) {
    program.c.setConstant(Rational(0));
    program.c(j) = Rational(sign == 0 ? 1 : -1);
    values[sign] = solve(program).x(j);
  }
  return values[0] == values[1];
}

}  // namespace

std::optional<Summary> minimise_linear(const Problem& problem) {
  if (problem.norm == Norm::l2) return std::nullopt;
  const auto residuals = affine_residuals(problem);
  if (!residuals) return std::nullopt;
  const LinearProgram program = epigraph(problem, *residuals);
  const LinearSolution solution = solve(program);
  Summary summary;
  summary.method = "exact LP with dual certificate";
  const Rational minimum = -solution.value;
  summary.minimum = exact(minimum, summary.method);
  bool unique = true;
  Vector<Rational> x = solution.x.head(static_cast<Eigen::Index>(problem.box.size()));
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    summary.minimiser.push_back(exact(x(j), summary.method));
    unique = unique && parameter_is_unique(program, j, minimum);
  }
  const Vector<Rational> values = residuals->constant + residuals->slope * x;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const bool active = problem.norm == Norm::linf ? abs(values(i)) == minimum : values(i).sign() == 0;
    if (active) summary.active.push_back(static_cast<int>(i));
  }
  summary.termination = unique ? Termination::proved : Termination::not_unique;
  summary.message =
      unique ? "the optimum is exact and unique" : "the minimum is exact; its minimisers are several";
  return summary;
}

}  // namespace subdiv
