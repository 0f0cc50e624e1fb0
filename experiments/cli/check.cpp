#include <iostream>

#include "experiments/cli/chosen_experiments.h"
#include "experiments/cli/progress.h"
#include "experiments/cli/verbs.h"
#include "experiments/report/compare.h"
#include "experiments/selection.h"

namespace subdiv::cli {
namespace {

/// Claims of the folder that the patterns mean, also those that no experiment owns any more.
bool means(const CheckOptions& options, const std::string& id) {
  if (options.patterns.empty()) return true;
  for (const std::string& pattern : options.patterns) {
    if (matches(pattern, id)) return true;
  }
  return false;
}

}  // namespace

int check(const CheckOptions& options) {
  const std::string against = chosen_folder(options.against, options.claims, "--against");
  const std::vector<Experiment> all = chosen_experiments(options.claims);
  const Selection selection = select(all, options.patterns);
  const ResultsFolder committed = load_results(against);

  std::vector<Outcome> outcomes;
  {
    Progress progress(selection.experiments.size());
    outcomes = run(selection.experiments, options.jobs,
                   [&](const Experiment& experiment) { progress.finished(experiment.name); });
  }
  auto differences =
      compare(against, committed, outcomes, [&](const std::string& id) { return means(options, id); });
  const std::vector<ClaimRecord> computed = computed_claims(outcomes);
  for (std::string& difference : certificate_differences(
           against, committed, computed, chosen_certificates(options.claims, computed, options.jobs)))
    differences.push_back(std::move(difference));
  if (selection.everything) {
    for (std::string& difference : page_differences(against, all, committed))
      differences.push_back(std::move(difference));
  }
  for (const Outcome& outcome : outcomes) {
    if (outcome.broke())
      differences.push_back("experiment '" + outcome.experiment->name + "' broke: " + outcome.error);
  }
  for (const std::string& difference : differences) std::cout << difference << "\n";
  std::cout << selection.ids.size() << " claims checked against " << against << ": " << differences.size()
            << (differences.size() == 1 ? " difference\n" : " differences\n");
  return differences.empty() ? ExitCode::done : ExitCode::differs;
}

}  // namespace subdiv::cli
