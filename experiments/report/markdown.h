#pragma once

#include <span>
#include <string>

#include "experiments/experiment.h"
#include "experiments/report/json.h"

namespace subdiv {

/// results/README.md: the count of verdicts, one table of claims an experiment, a paragraph for each refuted
/// claim that says what is true, and the figures.
[[nodiscard]] std::string results_page(std::span<const Experiment> experiments,
                                       std::span<const ClaimRecord> claims, const Manifest& manifest);

/// Text that Markdown shows as it stands: its special characters escaped, line breaks as spaces.
[[nodiscard]] std::string markdown_text(const std::string& text);

/// "97 claims: 70 reproduced, 20 refuted, 7 established, 0 undecided"; further verdicts only where they
/// occur.
[[nodiscard]] std::string verdict_count(std::span<const ClaimRecord> claims);

}  // namespace subdiv
