#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "schemes/algebra/ring.h"

namespace subdiv {

/// A Laurent polynomial sum of c_i z^i over a ring R, finitely many c_i, i of any sign. Zero coefficients at
/// both ends are dropped (by RingTraits<R>::is_zero), so equal polynomials over an exact ring compare equal.
template <class R>
class Laurent {
 public:
  Laurent() = default;
  /// A constant.
  Laurent(int n) : Laurent(0, {R(n)}) {}
  /// Coefficients of z^first, z^(first+1), ...
  Laurent(int first, std::vector<R> coefficients) : first_(first), coefficients_(std::move(coefficients)) {
    trim();
  }
  static Laurent constant(R c) { return Laurent(0, {std::move(c)}); }
  static Laurent monomial(int power, R c = R(1)) { return Laurent(power, {std::move(c)}); }

  [[nodiscard]] bool is_zero() const { return coefficients_.empty(); }
  /// Lowest and highest power with a coefficient that is not zero; 0 and -1 for the zero polynomial.
  [[nodiscard]] int first() const { return first_; }
  [[nodiscard]] int last() const { return first_ + static_cast<int>(coefficients_.size()) - 1; }
  [[nodiscard]] int size() const { return static_cast<int>(coefficients_.size()); }
  [[nodiscard]] const std::vector<R>& coefficients() const { return coefficients_; }
  /// The coefficient of z^i, zero outside the support.
  [[nodiscard]] R operator[](int i) const {
    return i < first() || i > last() ? R(0) : coefficients_[static_cast<std::size_t>(i - first_)];
  }

  friend Laurent operator+(const Laurent& a, const Laurent& b) {
    return combine(a, b, [](R& x, const R& y) { x = x + y; });
  }
  friend Laurent operator-(const Laurent& a, const Laurent& b) {
    return combine(a, b, [](R& x, const R& y) { x = x - y; });
  }
  friend Laurent operator-(const Laurent& a) { return Laurent() - a; }
  friend Laurent operator*(const Laurent& a, const Laurent& b) {
    if (a.is_zero() || b.is_zero()) return {};
    std::vector<R> product(a.coefficients_.size() + b.coefficients_.size() - 1, R(0));
    for (std::size_t i = 0; i < a.coefficients_.size(); ++i) {
      if (subdiv::is_zero(a.coefficients_[i])) continue;
      for (std::size_t j = 0; j < b.coefficients_.size(); ++j) {
        product[i + j] = product[i + j] + a.coefficients_[i] * b.coefficients_[j];
      }
    }
    return Laurent(a.first_ + b.first_, std::move(product));
  }
  friend Laurent operator*(const R& c, const Laurent& a) { return constant(c) * a; }
  Laurent& operator+=(const Laurent& o) { return *this = *this + o; }
  Laurent& operator-=(const Laurent& o) { return *this = *this - o; }
  Laurent& operator*=(const Laurent& o) { return *this = *this * o; }
  friend bool operator==(const Laurent& a, const Laurent& b) {
    return a.size() == b.size() && (a.is_zero() || a.first_ == b.first_) &&
           a.coefficients_ == b.coefficients_;
  }

 private:
  template <class Update>
  static Laurent combine(const Laurent& a, const Laurent& b, Update update) {
    if (b.is_zero()) return a;
    const int first = a.is_zero() ? b.first() : std::min(a.first(), b.first());
    const int last = a.is_zero() ? b.last() : std::max(a.last(), b.last());
    std::vector<R> sum(static_cast<std::size_t>(last - first + 1), R(0));
    for (int i = a.first(); i <= a.last(); ++i) sum[static_cast<std::size_t>(i - first)] = a[i];
    for (int i = b.first(); i <= b.last(); ++i) update(sum[static_cast<std::size_t>(i - first)], b[i]);
    return Laurent(first, std::move(sum));
  }
  void trim() {
    while (!coefficients_.empty() && subdiv::is_zero(coefficients_.back())) coefficients_.pop_back();
    std::size_t zeros = 0;
    while (zeros < coefficients_.size() && subdiv::is_zero(coefficients_[zeros])) ++zeros;
    coefficients_.erase(coefficients_.begin(), coefficients_.begin() + static_cast<std::ptrdiff_t>(zeros));
    first_ = coefficients_.empty() ? 0 : first_ + static_cast<int>(zeros);
  }

  int first_ = 0;
  std::vector<R> coefficients_;
};

/// p(z) z^k.
template <class R>
Laurent<R> shift(const Laurent<R>& p, int k) {
  return p.is_zero() ? p : Laurent<R>(p.first() + k, p.coefficients());
}

/// p(z^m), m >= 1.
template <class R>
Laurent<R> upsample(const Laurent<R>& p, int m) {
  if (p.is_zero()) return p;
  const auto spacing = static_cast<std::size_t>(m);
  std::vector<R> result((p.coefficients().size() - 1) * spacing + 1, R(0));
  for (std::size_t i = 0; i < p.coefficients().size(); ++i) result[i * spacing] = p.coefficients()[i];
  return Laurent<R>(p.first() * m, std::move(result));
}

/// The remainder r of i modulo m, 0 <= r < m, for any sign of i.
constexpr int residue(int i, int m) { return ((i % m) + m) % m; }
/// The largest integer not above i / m.
constexpr int floor_divide(int i, int m) { return (i - residue(i, m)) / m; }

/// The residue class r modulo m: sum of c_{r + m j} z^j over j (the r-th polyphase component).
template <class R>
Laurent<R> residue_class(const Laurent<R>& p, int r, int m) {
  const int low = floor_divide(p.first() - r + m - 1, m);
  const int high = floor_divide(p.last() - r, m);
  std::vector<R> result;
  for (int j = low; j <= high; ++j) result.push_back(p[r + m * j]);
  return Laurent<R>(low, std::move(result));
}

/// p(1/z).
template <class R>
Laurent<R> reverse(const Laurent<R>& p) {
  return Laurent<R>(-p.last(), std::vector<R>(p.coefficients().rbegin(), p.coefficients().rend()));
}

/// z p'(z): coefficients i c_i. Its value at 1 is the first moment.
template <class R>
Laurent<R> euler_derivative(const Laurent<R>& p) {
  std::vector<R> result;
  for (int i = p.first(); i <= p.last(); ++i) result.push_back(R(i) * p[i]);
  return Laurent<R>(p.first(), std::move(result));
}

/// p^n for n >= 0.
template <class R>
Laurent<R> pow(const Laurent<R>& p, int n) {
  Laurent<R> result(1);
  for (int i = 0; i < n; ++i) result *= p;
  return result;
}

/// p(1), the sum of the coefficients.
template <class R>
R sum(const Laurent<R>& p) {
  R total(0);
  for (const R& c : p.coefficients()) total = total + c;
  return total;
}

/// The value at x, x invertible where p has negative powers.
template <class R>
R evaluate(const Laurent<R>& p, const R& x) {
  R value(0);
  for (int i = p.size() - 1; i >= 0; --i) value = value * x + p.coefficients()[static_cast<std::size_t>(i)];
  for (int i = 0; i < p.first(); ++i) value = value * x;
  for (int i = 0; i > p.first(); --i) value = value / x;
  return value;
}

/// The coefficients sent through a map, for example into another ring.
template <class R, class Map>
auto map_coefficients(const Laurent<R>& p, Map map) {
  using S = decltype(map(p[0]));
  std::vector<S> result;
  for (const R& c : p.coefficients()) result.push_back(map(c));
  return Laurent<S>(p.first(), std::move(result));
}

/// Quotient and remainder by a divisor whose lowest coefficient is a unit: p = q d + r, where q takes off the
/// lowest powers first and r has support in the size(d) - 1 highest powers of p.
template <class R>
std::pair<Laurent<R>, Laurent<R>> divide_from_below(const Laurent<R>& p, const Laurent<R>& d) {
  if (d.is_zero()) throw std::domain_error("division by zero");
  const R& lowest = d.coefficients().front();
  const bool monic = is_zero(lowest - R(1));
  const auto over_lowest = [&](const R& c) -> R {
    if (monic) return c;
    if constexpr (requires { c / lowest; }) {
      return c / lowest;
    } else {
      throw std::domain_error("this ring divides only by polynomials whose lowest coefficient is 1");
    }
  };
  std::vector<R> rest = p.coefficients();
  std::vector<R> quotient;
  const auto length = static_cast<std::size_t>(d.size());
  for (std::size_t i = 0; i + length <= rest.size(); ++i) {
    const R q = over_lowest(rest[i]);
    for (std::size_t j = 0; j < length; ++j) rest[i + j] = rest[i + j] - q * d.coefficients()[j];
    rest[i] = R(0);
    quotient.push_back(q);
  }
  return {Laurent<R>(p.first() - d.first(), std::move(quotient)), Laurent<R>(p.first(), std::move(rest))};
}

/// p / d when d divides p, nothing otherwise. Decided for exact rings only. Over a ring without division the
/// lowest coefficient of d must be 1 (std::domain_error).
template <ExactRing R>
std::optional<Laurent<R>> divide_exactly(const Laurent<R>& p, const Laurent<R>& d) {
  auto [quotient, remainder] = divide_from_below(p, d);
  if (!remainder.is_zero()) return std::nullopt;
  return std::move(quotient);
}

/// 1 + z + ... + z^(m-1), the smoothing factor of arity m.
template <class R>
Laurent<R> smoothing_factor(int arity) {
  return Laurent<R>(0, std::vector<R>(static_cast<std::size_t>(arity), R(1)));
}

/// How often d divides p, and the cofactor. p must not be zero (std::domain_error).
template <ExactRing R>
std::pair<int, Laurent<R>> divide_out(Laurent<R> p, const Laurent<R>& d) {
  if (p.is_zero()) throw std::domain_error("every power divides zero");
  int multiplicity = 0;
  while (auto quotient = divide_exactly(p, d)) {
    p = std::move(*quotient);
    ++multiplicity;
  }
  return {multiplicity, p};
}

template <class R>
struct RingTraits<Laurent<R>> {
  static constexpr bool exact = RingTraits<R>::exact;
  static Laurent<R> from_rational(const Rational& q) {
    return Laurent<R>::constant(RingTraits<R>::from_rational(q));
  }
  static bool is_zero(const Laurent<R>& p) { return p.is_zero(); }
};

}  // namespace subdiv
