#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "experiments/report/record.h"

namespace subdiv {

/// A table of claims for a terminal: id, printed, value, rigour, verdict, at most `width` columns wide (long
/// ids may need more).
[[nodiscard]] std::string claims_table(std::span<const ClaimRecord> claims, std::size_t width = 100);

}  // namespace subdiv
