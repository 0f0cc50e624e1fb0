#pragma once

#include <string>

#include "experiments/report/html_claim.h"

namespace subdiv {

/// The page on which curves are drawn and measured by hand, report/explorer.html: the files of
/// experiments/explorer, with what the claims prove of smoothness, the curves of the documents and stored
/// polygons as data. Self-contained: the library's code is in it as WebAssembly.
[[nodiscard]] std::string explorer_page(const ReportSource& source);

/// The facts (experiments/explorer/facts.h) that the claims and the cells of smoothness-maps prove.
[[nodiscard]] std::string explorer_facts(const ReportSource& source);

}  // namespace subdiv
