#include "experiments/verifier/quotient.h"

#include <algorithm>
#include <cstdlib>

namespace subdiv::verifier {
namespace {

Monomial product(const Monomial& a, const Monomial& b) {
  Monomial result;
  auto i = a.begin();
  auto j = b.begin();
  while (i != a.end() || j != b.end()) {
    if (j == b.end() || (i != a.end() && i->first < j->first)) {
      result.push_back(*i++);
    } else if (i == a.end() || j->first < i->first) {
      result.push_back(*j++);
    } else {
      if (i->second + j->second != 0) result.emplace_back(i->first, i->second + j->second);
      ++i;
      ++j;
    }
  }
  return result;
}

void add_term(Sparse& p, const Monomial& m, const Rational& c) {
  const auto [place, is_new] = p.try_emplace(m, c);
  if (!is_new) place->second += c;
  if (place->second.sign() == 0) p.erase(place);
}

Quotient quotient(Sparse above, Sparse below) {
  Quotient result(std::move(above));
  if (below.size() > 1) {
    result.below = std::move(below);
    return result;
  }
  const auto& [monomial, coefficient] = *below.begin();
  Monomial inverse = monomial;
  for (auto& factor : inverse) factor.second = -factor.second;
  if (!inverse.empty() || !(coefficient == Rational(1))) {
    result.above = result.above * Sparse{{inverse, Rational(1) / coefficient}};
  }
  return result;
}

}  // namespace

Sparse operator+(Sparse a, const Sparse& b) {
  for (const auto& [m, c] : b) add_term(a, m, c);
  return a;
}

Sparse operator*(const Sparse& a, const Sparse& b) {
  Sparse result;
  for (const auto& [m, x] : a) {
    for (const auto& [n, y] : b) add_term(result, product(m, n), x * y);
  }
  return result;
}

long power_of(const Monomial& m, const std::string& x) {
  const auto found = std::find_if(m.begin(), m.end(), [&](const auto& factor) { return factor.first == x; });
  return found == m.end() ? 0 : found->second;
}

std::map<long, Sparse> by_power(const Sparse& p, const std::string& x) {
  std::map<long, Sparse> result;
  for (const auto& [m, c] : p) {
    Monomial rest = m;
    std::erase_if(rest, [&](const auto& factor) { return factor.first == x; });
    result[power_of(m, x)].emplace(std::move(rest), c);
  }
  return result;
}

Quotient::Quotient(const Rational& q) {
  if (q.sign() != 0) above.emplace(Monomial{}, q);
}

bool Quotient::is_number() const {
  return is_polynomial() && (above.empty() || (above.size() == 1 && above.begin()->first.empty()));
}

Quotient operator+(const Quotient& a, const Quotient& b) {
  if (a.below == b.below) return quotient(a.above + b.above, a.below);
  return quotient(a.above * b.below + b.above * a.below, a.below * b.below);
}

Quotient operator-(const Quotient& a, const Quotient& b) { return a + Quotient(Rational(-1)) * b; }

Quotient operator*(const Quotient& a, const Quotient& b) {
  return quotient(a.above * b.above, b.is_polynomial() ? a.below : a.below * b.below);
}

Quotient operator/(const Quotient& a, const Quotient& b) {
  need(!b.above.empty(), "division by zero");
  return quotient(a.above * b.below, a.below * b.above);
}

Quotient power(const Quotient& q, long n) {
  need(std::labs(n) <= 100000, "a power is too large");
  Quotient result(Rational(1));
  const Quotient base = n < 0 ? result / q : q;
  for (long i = 0; i < std::labs(n); ++i) result = result * base;
  return result;
}

Quotient substitute(const Quotient& q, const std::string& x, const Quotient& by) {
  const auto in_polynomial = [&](const Sparse& p) {
    Quotient sum;
    for (const auto& [n, rest] : by_power(p, x)) sum = sum + Quotient(rest) * power(by, n);
    return sum;
  };
  return in_polynomial(q.above) / in_polynomial(q.below);
}

Quotient derivative(const Quotient& q, const std::string& x) {
  const auto of_polynomial = [&](const Sparse& p) {
    Quotient sum;
    for (const auto& [n, rest] : by_power(p, x)) {
      sum = sum + Quotient(Rational(n)) * Quotient(rest) *
                      (n == 0 ? Quotient() : power(Quotient::variable(x), n - 1));
    }
    return sum;
  };
  if (q.is_polynomial()) return of_polynomial(q.above);
  const Quotient below(q.below);
  return (of_polynomial(q.above) * below - Quotient(q.above) * of_polynomial(q.below)) / (below * below);
}

Rational number(const Quotient& q) {
  need(q.is_number(), "a number is needed here");
  return q.above.empty() ? Rational(0) : q.above.begin()->second;
}

long whole(const Quotient& q) {
  const Rational value = number(q);
  need(value.is_integer() && abs(value) < Rational(1000000000), "a whole number is needed here");
  return value.to_integer();
}

}  // namespace subdiv::verifier
