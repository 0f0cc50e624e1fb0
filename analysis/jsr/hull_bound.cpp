#include "analysis/jsr/hull_bound.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <Eigen/QR>

namespace subdiv {
namespace {

/// A vector counts as safely independent of others when this share of its length is orthogonal to them.
constexpr double independence = 1e-4;

Eigen::VectorXcd point_of(const std::vector<BallMatrix>& vertices, const HullColumn& column) {
  const Eigen::VectorXcd point = vertices[static_cast<std::size_t>(column.vertex)].midpoints();
  return column.conjugate ? point.conjugate().eval() : point;
}

void copy_column(const std::vector<BallMatrix>& vertices, const HullColumn& column, BallMatrix& into,
                 long j) {
  const BallMatrix& v = vertices[static_cast<std::size_t>(column.vertex)];
  for (long i = 0; i < v.rows(); ++i) {
    column.conjugate ? acb_conj(into.at(i, j), v.at(i, 0)) : acb_set(into.at(i, j), v.at(i, 0));
  }
}

BallMatrix matrix_of(const std::vector<BallMatrix>& vertices, const std::vector<HullColumn>& columns) {
  BallMatrix result(vertices[0].rows(), static_cast<long>(columns.size()));
  for (std::size_t j = 0; j < columns.size(); ++j)
    copy_column(vertices, columns[j], result, static_cast<long>(j));
  return result;
}

/// Grows an orthonormal system by the part of v orthogonal to it, when that is large enough.
bool extend(Eigen::MatrixXcd& orthonormal, Eigen::Index& used, const Eigen::VectorXcd& v) {
  const auto system = orthonormal.leftCols(used);
  Eigen::VectorXcd rest = v - system * (system.adjoint() * v);
  rest -= system * (system.adjoint() * rest);
  if (!(rest.norm() > independence * v.norm())) return false;
  orthonormal.col(used++) = rest / rest.norm();
  return true;
}

Interval unbounded() {
  Interval result;
  arb_pos_inf(result.raw());
  return result;
}

}  // namespace

std::optional<std::vector<HullColumn>> spanning_columns(const std::vector<BallMatrix>& vertices,
                                                        bool complex_hull, long precision) {
  if (vertices.empty()) return std::nullopt;
  const long n = vertices[0].rows();
  std::vector<HullColumn> all;
  for (std::size_t j = 0; j < vertices.size(); ++j) {
    all.push_back({static_cast<int>(j), false});
    if (complex_hull) all.push_back({static_cast<int>(j), true});
  }
  if (static_cast<long>(all.size()) < n) return std::nullopt;
  Eigen::MatrixXcd points(n, static_cast<Eigen::Index>(all.size()));
  for (std::size_t j = 0; j < all.size(); ++j)
    points.col(static_cast<Eigen::Index>(j)) = point_of(vertices, all[j]);
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXcd> qr(points);
  std::vector<HullColumn> result;
  for (long k = 0; k < n; ++k)
    result.push_back(all[static_cast<std::size_t>(qr.colsPermutation().indices()(k))]);
  BallMatrix unit(n, n);
  acb_mat_one(unit.raw());
  if (!solve(matrix_of(vertices, result), unit, precision)) return std::nullopt;
  return result;
}

std::vector<HullColumn> basis_near(const HullCombination& combination,
                                   const std::vector<BallMatrix>& vertices,
                                   const std::vector<HullColumn>& spanning) {
  std::vector<HullCombination::Term> terms = combination.terms;
  std::sort(terms.begin(), terms.end(), [](const HullCombination::Term& a, const HullCombination::Term& b) {
    return std::abs(a.coefficient) > std::abs(b.coefficient);
  });
  std::vector<HullColumn> wanted;
  for (const HullCombination::Term& term : terms) wanted.push_back({term.vertex, term.conjugate});
  wanted.insert(wanted.end(), spanning.begin(), spanning.end());
  const auto n = static_cast<Eigen::Index>(spanning.size());
  Eigen::MatrixXcd orthonormal(n, n);
  Eigen::Index used = 0;
  std::vector<HullColumn> result;
  for (const HullColumn& column : wanted) {
    if (used == n) break;
    if (extend(orthonormal, used, point_of(vertices, column))) result.push_back(column);
  }
  return used == n ? result : spanning;
}

Interval gauge_bound(const BallMatrix& x, const std::vector<BallMatrix>& vertices,
                     const HullCombination& combination, const std::vector<HullColumn>& basis,
                     const std::vector<HullColumn>& spanning, long precision) {
  BallMatrix rest = x;
  Interval sum = Interval(0).with_precision(precision);
  const auto take = [&](const HullColumn& column, acb_srcptr coefficient) {
    sum += modulus(coefficient, precision);
    BallMatrix v(x.rows(), 1);
    copy_column(vertices, column, v, 0);
    for (long i = 0; i < x.rows(); ++i) acb_submul(rest.at(i, 0), coefficient, v.at(i, 0), precision);
  };
  BallMatrix number(1, 1);
  for (const HullCombination::Term& term : combination.terms) {
    const HullColumn column{term.vertex, term.conjugate};
    if (std::find(basis.begin(), basis.end(), column) != basis.end()) continue;
    acb_set_d_d(number.at(0, 0), term.coefficient.real(), term.coefficient.imag());
    take(column, number.at(0, 0));
  }
  // Approximate coefficients on the basis are as good as any; what they leave is small, or as wide as x
  // itself.
  BallMatrix middle(x.rows(), 1);
  BallMatrix approximate(x.rows(), 1);
  BallMatrix columns = matrix_of(vertices, basis);
  acb_mat_get_mid(middle.raw(), rest.raw());
  acb_mat_get_mid(columns.raw(), columns.raw());
  if (acb_mat_approx_solve(approximate.raw(), columns.raw(), middle.raw(), precision) != 0) {
    acb_mat_get_mid(approximate.raw(), approximate.raw());
    for (std::size_t k = 0; k < basis.size(); ++k) take(basis[k], approximate.at(static_cast<long>(k), 0));
  }
  const std::optional<BallMatrix> left = solve(matrix_of(vertices, spanning), rest, precision);
  if (!left) return unbounded();
  for (long i = 0; i < left->rows(); ++i) sum += modulus(left->at(i, 0), precision);
  return sum;
}

bool is_exactly_inside(const Vector<FieldElement>& x, const std::vector<Vector<FieldElement>>& basis) {
  Matrix<FieldElement> columns(x.size(), static_cast<Eigen::Index>(basis.size()));
  for (std::size_t j = 0; j < basis.size(); ++j) columns.col(static_cast<Eigen::Index>(j)) = basis[j];
  const std::optional<Vector<FieldElement>> c = solve(columns, x);
  if (!c) return false;
  FieldElement rest(1);
  for (Eigen::Index i = 0; i < c->size(); ++i) rest -= abs((*c)(i));
  return rest.sign() >= 0;
}

}  // namespace subdiv
