#include "experiments/report/pages.h"

#include "experiments/report/html_errata.h"
#include "experiments/report/html_explorer.h"
#include "experiments/report/html_report.h"
#include "experiments/report/markdown.h"

namespace subdiv {

std::vector<std::string> page_names() {
  return {"README.md", "report/index.html", "report/errata.html", "report/explorer.html"};
}

std::vector<Page> derived_pages(const ReportSource& source) {
  const std::vector<std::string> names = page_names();
  return {{names[0], results_page(source.experiments, source.claims, *source.manifest)},
          {names[1], report_page(source)},
          {names[2], errata_page(source)},
          {names[3], explorer_page(source)}};
}

}  // namespace subdiv
