#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "experiments/report/folder.h"

namespace subdiv {

/// What differs between a claim as committed and as found now, one line a difference; empty when nothing
/// does. Verdict, rigour and what the document says are compared as text, and so are exact values. Enclosures
/// must overlap, and the new one may be no wider than the committed one but for the rounding of the printed
/// ends; a committed one a thousand times wider than the new is stale. Approximate ends are printed to the
/// digits that are believed, so they compare the same way. Notes are not compared.
[[nodiscard]] std::vector<std::string> differences(const ClaimRecord& committed, const ClaimRecord& found);

/// Differences between two series as CSV text: cells are equal as text, or both decimals with a point that
/// differ by at most one unit in the last digit of either.
[[nodiscard]] std::vector<std::string> series_differences(const std::string& file,
                                                          const std::string& committed,
                                                          const std::string& found);

/// Compares a results folder with the outcomes of a fresh run, for the claims that `chosen` accepts: claims
/// one by one, missing and superfluous ones, series cell by cell, figures by being there. Broken experiments
/// are left out.
[[nodiscard]] std::vector<std::string> compare(const std::filesystem::path& folder,
                                               const ResultsFolder& committed,
                                               std::span<const Outcome> outcomes,
                                               const std::function<bool(const std::string& id)>& chosen);

}  // namespace subdiv
