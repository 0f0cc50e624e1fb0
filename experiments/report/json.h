#pragma once

#include <span>
#include <string>
#include <vector>

#include "experiments/report/record.h"

namespace subdiv {

/// What else a results folder holds: one series/NAME.csv or figures/NAME.svg, and the experiment that writes
/// it.
struct FileEntry {
  std::string name;
  std::string experiment;
  std::string title;                     // of a figure, as all below; empty for a series
  std::string shows = {};                // its axes and curves in words
  std::vector<std::string> claims = {};  // the claims that it shows, as in Figure

  friend bool operator==(const FileEntry&, const FileEntry&) = default;
};
struct Manifest {
  std::vector<FileEntry> series;
  std::vector<FileEntry> figures;
  std::vector<std::string> certificates = {};  // the claims that have one
  std::vector<std::string> pages = {};  // what is derived from the rest: "README.md", "report/index.html"
};

/// Names of series and figures become file names: letters, digits, '-', '_' and '.', no '.' in front.
[[nodiscard]] bool is_file_name(const std::string& name);

/// The text of claims.json: {"claims": [{id, document, section, printed, kind, definition, value {exact?,
/// lower, upper}, rigour, verdict, note}]}; printed, lower and upper are null where there is nothing.
[[nodiscard]] std::string claims_to_json(std::span<const ClaimRecord> claims);

/// Reads it back. Throws InputError with `file`, the line and column where the text is not JSON, or the claim
/// and key that is missing or of the wrong type. Unknown keys are ignored.
[[nodiscard]] std::vector<ClaimRecord> claims_from_json(const std::string& text, const std::string& file);

/// The text of manifest.json, and back; errors as above.
[[nodiscard]] std::string manifest_to_json(const Manifest& manifest);
[[nodiscard]] Manifest manifest_from_json(const std::string& text, const std::string& file);

}  // namespace subdiv
