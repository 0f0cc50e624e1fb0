#include "analysis/contraction_range.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Dense>

#include "analysis/jsr/word.h"
#include "analysis/sign_on_interval.h"
#include "analysis/symmetric_gauge.h"
#include "schemes/algebra/specialize.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

Eigen::MatrixXd approximate(const Matrix<Function>& a, const Rational& at) {
  return a.unaryExpr([&](const Function& f) { return specialize(f, 0, at).to_double(); });
}

/// The real eigenvector whose eigenvalue is nearest to 1, largest entry 1, rounded to three digits.
std::optional<Vector<Function>> rounded_eigenvector(const Eigen::MatrixXd& matrix) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(matrix);
  if (solver.info() != Eigen::Success) return std::nullopt;
  Eigen::Index nearest = 0;
  (solver.eigenvalues().array() - 1).abs().minCoeff(&nearest);
  if (solver.eigenvalues()(nearest).imag() != 0) return std::nullopt;
  const Eigen::VectorXd v = solver.eigenvectors().col(nearest).real();
  constexpr int digits = 1000;
  return Vector<Function>((v * (digits / v.cwiseAbs().maxCoeff())).unaryExpr([](double x) {
    return Function(Rational(std::lround(x), digits));
  }));
}

/// adj(I - leading) v_0, by Cramer's rule.
std::optional<Vector<Function>> critical_vector(const Matrix<Function>& leading, const Rational& at) {
  const auto start = rounded_eigenvector(approximate(leading, at));
  if (!start) return std::nullopt;
  const Matrix<Function> rest = identity_matrix<Function>(leading.rows()) - leading;
  auto solution = solve(rest, *start);
  if (!solution) return std::nullopt;
  const Function determinant = characteristic_polynomial(rest)[0];
  for (Eigen::Index i = 0; i < solution->size(); ++i) (*solution)(i) *= determinant;
  return solution;
}

/// Vertices over Q(p) beside their values at one point.
class Hull {
 public:
  Hull(const std::optional<Matrix<Function>>& mirror, const Rational& at) : mirror_(mirror), at_(at) {}

  void add(const Vector<Function>& v) {
    append(v);
    if (mirror_) append(Vector<Function>(*mirror_ * v));
  }
  [[nodiscard]] bool contains(const Vector<Function>& v) const {
    constexpr double rounding = 1e-9;
    const auto gauge = SymmetricGauge::of(points_);
    return gauge && gauge->gauge(approximate(v, at_)) <= 1 - rounding;
  }
  [[nodiscard]] const std::vector<Vector<Function>>& vertices() const { return vertices_; }

 private:
  void append(const Vector<Function>& v) {
    vertices_.push_back(v);
    points_.conservativeResize(v.size(), points_.cols() + 1);
    points_.rightCols<1>() = approximate(v, at_);
  }

  const std::optional<Matrix<Function>>& mirror_;
  const Rational& at_;
  std::vector<Vector<Function>> vertices_;
  Eigen::MatrixXd points_;
};

Matrix<Function> as_columns(const std::vector<Vector<Function>>& vectors) {
  Matrix<Function> result(vectors[0].size(), static_cast<Eigen::Index>(vectors.size()));
  for (std::size_t j = 0; j < vectors.size(); ++j) result.col(static_cast<Eigen::Index>(j)) = vectors[j];
  return result;
}

/// A rational number a given part of the way from one end of the range to the other.
Rational between(const Algebraic& from, const Algebraic& to, const Rational& part) {
  const Rational a = from.to_interval().midpoint();
  const Rational width = to.to_interval().midpoint() - a;
  const Rational target = a + part * width;
  const Rational tolerance = abs(width) * std::min(part, Rational(1) - part) / Rational(16);
  return simplest_between(target - tolerance, target + tolerance);
}

}  // namespace

std::optional<Matrix<Function>> critical_vertices(const std::vector<Matrix<Function>>& matrices,
                                                  const Matrix<Function>& leading,
                                                  const std::optional<Matrix<Function>>& mirror,
                                                  const Rational& at,
                                                  const std::vector<Matrix<Function>>& beginnings) {
  const auto start = critical_vector(leading, at);
  if (!start) return std::nullopt;
  const Function longer = fraction<Function>(101, 100);
  constexpr std::size_t most_vertices = 60;
  Hull hull(mirror, at);
  hull.add(*start);
  std::vector<Vector<Function>> inside;  // for every p, see the header
  for (const Matrix<Function>& beginning : beginnings) {
    inside.emplace_back(beginning * *start);
    hull.add(inside.back());
  }
  inside.emplace_back(leading * *start);
  const auto is_known = [&](const Vector<Function>& v) {
    return std::ranges::any_of(inside, [&](const Vector<Function>& known) {
      return v == known || (mirror && v == Vector<Function>(*mirror * known));
    });
  };
  for (std::size_t j = 0; j < hull.vertices().size(); ++j) {
    for (const Matrix<Function>& t : matrices) {
      const Vector<Function> v = t * hull.vertices()[j];
      if (is_known(v) || hull.contains(v)) continue;
      hull.add(Vector<Function>(v.unaryExpr([&](const Function& f) { return f * longer; })));
      if (hull.vertices().size() > most_vertices) return std::nullopt;
    }
  }
  return as_columns(hull.vertices());
}

std::optional<ContractionRange> prove_contraction(const std::vector<Matrix<Function>>& matrices,
                                                  const Matrix<Function>& leading,
                                                  const std::optional<Matrix<Function>>& mirror,
                                                  const RealInterval& range) {
  const Eigen::Index n = leading.rows();
  const Matrix<Function> rest = identity_matrix<Function>(n) - leading;
  const bool upwards =
      !has_no_root(characteristic_polynomial(rest)[0].numerator(), {range.upper, range.upper, true, true});
  const Algebraic& critical = upwards ? *range.upper : *range.lower;
  const Algebraic& other = upwards ? *range.lower : *range.upper;
  const auto vertices =
      critical_vertices(matrices, leading, mirror, between(critical, other, Rational(1, 1000)));
  if (!vertices) return std::nullopt;
  constexpr int longest = 3;
  const Rational step(1, 16);
  for (Rational part = Rational(2) * step; part < Rational(1); part += step) {
    const Algebraic cut(between(critical, other, part));
    const RealInterval near =
        upwards ? RealInterval{cut, critical, true, false} : RealInterval{critical, cut, false, true};
    const RealInterval far =
        upwards ? RealInterval{other, cut, false, true} : RealInterval{cut, other, true, false};
    for (int length = 1; length <= longest; ++length) {
      auto norms = prove_containment(all_products(matrices, length), identity_matrix<Function>(n),
                                     Function(1), far, Containment::interior, 1);
      if (!norms) continue;
      auto polytopes = prove_containment(matrices, *vertices, Function(1), near, Containment::interior);
      if (!polytopes) return std::nullopt;
      return ContractionRange{range, length, std::move(*norms), std::move(*polytopes)};
    }
  }
  return std::nullopt;
}

Matrix<Function> reversal(Eigen::Index n) {
  Matrix<Function> result = zero_matrix<Function>(n, n);
  for (Eigen::Index i = 0; i < n; ++i) result(i, n - 1 - i) = Function(1);
  return result;
}

}  // namespace subdiv
