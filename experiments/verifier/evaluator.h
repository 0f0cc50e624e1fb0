#pragma once

#include <map>
#include <string>
#include <vector>

#include "experiments/verifier/quotient.h"
#include "experiments/verifier/term.h"

namespace subdiv::verifier {

/// A rational function, or a list of values.
struct Value {
  Quotient number{};
  std::vector<Value> items{};
  bool is_list = false;

  Value() = default;
  Value(Quotient q) : number(std::move(q)) {}
  Value(std::vector<Value> list) : items(std::move(list)), is_list(true) {}
};

/// The rational function, the list, that a value is; Rejected when it is the other.
[[nodiscard]] const Quotient& scalar(const Value& v);
[[nodiscard]] const std::vector<Value>& list(const Value& v);

[[nodiscard]] Value operator+(const Value& a, const Value& b);
[[nodiscard]] Value operator-(const Value& a, const Value& b);
/// Number times list, matrix times vector or matrix, vector times matrix, dot product.
[[nodiscard]] Value operator*(const Value& a, const Value& b);
[[nodiscard]] Quotient determinant(const Value& matrix);
[[nodiscard]] Value transposed(const Value& matrix);

struct Function {
  std::vector<std::string> parameters;
  Term body;
};

/// What names mean. Names that stand nowhere are indeterminates.
struct Names {
  std::map<std::string, Value> values;
  std::map<std::string, Function> functions;
};

/// Rejected when the term has no value.
[[nodiscard]] Value evaluate(const Term& term, const Names& names);
[[nodiscard]] inline Value evaluate(std::string_view text, const Names& names) {
  return evaluate(parse_term(text), names);
}

}  // namespace subdiv::verifier
