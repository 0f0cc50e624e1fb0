#include "experiments/cli/chosen_experiments.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "experiments/data.h"
#include "experiments/own_claims.h"
#include "experiments/report/folder.h"
#include "schemes/input_error.h"
#include "schemes/text.h"

namespace subdiv::cli {

std::vector<Experiment> chosen_experiments(const std::string& claims_file) {
  if (!claims_file.empty()) return own_experiments(read_own_claims(claims_file));
  const auto all = experiments();
  return {all.begin(), all.end()};
}

std::string chosen_folder(const std::string& given, const std::string& claims_file,
                          const std::string& option) {
  if (!given.empty()) return given;
  if (claims_file.empty()) return "results";
  throw InputError("--claims " + claims_file +
                   ": name the results folder of your own claims, too: " + option + " DIR");
}

void require_own_folder(const std::string& folder, const std::string& claims_file,
                        const std::vector<Experiment>& own) {
  if (claims_file.empty()) return;
  std::set<std::string> ids;
  for (const Experiment& experiment : experiments()) {
    for (const ClaimHead& head : experiment.heads()) ids.insert(head.id);
  }
  for (const Experiment& experiment : own) {
    for (const ClaimHead& head : experiment.heads()) ids.erase(head.id);
  }
  const auto there = load_results_if_any(folder);
  if (!there) return;
  for (const ClaimRecord& claim : there->claims) {
    if (!ids.contains(claim.id)) continue;
    throw InputError(
        fmt::format("{} holds the claims of the papers, {} among them; name another folder for those of {}",
                    folder, in_quotes(claim.id), claims_file));
  }
}

std::vector<ClaimRecord> computed_claims(std::span<const Outcome> outcomes) {
  std::vector<ClaimRecord> result;
  for (const Outcome& outcome : outcomes) {
    if (outcome.broke()) continue;
    for (const Claim& claim : outcome.results.claims) result.push_back(to_record(claim));
  }
  return result;
}

std::vector<ClaimCertificate> chosen_certificates(const std::string& claims_file,
                                                  std::span<const ClaimRecord> claims, int jobs) {
  if (!claims_file.empty()) return {};
  return claim_certificates(claims, data_folder(), jobs);
}

}  // namespace subdiv::cli
