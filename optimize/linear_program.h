#pragma once

#include "schemes/algebra/matrix.h"

namespace subdiv {

/// Maximise c . x subject to b + A x >= 0 (one inequality a row), x free, over the rationals.
struct LinearProgram {
  Matrix<Rational> a;  ///< A, one inequality a row
  Vector<Rational> b;  ///< one number a row
  Vector<Rational> c;  ///< the objective
};

/// optimal: x attains the maximum and y proves it (y >= 0, A^T y = -c, b . y = c . x); infeasible: y >= 0
/// with A^T y = 0 and b . y < 0; unbounded: no certificate is kept.
struct LinearSolution {
  /// What was found.
  enum class Status { optimal, infeasible, unbounded } status = Status::infeasible;  ///< which of them
  Vector<Rational> x;  ///< the maximiser; empty unless optimal
  Vector<Rational> y;  ///< the certificate; empty when unbounded
  Rational value;      ///< the maximum
};

/// Solves in exact rational arithmetic (cddlib) and checks the certificate independently of the solver: a
/// solution that comes back is proved. Throws std::runtime_error when the solver fails or its certificate
/// does not hold.
[[nodiscard]] LinearSolution solve(const LinearProgram& program);

/// y >= 0, A^T y = -c, b . y = c . x and b + A x >= 0: together they prove that x maximises c . x.
[[nodiscard]] bool is_optimal_pair(const LinearProgram& program, const Vector<Rational>& x,
                                   const Vector<Rational>& y);

}  // namespace subdiv
