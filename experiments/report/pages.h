#pragma once

#include <span>
#include <string>
#include <vector>

#include "experiments/report/html_claim.h"

namespace subdiv {

/// A file that follows from the claims, the manifest and the figures of a results folder.
struct Page {
  std::string name;  // below the folder: "report/index.html"
  std::string text;
};

/// README.md, report/index.html, report/errata.html and report/explorer.html.
[[nodiscard]] std::vector<Page> derived_pages(const ReportSource& source);

/// Their names, in the same order.
[[nodiscard]] std::vector<std::string> page_names();

}  // namespace subdiv
