#include "analysis/mesh/lattice_limits.h"

#include <cmath>
#include <complex>

#include <Eigen/LU>

namespace subdiv {
namespace {

using Complex = std::complex<double>;

constexpr double rounding = 1e-9;

/// The left eigenvector for an eigenvalue of geometric multiplicity 1, of any length.
std::optional<Eigen::VectorXcd> left_eigenvector(const Eigen::MatrixXcd& matrix, double eigenvalue) {
  const Eigen::MatrixXcd shifted =
      matrix.transpose() - eigenvalue * Eigen::MatrixXcd::Identity(matrix.rows(), matrix.cols());
  Eigen::FullPivLU<Eigen::MatrixXcd> elimination(shifted);
  elimination.setThreshold(rounding);
  if (elimination.dimensionOfKernel() != 1) return std::nullopt;
  return Eigen::VectorXcd(elimination.kernel().col(0).normalized());
}

}  // namespace

PlaneNumber<double> LatticeLimits::point(const CharacteristicNet<double>& net, int a, int b) const {
  PlaneNumber<double> sum;
  for (std::size_t i = 0; i < offsets.size(); ++i)
    sum = sum + position[i] * net.at(a + offsets[i].a, b + offsets[i].b);
  return sum;
}

double LatticeLimits::jacobian(const CharacteristicNet<double>& net, int a, int b) const {
  PlaneNumber<double> along;
  PlaneNumber<double> against;
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    const PlaneNumber<double> p = net.at(a + offsets[i].a, b + offsets[i].b);
    along = along + derivative[i] * p;
    against = against + conjugate(derivative[i]) * p;
  }
  return along.x * along.x + along.y * along.y - against.x * against.x - against.y * against.y;
}

std::optional<LatticeLimits> lattice_limits(const MeshScheme<double>& scheme) {
  const int sides = scheme.split == MeshSplit::quads ? 4 : 3;
  const int regular = sides == 4 ? 4 : 6;
  const FanMatrix<double> fan = fan_matrix(scheme, regular, eigenvalue_rings(scheme));
  const std::vector<FanPlace> places = sector_places(sides, fan.rings);
  const Eigen::Index n = fan.places();
  const auto w = [&](int k) {
    const PlaneNumber<double> number = turn<double>(k, regular);
    return Complex(number.x, number.y);
  };
  Eigen::MatrixXcd block = Eigen::MatrixXcd::Zero(n, n);
  for (int k = 0; k < regular; ++k) block += w(k) * fan.blocks[static_cast<std::size_t>(k)].cast<Complex>();
  const std::optional<Eigen::VectorXcd> turning = left_eigenvector(block, 1.0 / 2);
  const std::optional<Eigen::VectorXcd> invariant =
      left_eigenvector(invariant_block(fan).cast<Complex>(), 1.0);
  if (!turning || !invariant) return std::nullopt;

  const Complex sum = invariant->sum();  // the data 1 have the limit 1
  Complex slope = 0;                     // and the data z the derivative 1
  for (Eigen::Index p = 0; p < n; ++p) {
    const FanPlace& place = places[static_cast<std::size_t>(p)];
    slope += (*turning)(p) * (static_cast<double>(place.a) + static_cast<double>(place.b) * w(1));
  }
  // Orthogonal to its right eigenvector: the eigenvalue has a Jordan block.
  if (std::abs(sum) < rounding || std::abs(slope) < rounding) return std::nullopt;
  LatticeLimits result;
  result.offsets.push_back({0, 0});
  result.position.push_back(((*invariant)(0) / sum).real());
  result.derivative.push_back({0, 0});
  for (int k = 0; k < regular; ++k) {
    for (Eigen::Index p = 0; p < n; ++p) {
      FanPlace place = places[static_cast<std::size_t>(p)];
      place.sector = k;
      const Complex derivative = std::conj(w(k)) * (*turning)(p) / (slope * static_cast<double>(regular));
      result.offsets.push_back(lattice_offset(sides, place));
      result.position.push_back(((*invariant)(p + 1) / sum).real() / regular);
      result.derivative.push_back({derivative.real(), derivative.imag()});
    }
  }
  return result;
}

}  // namespace subdiv
