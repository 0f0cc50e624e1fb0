#include "analysis/mesh/limit_stencils.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "analysis/mesh/fan_matrix.h"
#include "schemes/input_error.h"
#include "schemes/mesh/fan.h"

namespace subdiv {
namespace {

using Complex = std::complex<double>;
/// Eigenvalues closer than this count as equal: multiple ones are computed to the square root of the
/// precision.
constexpr double gap = 1e-7;

Eigen::MatrixXcd mode_block(const FanMatrix<double>& fan, int mode) {
  Eigen::MatrixXcd block = Eigen::MatrixXcd::Zero(fan.places(), fan.places());
  for (int k = 0; k < fan.valence; ++k)
    block += std::polar(1.0, 2 * std::numbers::pi * k * mode / fan.valence) *
             fan.blocks[static_cast<std::size_t>(k)];
  return block;
}

/// The moduli of all eigenvalues of mode 0 but one 1, and of modes 2 .. n - 2.
double largest_of_others(const FanMatrix<double>& fan) {
  const Eigen::VectorXcd invariant =
      Eigen::EigenSolver<Eigen::MatrixXd>(invariant_block(fan), false).eigenvalues();
  const auto one = std::min_element(invariant.begin(), invariant.end(), [](Complex a, Complex b) {
    return std::abs(a - 1.0) < std::abs(b - 1.0);
  });
  double largest = 0;
  for (auto it = invariant.begin(); it != invariant.end(); ++it) {
    if (it != one) largest = std::max(largest, std::abs(*it));
  }
  if (std::abs(*one - 1.0) > gap || largest > 1 - gap)
    throw std::domain_error("1 is no simple eigenvalue larger than all others");
  for (int mode = 2; 2 * mode <= fan.valence; ++mode) {
    const Eigen::ComplexEigenSolver<Eigen::MatrixXcd> solver(mode_block(fan, mode), false);
    largest = std::max(largest, solver.eigenvalues().cwiseAbs().maxCoeff());
  }
  if (largest > 1 - gap) throw std::domain_error("1 is no simple eigenvalue larger than all others");
  return largest;
}

std::optional<std::vector<std::array<double, 2>>> tangent_weights(const FanMatrix<double>& fan,
                                                                  double others) {
  const Eigen::ComplexEigenSolver<Eigen::MatrixXcd> solver(mode_block(fan, 1).transpose());
  const auto& values = solver.eigenvalues();
  Eigen::Index first = 0;
  values.cwiseAbs().maxCoeff(&first);
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (i != first) others = std::max(others, std::abs(values(i)));
  }
  const Complex lambda = values(first);
  if (std::abs(lambda) < others + gap || lambda.real() < 0 || std::abs(lambda.imag()) > gap)
    return std::nullopt;
  std::vector<std::array<double, 2>> weights;
  for (const Complex& u : solver.eigenvectors().col(first)) weights.push_back({u.real(), u.imag()});
  return weights;
}

/// The fan of a vertex and its limit stencil, one for each valence met.
class LimitStencils {
 public:
  explicit LimitStencils(MeshScheme<double> scheme) : scheme_(std::move(scheme)) {}
  [[nodiscard]] const MeshScheme<double>& scheme() const { return scheme_; }
  const LimitStencil& of(int valence) {
    const auto found = known_.find(valence);
    if (found != known_.end()) return found->second;
    return known_.emplace(valence, limit_stencil(scheme_, valence)).first->second;
  }

 private:
  MeshScheme<double> scheme_;
  std::map<int, LimitStencil> known_;
};

std::vector<int> fan_of(const MeshTopology& mesh, int v, int rings) {
  auto fan = fan_vertices(mesh, mesh.outgoing(v), rings);
  if (!fan) {
    throw InputError(
        fmt::format("vertex {} of the last level: the limit needs {} rings that are regular but for the "
                    "vertex; use more levels",
                    v + 1, rings));
  }
  return std::move(*fan);
}

/// The curve with even rule (a, 1 - 2a, a) and mid-edge points tends to (P_0 + 4 a M)/(1 + 4 a), M the mean
/// of its neighbours.
Stencil<double> border_limit(const MeshScheme<double>& scheme, const MeshTopology& mesh, int v) {
  const double kept = scheme.vertex_rule(mesh, v).weight(v);
  const double pull = 2 * (1 - kept);  // 4 a
  Stencil<double> result;
  result.add(v, 1 / (1 + pull));
  if (pull == 0) return result;
  const std::vector<int> around = neighbours(mesh, v);
  for (const int u : {around.front(), around.back()}) result.add(u, pull / (1 + pull) / 2);
  return result;
}

Stencil<double> limit_position(LimitStencils& stencils, const MeshTopology& mesh, int v) {
  if (mesh.outgoing(v) < 0) return Stencil<double>(v);
  if (mesh.is_border(v)) return border_limit(stencils.scheme(), mesh, v);
  const LimitStencil& limit = stencils.of(mesh.valence(v));
  const std::vector<int> fan = fan_of(mesh, v, limit.rings);
  Stencil<double> result;
  result.add(v, limit.centre);
  for (std::size_t i = 1; i < fan.size(); ++i) {
    const double weight = limit.position[(i - 1) % limit.position.size()];
    if (weight != 0) result.add(fan[i], weight);
  }
  return result;
}

Stencil<double> limit_tangent(LimitStencils& stencils, const MeshTopology& mesh, int v, bool imaginary) {
  if (mesh.is_border(v)) return {};
  const LimitStencil& limit = stencils.of(mesh.valence(v));
  if (!limit.tangent) return {};
  const std::vector<int> fan = fan_of(mesh, v, limit.rings);
  const std::size_t places = limit.tangent->size();
  Stencil<double> result;
  for (std::size_t i = 1; i < fan.size(); ++i) {
    const auto& [re, im] = (*limit.tangent)[(i - 1) % places];
    const auto sector = static_cast<double>((i - 1) / places);
    const Complex weight =
        std::polar(1.0, -2 * std::numbers::pi * sector / mesh.valence(v)) * Complex(re, im);
    result.add(fan[i], imaginary ? weight.imag() : weight.real());
  }
  return result;
}

}  // namespace

LimitStencil limit_stencil(const MeshScheme<double>& scheme, int valence) {
  const FanMatrix<double> fan = fan_matrix(scheme, valence, scheme.reach);
  LimitStencil result;
  result.rings = scheme.reach;
  const double others = largest_of_others(fan);
  const Eigen::MatrixXd block = invariant_block(fan);
  // y (B - I) = 0 with weights of sum 1: one equation of the square system is redundant and gives way.
  Eigen::MatrixXd system = block.transpose() - Eigen::MatrixXd::Identity(block.rows(), block.rows());
  system.row(0).setOnes();
  const Eigen::VectorXd y = system.fullPivLu().solve(Eigen::VectorXd::Unit(block.rows(), 0));
  result.centre = y(0);
  for (Eigen::Index p = 1; p < y.size(); ++p) result.position.push_back(y(p) / valence);
  result.tangent = tangent_weights(fan, others);
  return result;
}

LimitRules limit_rules(const MeshScheme<double>& scheme) {
  const auto stencils = std::make_shared<LimitStencils>(scheme);
  return {[stencils](const MeshTopology& mesh, int v) { return limit_position(*stencils, mesh, v); },
          [stencils](const MeshTopology& mesh, int v) { return limit_tangent(*stencils, mesh, v, false); },
          [stencils](const MeshTopology& mesh, int v) { return limit_tangent(*stencils, mesh, v, true); }};
}

}  // namespace subdiv
