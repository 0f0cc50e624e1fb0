#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>

#include "experiments/certificates/claim_certificates.h"
#include "experiments/certificates/statement_file.h"
#include "experiments/cli/verbs.h"
#include "experiments/data.h"
#include "experiments/report/files.h"
#include "experiments/report/folder.h"
#include "experiments/verifier/certificate.h"
#include "experiments/verifier/claim_value.h"
#include "schemes/input_error.h"

namespace subdiv::cli {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> certificates_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".txt") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  if (files.empty()) throw InputError(folder.string() + ": there are no certificates (*.txt) in this folder");
  return files;
}

/// Rejected unless the certificate states what the data folder has as the claim's statement.
void check_statement(const verifier::Certificate& certificate,
                     const std::map<std::string, Statement>& statements, const ClaimRecord& claim) {
  const auto found = statements.find(certificate.claim);
  verifier::need(found != statements.end(), "the data folder has no statement of this claim");
  const Statement expected = filled(found->second, claim);
  const bool same_head = std::equal(
      expected.head.begin(), expected.head.end(), certificate.head.begin(), certificate.head.end(),
      [](const std::string& line, const std::string& written) { return written.starts_with(line + " "); });
  verifier::need(same_head && expected.lines == certificate.statement,
                 "this is not the claim's statement in the data folder");
}

/// The claims that the results folder around a folder of certificates holds, by id.
std::optional<std::map<std::string, ClaimRecord>> claims_beside(const fs::path& folder) {
  const auto results = load_results_if_any(fs::absolute(folder).lexically_normal().parent_path());
  if (!results) return std::nullopt;
  std::map<std::string, ClaimRecord> claims;
  for (const ClaimRecord& record : results->claims) claims[record.id] = record;
  return claims;
}

}  // namespace

int verify(const VerifyOptions& options) {
  const fs::path data = data_folder();
  int proved = 0;
  int rejected = 0;
  for (const std::string& path : options.paths) {
    const fs::path place = path;
    std::error_code ignored;
    const bool is_folder = fs::is_directory(place, ignored);
    if (!is_folder && !fs::exists(place, ignored)) {
      throw InputError(
          place.string() +
          ": there is no such folder or file; 'subdivlab reproduce' writes results/certificates");
    }
    const auto statements = is_folder ? claim_statements(data) : std::map<std::string, Statement>();
    auto claims = is_folder ? claims_beside(place) : std::nullopt;
    for (const fs::path& file : is_folder ? certificates_in(place) : std::vector<fs::path>{place}) {
      try {
        const verifier::Certificate certificate = verifier::parse_certificate(read_file(file));
        verifier::need(!is_folder || certificate.claim == file.stem().string(),
                       "the file is named after another claim");
        const verifier::Context context = verifier::check(certificate, data);
        if (claims) {
          const auto claim = claims->find(certificate.claim);
          verifier::need(claim != claims->end(), "claims.json has no such claim");
          check_statement(certificate, statements, claim->second);
          verifier::check_claim_value(context.values, context.ranges,
                                      {claim->second.exact, claim->second.lower, claim->second.upper});
          claims->erase(claim);
        }
        ++proved;
        if (options.print_statement) {
          std::cout << verifier::in_words(certificate) << "\n";
        } else if (!is_folder) {
          std::cout << file.string() << ": proved\n";
        }
      } catch (const verifier::Rejected& error) {
        ++rejected;
        std::cerr << "subdivlab: " << file.string() << ": rejected: " << error.what() << "\n";
      }
    }
    if (!claims) continue;
    std::erase_if(*claims, [](const auto& entry) { return !wants_certificate(entry.second); });
    std::cout << claims->size() << " exact or certified claims have no certificate"
              << (options.missing || claims->empty() ? "\n" : " (--missing lists them)\n");
    if (options.missing) {
      for (const auto& [id, record] : *claims) std::cout << id << "\n";
    }
  }
  std::cout << proved << " certificates proved, " << rejected << " rejected\n";
  return rejected > 0 ? ExitCode::differs : ExitCode::done;
}

}  // namespace subdiv::cli
