#include <iostream>

#include <nlohmann/json.hpp>

#include "experiments/cli/verbs.h"
#include "experiments/experiment.h"
#include "experiments/report/utf8.h"

namespace subdiv::cli {
namespace {

using Json = nlohmann::ordered_json;

void print_claims() {
  std::size_t width = 0;
  for (const Experiment& experiment : experiments()) {
    for (const ClaimHead& head : experiment.heads()) width = std::max(width, display_width(head.id));
  }
  for (const Experiment& experiment : experiments()) {
    std::cout << experiment.title << "\n";
    for (const ClaimHead& head : experiment.heads()) {
      std::cout << "  " << padded(head.id, width + 2) << padded(to_string(head.kind), 18)
                << clipped(head.printed.value_or("(finding) " + head.definition), 100 - width - 22) << "\n";
    }
  }
}

Json claims_json() {
  Json list = Json::array();
  for (const Experiment& experiment : experiments()) {
    for (const ClaimHead& head : experiment.heads()) {
      list.push_back({{"id", head.id},
                      {"experiment", experiment.name},
                      {"document", head.document},
                      {"section", head.section},
                      {"printed", head.printed ? Json(*head.printed) : Json(nullptr)},
                      {"kind", to_string(head.kind)},
                      {"definition", head.definition}});
    }
  }
  return list;
}

}  // namespace

int list(const ListOptions& options) {
  if (options.json) {
    std::cout << Json{{"claims", claims_json()}}.dump(2) << "\n";
  } else {
    print_claims();
  }
  return ExitCode::done;
}

}  // namespace subdiv::cli
