#pragma once

#include <cstdlib>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "schemes/algebra/laurent.h"
#include "schemes/expression.h"

namespace subdiv {

/// The name of a symbol's indeterminate.
inline constexpr std::string_view symbol_name = "z";

/// The values of names: over R and, for those that are rational numbers, exactly.
template <class R>
struct Bindings {
  std::map<std::string, R, std::less<>> values;
  std::map<std::string, Rational, std::less<>> rational;
};

/// A symbol with its smoothing factors split off: a(z) = (1 + z + .. + z^(m-1))^smoothing_factors
/// cofactor(z), m the arity. Over an exact ring the cofactor has no further smoothing factor. Over an inexact
/// ring the count comes from those factors of the written product that are exact, such as ((1+z)/2)^4: it is
/// certain, and the cofactor may hide more.
template <class R>
struct FactoredSymbol {
  int smoothing_factors = 0;
  Laurent<R> cofactor;

  [[nodiscard]] Laurent<R> expanded(int arity) const {
    return pow(smoothing_factor<R>(arity), smoothing_factors) * cofactor;
  }
};

/// A factor of an expression's top-level product: the subexpression with this root, to a power that is
/// negative for divisors.
struct WrittenFactor {
  std::size_t root;
  long power;
};
struct WrittenProduct {
  int sign = 1;
  std::vector<WrittenFactor> factors;
};
/// The expression as the product in which it is written: products, quotients, whole powers and signs are
/// taken apart.
[[nodiscard]] WrittenProduct written_product(const Expression& expression);

/// The subexpression as a Laurent polynomial in z; every other name must be bound. The literal maps a
/// number's node to R.
template <class R, class Literal>
Laurent<R> evaluate_symbol(const Expression& expression, std::size_t root,
                           const std::map<std::string, R, std::less<>>& values, const Literal& literal) {
  const auto lookup = [&](const std::string& name, const Expression::Node& node) {
    if (name == symbol_name) return Laurent<R>::monomial(1);
    const auto found = values.find(name);
    if (found == values.end()) throw InputError(expression.locate(node, "unknown name " + in_quotes(name)));
    return Laurent<R>::constant(found->second);
  };
  const auto constant = [&](const Expression::Node& node) { return Laurent<R>::constant(literal(node)); };
  return evaluate<Laurent<R>>(expression, root, lookup, constant);
}

namespace detail {

/// Numerator and denominator of the part of a product that lies in one ring.
template <class R>
struct Quotient {
  Laurent<R> above{1};
  Laurent<R> below{1};
  CostMeter<Laurent<R>> meter{};

  void include(const Laurent<R>& factor, long power) {
    if (power < 0 && factor.is_zero()) throw std::domain_error("division by zero: this divisor is 0");
    Laurent<R>& part = power > 0 ? above : below;
    part = metered_product(part, integer_power(factor, std::abs(power), meter), meter);
  }
  [[nodiscard]] Laurent<R> value() const { return ExpressionRing<Laurent<R>>::quotient(above, below); }
};

/// The exact value of a subexpression, when all that occurs in it is rational; exact_decimals says whether
/// decimals are.
template <class R>
std::optional<Laurent<Rational>> rational_value(const Expression& expression, std::size_t root,
                                                const Bindings<R>& bindings, bool exact_decimals) {
  if (!exact_decimals && expression.has_decimals(root)) return std::nullopt;
  for (const std::string& name : expression.names(root)) {
    if (name != symbol_name && !bindings.rational.contains(name)) return std::nullopt;
  }
  try {
    return evaluate_symbol<Rational>(expression, root, bindings.rational,
                                     [](const Expression::Node& node) { return node.value; });
  } catch (const OutsideRingError&) {
    return std::nullopt;
  }
}

/// The product of both parts, its smoothing factors split off.
template <class R>
FactoredSymbol<R> combine(const Quotient<Rational>& exact, const Quotient<R>& other, int arity) {
  const auto in_ring = [](const Laurent<Rational>& p) {
    return map_coefficients(p, [](const Rational& q) { return from_rational<R>(q); });
  };
  CostMeter<Laurent<R>> meter;
  if constexpr (ExactRing<R>) {
    const Quotient<R> whole{metered_product(in_ring(exact.above), other.above, meter),
                            metered_product(in_ring(exact.below), other.below, meter)};
    const Laurent<R> value = whole.value();
    if (value.is_zero()) return {};
    auto [count, cofactor] = divide_out(value, smoothing_factor<R>(arity));
    return {count, std::move(cofactor)};
  } else {
    const Laurent<Rational> value = exact.value();
    if (value.is_zero() || other.above.is_zero()) return {};
    const auto [count, cofactor] = divide_out(value, smoothing_factor<Rational>(arity));
    return {count, metered_product(in_ring(cofactor), other.value(), meter)};
  }
}

}  // namespace detail

/// The symbol written by an expression in z and the bound names. exact_decimals: decimals are the numbers
/// they show, as opposed to roundings that the literal widens. Throws InputError with the column.
template <class R, class Literal>
FactoredSymbol<R> factored_symbol(const Expression& expression, int arity, const Bindings<R>& bindings,
                                  const Literal& literal, bool exact_decimals) {
  detail::Quotient<Rational> exact;
  detail::Quotient<R> other;
  const WrittenProduct product = written_product(expression);
  exact.above = Laurent<Rational>(product.sign);
  const Expression::Node* node = nullptr;
  try {
    for (const WrittenFactor& factor : product.factors) {
      node = &expression.nodes()[factor.root];
      if (const auto rational = detail::rational_value(expression, factor.root, bindings, exact_decimals)) {
        exact.include(*rational, factor.power);
      } else {
        other.include(evaluate_symbol(expression, factor.root, bindings.values, literal), factor.power);
      }
    }
    node = &expression.nodes()[expression.root()];
    return detail::combine(exact, other, arity);
  } catch (const OutsideRing& error) {
    throw OutsideRingError(expression.locate(*node, error.what()));
  } catch (const std::domain_error& error) {
    throw InputError(expression.locate(*node, error.what()));
  }
}

}  // namespace subdiv
