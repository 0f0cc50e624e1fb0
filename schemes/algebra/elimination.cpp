#include "schemes/algebra/elimination.h"

#include <flint/fmpq_mat.h>

namespace subdiv {
namespace {

/// Owns a FLINT matrix.
class RationalMatrix {
 public:
  RationalMatrix(Eigen::Index rows, Eigen::Index columns) { fmpq_mat_init(value_, rows, columns); }
  RationalMatrix(const RationalMatrix&) = delete;
  RationalMatrix& operator=(const RationalMatrix&) = delete;
  ~RationalMatrix() { fmpq_mat_clear(value_); }

  [[nodiscard]] fmpq* at(Eigen::Index i, Eigen::Index j) { return fmpq_mat_entry(value_, i, j); }
  [[nodiscard]] fmpq_mat_struct* raw() { return value_; }

 private:
  fmpq_mat_t value_;
};

}  // namespace

std::optional<Vector<Rational>> solve_linear(const Matrix<Rational>& a, const Vector<Rational>& b) {
  const Eigen::Index n = a.cols();
  RationalMatrix augmented(a.rows(), n + 1);
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    for (Eigen::Index j = 0; j < n; ++j) fmpq_set(augmented.at(i, j), a(i, j).raw());
    fmpq_set(augmented.at(i, n), b(i).raw());
  }
  const long rank = fmpq_mat_rref(augmented.raw(), augmented.raw());
  if (rank != n) return std::nullopt;
  // Full column rank without a contradiction: the first n rows begin with the identity.
  Vector<Rational> x(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    if (fmpq_is_one(augmented.at(i, i)) == 0) return std::nullopt;
    fmpq_set(x(i).raw(), augmented.at(i, n));
  }
  return x;
}

}  // namespace subdiv
