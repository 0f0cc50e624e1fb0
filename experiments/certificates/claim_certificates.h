#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "experiments/certificates/prove.h"
#include "experiments/report/record.h"

namespace subdiv {

/// The certificate of a claim: its text, or why there is none although there is a statement for it.
struct ClaimCertificate {
  std::string claim;
  std::string text;
  std::string failure;
};

/// The certificates of those claims for which the data folder holds a statement (statements/*.statements), in
/// the order of the claims, found on `jobs` threads. Throws InputError when a file of statements is malformed
/// or two of them speak of one claim.
[[nodiscard]] std::vector<ClaimCertificate> claim_certificates(std::span<const ClaimRecord> claims,
                                                               const std::filesystem::path& data, int jobs);

/// The statements of claims that the data folder holds (statements/*.statements), before values are filled
/// in. Errors as above.
[[nodiscard]] std::map<std::string, Statement> claim_statements(const std::filesystem::path& data);

/// Whether a claim is one that a certificate should prove: exact or certified, and decided.
[[nodiscard]] bool wants_certificate(const ClaimRecord& claim);

}  // namespace subdiv
