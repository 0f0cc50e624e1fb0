#include "analysis/jsr/hull_gauge.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>

#include <Eigen/LU>

namespace subdiv {
namespace {

/// Multiples of the unit vectors that make every linear program feasible at a prohibitive price.
constexpr double artificial_size = 1e-7;
constexpr int first_phases = 4;  // on the half circle
constexpr int most_rounds = 8;
constexpr double violation = 1e-6;

SymmetricGauge artificial_gauge(Eigen::Index n) {
  return SymmetricGauge::of(artificial_size * Eigen::MatrixXd::Identity(n, n)).value();
}

bool is_real(const Eigen::VectorXcd& v) { return v.imag().isZero(0); }

}  // namespace

HullGauge::HullGauge(Eigen::Index dimension, bool complex_hull)
    : complex_(complex_hull),
      artificial_(complex_hull ? 2 * dimension : dimension),
      gauge_(artificial_gauge(artificial_)) {}

void HullGauge::condition() {
  const Eigen::Index columns = gauge_.vertices().cols() - artificial_;
  if (columns < gauge_.dimension()) return;
  if (std::optional<SymmetricGauge> fresh = SymmetricGauge::of(gauge_.vertices().rightCols(columns))) {
    gauge_ = std::move(*fresh);
    artificial_ = 0;
  }
}

Eigen::VectorXd HullGauge::lift(const Eigen::VectorXcd& x) const {
  if (!complex_) return x.real();
  Eigen::VectorXd result(2 * x.size());
  result << x.real(), x.imag();
  return result;
}

void HullGauge::add_column(int vertex, bool conjugate, std::complex<double> phase) {
  const Eigen::VectorXcd& v = vertices_[static_cast<std::size_t>(vertex)];
  gauge_.add_vertex(lift(phase * (conjugate ? v.conjugate().eval() : v)));
  columns_.push_back({vertex, conjugate, phase});
}

void HullGauge::add(const Eigen::VectorXcd& vertex) {
  const int index = static_cast<int>(vertices_.size());
  vertices_.push_back(vertex);
  if (!complex_) {
    add_column(index, false, 1);
    return;
  }
  for (int k = 0; k < first_phases; ++k) {
    const std::complex<double> phase = std::polar(1.0, std::numbers::pi * k / first_phases);
    add_column(index, false, phase);
    if (!is_real(vertex)) add_column(index, true, std::conj(phase));
  }
}

bool HullGauge::add_violated_columns(const Combination& combination) {
  const Eigen::Index n = gauge_.dimension();
  Eigen::MatrixXd basis(n, n);
  Eigen::VectorXd signs(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    basis.col(k) = gauge_.vertices().col(combination.basis[static_cast<std::size_t>(k)]);
    signs(k) = combination.coefficients(k) < 0 ? -1 : 1;
  }
  const Eigen::VectorXd dual = basis.transpose().partialPivLu().solve(signs);
  const Eigen::VectorXcd functional =
      dual.head(n / 2).cast<std::complex<double>>() - std::complex<double>(0, 1) * dual.tail(n / 2);
  std::vector<std::pair<double, Column>> violated;
  for (std::size_t j = 0; j < vertices_.size(); ++j) {
    for (const bool conjugate : {false, true}) {
      if (conjugate && is_real(vertices_[j])) continue;
      const Eigen::VectorXcd v = conjugate ? vertices_[j].conjugate().eval() : vertices_[j];
      const std::complex<double> value = (functional.transpose() * v)(0);
      const double size = std::abs(value);
      if (size > 1 + violation)
        violated.push_back({size, {static_cast<int>(j), conjugate, std::conj(value) / size}});
    }
  }
  // The worst ones, so that the programs stay small.
  std::stable_sort(violated.begin(), violated.end(),
                   [](const auto& x, const auto& y) { return x.first > y.first; });
  if (violated.size() > static_cast<std::size_t>(n)) violated.resize(static_cast<std::size_t>(n));
  for (const auto& [size, column] : violated) add_column(column.vertex, column.conjugate, column.phase);
  return !violated.empty();
}

HullCombination HullGauge::collect(const Combination& combination) const {
  std::vector<std::complex<double>> plain(vertices_.size());
  std::vector<std::complex<double>> conjugated(vertices_.size());
  HullCombination result;
  for (std::size_t k = 0; k < combination.basis.size(); ++k) {
    const double c = combination.coefficients(static_cast<Eigen::Index>(k));
    const int index = combination.basis[k] - static_cast<int>(artificial_);
    if (index < 0) {
      result.sum += std::abs(c);
      continue;
    }
    const Column& column = columns_[static_cast<std::size_t>(index)];
    (column.conjugate ? conjugated : plain)[static_cast<std::size_t>(column.vertex)] += c * column.phase;
  }
  for (std::size_t j = 0; j < vertices_.size(); ++j) {
    result.sum += std::abs(plain[j]) + std::abs(conjugated[j]);
    if (plain[j] != 0.0) result.terms.push_back({static_cast<int>(j), false, plain[j]});
    if (conjugated[j] != 0.0) result.terms.push_back({static_cast<int>(j), true, conjugated[j]});
  }
  return result;
}

HullCombination HullGauge::combine(const Eigen::VectorXcd& x, double enough) {
  const Eigen::VectorXd point = lift(x);
  HullCombination best = collect(gauge_.combine(point, enough));
  if (!complex_) return best;
  for (int round = 0; round < most_rounds && best.sum > enough; ++round) {
    const Combination combination = gauge_.combine(point, enough);
    HullCombination next = collect(combination);
    if (next.sum < best.sum) best = std::move(next);
    if (best.sum <= enough || !add_violated_columns(combination)) break;
  }
  return best;
}

}  // namespace subdiv
