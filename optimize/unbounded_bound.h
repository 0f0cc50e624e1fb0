#pragma once

#include <optional>
#include <vector>

#include "schemes/algebra/polynomial.h"
#include "schemes/algebra/rational.h"

namespace subdiv {

/// max over i of |f_i(y, s)| for polynomials f_i in unbounded unknowns y_0 .. y_{n-1} (the variables x_0 ..
/// x_{n-1}) and one parameter s (the variable x_n) in an interval: bounds that hold for all real y at once.
///
/// The products y^h f_i, |h| <= d, are linear forms in the monomials y^k, |k| <= D = d + max deg f_i: the
/// columns of a matrix M(s). With X an approximate right inverse of M at the middle of the interval, M(s) X =
/// I + E, |E| <= W on all of the interval and z >= (I - W)^-1 e, every y^k is a combination of the y^h f_i
/// whose coefficients' absolute values add up to at most norm_k = sum of |X| z. So |y^k| <= norm_k max|f_i|
/// T^d, T = max(1, |y_j|): a linear Nullstellensatz certificate, guessed in approximate and checked in ball
/// arithmetic (Macaulay's matrix).
struct UnboundedProblem {
  std::vector<Polynomial> functions;  ///< f_i
  int unknowns = 2;                   ///< n
  int multiplier_degree = 2;          ///< d
};

/// The certificate's matrix, ready for many intervals of s.
class UnboundedBound {
 public:
  /// Precision in bits.
  UnboundedBound(const UnboundedProblem& problem, long precision);

  /// A t >= 0 with max|f_i(y, s)| >= t for all real y and all s in the interval; 0 when nothing is proved.
  [[nodiscard]] Rational least_maximum(const Rational& lower, const Rational& upper) const;
  /// r_j with |y_j| <= r_j wherever max|f_i(y, s)| <= level, for all s in the interval; nothing when no bound
  /// is proved.
  [[nodiscard]] std::optional<std::vector<Rational>> radii(const Rational& lower, const Rational& upper,
                                                           const Rational& level) const;

 private:
  using Exponents = std::vector<long>;
  struct Entry {
    std::size_t row;
    std::size_t column;
    std::size_t coefficient;  // in coefficients_
  };
  /// Upper bounds of norm_k for these monomials; nothing when no certificate is found.
  [[nodiscard]] std::optional<std::vector<double>> norms(const Rational& lower, const Rational& upper,
                                                         const std::vector<std::size_t>& targets) const;
  [[nodiscard]] std::size_t index_of(const Exponents& exponents) const;

  long precision_;
  int unknowns_;
  std::vector<Exponents> monomials_;                 // of degree <= D: the rows of M
  std::vector<std::vector<Rational>> coefficients_;  // of the f_i in y: polynomials in s
  std::vector<Entry> entries_;                       // of M
  std::size_t columns_ = 0;
  std::size_t powers_ = 1;             // one more than the degree in s
  std::vector<std::size_t> extremes_;  // rows of 1 and of the y_j^D
};

/// Is max|f_i(y, s)| > level q(s) for all real y and all s in the interval, q > 0 there? By bisection on at
/// most max_intervals intervals, which are counted.
struct UnboundedAnswer {
  bool proved = false;  ///< whether the answer is yes
  int intervals = 0;    ///< that were examined
};
/// The question for one polynomial q in x_parameter.
[[nodiscard]] UnboundedAnswer exceeds(const UnboundedBound& bound, const Polynomial& q, int parameter,
                                      const Rational& level, const Rational& lower, const Rational& upper,
                                      int max_intervals);

}  // namespace subdiv
