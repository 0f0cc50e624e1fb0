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
  std::map<std::string, R, std::less<>> values;           ///< of all names, over R
  std::map<std::string, Rational, std::less<>> rational;  ///< of those that are rational
};

/// A symbol with its smoothing factors split off: a(z) = (1 + z + .. + z^(m-1))^smoothing_factors
/// cofactor(z), m the arity. Over an exact ring the cofactor has no further smoothing factor. Over an inexact
/// ring the count comes from those factors of the written product that are exact, such as ((1+z)/2)^4: it is
/// certain, and the cofactor may hide more.
template <class R>
struct FactoredSymbol {
  int smoothing_factors = 0;  ///< how many are split off
  Laurent<R> cofactor;        ///< the rest

  /// The product, for the arity m.
  [[nodiscard]] Laurent<R> expanded(int arity) const {
    return pow(smoothing_factor<R>(arity), smoothing_factors) * cofactor;
  }
};

/// A factor of an expression's top-level product: the subexpression with this root, to a power that is
/// negative for divisors.
struct WrittenFactor {
  std::size_t root;  ///< of the subexpression, a node's index
  long power;        ///< negative for divisors
};
/// An expression's top-level product.
struct WrittenProduct {
  int sign = 1;                        ///< 1 or -1
  std::vector<WrittenFactor> factors;  ///< from left to right
};
/// The expression as the product in which it is written: products, quotients, whole powers and signs are
/// taken apart.
[[nodiscard]] WrittenProduct written_product(const Expression& expression);

/// The subexpression as a Laurent polynomial in z; every other name must be bound. literal as in evaluate.
template <class R, class Literal>
Laurent<R> evaluate_symbol(const Expression& expression, std::size_t root,
                           const std::map<std::string, R, std::less<>>& values, const Literal& literal) {
  const auto lookup = [&](const std::string& name, const Expression::Node& node) {
    if (name == symbol_name) return Laurent<R>::monomial(1);
    const auto found = values.find(name);
    if (found == values.end()) throw InputError(expression.locate(node, "unknown name " + in_quotes(name)));
    return Laurent<R>::constant(found->second);
  };
  const auto constant = [&](const Rational& value, const Rational& half_unit) {
    return Laurent<R>::constant(literal(value, half_unit));
  };
  return evaluate<Laurent<R>>(expression, root, lookup, constant);
}

namespace detail {

/// The part of a written product that lies in one ring, as numerator and denominator.
template <class R>
struct SymbolPart {
  Laurent<R> above{1};
  Laurent<R> below{1};
  CostMeter<Laurent<R>> meter{};

  void include(const Laurent<R>& factor, long power) {
    if (power < 0 && factor.is_zero()) throw std::domain_error("division by zero: this divisor is 0");
    Laurent<R>& side = power > 0 ? above : below;
    side = metered_product(side, integer_power(factor, std::abs(power), meter), meter);
  }
  [[nodiscard]] Laurent<R> value() const { return ExpressionRing<Laurent<R>>::quotient(above, below); }
};

/// The exact value of a subexpression, when all that occurs in it is rational.
template <class R>
std::optional<Laurent<Rational>> rational_value(const Expression& expression, std::size_t root,
                                                const Bindings<R>& bindings, bool decimals_are_exact) {
  if (!decimals_are_exact && expression.has_decimals(root)) return std::nullopt;
  for (const std::string& name : expression.names(root)) {
    if (name != symbol_name && !bindings.rational.contains(name)) return std::nullopt;
  }
  try {
    return evaluate_symbol<Rational>(expression, root, bindings.rational, ExactLiteral<Rational>{});
  } catch (const OutsideRingError&) {
    return std::nullopt;
  }
}

/// Sorts the factors of the written product into those that are exactly rational and the others, and combines
/// both parts; an error of the combination is shown at the root.
template <class R, class Literal, class Combine>
auto combine_factors(const Expression& expression, const Bindings<R>& bindings, const Literal& literal,
                     const Combine& combine) {
  const WrittenProduct product = written_product(expression);
  SymbolPart<Rational> rational;
  SymbolPart<R> other;
  rational.above = Laurent<Rational>(product.sign);
  const Expression::Node* node = nullptr;
  try {
    for (const WrittenFactor& factor : product.factors) {
      node = &expression.nodes()[factor.root];
      if (const auto value = rational_value(expression, factor.root, bindings, literal.decimals_are_exact)) {
        rational.include(*value, factor.power);
      } else {
        other.include(evaluate_symbol(expression, factor.root, bindings.values, literal), factor.power);
      }
    }
    node = &expression.nodes()[expression.root()];
    return combine(rational, other);
  } catch (const OutsideRing& error) {
    throw OutsideRingError(expression.locate(*node, error.what()));
  } catch (const std::domain_error& error) {
    throw InputError(expression.locate(*node, error.what()));
  }
}

/// A polynomial over Q with its coefficients in R.
template <class R, class Literal>
Laurent<R> in_ring(const Laurent<Rational>& p, const Literal& literal) {
  return map_coefficients(p, [&](const Rational& q) { return literal(q, Rational(0)); });
}

/// The product of a rational polynomial and the other part of a symbol.
template <class R, class Literal>
Laurent<R> joined_value(const Laurent<Rational>& rational, const SymbolPart<R>& other,
                        const Literal& literal) {
  CostMeter<Laurent<R>> meter;
  return metered_product(in_ring<R>(rational, literal), other.value(), meter);
}

/// The value of both parts. Exact rings divide the whole product, so that a factor of one part may cancel
/// against the other.
template <class R, class Literal>
Laurent<R> joined_value(const SymbolPart<Rational>& rational, const SymbolPart<R>& other,
                        const Literal& literal) {
  if constexpr (ExactRing<R>) {
    CostMeter<Laurent<R>> meter;
    return SymbolPart<R>{metered_product(in_ring<R>(rational.above, literal), other.above, meter),
                         metered_product(in_ring<R>(rational.below, literal), other.below, meter)}
        .value();
  } else {
    return joined_value(rational.value(), other, literal);
  }
}

}  // namespace detail

/// The symbol written by an expression in z and the bound names. The literal is an ExactLiteral<R> or
/// IntervalLiteral. Throws InputError with the column.
template <class R, class Literal>
Laurent<R> symbol_value(const Expression& expression, const Bindings<R>& bindings, const Literal& literal) {
  return detail::combine_factors(expression, bindings, literal, [&](const auto& rational, const auto& other) {
    return detail::joined_value(rational, other, literal);
  });
}

/// The same with its smoothing factors split off.
template <class R, class Literal>
FactoredSymbol<R> factored_symbol(const Expression& expression, int arity, const Bindings<R>& bindings,
                                  const Literal& literal) {
  const auto combine = [&](const detail::SymbolPart<Rational>& rational,
                           const detail::SymbolPart<R>& other) -> FactoredSymbol<R> {
    if constexpr (ExactRing<R>) {
      const Laurent<R> value = detail::joined_value(rational, other, literal);
      if (value.is_zero()) return {};
      auto [count, cofactor] = divide_out(value, smoothing_factor<R>(arity));
      return {count, std::move(cofactor)};
    } else {
      const Laurent<Rational> value = rational.value();
      if (value.is_zero()) return {};
      const auto [count, cofactor] = divide_out(value, smoothing_factor<Rational>(arity));
      return {count, detail::joined_value(cofactor, other, literal)};
    }
  };
  return detail::combine_factors(expression, bindings, literal, combine);
}

}  // namespace subdiv
