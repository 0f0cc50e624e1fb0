#pragma once

#include <vector>

#include "analysis/deadline.h"
#include "analysis/jsr/word.h"
#include "schemes/algebra/interval.h"
#include "schemes/algebra/matrix.h"

namespace subdiv {

/// A polynomial g over Q in the parameters of a family T_0, T_1, ..: wherever g <= 0 and the family has no
/// pole, the product of this word has a spectral radius of at least 1.
struct ExpandingCondition {
  Word word;     ///< whose product expands
  Polynomial g;  ///< at most 0 where it does
};

/// From the irreducible factors f(x) = f_d x^d + .. + f_0 of the characteristic equation of a word's product,
/// f_d with no zero but at poles: f(1), (-1)^d f(-1) and f_d -+ f_0, each times f_d, or divided by it when it
/// is constant.
[[nodiscard]] std::vector<ExpandingCondition> expanding_conditions(
    const std::vector<Matrix<RationalFunction>>& family, const Word& word);

/// Those of all Lyndon words up to a length, shorter words first, as many as are ready when the deadline
/// passes; each polynomial once, with a shortest word.
[[nodiscard]] std::vector<ExpandingCondition> expanding_conditions(
    const std::vector<Matrix<RationalFunction>>& family, int longest, const Deadline& deadline);
/// The same without a deadline.
[[nodiscard]] std::vector<ExpandingCondition> expanding_conditions(
    const std::vector<Matrix<RationalFunction>>& family, int longest);

/// A polynomial prepared for ranges over many boxes.
class RangedPolynomial {
 public:
  /// Of p in x_0 .. x_{variables-1}, with its partial derivatives.
  RangedPolynomial(const Polynomial& p, std::size_t variables);

  /// Encloses the values for x_k in the intervals: the mean-value form and the plain one, whichever tells
  /// more.
  [[nodiscard]] Interval range(const std::vector<Interval>& box) const;
  /// In floating point.
  [[nodiscard]] double value(const std::vector<double>& x) const;

 private:
  struct Term {
    Interval coefficient;
    double approximate;
    std::vector<long> exponents;
  };
  using Terms = std::vector<Term>;

  static Terms terms_of(const Polynomial& p, std::size_t variables);
  static Interval sum(const Terms& terms, const std::vector<std::vector<Interval>>& powers);

  Terms terms_;
  std::vector<Terms> derivatives_;
  long degree_ = 0;
};

}  // namespace subdiv
