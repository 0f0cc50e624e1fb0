#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "schemes/algebra/rational.h"

namespace subdiv::verifier {

/// A certificate does not prove what it states; the message says where it fails.
class Rejected : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

inline void need(bool condition, const std::string& why) {
  if (!condition) throw Rejected(why);
}

/// Indeterminates by name, ascending, with powers that are not 0.
using Monomial = std::vector<std::pair<std::string, long>>;
/// A Laurent polynomial over Q in any number of indeterminates; no coefficient is 0.
using Sparse = std::map<Monomial, Rational>;

[[nodiscard]] Sparse operator+(Sparse a, const Sparse& b);
[[nodiscard]] Sparse operator*(const Sparse& a, const Sparse& b);
/// The polynomial by the powers of x: coefficients in the other indeterminates.
[[nodiscard]] std::map<long, Sparse> by_power(const Sparse& p, const std::string& x);
/// The power of x in a monomial.
[[nodiscard]] long power_of(const Monomial& m, const std::string& x);

/// above / below; not reduced, but a denominator of one term is moved into `above`.
struct Quotient {
  Sparse above;
  Sparse below{{{}, Rational(1)}};

  Quotient() = default;
  Quotient(const Rational& q);
  explicit Quotient(Sparse p) : above(std::move(p)) {}
  static Quotient variable(const std::string& name) { return Quotient(Sparse{{{{name, 1}}, Rational(1)}}); }

  [[nodiscard]] bool is_polynomial() const { return below.size() == 1; }
  [[nodiscard]] bool is_number() const;
};

[[nodiscard]] Quotient operator+(const Quotient& a, const Quotient& b);
[[nodiscard]] Quotient operator-(const Quotient& a, const Quotient& b);
[[nodiscard]] Quotient operator*(const Quotient& a, const Quotient& b);
/// Rejected for division by 0.
[[nodiscard]] Quotient operator/(const Quotient& a, const Quotient& b);
[[nodiscard]] Quotient power(const Quotient& q, long n);
[[nodiscard]] Quotient substitute(const Quotient& q, const std::string& x, const Quotient& by);
[[nodiscard]] Quotient derivative(const Quotient& q, const std::string& x);

/// The value of a number, of a whole number; Rejected when it is none.
[[nodiscard]] Rational number(const Quotient& q);
[[nodiscard]] long whole(const Quotient& q);

}  // namespace subdiv::verifier
