#pragma once

#include <span>
#include <string>
#include <vector>

#include "experiments/report/record.h"

namespace subdiv {

/// Whether a claim is sharpened: a printed bound or range that is reproduced and for which more is proved. A
/// claim is a bound or range when its kind is bound, or its printed string has one of < > ≤ ≥ or the word
/// "range". More is proved when the value of a bound lies strictly inside, or when there are findings of
/// sharper_findings().
[[nodiscard]] bool is_sharpened(const ClaimRecord& claim, std::span<const ClaimRecord> claims);

/// The established findings that say more than a claim: those below its id ("fit.b2.edge-bound.sharp"), those
/// that its note or definition names, and those of the same section about the same thing (the first and the
/// third part of the id and on: "smooth.exact.c1.lower" for "smooth.sufficient.c1.lower" and for
/// "smooth.list.c1"). Ids, in the order of `claims`.
[[nodiscard]] std::vector<std::string> sharper_findings(const ClaimRecord& claim,
                                                        std::span<const ClaimRecord> claims);

/// What the pages say of the word.
[[nodiscard]] std::string sharpened_definition();

}  // namespace subdiv
