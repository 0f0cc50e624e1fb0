#pragma once

#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

#include "analysis/basis_function.h"

namespace subdiv {

/// What local questions about the basis function phi of a stationary scheme of arity 2 need: its mask a_i,
/// phi and phi' at the integers, and cells_i = integral of phi over [i, i+1].
template <class R>
struct BasisTables {
  Laurent<R> mask;    ///< a_i
  Laurent<R> values;  ///< phi(i)
  Laurent<R> slopes;  ///< phi'(i)
  Laurent<R> cells;   ///< the integral of phi over [i, i+1]
};

/// The tables over an exact field. phi must be C^1. Throws std::domain_error when the arity is not 2 or the
/// refinement equations do not determine an entry.
template <ExactRing R>
BasisTables<R> basis_tables(const Mask<R>& mask) {
  if (mask.arity != 2) throw std::domain_error("dyadic pieces of a basis function need arity 2");
  const BasisIntegral<R> integral = basis_integral(mask, 0);
  std::vector<R> cells;
  for (int i = mask.symbol.first(); i < mask.symbol.last(); ++i)
    cells.push_back(integral.at(i + 1) - integral.at(i));
  return {mask.symbol, integer_values(mask, 0), integer_values(mask, 1),
          Laurent<R>(mask.symbol.first(), cells)};
}

/// The same tables over another ring: the map is applied to each coefficient.
template <class R, class Map>
auto map_coefficients(const BasisTables<R>& t, Map map) {
  using S = decltype(map(t.mask[0]));
  return BasisTables<S>{map_coefficients(t.mask, map), map_coefficients(t.values, map),
                        map_coefficients(t.slopes, map), map_coefficients(t.cells, map)};
}

/// phi on the interval I = [i, i+1] / 2^level: there phi(t) = sum of P_k phi(2^level t - k) over the k = i +
/// 1 - a.last() .. i - a.first() whose copies meet I; the P_k are coefficients of the iterate of that level.
template <class R>
struct BasisPiece {
  Rational left;                ///< i / 2^level
  int level = 0;                ///< the interval is as wide as 2^-level
  std::vector<R> coefficients;  ///< P_k, in ascending order of k

  [[nodiscard]] Rational width() const { return Rational::power_of_two(-level); }
  [[nodiscard]] Rational right() const { return left + width(); }
};

/// Pieces of one basis function: made at the integers, halved at will. first and last are the mask's ends:
/// they are kept apart because an outer coefficient may vanish at a parameter value.
template <class R>
class LocalBasis {
 public:
  /// From the tables of a mask whose indices run from first to last.
  LocalBasis(BasisTables<R> tables, int first, int last)
      : tables_(std::move(tables)),
        first_(first),
        last_(last),
        children_(static_cast<std::size_t>(last - first + 1)) {
    for (int j = 0; j <= last - first; ++j) {
      for (int c = 0; c < last - first; ++c) {
        const int index = last - 1 + j - 2 * c;
        if (index < first || index > last) continue;
        children_[static_cast<std::size_t>(j)].emplace_back(static_cast<std::size_t>(c), tables_.mask[index]);
      }
    }
    values_ = weights(tables_.values);
    slopes_ = weights(tables_.slopes);
    for (int c = 0; c < last - first; ++c) cells_.push_back(tables_.cells[last - 1 - c]);
  }

  [[nodiscard]] const BasisTables<R>& tables() const { return tables_; }

  /// phi on [i, i + 1].
  [[nodiscard]] BasisPiece<R> unit(int i) const {
    BasisPiece<R> piece{Rational(i), 0, std::vector<R>(static_cast<std::size_t>(last_ - first_), R(0))};
    const int impulse = last_ - 1 - i;  // P_k is 1 at k = 0
    if (impulse >= 0 && impulse < last_ - first_)
      piece.coefficients[static_cast<std::size_t>(impulse)] = R(1);
    return piece;
  }

  /// The pieces on the two halves of the interval, left one first.
  [[nodiscard]] std::pair<BasisPiece<R>, BasisPiece<R>> halves(const BasisPiece<R>& piece) const {
    std::vector<R> fine;
    fine.reserve(children_.size());
    for (const auto& row : children_) {
      R sum(0);
      for (const auto& [c, weight] : row) add_product(sum, weight, piece.coefficients[c]);
      fine.push_back(std::move(sum));
    }
    const int level = piece.level + 1;
    const Rational middle = piece.left + Rational::power_of_two(-level);
    return {{piece.left, level, {fine.begin(), fine.end() - 1}},
            {middle, level, {fine.begin() + 1, fine.end()}}};
  }

  /// phi at the ends of I.
  [[nodiscard]] R left_value(const BasisPiece<R>& piece) const { return combine(values_, 1, piece); }
  [[nodiscard]] R right_value(const BasisPiece<R>& piece) const { return combine(values_, 0, piece); }
  /// phi' at the ends of I, divided by 2^level.
  [[nodiscard]] R left_slope(const BasisPiece<R>& piece) const { return combine(slopes_, 1, piece); }
  [[nodiscard]] R right_slope(const BasisPiece<R>& piece) const { return combine(slopes_, 0, piece); }
  /// The integral of phi over I, multiplied by 2^level.
  [[nodiscard]] R integral(const BasisPiece<R>& piece) const { return combine(cells_, 0, piece); }

 private:
  /// f(i + 1 - k) in the order of the coefficients P_k, and one more: from the second entry on it is f(i -
  /// k).
  [[nodiscard]] std::vector<R> weights(const Laurent<R>& f) const {
    std::vector<R> result;
    for (int c = 0; c <= last_ - first_; ++c) result.push_back(f[last_ - c]);
    return result;
  }
  [[nodiscard]] static R combine(const std::vector<R>& weights, std::size_t shift,
                                 const BasisPiece<R>& piece) {
    R sum(0);
    for (std::size_t c = 0; c < piece.coefficients.size(); ++c) {
      add_product(sum, weights[c + shift], piece.coefficients[c]);
    }
    return sum;
  }

  BasisTables<R> tables_;
  int first_;
  int last_;
  /// Coefficient j of the finer level: (c, a) stands for a times coefficient c.
  std::vector<std::vector<std::pair<std::size_t, R>>> children_;
  std::vector<R> values_;
  std::vector<R> slopes_;
  std::vector<R> cells_;
};

}  // namespace subdiv
