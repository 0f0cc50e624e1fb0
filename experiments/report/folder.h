#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiments/report/json.h"
#include "experiments/run.h"

namespace subdiv {

/// A results folder as it stands on disk: claims.json and manifest.json (README.md, report/ and claims.csv
/// are derived from them).
struct ResultsFolder {
  std::vector<ClaimRecord> claims;
  Manifest manifest;
};

/// Reads a folder. Throws InputError when claims.json is missing, or either file does not parse; a missing
/// manifest is empty.
[[nodiscard]] ResultsFolder load_results(const std::filesystem::path& folder);
/// The same, but nothing when there is no claims.json.
[[nodiscard]] std::optional<ResultsFolder> load_results_if_any(const std::filesystem::path& folder);

/// What the folder shall hold after a run: claims, series and figures of the experiments that ran to their
/// end replace the old ones; those of broken experiments, and of experiments that were not run, stay as they
/// were. After a run of everything, what belongs to no experiment any more is left out. Claims stand in the
/// order of `all`.
[[nodiscard]] ResultsFolder merge(std::span<const Experiment> all, std::span<const Outcome> outcomes,
                                  const ResultsFolder& old, bool ran_everything);

/// Draws the figures of the outcomes and writes the folder: series, figures, the derived pages (README.md,
/// report/), claims.csv, manifest.json and last claims.json, each whole; files that `old` lists and `merged`
/// does not are removed. Nothing changes when drawing or writing fails (InputError, std::runtime_error).
void write_results(const std::filesystem::path& folder, std::span<const Experiment> all,
                   std::span<const Outcome> outcomes, const ResultsFolder& old, const ResultsFolder& merged);

/// What is wrong with the derived pages of a folder: those that are missing or are not what its claims,
/// manifest and figures give.
[[nodiscard]] std::vector<std::string> page_differences(const std::filesystem::path& folder,
                                                        std::span<const Experiment> all,
                                                        const ResultsFolder& committed);

[[nodiscard]] std::filesystem::path series_path(const std::filesystem::path& folder, const std::string& name);
[[nodiscard]] std::filesystem::path figure_path(const std::filesystem::path& folder, const std::string& name);

}  // namespace subdiv
