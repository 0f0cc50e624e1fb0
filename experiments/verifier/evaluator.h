#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/verifier/quotient.h"
#include "experiments/verifier/term.h"

namespace subdiv::verifier {

/// A rational function, or a list of values, which copies share.
class Value {
 public:
  Value() = default;
  Value(Quotient q) : number_(std::move(q)) {}
  Value(std::vector<Value> list) : items_(std::make_shared<const std::vector<Value>>(std::move(list))) {}

  [[nodiscard]] bool is_list() const { return items_ != nullptr; }
  /// Of what is no list.
  [[nodiscard]] const Quotient& number() const { return number_; }
  /// Of a list; empty for others.
  [[nodiscard]] const std::vector<Value>& items() const {
    static const std::vector<Value> none;
    return items_ ? *items_ : none;
  }

 private:
  Quotient number_{};
  std::shared_ptr<const std::vector<Value>> items_{};
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
  std::set<std::string> roots;  // indeterminates that obey an equation
};
/// Whether the language itself has a function of this name.
[[nodiscard]] bool is_built_in(const std::string& name);

/// Rejected when the term has no value.
[[nodiscard]] Value evaluate(const Term& term, const Names& names);
[[nodiscard]] inline Value evaluate(std::string_view text, const Names& names) {
  return evaluate(parse_term(text), names);
}

}  // namespace subdiv::verifier
