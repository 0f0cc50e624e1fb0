#pragma once

#include <string>

#include "experiments/report/html_claim.h"

namespace subdiv {

/// results/report/index.html: every claim by document and section, with its figures, and filters; one file
/// that needs nothing else.
[[nodiscard]] std::string report_page(const ReportSource& source);

}  // namespace subdiv
