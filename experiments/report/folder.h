#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiments/certificates/claim_certificates.h"
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

/// Lists the certificates in the manifest: those of the claims that were looked at are new, those of other
/// claims stay.
void list_certificates(ResultsFolder& merged, const ResultsFolder& old,
                       std::span<const ClaimRecord> looked_at,
                       std::span<const ClaimCertificate> certificates);

/// Draws the figures of the outcomes and writes the folder: series, figures, the derived pages (README.md,
/// report/), claims.csv, manifest.json and last claims.json, each whole; files that `old` lists and `merged`
/// does not are removed. Nothing changes when drawing or writing fails (InputError, std::runtime_error).
void write_results(const std::filesystem::path& folder, std::span<const Experiment> all,
                   std::span<const Outcome> outcomes, const ResultsFolder& old, const ResultsFolder& merged,
                   std::span<const ClaimCertificate> certificates = {});

/// How the certificates of claims differ from those that a folder holds.
[[nodiscard]] std::vector<std::string> certificate_differences(
    const std::filesystem::path& folder, const ResultsFolder& committed,
    std::span<const ClaimRecord> looked_at, std::span<const ClaimCertificate> certificates);

/// What is wrong with the derived pages of a folder: those that are missing or are not what its claims,
/// manifest and figures give.
[[nodiscard]] std::vector<std::string> page_differences(const std::filesystem::path& folder,
                                                        std::span<const Experiment> all,
                                                        const ResultsFolder& committed);

[[nodiscard]] std::filesystem::path series_path(const std::filesystem::path& folder, const std::string& name);
[[nodiscard]] std::filesystem::path figure_path(const std::filesystem::path& folder, const std::string& name);
[[nodiscard]] std::filesystem::path certificate_path(const std::filesystem::path& folder,
                                                     const std::string& claim);

}  // namespace subdiv
