#pragma once

#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>

#include "experiments/experiment.h"
#include "experiments/report/html_figure.h"

namespace subdiv {

/// All that the pages are made of.
struct ReportSource {
  std::span<const Experiment> experiments;
  std::span<const ClaimRecord> claims;
  const Manifest* manifest = nullptr;
  std::function<std::string(const std::string& name)> picture;  // a figure's SVG; empty where there is none
  std::function<std::string(const std::string& name)> series = {};  // a table's CSV; the same
};

/// What claims of one page have in common.
struct ClaimContext {
  ReportSource source;
  FigurePlaces figures;
  std::set<std::string> ids;
};
[[nodiscard]] ClaimContext context_of(const ReportSource& source);

/// A claim as an article with the claim's id: the mark of its verdict, where it stands, what is printed, the
/// value, what is true, the definition, sharper findings, the certificate, its figures.
[[nodiscard]] std::string html_claim(const ClaimRecord& claim, const ClaimContext& context);

/// A claim's value as HTML: the exact text, the digits that are certain and the enclosure, as far as there
/// are any; the brief one leaves the enclosure out, and exact text that is long.
enum class ValueLength { full, brief };
[[nodiscard]] std::string html_value(const ClaimRecord& claim, ValueLength length = ValueLength::full);

/// Whether a printed claim does not hold, is not supported or cannot be recomputed: whether the errata have
/// it.
[[nodiscard]] bool is_erratum(const ClaimRecord& claim);

/// The address of a claim's certificate, seen from the page; nothing where it has none.
[[nodiscard]] std::optional<std::string> certificate_address(const ClaimRecord& claim,
                                                             const Manifest& manifest);

}  // namespace subdiv
