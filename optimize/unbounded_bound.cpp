#include "optimize/unbounded_bound.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/LU>

#include <arb_mat.h>

#include "schemes/algebra/interval.h"
#include "schemes/algebra/univariate.h"

namespace subdiv {
namespace {

/// A matrix of balls that frees itself.
class BallMatrix {
 public:
  BallMatrix(std::size_t rows, std::size_t columns) {
    arb_mat_init(matrix_, static_cast<slong>(rows), static_cast<slong>(columns));
  }
  ~BallMatrix() { arb_mat_clear(matrix_); }
  BallMatrix(const BallMatrix&) = delete;
  BallMatrix& operator=(const BallMatrix&) = delete;

  arb_ptr at(std::size_t i, std::size_t j) { return arb_mat_entry(matrix_, i, j); }
  arb_mat_struct* raw() { return matrix_; }

 private:
  arb_mat_t matrix_;
};

/// An upper bound of |x| as a double.
double magnitude(const arb_struct* x) {
  mag_t bound;
  mag_init(bound);
  arb_get_mag(bound, x);
  const double result = mag_get_d(bound);
  mag_clear(bound);
  // mag_get_d is exact in the range of doubles; below it, it may round to 0.
  return std::nextafter(result, INFINITY);
}

/// Sums and products of a few dozen non-negative doubles fall short of the true value by less than this
/// factor.
constexpr double rounding_up = 1 + 1e-12;
constexpr double underflow = 1e-300;

void list_monomials(int variables, long degree, std::vector<long>& prefix,
                    std::vector<std::vector<long>>& result) {
  if (static_cast<int>(prefix.size()) == variables) {
    result.push_back(prefix);
    return;
  }
  for (long power = 0; power <= degree; ++power) {
    prefix.push_back(power);
    list_monomials(variables, degree - power, prefix, result);
    prefix.pop_back();
  }
}

std::vector<std::vector<long>> monomials_up_to(int variables, long degree) {
  std::vector<std::vector<long>> result;
  std::vector<long> prefix;
  list_monomials(variables, degree, prefix, result);
  return result;
}

/// Taylor coefficients about `centre` of the polynomials with these coefficients.
std::vector<std::vector<Interval>> expanded(const std::vector<std::vector<Rational>>& polynomials,
                                            const Rational& centre, long precision) {
  const Interval shift(centre, precision);
  std::vector<std::vector<Interval>> result;
  for (const std::vector<Rational>& p : polynomials) {
    std::vector<Interval> c;
    for (const Rational& q : p) c.emplace_back(q, precision);
    for (std::size_t low = 0; low + 1 < c.size(); ++low) {
      for (std::size_t i = c.size() - 1; i-- > low;) c[i] += shift * c[i + 1];
    }
    result.push_back(std::move(c));
  }
  return result;
}

/// A positive z with z >= (I - W)^-1 e_target, proved; nothing when none is found. W z + e <= (1 - 1e-9) z
/// with z > 0 implies that the spectral radius of W is below 1 and, as (I - W)^-1 is then not negative, the
/// claim.
std::optional<Eigen::VectorXd> dominating_solution(const Eigen::MatrixXd& w, std::size_t target) {
  constexpr double margin = 1e-9;
  const Eigen::Index n = w.rows();
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  right(static_cast<Eigen::Index>(target)) = 1;
  const Eigen::MatrixXd system = Eigen::MatrixXd::Identity(n, n) - w;
  Eigen::VectorXd z = system.partialPivLu().solve(right);
  if (!z.allFinite()) return std::nullopt;
  // Strictly above the solution, in every component.
  constexpr double smallest = 1e-30;
  Eigen::VectorXd raised =
      system.partialPivLu().solve(right + 8 * margin * (z.cwiseAbs().array() + smallest).matrix());
  if (!raised.allFinite() || raised.minCoeff() <= 0) return std::nullopt;
  const Eigen::VectorXd left = rounding_up * (w * raised + right);
  if (((1 - margin) * raised - left).minCoeff() < 0) return std::nullopt;
  return raised;
}

}  // namespace

UnboundedBound::UnboundedBound(const UnboundedProblem& problem, long precision)
    : precision_(precision), unknowns_(problem.unknowns) {
  const auto n = static_cast<std::size_t>(unknowns_);
  struct Place {
    std::size_t function;
    Exponents exponents;
  };
  std::vector<Place> places;  // of each coefficient
  long degree = 0;
  for (std::size_t i = 0; i < problem.functions.size(); ++i) {
    for (const Polynomial::Term& term : problem.functions[i].terms()) {
      const Exponents e(term.exponents.begin(), term.exponents.begin() + unknowns_);
      degree = std::max(degree, std::accumulate(e.begin(), e.end(), 0L));
      const auto power = static_cast<std::size_t>(term.exponents[n]);
      powers_ = std::max(powers_, power + 1);
      const auto known = std::ranges::find_if(
          places, [&](const Place& place) { return place.function == i && place.exponents == e; });
      const auto k = static_cast<std::size_t>(known - places.begin());
      if (known == places.end()) {
        places.push_back({i, e});
        coefficients_.emplace_back();
      }
      if (coefficients_[k].size() <= power) coefficients_[k].resize(power + 1);
      coefficients_[k][power] = term.coefficient;
    }
  }
  const long highest = degree + problem.multiplier_degree;
  monomials_ = monomials_up_to(unknowns_, highest);
  extremes_.push_back(index_of(Exponents(n, 0)));
  for (std::size_t j = 0; j < n; ++j) {
    Exponents e(n, 0);
    e[j] = highest;
    extremes_.push_back(index_of(e));
  }
  for (const Exponents& multiplier : monomials_up_to(unknowns_, problem.multiplier_degree)) {
    for (std::size_t k = 0; k < places.size(); ++k) {
      Exponents e = places[k].exponents;
      for (std::size_t j = 0; j < n; ++j) e[j] += multiplier[j];
      entries_.push_back({index_of(e), columns_ + places[k].function, k});
    }
    columns_ += problem.functions.size();
  }
}

std::size_t UnboundedBound::index_of(const Exponents& exponents) const {
  return static_cast<std::size_t>(std::ranges::find(monomials_, exponents) - monomials_.begin());
}

std::optional<std::vector<double>> UnboundedBound::norms(const Rational& lower, const Rational& upper,
                                                         const std::vector<std::size_t>& targets) const {
  const std::size_t rows = monomials_.size();
  const double half = std::nextafter(((upper - lower) / Rational(2)).to_double(), INFINITY);
  const auto taylor = expanded(coefficients_, (lower + upper) / Rational(2), precision_);
  BallMatrix m(rows, columns_);
  for (const Entry& entry : entries_)
    arb_set(m.at(entry.row, entry.column), taylor[entry.coefficient][0].raw());
  // X = M' (M M')^-1, the right inverse of least norm, in approximate arithmetic.
  BallMatrix transposed(columns_, rows);
  BallMatrix gram(rows, rows);
  BallMatrix inverse(rows, rows);
  BallMatrix x(columns_, rows);
  arb_mat_transpose(transposed.raw(), m.raw());
  arb_mat_approx_mul(gram.raw(), m.raw(), transposed.raw(), precision_);
  if (arb_mat_approx_inv(inverse.raw(), gram.raw(), precision_) == 0) return std::nullopt;
  arb_mat_approx_mul(x.raw(), transposed.raw(), inverse.raw(), precision_);
  arb_mat_get_mid(x.raw(), x.raw());
  // W: what M(s) X misses of I, by powers of s - middle.
  const auto n = static_cast<Eigen::Index>(rows);
  Eigen::MatrixXd w = Eigen::MatrixXd::Zero(n, n);
  std::vector<Interval> missing(rows * powers_);
  for (std::size_t column = 0; column < rows; ++column) {
    for (Interval& sum : missing) arb_zero(sum.raw());
    arb_set_si(missing[column * powers_].raw(), -1);
    for (const Entry& entry : entries_) {
      const std::vector<Interval>& c = taylor[entry.coefficient];
      for (std::size_t o = 0; o < c.size(); ++o) {
        arb_addmul(missing[entry.row * powers_ + o].raw(), c[o].raw(), x.at(entry.column, column),
                   precision_);
      }
    }
    for (std::size_t row = 0; row < rows; ++row) {
      double power = 1;
      double total = 0;
      for (std::size_t o = 0; o < powers_; ++o, power *= half) {
        total += power * magnitude(missing[row * powers_ + o].raw());
      }
      w(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) = total * rounding_up + underflow;
    }
  }
  Eigen::VectorXd lengths = Eigen::VectorXd::Zero(n);
  for (std::size_t column = 0; column < rows; ++column) {
    for (std::size_t k = 0; k < columns_; ++k)
      lengths(static_cast<Eigen::Index>(column)) += magnitude(x.at(k, column));
  }
  if (!w.allFinite() || !lengths.allFinite()) return std::nullopt;
  std::vector<double> result;
  for (const std::size_t target : targets) {
    const auto z = dominating_solution(w, target);
    if (!z) return std::nullopt;
    result.push_back(lengths.dot(*z) * rounding_up);
    if (!std::isfinite(result.back())) return std::nullopt;
  }
  return result;
}

Rational UnboundedBound::least_maximum(const Rational& lower, const Rational& upper) const {
  // One of 1, y_j^D has the size T^D, and T^D <= norm max|f_i| T^d <= norm max|f_i| T^D.
  const auto found = norms(lower, upper, extremes_);
  if (!found) return 0;
  return Rational(1) / Rational::from_double(*std::ranges::max_element(*found));
}

std::optional<std::vector<Rational>> UnboundedBound::radii(const Rational& lower, const Rational& upper,
                                                           const Rational& level) const {
  const auto n = static_cast<std::size_t>(unknowns_);
  std::vector<std::size_t> targets(extremes_.begin() + 1, extremes_.end());
  for (std::size_t j = 0; j < n; ++j) {
    Exponents e(n, 0);
    e[j] = 1;
    targets.push_back(index_of(e));
  }
  const auto found = norms(lower, upper, targets);
  if (!found) return std::nullopt;
  std::vector<Rational> result;
  for (std::size_t k = 0; k < targets.size(); ++k) {
    const Rational size = Rational::from_double((*found)[k]) * level;
    // If T > 1, some |y_j|^D = T^D <= norm level T^d < T^D: a contradiction, so T = 1.
    if (k < n && size >= Rational(1)) return std::nullopt;
    if (k >= n) result.push_back(size);
  }
  return result;
}

UnboundedAnswer exceeds(const UnboundedBound& bound, const Polynomial& q, int parameter,
                        const Rational& level, const Rational& lower, const Rational& upper,
                        int max_intervals) {
  const UnivariatePolynomial weight(q, parameter);
  struct Range1 {
    Rational lower;
    Rational upper;
  };
  std::vector<Range1> open{{lower, upper}};
  UnboundedAnswer answer;
  while (!open.empty()) {
    if (answer.intervals == max_intervals) return answer;
    ++answer.intervals;
    const Range1 next = open.back();
    open.pop_back();
    const Rational largest = weight.evaluate(Interval::hull(next.lower, next.upper)).upper();
    if (bound.least_maximum(next.lower, next.upper) > level * largest) continue;
    const Rational middle = (next.lower + next.upper) / Rational(2);
    open.push_back({next.lower, middle});
    open.push_back({middle, next.upper});
  }
  answer.proved = true;
  return answer;
}

}  // namespace subdiv
