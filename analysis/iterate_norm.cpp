#include "analysis/iterate_norm.h"

#include <cmath>
#include <cstdint>
#include <utility>

#include "analysis/iterate_norm_kernel.h"
#include "schemes/algebra/interval.h"

namespace subdiv {
namespace {

constexpr std::int64_t max_classes = std::int64_t{1} << 36;
/// The inner table of a tile should stay in the first-level cache, the outer one within megabytes.
constexpr std::int64_t inner_classes = 1024;
constexpr std::int64_t outer_classes = 65536;

/// gamma_n = n u / (1 - n u), u = 2^-53: a sum of n products computed in double arithmetic differs from its
/// exact value by at most gamma_n times the sum of their absolute values, if nothing underflows (Higham,
/// Accuracy and Stability, 3.1).
Interval rounding(std::size_t n) {
  const Rational nu = Rational(static_cast<std::int64_t>(n)) * Rational::power_of_two(-53);
  return Interval(nu / (Rational(1) - nu));
}

/// The exponent e for which the norm of 2^-e d lies in (1/2, 1]; scaling by powers of two is exact and keeps
/// every iterate in the range of double.
long scale_of(const Rational& norm) {
  const auto above = static_cast<long>(fmpz_bits(fmpq_numref(norm.raw())));
  const auto below = static_cast<long>(fmpz_bits(fmpq_denref(norm.raw())));
  const long exponent = above - below;
  return norm > Rational::power_of_two(exponent) ? exponent + 1 : exponent;
}

/// The class matrices in double with what is known of them.
struct Steps {
  int arity = 2;
  std::size_t n = 1;
  std::vector<std::vector<double>> matrices;  // A_e, row by row
  Interval norm;                              // of the matrices as stored
  Interval error;                             // norm of stored minus exact matrices
};

/// All classes of one level, and what is known of them in the norm of class vectors: |stored| <= norm,
/// |exact| <= exact_norm and |stored - exact| <= error for every class.
struct Level {
  std::int64_t classes = 1;
  std::size_t stride = detail::tile_padding;
  std::vector<double> entries;  // entry l of class r at l stride + r
  Interval norm = Interval(1);
  Interval exact_norm = Interval(1);
  Interval error = Interval(0);
};

Steps steps_of(const Laurent<Rational>& d, int arity) {
  Steps result{arity, static_cast<std::size_t>(class_size(d, arity)), {}, Interval(0), Interval(0)};
  for (const Matrix<Rational>& exact : class_matrices(d, arity)) {
    std::vector<double> stored;
    for (Eigen::Index l = 0; l < exact.rows(); ++l) {
      for (Eigen::Index j = 0; j < exact.cols(); ++j) stored.push_back(exact(l, j).to_double());
    }
    for (std::size_t j = 0; j < result.n; ++j) {
      Rational norm;
      Rational error;
      for (std::size_t l = 0; l < result.n; ++l) {
        const Rational value = Rational::from_double(stored[result.n * l + j]);
        norm += abs(value);
        error += abs(value - exact(static_cast<Eigen::Index>(l), static_cast<Eigen::Index>(j)));
      }
      result.norm = max(result.norm, Interval(norm));
      result.error = max(result.error, Interval(error));
    }
    result.matrices.push_back(std::move(stored));
  }
  return result;
}

/// |A' v - fl(A v)| for stored matrices A of norm `norm`, |A - A'| <= error, and a stored vector v of norm
/// v_norm: A' v - fl(A v) = (A' - A) v + (A v - fl(A v)), the second part with underflows.
Interval defect(const Interval& norm, const Interval& error, const Interval& v_norm, std::size_t n) {
  const auto products = static_cast<std::int64_t>(n * n);
  const Interval underflow(Rational(products) * Rational::power_of_two(-1074));
  return (error + rounding(n) * norm) * v_norm + underflow;
}

double stored_norm(const Level& level, std::size_t n) {
  double largest = 0;
  for (std::size_t r = 0; r < static_cast<std::size_t>(level.classes); ++r) {
    double sum = 0;
    for (std::size_t l = 0; l < n; ++l) sum += std::abs(level.entries[l * level.stride + r]);
    largest = std::max(largest, sum);
  }
  return largest;
}

/// From the classes modulo m^i to those modulo m^(i+1), in place: v(r + m^i e) = A_e v(r).
void descend(const Steps& steps, Level& level) {
  const std::size_t n = steps.n;
  const auto classes = static_cast<std::size_t>(level.classes);
  std::vector<double> parent(n);
  for (std::size_t r = 0; r < classes; ++r) {
    for (std::size_t j = 0; j < n; ++j) parent[j] = level.entries[j * level.stride + r];
    for (std::size_t e = 0; e < steps.matrices.size(); ++e) {
      const std::vector<double>& a = steps.matrices[e];
      for (std::size_t l = 0; l < n; ++l) {
        double sum = 0;
        for (std::size_t j = 0; j < n; ++j) sum += a[n * l + j] * parent[j];
        level.entries[l * level.stride + e * classes + r] = sum;
      }
    }
  }
  level.classes *= steps.arity;
  level.norm = Interval(stored_norm(level, n)) * (Interval(1) + rounding(n));
}

std::int64_t power(int base, int exponent) {
  std::int64_t result = 1;
  for (int i = 0; i < exponent; ++i) {
    if (result > max_classes / base)
      throw std::domain_error("the iterate has more than 2^36 residue classes");
    result *= base;
  }
  return result;
}

/// The classes modulo m^k. The defect of step i passes through k - i exact steps, whose norm is at most
/// norm_{k-i}: the error of level k is at most the sum over i of defect_i norm_{k-i}.
Level level_of(const Steps& steps, int k) {
  Level level;
  const auto classes = static_cast<std::size_t>(power(steps.arity, k));
  level.stride = (classes + detail::tile_padding - 1) / detail::tile_padding * detail::tile_padding;
  level.entries.assign(steps.n * level.stride, 0.0);
  level.entries[0] = 1.0;
  std::vector<Interval> exact_norms{Interval(1)};
  std::vector<Interval> defects;
  for (int i = 0; i < k; ++i) {
    defects.push_back(defect(steps.norm, steps.error, level.norm, steps.n));
    descend(steps, level);
    level.error = Interval(0);
    for (std::size_t j = 0; j < defects.size(); ++j) {
      level.error += defects[j] * exact_norms[defects.size() - 1 - j];
    }
    level.exact_norm = level.norm + level.error;
    exact_norms.push_back(level.exact_norm);
  }
  return level;
}

/// The k1 levels of the inner table: cache-sized, unless the outer table would grow beyond megabytes.
int inner_levels(int arity, int k) {
  int inner = 0;
  while (inner < (k + 1) / 2 && power(arity, inner + 1) <= inner_classes) ++inner;
  while (power(arity, k - inner) > outer_classes) ++inner;
  return inner;
}

/// The product of the k2 last matrices that belongs to outer class r: column j holds class r - j.
void outer_matrix(const Level& outer, std::int64_t r, std::size_t n, std::vector<double>& matrix) {
  for (std::size_t j = 0; j < n; ++j) {
    std::int64_t position = r - static_cast<std::int64_t>(j);
    std::size_t carry = 0;
    for (; position < 0; position += outer.classes) ++carry;
    for (std::size_t q = 0; q < n; ++q) {
      const std::size_t entry = q < carry ? n : q - carry;
      matrix[n * q + j] =
          entry < n ? outer.entries[entry * outer.stride + static_cast<std::size_t>(position)] : 0.0;
    }
  }
}

/// Outer classes first .. last (modulo their number) that meet every class of the product up to the mirror
/// symmetry r <-> total - r, total the degree of D_k; all of them when d is not symmetric.
std::pair<std::int64_t, std::int64_t> outer_range(const Laurent<Rational>& d, int arity, std::int64_t classes,
                                                  const Level& inner, const Level& outer) {
  const Laurent<Rational> mirror = shift(reverse(d), d.first() + d.last());
  if (d != mirror && d != -mirror) return {0, outer.classes - 1};
  const std::int64_t total = ((classes - 1) / (arity - 1) % classes) * (d.size() - 1) % classes;
  const std::int64_t first = (total + 1) / 2 / inner.classes;
  const std::int64_t last = (total + classes) / 2 / inner.classes;
  return {first, std::min(last, first + outer.classes - 1)};
}

}  // namespace

Enclosure iterate_norm_enclosure(const Laurent<Rational>& d, int arity, int k) {
  if (k < 0) throw std::domain_error("the power of an iterate is at least 0");
  if (d.is_zero()) return exact(Rational(k == 0 ? 1 : 0));
  const std::int64_t classes = power(arity, k);
  const Rational norm = iterate_norms(d, arity, 1).back();
  const long exponent = scale_of(norm);
  const Laurent<Rational> scaled = Laurent<Rational>::constant(Rational::power_of_two(-exponent)) * d;
  const Steps steps = steps_of(scaled, arity);
  const int k1 = inner_levels(arity, k);
  const Level inner = level_of(steps, k1);
  const Level outer = level_of(steps, k - k1);

  std::vector<double> matrix(steps.n * steps.n);
  double largest = 0;
  const auto [first, last] = outer_range(d, arity, classes, inner, outer);
  for (std::int64_t r = first; r <= last; ++r) {
    outer_matrix(outer, r % outer.classes, steps.n, matrix);
    largest = std::max(largest, detail::largest_norm_in_tile(inner.entries.data(), inner.stride, inner.stride,
                                                             matrix.data(), steps.n));
  }
  const Interval computed(largest);
  const Interval error = defect(outer.norm, outer.error, inner.norm, steps.n) +
                         outer.exact_norm * inner.error + computed * rounding(steps.n);
  const Rational scale = Rational::power_of_two(exponent * k);
  const Rational lower = (computed - error).lower();
  return certified(scale * std::max(lower, Rational(0)), scale * (computed + error).upper(),
                   "all residue classes in double, rounding errors bounded");
}

}  // namespace subdiv
