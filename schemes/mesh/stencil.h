#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "schemes/algebra/ring.h"

namespace subdiv {

/// p/q in the ring R; rounded once, and without a rational in between, where R rounds.
template <class R>
R ratio(long p, long q) {
  if constexpr (std::is_floating_point_v<R>) {
    return static_cast<R>(p) / static_cast<R>(q);
  } else {
    return fraction<R>(p, q);
  }
}

/// A new point as a combination of old ones: the sum of weight P_vertex, by ascending vertices, each once.
template <class R>
class Stencil {
 public:
  /// A vertex with its weight.
  using Term = std::pair<int, R>;
  /// By ascending vertices, each once.
  using Terms = std::vector<Term>;

  Stencil() = default;
  /// The point itself.
  explicit Stencil(int vertex) { add(vertex, R(1)); }

  /// Adds to the weight of a vertex.
  void add(int vertex, const R& weight) {
    constexpr std::size_t usual = 16;  // those of J_s in regular regions
    if (terms_.empty()) terms_.reserve(usual);
    const auto place = std::lower_bound(terms_.begin(), terms_.end(), vertex,
                                        [](const Term& term, int v) { return term.first < v; });
    if (place != terms_.end() && place->first == vertex) {
      place->second = place->second + weight;
    } else {
      terms_.emplace(place, vertex, weight);
    }
  }
  /// Adds a multiple of another stencil.
  void add(const Stencil& other, const R& factor) {
    for (const Term& term : other.terms_) add(term.first, term.second * factor);
  }

  [[nodiscard]] const Terms& terms() const { return terms_; }
  /// The weight of a vertex; 0 when it does not occur.
  [[nodiscard]] R weight(int vertex) const {
    for (const Term& term : terms_) {
      if (term.first == vertex) return term.second;
    }
    return R(0);
  }
  /// The sum of all weights: 1 for an affine combination.
  [[nodiscard]] R sum() const {
    R result(0);
    for (const Term& term : terms_) result = result + term.second;
    return result;
  }

 private:
  Terms terms_;
};

}  // namespace subdiv
