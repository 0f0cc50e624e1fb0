#include "optimize/linear_program.h"

#include <memory>
#include <mutex>
#include <stdexcept>

#include <gmp.h>

#include <cddlib/setoper.h>
// cddlib's macros assume that setoper.h comes first.
#include <cddlib/cdd.h>

namespace subdiv {
namespace {

/// cddlib keeps constants and counters in global variables: one caller at a time.
std::mutex& cdd_mutex() {
  static std::mutex mutex;
  static const bool constants_are_set = (dd_set_global_constants(), true);
  static_cast<void>(constants_are_set);
  return mutex;
}

Rational from_mpq(const mpq_t q) {
  Rational result;
  fmpq_set_mpq(result.raw(), q);
  return result;
}

struct MatrixDeleter {
  void operator()(dd_MatrixPtr m) const { dd_FreeMatrix(m); }
};
struct ProgramDeleter {
  void operator()(dd_LPPtr p) const { dd_FreeLPData(p); }
};
using CddMatrix = std::unique_ptr<dd_matrixdata, MatrixDeleter>;
using CddProgram = std::unique_ptr<dd_lpdata, ProgramDeleter>;

CddMatrix to_cdd(const LinearProgram& p) {
  const auto rows = p.a.rows();
  const auto columns = p.a.cols();
  CddMatrix m(dd_CreateMatrix(rows, columns + 1));
  m->representation = dd_Inequality;
  m->numbtype = dd_Rational;
  m->objective = dd_LPmax;
  for (Eigen::Index i = 0; i < rows; ++i) {
    fmpq_get_mpq(m->matrix[i][0], p.b(i).raw());
    for (Eigen::Index j = 0; j < columns; ++j) fmpq_get_mpq(m->matrix[i][j + 1], p.a(i, j).raw());
  }
  mpq_set_si(m->rowvec[0], 0, 1);
  for (Eigen::Index j = 0; j < columns; ++j) fmpq_get_mpq(m->rowvec[j + 1], p.c(j).raw());
  return m;
}

Rational dot(const Vector<Rational>& x, const Vector<Rational>& y) {
  Rational total;
  for (Eigen::Index i = 0; i < x.size(); ++i) total += x(i) * y(i);
  return total;
}

bool is_nonnegative(const Vector<Rational>& x) {
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (x(i).sign() < 0) return false;
  }
  return true;
}

/// A^T y = target.
bool transposed_equals(const Matrix<Rational>& a, const Vector<Rational>& y, const Vector<Rational>& target) {
  for (Eigen::Index j = 0; j < a.cols(); ++j) {
    if (dot(a.col(j), y) != target(j)) return false;
  }
  return true;
}

/// The multipliers of the nonbasic rows. cddlib reports them by position (nbindex) and with its own sign.
Vector<Rational> multipliers(const dd_lpdata& lp, Eigen::Index rows) {
  Vector<Rational> y = Vector<Rational>::Constant(rows, Rational(0));
  for (long j = 1; j < lp.d; ++j) {
    const long row = lp.nbindex[j + 1];
    if (row > 0 && row <= rows) y(row - 1) = abs(from_mpq(lp.dsol[j]));
  }
  return y;
}

}  // namespace

bool is_optimal_pair(const LinearProgram& program, const Vector<Rational>& x, const Vector<Rational>& y) {
  const Vector<Rational> slack = program.b + program.a * x;
  const Vector<Rational> target = -program.c;
  return is_nonnegative(slack) && is_nonnegative(y) && transposed_equals(program.a, y, target) &&
         dot(program.b, y) == dot(program.c, x);
}

LinearSolution solve(const LinearProgram& program) {
  const std::lock_guard lock(cdd_mutex());
  const CddMatrix matrix = to_cdd(program);
  dd_ErrorType error = dd_NoError;
  const CddProgram lp(dd_Matrix2LP(matrix.get(), &error));
  if (error != dd_NoError || !dd_LPSolve(lp.get(), dd_DualSimplex, &error) || error != dd_NoError) {
    throw std::runtime_error("the exact LP solver failed");
  }
  LinearSolution solution;
  solution.y = multipliers(*lp, program.a.rows());
  if (lp->LPS == dd_Optimal) {
    solution.status = LinearSolution::Status::optimal;
    solution.x = Vector<Rational>(program.a.cols());
    for (Eigen::Index j = 0; j < program.a.cols(); ++j) solution.x(j) = from_mpq(lp->sol[j + 1]);
    solution.value = dot(program.c, solution.x);
    if (!is_optimal_pair(program, solution.x, solution.y)) {
      throw std::runtime_error("the exact LP solver's dual certificate does not hold");
    }
    return solution;
  }
  if (lp->LPS == dd_Inconsistent || lp->LPS == dd_StrucInconsistent) {
    solution.status = LinearSolution::Status::infeasible;
    if (lp->re > 0 && lp->re <= program.a.rows()) solution.y(lp->re - 1) = Rational(1);
    const Vector<Rational> zero = Vector<Rational>::Constant(program.a.cols(), Rational(0));
    if (!is_nonnegative(solution.y) || !transposed_equals(program.a, solution.y, zero) ||
        dot(program.b, solution.y).sign() >= 0) {
      throw std::runtime_error("the exact LP solver's proof of infeasibility does not hold");
    }
    return solution;
  }
  solution.status = LinearSolution::Status::unbounded;
  return solution;
}

}  // namespace subdiv
