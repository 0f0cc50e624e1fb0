#pragma once

#include <span>
#include <string>
#include <vector>

#include "experiments/certificates/claim_certificates.h"
#include "experiments/experiment.h"
#include "experiments/run.h"

namespace subdiv::cli {

/// The built-in experiments, or those of a file of one's own claims where one is named.
[[nodiscard]] std::vector<Experiment> chosen_experiments(const std::string& claims_file);

/// The results folder of a run: the one given, else "results". With a file of one's own claims it must be
/// given, by the named option, and may not hold claims that are not in the file: InputError.
[[nodiscard]] std::string chosen_folder(const std::string& given, const std::string& claims_file,
                                        const std::string& option);
void require_own_folder(const std::string& folder, const std::string& claims_file,
                        const std::vector<Experiment>& own);

/// The claims that a run has settled.
[[nodiscard]] std::vector<ClaimRecord> computed_claims(std::span<const Outcome> outcomes);
/// The certificates of built-in claims; none for a file of one's own claims.
[[nodiscard]] std::vector<ClaimCertificate> chosen_certificates(const std::string& claims_file,
                                                                std::span<const ClaimRecord> claims,
                                                                int jobs);

}  // namespace subdiv::cli
