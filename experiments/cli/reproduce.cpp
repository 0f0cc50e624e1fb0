#include <algorithm>
#include <filesystem>
#include <iostream>

#include "experiments/cli/chosen_experiments.h"
#include "experiments/cli/progress.h"
#include "experiments/cli/verbs.h"
#include "experiments/report/files.h"
#include "experiments/report/folder.h"
#include "experiments/report/gnuplot.h"
#include "experiments/report/markdown.h"
#include "experiments/report/table.h"
#include "experiments/selection.h"
#include "schemes/input_error.h"

namespace subdiv::cli {
namespace {

/// What the folder holds before the run. A run of everything replaces it, so there a folder that does not
/// parse is no error.
ResultsFolder old_results(const std::filesystem::path& folder, bool replaces_everything) {
  try {
    return load_results_if_any(folder).value_or(ResultsFolder{});
  } catch (const InputError& error) {
    if (!replaces_everything) throw;
    std::cerr << "subdivlab: " << error.what() << "\nsubdivlab: this run replaces it\n";
    return {};
  }
}

/// Reports claims whose verdict is not what the folder held before.
int count_changed_verdicts(const ResultsFolder& old, std::span<const ClaimRecord> claims) {
  int changed = 0;
  for (const ClaimRecord& claim : claims) {
    const auto before = std::find_if(old.claims.begin(), old.claims.end(),
                                     [&](const ClaimRecord& c) { return c.id == claim.id; });
    if (before == old.claims.end() || before->verdict == claim.verdict) continue;
    std::cerr << "subdivlab: " << claim.id << ": the verdict was " << before->verdict << ", it is now "
              << claim.verdict << "\n";
    ++changed;
  }
  return changed;
}

}  // namespace

int reproduce(const ReproduceOptions& options) {
  const std::string out = chosen_folder(options.out, options.claims, "--out");
  const std::vector<Experiment> all = chosen_experiments(options.claims);
  const Selection selection = select(all, options.patterns);
  require_gnuplot();
  require_own_folder(out, options.claims, all);
  const std::filesystem::path folder = out;
  const ResultsFolder old = old_results(folder, selection.everything);
  prepare_folder(folder);

  Progress progress(selection.experiments.size());
  const auto outcomes = run(selection.experiments, options.jobs,
                            [&](const Experiment& experiment) { progress.finished(experiment.name); });
  ResultsFolder merged = merge(all, outcomes, old, selection.everything);
  const std::vector<ClaimRecord> computed = computed_claims(outcomes);
  const std::vector<ClaimCertificate> certificates =
      chosen_certificates(options.claims, computed, options.jobs);
  list_certificates(merged, old, computed, certificates);
  write_results(folder, all, outcomes, old, merged, certificates);

  std::vector<ClaimRecord> chosen;
  std::copy_if(merged.claims.begin(), merged.claims.end(), std::back_inserter(chosen),
               [&](const ClaimRecord& claim) { return selection.ids.contains(claim.id); });
  const auto broken =
      std::count_if(outcomes.begin(), outcomes.end(), [](const Outcome& o) { return o.broke(); });
  std::cout << claims_table(chosen) << "\n" << verdict_count(chosen) << "\n" << std::flush;
  for (const Outcome& outcome : outcomes) {
    if (!outcome.broke()) continue;
    std::cerr << "subdivlab: experiment '" << outcome.experiment->name
              << "' broke, its claims stay as they were: " << outcome.error << "\n";
  }
  const auto unproved =
      std::ranges::count_if(certificates, [](const ClaimCertificate& c) { return c.text.empty(); });
  for (const ClaimCertificate& certificate : certificates) {
    if (certificate.text.empty())
      std::cerr << "subdivlab: " << certificate.claim << ": no certificate was found: " << certificate.failure
                << "\n";
  }
  const int changed = count_changed_verdicts(old, chosen);
  if (broken > 0 || changed > 0 || unproved > 0) return ExitCode::differs;
  const bool open = std::any_of(chosen.begin(), chosen.end(), [](const ClaimRecord& c) {
    return c.verdict == to_string(Verdict::undecided);
  });
  return open ? ExitCode::undecided : ExitCode::done;
}

}  // namespace subdiv::cli
