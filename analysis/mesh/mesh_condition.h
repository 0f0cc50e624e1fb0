#pragma once

#include "analysis/mesh/spectral_condition.h"

namespace subdiv {

/// The condition at one valence from equations for all valences: mode 0 over Q(s, 1/n) as invariant_modes
/// gives it.
[[nodiscard]] inline SpectralCondition spectral_condition(const ModeEquation& turning, ModeEquation invariant,
                                                          int valence) {
  for (auto& [base, multiplicity] : invariant.factors) {
    base = base.substitute(valence_variable, Polynomial(Rational(1, valence)));
  }
  return {turning, invariant, valence};
}

/// The whole matrix: the vertex, then the places sector after sector.
template <class R>
Matrix<R> full_matrix(const FanMatrix<R>& fan) {
  const Eigen::Index places = fan.places();
  const Eigen::Index size = 1 + places * fan.valence;
  Matrix<R> result = zero_matrix<R>(size, size);
  result(0, 0) = fan.centre;
  for (int from = 0; from < fan.valence; ++from) {
    for (Eigen::Index p = 0; p < places; ++p) {
      const Eigen::Index row = 1 + from * places + p;
      result(0, row) = fan.spread(p);
      result(row, 0) = fan.pull(p);
      for (int k = 0; k < fan.valence; ++k) {
        for (Eigen::Index q = 0; q < places; ++q) {
          result(row, 1 + (from + k) % fan.valence * places + q) =
              fan.blocks[static_cast<std::size_t>(k)](p, q);
        }
      }
    }
  }
  return result;
}

}  // namespace subdiv
