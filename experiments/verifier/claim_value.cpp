#include "experiments/verifier/claim_value.h"

#include <sstream>
#include <stdexcept>
#include <utility>

namespace subdiv::verifier {
namespace {

/// Whether a - b >= 0 for all numbers in the ranges, by the coefficients over the whole box.
bool is_at_least(const Quotient& a, const Quotient& b, const Ranges& ranges) {
  const Quotient difference = a - b;
  if (difference.is_number()) return number(difference).sign() >= 0;
  // A quotient has the sign of this product where its denominator is not 0.
  const Quotient same_sign = Quotient(difference.above) * Quotient(difference.below);
  const auto [cover, cell] =
      pose(Condition::sign, !difference.is_polynomial(), {same_sign.above, {}}, ranges);
  return holds(cover, cell, ".");
}

/// The numbers of "(a, b, c)"; nothing when it is no such list.
std::optional<std::vector<Rational>> numbers_in(const std::string& text) {
  if (!text.starts_with('(') || !text.ends_with(')')) return std::nullopt;
  std::vector<Rational> result;
  std::istringstream stream(text.substr(1, text.size() - 2));
  for (std::string part; std::getline(stream, part, ',');) {
    const std::size_t begin = std::min(part.find_first_not_of(' '), part.size());
    try {
      result.push_back(Rational::parse(part.substr(begin)));
    } catch (const std::invalid_argument&) {
      return std::nullopt;
    }
  }
  return result;
}

}  // namespace

void check_claim_value(const std::vector<Value>& values, const Ranges& ranges, const ClaimValue& claim) {
  for (const Value& value : values) {
    if (!value.is_list()) {
      const bool is_within =
          (!claim.lower || is_at_least(value.number(), Rational::parse(*claim.lower), ranges)) &&
          (!claim.upper || is_at_least(Rational::parse(*claim.upper), value.number(), ranges));
      need(is_within, "the value is not the claim's");
      continue;
    }
    const auto numbers = claim.exact ? numbers_in(*claim.exact) : std::nullopt;
    if (!numbers) continue;
    need(numbers->size() == value.items().size(), "the list of values is not the claim's");
    for (std::size_t i = 0; i < numbers->size(); ++i)
      need(number(scalar(value.items()[i])) == (*numbers)[i], "the list of values is not the claim's");
  }
}

}  // namespace subdiv::verifier
