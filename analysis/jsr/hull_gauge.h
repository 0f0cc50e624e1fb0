#pragma once

#include <complex>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "analysis/symmetric_gauge.h"

namespace subdiv {

/// x = sum of c v over vertices v or their conjugates, and the sum of |c|.
struct HullCombination {
  /// c v for one vertex.
  struct Term {
    int vertex;                        ///< its number
    bool conjugate;                    ///< whether v is the conjugate of the vertex
    std::complex<double> coefficient;  ///< c
  };
  std::vector<Term> terms;  ///< those that are not 0
  double sum = 0;           ///< of |c|: the gauge, when the combination is optimal
};

/// The gauge of the balanced hull of vertices v_0, v_1, .. in floating point: the least sum of |c_j| with sum
/// c_j v_j = x. Real hull: real vertices and coefficients, conv(+-v_j). Complex hull: complex coefficients,
/// and the conjugates of the vertices belong to them; a linear program over finitely many phases e^(it), to
/// which phases are added where its dual solution asks for them. Nothing here is a proof: combinations are
/// proposals.
class HullGauge {
 public:
  /// Of vectors of one dimension; without vertices yet.
  HullGauge(Eigen::Index dimension, bool complex_hull);

  /// Adds a vertex, in a real hull one without imaginary part.
  void add(const Eigen::VectorXcd& vertex);
  /// Starts further linear programs from a well-conditioned basis of the vertices, once they span the space.
  void condition();
  /// An optimal combination, or the first one found with a sum of at most `enough`. Points outside the span
  /// of the vertices get a huge sum.
  HullCombination combine(const Eigen::VectorXcd& x, double enough = 0);

 private:
  struct Column {
    int vertex;
    bool conjugate;
    std::complex<double> phase;
  };
  void add_column(int vertex, bool conjugate, std::complex<double> phase);
  bool add_violated_columns(const Combination& combination);
  [[nodiscard]] HullCombination collect(const Combination& combination) const;
  [[nodiscard]] Eigen::VectorXd lift(const Eigen::VectorXcd& x) const;

  bool complex_;
  std::vector<Eigen::VectorXcd> vertices_;
  std::vector<Column> columns_;
  Eigen::Index
      artificial_;  // that many leading columns of gauge_ are no vertices, but make every program feasible
  SymmetricGauge gauge_;
};

}  // namespace subdiv
