#pragma once

#include <span>
#include <string>
#include <vector>

#include "experiments/report/record.h"

namespace subdiv {

/// A document whose claims are examined, as pages speak of it.
struct Document {
  std::string key;    // "jsplines", as in claims.json
  std::string title;  // "J-splines (Rossignac & Schaefer 2008)"
  std::string about;  // one sentence
};

/// The documents that claims come from, in the order of the pages: the five papers, then documents of other
/// keys as they occur, then subdivlab's own findings.
[[nodiscard]] std::vector<Document> documents_of(std::span<const ClaimRecord> claims);

/// A claim's section without the other documents that it names: "3" of "3 (js-report 3)"; "3" of a finding's
/// "jsplines 3", too.
[[nodiscard]] std::string own_section(const ClaimRecord& claim);

/// Where a claim stands, in words: "section 3; also js-report, section 3"; for a finding what it belongs to:
/// "on jsplines, section 3".
[[nodiscard]] std::string place_of(const ClaimRecord& claim);

/// The document that a finding belongs to, "jsplines" of "jsplines 3", and a printed claim's own.
[[nodiscard]] std::string subject_of(const ClaimRecord& claim);

}  // namespace subdiv
