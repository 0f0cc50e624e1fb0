#include "experiments/report/markdown.h"

#include <algorithm>
#include <cstddef>
#include <set>

namespace subdiv {
namespace {

constexpr std::size_t value_width = 44;

std::string table(std::span<const ClaimRecord* const> claims) {
  std::string text = "| claim | document | printed | value | rigour | verdict |\n|---|---|---|---|---|---|\n";
  for (const ClaimRecord* claim : claims) {
    text += "| " + markdown_text(claim->id) + " | " + markdown_text(claim->document + " " + claim->section) +
            " | " + markdown_text(claim->printed.value_or("")) + " | " +
            markdown_text(value_text(*claim, value_width)) + " | " + claim->rigour + " | " +
            (claim->verdict == "refuted" ? "**refuted**" : claim->verdict) + " |\n";
  }
  return text;
}

/// The claims of one experiment, in the order of its table.
std::vector<const ClaimRecord*> claims_of(const Experiment& experiment, std::span<const ClaimRecord> claims,
                                          std::set<std::string>& shown) {
  std::vector<const ClaimRecord*> result;
  for (const ClaimHead& head : experiment.heads()) {
    for (const ClaimRecord& claim : claims) {
      if (claim.id != head.id) continue;
      result.push_back(&claim);
      shown.insert(claim.id);
    }
  }
  return result;
}

std::string refuted_paragraphs(std::span<const ClaimRecord> claims) {
  std::string text;
  for (const ClaimRecord& claim : claims) {
    if (claim.verdict != "refuted") continue;
    text += "**" + markdown_text(claim.id) + "** (" + markdown_text(claim.document + " " + claim.section);
    if (claim.printed) text += ", printed: " + markdown_text(*claim.printed);
    text += "). " + markdown_text(claim.note) + "\n\n";
  }
  return text;
}

}  // namespace

std::string markdown_text(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\n') {
      result += ' ';
      continue;
    }
    if (std::string_view("\\`*_[]<>|#~$").find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

std::string verdict_count(std::span<const ClaimRecord> claims) {
  struct Column {
    const char* verdict;
    bool always;
  };
  constexpr Column columns[] = {{"reproduced", true},       {"refuted", true},     {"established", true},
                                {"undecided", true},        {"consistent", false}, {"inconsistent", false},
                                {"not-reproducible", false}};
  std::string text = std::to_string(claims.size()) + (claims.size() == 1 ? " claim" : " claims");
  std::string separator = ": ";
  for (const auto& [verdict, always] : columns) {
    const auto count = std::count_if(claims.begin(), claims.end(),
                                     [&](const ClaimRecord& c) { return c.verdict == verdict; });
    if (count == 0 && !always) continue;
    text += separator + std::to_string(count) + " " + verdict;
    separator = ", ";
  }
  return text;
}

std::string results_page(std::span<const Experiment> experiments, std::span<const ClaimRecord> claims,
                         const Manifest& manifest) {
  std::string text =
      "# Results\n\nWritten by `subdivlab reproduce`; not to be edited by hand. " + verdict_count(claims) +
      ".\nDefinitions, full digits and notes stand in [claims.json](claims.json) and "
      "[claims.csv](claims.csv), the numbers behind the figures in series/. The same with filters and the "
      "figures beside the claims: [report/index.html](report/index.html); for the authors of the "
      "documents: [report/errata.html](report/errata.html).\n";
  std::set<std::string> shown;
  for (const Experiment& experiment : experiments) {
    const auto own = claims_of(experiment, claims, shown);
    if (!own.empty()) text += "\n## " + markdown_text(experiment.title) + "\n\n" + table(own);
  }
  std::vector<const ClaimRecord*> others;
  for (const ClaimRecord& claim : claims) {
    if (!shown.contains(claim.id)) others.push_back(&claim);
  }
  if (!others.empty()) text += "\n## Claims that no experiment owns\n\n" + table(others);
  if (const std::string refuted = refuted_paragraphs(claims); !refuted.empty()) {
    text += "\n## What is true instead of the refuted claims\n\n" + refuted;
    text.pop_back();
  }
  if (!manifest.figures.empty()) text += "\n## Figures\n";
  for (const FileEntry& figure : manifest.figures) {
    text += "\n![" + markdown_text(figure.title) + "](figures/" + figure.name + ".svg)\n";
  }
  return text;
}

}  // namespace subdiv
