#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "schemes/algebra/rational.h"
#include "schemes/expression_cost.h"
#include "schemes/expression_ring.h"
#include "schemes/input_error.h"
#include "schemes/text.h"

namespace subdiv {

/// A value that a ring cannot hold, such as sqrt(2) among the rationals, or only at too high a cost; a larger
/// or an inexact ring can.
class OutsideRingError : public InputError {
 public:
  using InputError::InputError;
};

/// A parsed exact expression, an immutable value:
///
///     sum     = product { (+|-) product }
///     product = signed { (*|/) signed }           p/q is a quotient
///     signed  = { +|- } power                     -z^2 is -(z^2)
///     power   = atom [ ^ integer ]                the integer may have a sign and stand in parentheses
///     atom    = number | name | sqrt ( sum ) | ( sum )
///     number  = digits, or a decimal with an optional exponent: 2, 0.46415, 1e-3
///     name    = a letter, then letters, digits and _
///
/// Decimals mean their exact value. Nothing is evaluated when parsing, so division by zero is found later.
/// Depth, powers and size are limited, so that no text can exhaust the stack or the memory.
class Expression {
 public:
  /// Throws InputError with the column, what was found and what was expected.
  static Expression parse(std::string_view text);

  /// What a node is: a number, a name, or an operation on its operands.
  enum class Kind { number, name, negate, add, subtract, multiply, divide, power, square_root };
  /// Operands stand before their operator: node k's operands are nodes of smaller index, and the nodes of the
  /// subexpression with root k are first .. k.
  struct Node {
    Kind kind;                 ///< what it is
    std::size_t begin = 0;     ///< the node's source text, positions [begin, end), with its parentheses
    std::size_t end = 0;       ///< one behind the last position
    std::size_t position = 0;  ///< where an error in this node is shown: the operator
    std::size_t first = 0;     ///< the smallest index in the subexpression
    std::size_t left = 0;      ///< operand (the only one of negate, power, square_root)
    std::size_t right = 0;     ///< second operand
    long exponent = 0;         ///< of a power
    std::string name{};        ///< of a name
    Rational value{};          ///< of a number
    Rational half_unit{};      ///< half a unit of a decimal's last digit; 0 for integers
  };

  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  [[nodiscard]] std::size_t root() const { return nodes_.size() - 1; }
  /// The node's source text.
  [[nodiscard]] std::string_view source(const Node& node) const {
    return std::string_view(text_).substr(node.begin, node.end - node.begin);
  }
  /// The distinct names that occur in the subexpression with this root, by first appearance.
  [[nodiscard]] std::vector<std::string> names(std::size_t root) const;
  [[nodiscard]] std::vector<std::string> names() const { return names(root()); }
  /// Whether a decimal, as opposed to integers alone, occurs in the subexpression with this root.
  [[nodiscard]] bool has_decimals(std::size_t root) const;
  [[nodiscard]] bool has_decimals() const { return has_decimals(root()); }
  /// "column 2 of '1/(6+s)': what", about a node.
  [[nodiscard]] std::string locate(const Node& node, const std::string& what) const {
    return located(text_, node.position, what);
  }

 private:
  Expression(std::string text, std::vector<Node> nodes) : text_(std::move(text)), nodes_(std::move(nodes)) {}

  std::string text_;
  std::vector<Node> nodes_;
};

/// Numbers as their exact values.
template <class R>
struct ExactLiteral {
  static constexpr bool decimals_are_exact = true;  ///< decimals mean their exact value
  R operator()(const Rational& value, const Rational& /*half_unit*/) const { return from_rational<R>(value); }
};

/// Numbers as intervals at a precision in bits; decimals that are not exact are known to half_unit on both
/// sides.
struct IntervalLiteral {
  long precision = Interval::default_precision;  ///< in bits
  bool decimals_are_exact = true;                ///< whether decimals mean their exact value
  Interval operator()(const Rational& value, const Rational& half_unit) const {
    if (decimals_are_exact || half_unit.sign() == 0) return Interval(value, precision);
    return Interval::hull(value - half_unit, value + half_unit, precision);
  }
};

namespace detail {

/// Replaces the operands on top of the stack by the operator's value.
template <class R>
void apply(const Expression& expression, const Expression::Node& node, std::vector<R>& stack,
           CostMeter<R>& meter) {
  using Kind = Expression::Kind;
  using Ring = ExpressionRing<R>;
  if (node.kind == Kind::negate) {
    stack.back() = R(0) - stack.back();
  } else if (node.kind == Kind::power) {
    stack.back() = integer_power(stack.back(), node.exponent, meter);
  } else if (node.kind == Kind::square_root) {
    stack.back() = Ring::square_root(stack.back());
  } else {
    const R right = std::move(stack.back());
    stack.pop_back();
    R& left = stack.back();
    if (node.kind == Kind::divide && is_zero(right)) {
      const std::string_view divisor = expression.source(expression.nodes()[node.right]);
      throw std::domain_error("division by zero: " + in_quotes(divisor) + " is 0");
    }
    if (node.kind == Kind::multiply || node.kind == Kind::divide) {
      meter.charge(product_cost(left, right));
      left = node.kind == Kind::multiply ? left * right : Ring::quotient(left, right);
    } else {
      meter.charge(sum_cost(left, right));
      left = node.kind == Kind::add ? left + right : left - right;
    }
  }
}

}  // namespace detail

/// The value over a ring R of the subexpression with the given root. lookup(name, node) gives a name's value,
/// literal(value, half_unit) a number's. Throws InputError with the column for division by zero and roots of
/// negative numbers; OutsideRingError for values that R does not hold and those too large to compute.
template <class R, class Lookup, class Literal>
R evaluate(const Expression& expression, std::size_t root, const Lookup& lookup, const Literal& literal) {
  const std::vector<Expression::Node>& nodes = expression.nodes();
  std::vector<R> stack;  // operands stand before their operators
  CostMeter<R> meter;
  for (std::size_t i = nodes[root].first; i <= root; ++i) {
    const Expression::Node& node = nodes[i];
    try {
      if (node.kind == Expression::Kind::number) {
        stack.push_back(literal(node.value, node.half_unit));
      } else if (node.kind == Expression::Kind::name) {
        stack.push_back(lookup(node.name, node));
      } else {
        detail::apply(expression, node, stack, meter);
      }
    } catch (const OutsideRing& error) {
      throw OutsideRingError(expression.locate(node, error.what()));
    } catch (const std::domain_error& error) {
      throw InputError(expression.locate(node, error.what()));
    }
  }
  return std::move(stack.back());
}

/// The value of the whole expression, numbers taken as their exact values.
template <class R, class Lookup>
R evaluate(const Expression& expression, const Lookup& lookup) {
  return evaluate<R>(expression, expression.root(), lookup, ExactLiteral<R>{});
}

/// A constant's value. Names are errors (InputError).
template <class R>
R evaluate_constant(const Expression& expression) {
  return evaluate<R>(expression, [&](const std::string& name, const Expression::Node& node) -> R {
    throw InputError(expression.locate(node, "expected a number, found the name " + in_quotes(name)));
  });
}

}  // namespace subdiv
