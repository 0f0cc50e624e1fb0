#include "experiments/certificates/claim_certificates.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <thread>
#include <utility>

#include "experiments/certificates/statement_file.h"
#include "experiments/claim.h"
#include "schemes/algebra/thread_caches.h"
#include "schemes/input_error.h"

namespace subdiv {

namespace fs = std::filesystem;

std::map<std::string, Statement> claim_statements(const fs::path& data) {
  const fs::path folder = data / "statements";
  std::error_code ignored;
  if (!fs::exists(folder, ignored)) return {};
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".statements") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  std::map<std::string, Statement> statements;
  for (const fs::path& file : files) {
    for (WrittenStatement& written : read_statements(file)) {
      const std::string claim = written.statement.claim;
      if (!statements.emplace(claim, std::move(written.statement)).second) {
        throw InputError(file.string() + ":" + std::to_string(written.line) +
                         ": another file has a statement of " + claim + ", too");
      }
    }
  }
  return statements;
}

std::vector<ClaimCertificate> claim_certificates(std::span<const ClaimRecord> claims, const fs::path& data,
                                                 int jobs) {
  const std::map<std::string, Statement> statements = claim_statements(data);
  std::vector<std::pair<const ClaimRecord*, const Statement*>> work;
  for (const ClaimRecord& claim : claims) {
    const auto found = statements.find(claim.id);
    if (found != statements.end() && wants_certificate(claim)) work.emplace_back(&claim, &found->second);
  }
  std::vector<ClaimCertificate> result(work.size());
  std::atomic<std::size_t> next = 0;
  const auto take = [&] {
    for (std::size_t i = next++; i < work.size(); i = next++) {
      const auto& [claim, statement] = work[i];
      result[i].claim = claim->id;
      try {
        result[i].text = verifier::to_text(prove(filled(*statement, *claim), data));
      } catch (const std::exception& error) {
        result[i].failure = error.what();
      }
    }
  };
  std::vector<std::thread> threads;
  for (int k = 1; k < jobs; ++k) {
    threads.emplace_back([&] {
      take();
      release_thread_caches();
    });
  }
  take();
  for (std::thread& thread : threads) thread.join();
  return result;
}

bool wants_certificate(const ClaimRecord& claim) {
  return claim.rigour != to_string(Rigour::approximate) &&
         claim.verdict != to_string(Verdict::not_reproducible) &&
         claim.verdict != to_string(Verdict::undecided);
}

}  // namespace subdiv
