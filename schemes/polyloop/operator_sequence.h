#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "schemes/expression.h"
#include "schemes/polyloop/polyloop_operator.h"

namespace subdiv {

/// An operator as written: its name and the values in its parentheses, unevaluated.
struct OperatorCall {
  /// The operators; family: a scheme of the catalogue, such as J(s).
  enum class Kind { refine, dual, tuck, untuck, tweak, family };
  Kind kind = Kind::refine;        ///< which of them
  std::vector<Expression> values;  ///< one for each parameter
  std::string text;                ///< "tuck(-s/8)"
};

/// A sequence of operators on polyloops as polyloops 2 and 3 write them.
struct OperatorSequence {
  std::string text;                 ///< as written
  std::vector<OperatorCall> calls;  ///< in the order of the text, each once
  std::vector<std::size_t> order;   ///< numbers of calls as they follow each other, repetitions written out
  /// Names that stand in values, by first appearance: free parameter i is the indeterminate x_i.
  std::vector<std::string> free_parameters;
};

/// Longer sequences are refused: they would rather be repeated.
inline constexpr std::size_t longest_sequence = 10000;

/// Reads
///
///     SEQUENCE = ITEM { ; ITEM } [ ; ]
///     ITEM     = ( OPERATOR | "{" SEQUENCE "}" ) [ ^ N ]          N = 1, 2, .. times
///     OPERATOR = refine | split | dual | tuck(t) | untuck | tweak(old, new) | J(s)
///
/// split is refine and untuck is tuck(-1) (polyloop_operator.h); J(s) is {refine; tuck(1/2); tuck(-s/8)}. A
/// value is an exact expression (schemes/expression.h), a name in it leaves a parameter free. Throws
/// InputError with the column, what is wrong there and what fits.
[[nodiscard]] OperatorSequence parse_operators(std::string_view text);

/// The operator of a call; lookup(name, node) gives a name's value, literal(value, half_unit) a number's.
template <class R, class Lookup, class Literal>
PolyloopOperator<R> operator_of(const OperatorCall& call, const Lookup& lookup, const Literal& literal) {
  const auto value = [&](std::size_t i) {
    return evaluate<R>(call.values[i], call.values[i].root(), lookup, literal);
  };
  switch (call.kind) {
    case OperatorCall::Kind::refine:
      return polyloop::refine<R>();
    case OperatorCall::Kind::dual:
      return polyloop::dual<R>();
    case OperatorCall::Kind::tuck:
      return polyloop::tuck(value(0));
    case OperatorCall::Kind::untuck:
      return polyloop::untuck<R>();
    case OperatorCall::Kind::tweak:
      return polyloop::tweak(value(0), value(1));
    case OperatorCall::Kind::family:
      return composed(composed(polyloop::refine<R>(), polyloop::tuck(fraction<R>(1, 2))),
                      polyloop::tuck(value(0) * fraction<R>(-1, 8)));
  }
  throw std::logic_error("an operator without a kind");
}

/// The operators of the calls over a ring R, in the order of OperatorSequence::calls; free_values[i] stands
/// for the free parameter i (std::domain_error unless there is one for each). InputError where a value does
/// not exist, such as 1/0; OutsideRingError for a root that R does not hold.
template <class R, class Literal = ExactLiteral<R>>
std::vector<PolyloopOperator<R>> operators_of(const OperatorSequence& sequence,
                                              std::span<const R> free_values = {},
                                              const Literal& literal = {}) {
  if (free_values.size() != sequence.free_parameters.size())
    throw std::domain_error("a sequence of operators needs a value for every free parameter");
  const auto lookup = [&](const std::string& name, const Expression::Node& /*node*/) {
    std::size_t i = 0;
    while (sequence.free_parameters[i] != name) ++i;
    return free_values[i];
  };
  std::vector<PolyloopOperator<R>> result;
  for (const OperatorCall& call : sequence.calls) {
    try {
      result.push_back(operator_of<R>(call, lookup, literal));
    } catch (const OutsideRingError& error) {
      throw OutsideRingError(in_quotes(call.text) + ": " + error.what());
    } catch (const InputError& error) {
      throw InputError(in_quotes(call.text) + ": " + error.what());
    }
  }
  return result;
}

/// The composed operator of the whole sequence.
template <class R>
PolyloopOperator<R> composed_operator(const OperatorSequence& sequence, std::span<const R> free_values = {}) {
  const std::vector<PolyloopOperator<R>> operators = operators_of<R>(sequence, free_values);
  std::vector<PolyloopOperator<R>> steps;
  for (const std::size_t i : sequence.order) steps.push_back(operators[i]);
  return subdiv::sequence(steps);
}

/// The operators in double, each coefficient the nearest number but for the last unit. InputError where free
/// parameters have no value, a value does not exist, or it leaves the range of doubles.
[[nodiscard]] std::vector<PolyloopOperator<double>> operators_in_double(const OperatorSequence& sequence);

}  // namespace subdiv
