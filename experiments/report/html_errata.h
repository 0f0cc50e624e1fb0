#pragma once

#include <string>

#include "experiments/report/html_claim.h"

namespace subdiv {

/// results/report/errata.html, a page for the authors of the documents: for each document what is printed and
/// does not hold, with what is true, how that was decided and how to redo it; statements that measurements do
/// not support; and what could not be recomputed, with what is missing.
[[nodiscard]] std::string errata_page(const ReportSource& source);

}  // namespace subdiv
