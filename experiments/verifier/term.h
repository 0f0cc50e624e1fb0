#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "schemes/algebra/rational.h"

namespace subdiv::verifier {

/// An expression of the language of certificates (experiments/certificates/README.md), as a tree.
struct Term {
  enum class Kind { number, name, list, index, negate, add, subtract, multiply, divide, power, call };
  Kind kind = Kind::number;
  Rational value{};    // of a number
  std::string name{};  // of a name or a call
  std::vector<Term> operands{};
};

/// Rejected when the text is no expression, or nested deeper than 200.
[[nodiscard]] Term parse_term(std::string_view text);

}  // namespace subdiv::verifier
