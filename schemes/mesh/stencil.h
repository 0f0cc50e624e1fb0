#pragma once

#include <utility>
#include <vector>

#include "schemes/algebra/ring.h"

namespace subdiv {

/// A new point as a combination of old ones: the sum of weight P_vertex. Each vertex stands once.
template <class R>
class Stencil {
 public:
  using Term = std::pair<int, R>;

  Stencil() = default;
  /// The point itself.
  explicit Stencil(int vertex) { add(vertex, R(1)); }

  void add(int vertex, const R& weight) {
    for (Term& term : terms_) {
      if (term.first != vertex) continue;
      term.second = term.second + weight;
      return;
    }
    terms_.emplace_back(vertex, weight);
  }
  void add(const Stencil& other, const R& factor) {
    for (const Term& term : other.terms_) add(term.first, term.second * factor);
  }

  [[nodiscard]] const std::vector<Term>& terms() const { return terms_; }
  [[nodiscard]] R weight(int vertex) const {
    for (const Term& term : terms_) {
      if (term.first == vertex) return term.second;
    }
    return R(0);
  }
  [[nodiscard]] R sum() const {
    R result(0);
    for (const Term& term : terms_) result = result + term.second;
    return result;
  }

 private:
  std::vector<Term> terms_;
};

}  // namespace subdiv
