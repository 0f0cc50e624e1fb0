#include "analysis/mesh/limit_stencils.h"

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
#include "schemes/mesh/neighbourhood.h"

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

std::optional<std::vector<std::array<double, 2>>> tangent_eigenvector(const FanMatrix<double>& fan,
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

/// Weights of a vertex and of the places of the rings around it, sector by sector.
struct FanWeights {
  double centre = 0;
  std::vector<double> places;
};

FanWeights position_weights(const LimitStencil& limit, int valence) {
  FanWeights result{limit.centre, {}};
  for (int k = 0; k < valence; ++k)
    result.places.insert(result.places.end(), limit.position.begin(), limit.position.end());
  return result;
}

/// The real part (quarter = 0) or the imaginary part (1) of the tangents' sum.
FanWeights tangent_weights(const LimitStencil& limit, int valence, int quarter) {
  FanWeights result;
  if (!limit.tangent) return result;
  for (int k = 0; k < valence; ++k) {
    const Complex turn = std::polar(1.0, -2 * std::numbers::pi * k / valence);
    for (const auto& [re, im] : *limit.tangent) {
      const Complex weight = turn * Complex(re, im);
      result.places.push_back(quarter == 0 ? weight.real() : weight.imag());
    }
  }
  return result;
}

/// The rules of one mesh.
class LimitsOnMesh {
 public:
  LimitsOnMesh(const MeshTopology& mesh, std::shared_ptr<LimitStencils> stencils)
      : mesh_(mesh), stencils_(std::move(stencils)), finder_(mesh) {
    if (mesh.half_edges() > 0 && mesh.sides() != (stencils_->scheme().split == MeshSplit::quads ? 4 : 3))
      throw InputError(
          "limits where faces have other numbers of corners than the scheme makes: use at least one level");
  }

  [[nodiscard]] const LimitStencil& stencil(int v) { return stencils_->of(mesh_.valence(v)); }

  Stencil<double> position(int v) {
    if (mesh_.outgoing(v) < 0) return Stencil<double>(v);
    if (mesh_.is_border(v)) return border_limit(stencils_->scheme(), mesh_, v);
    return on_fan(v, position_weights(stencil(v), mesh_.valence(v)));
  }

  Stencil<double> tangent(int v, int quarter) {
    if (mesh_.is_border(v) || !stencil(v).tangent) return {};
    return on_fan(v, tangent_weights(stencil(v), mesh_.valence(v), quarter));
  }

 private:
  /// The vertices around v in the order of a fan, if the rules see nothing irregular but v among them.
  static std::optional<std::vector<int>> regular_fan(const MeshTopology& mesh, int v,
                                                     const MeshScheme<double>& scheme) {
    const int seen = scheme.sight > scheme.reach ? scheme.reach + 1 : scheme.reach;
    if (!fan_vertices(mesh, mesh.outgoing(v), seen)) return std::nullopt;
    return fan_vertices(mesh, mesh.outgoing(v), scheme.reach);
  }

  /// Next to irregular vertices, rings are not regular at any level; but those of the same vertex are one or
  /// two levels on: by then it stands some steps away.
  Stencil<double> on_fan(int v, const FanWeights& weights) {
    const MeshScheme<double>& scheme = stencils_->scheme();
    if (const auto fan = regular_fan(mesh_, v, scheme)) return weighted(*fan, weights);
    finder_.find(mesh_.face(mesh_.outgoing(v)), scheme.sight, neighbourhood_);
    const MeshTopology local = part_of(mesh_, neighbourhood_.entries, neighbourhood_.vertices);
    const auto place =
        static_cast<int>(std::find(neighbourhood_.vertices.begin(), neighbourhood_.vertices.end(), v) -
                         neighbourhood_.vertices.begin());
    std::vector<MeshTopology> levels{local};
    std::optional<std::vector<int>> fan;
    for (constexpr std::size_t most = 3; !fan; fan = regular_fan(levels.back(), place, scheme)) {
      if (levels.size() > most) throw std::logic_error("irregular vertices stand apart after a few levels");
      levels.push_back(split(levels.back(), scheme.split));
    }
    Stencil<double> sum = weighted(*fan, weights);
    for (levels.pop_back(); !levels.empty(); levels.pop_back()) {
      Stencil<double> of_coarser;
      for (const auto& [number, weight] : sum.terms())
        of_coarser.add(stencil_of(levels.back(), scheme, number), weight);
      sum = std::move(of_coarser);
    }
    Stencil<double> result;
    for (const auto& [number, weight] : sum.terms())
      result.add(neighbourhood_.vertices[static_cast<std::size_t>(number)], weight);
    return result;
  }

  static Stencil<double> weighted(const std::vector<int>& fan, const FanWeights& weights) {
    Stencil<double> result;
    if (weights.centre != 0) result.add(fan[0], weights.centre);
    for (std::size_t i = 1; i < fan.size(); ++i) {
      if (weights.places[i - 1] != 0) result.add(fan[i], weights.places[i - 1]);
    }
    return result;
  }

  const MeshTopology& mesh_;
  std::shared_ptr<LimitStencils> stencils_;
  NeighbourhoodFinder finder_;
  Neighbourhood neighbourhood_;
};

}  // namespace

LimitStencil limit_stencil(const MeshScheme<double>& scheme, int valence) {
  const FanMatrix<double> fan = fan_matrix(scheme, valence, scheme.reach);
  LimitStencil result;
  result.rings = scheme.reach;
  // Further rings have eigenvalues of their own, but no weight in these eigenvectors.
  const double others = largest_of_others(fan_matrix(scheme, valence, eigenvalue_rings(scheme)));
  const Eigen::MatrixXd block = invariant_block(fan);
  // y (B - I) = 0 with weights of sum 1: one equation of the square system is redundant and gives way.
  Eigen::MatrixXd system = block.transpose() - Eigen::MatrixXd::Identity(block.rows(), block.rows());
  system.row(0).setOnes();
  const Eigen::VectorXd y = system.fullPivLu().solve(Eigen::VectorXd::Unit(block.rows(), 0));
  result.centre = y(0);
  for (Eigen::Index p = 1; p < y.size(); ++p) result.position.push_back(y(p) / valence);
  result.tangent = tangent_eigenvector(fan, others);
  return result;
}

LimitRules limit_rules(const MeshScheme<double>& scheme) {
  const auto stencils = std::make_shared<LimitStencils>(scheme);
  const auto rule = [&](auto kind) -> FinalRule {
    return [stencils, kind](const MeshTopology& mesh) {
      return
          [limits = std::make_shared<LimitsOnMesh>(mesh, stencils), kind](int v) { return kind(*limits, v); };
    };
  };
  return {rule([](LimitsOnMesh& limits, int v) { return limits.position(v); }),
          rule([](LimitsOnMesh& limits, int v) { return limits.tangent(v, 0); }),
          rule([](LimitsOnMesh& limits, int v) { return limits.tangent(v, 1); })};
}

}  // namespace subdiv
