#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/verifier/statement.h"

namespace subdiv::verifier {

/// What a claim says of its value: exact text, and ends as decimals.
struct ClaimValue {
  std::optional<std::string> exact;
  std::optional<std::string> lower;
  std::optional<std::string> upper;
};

/// Rejected unless the values that a certificate states are the claim's: numbers between its ends, a list the
/// numbers of its text "(a, b, c)". Values with roots are compared by the root's range.
void check_claim_value(const std::vector<Value>& values, const Ranges& ranges, const ClaimValue& claim);

}  // namespace subdiv::verifier
