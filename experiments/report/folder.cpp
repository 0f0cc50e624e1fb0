#include "experiments/report/folder.h"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <string>

#include "experiments/report/csv.h"
#include "experiments/report/files.h"
#include "experiments/report/gnuplot.h"
#include "experiments/report/pages.h"
#include "schemes/input_error.h"

namespace subdiv {
namespace {

namespace fs = std::filesystem;

const Outcome* outcome_of(std::span<const Outcome> outcomes, const Experiment& experiment) {
  const auto found = std::find_if(outcomes.begin(), outcomes.end(),
                                  [&](const Outcome& o) { return o.experiment->name == experiment.name; });
  return found == outcomes.end() || found->broke() ? nullptr : &*found;
}

std::vector<ClaimRecord> merge_claims(std::span<const Experiment> all, std::span<const Outcome> outcomes,
                                      const std::vector<ClaimRecord>& old, bool ran_everything) {
  std::map<std::string, const ClaimRecord*> left;
  for (const ClaimRecord& record : old) left[record.id] = &record;
  std::vector<ClaimRecord> merged;
  for (const Experiment& experiment : all) {
    if (const Outcome* outcome = outcome_of(outcomes, experiment)) {
      for (const Claim& claim : outcome->results.claims) {
        merged.push_back(to_record(claim));
        left.erase(claim.head.id);
      }
      continue;
    }
    for (const ClaimHead& head : experiment.heads()) {
      const auto found = left.find(head.id);
      if (found == left.end()) continue;
      merged.push_back(*found->second);
      left.erase(found);
    }
  }
  if (ran_everything) return merged;
  for (const ClaimRecord& record : old) {
    if (left.contains(record.id)) merged.push_back(record);
  }
  return merged;
}

/// `mine` extracts the new entries of an outcome.
template <class Entries>
std::vector<FileEntry> merge_entries(std::span<const Experiment> all, std::span<const Outcome> outcomes,
                                     const std::vector<FileEntry>& old, bool ran_everything, Entries mine) {
  std::vector<FileEntry> merged;
  std::set<std::string> known;
  for (const Experiment& experiment : all) {
    known.insert(experiment.name);
    if (const Outcome* outcome = outcome_of(outcomes, experiment)) {
      for (FileEntry& entry : mine(*outcome)) merged.push_back(std::move(entry));
    } else {
      std::copy_if(old.begin(), old.end(), std::back_inserter(merged),
                   [&](const FileEntry& entry) { return entry.experiment == experiment.name; });
    }
  }
  if (!ran_everything) {
    std::copy_if(old.begin(), old.end(), std::back_inserter(merged),
                 [&](const FileEntry& entry) { return !known.contains(entry.experiment); });
  }
  std::set<std::string> names;
  for (const FileEntry& entry : merged) {
    if (!names.insert(entry.name).second) {
      throw std::logic_error("two experiments write '" + entry.name + "', one of them '" + entry.experiment +
                             "'");
    }
  }
  return merged;
}

std::vector<FileEntry> series_of(const Outcome& outcome) {
  std::vector<FileEntry> entries;
  for (const Series& series : outcome.results.series)
    entries.push_back({series.name, outcome.experiment->name, ""});
  return entries;
}

/// Axes and curves in words, for those who do not see the figure.
std::string shown_by(const Figure& figure) {
  std::string text;
  if (!figure.x_label.empty()) text += "Horizontal axis: " + figure.x_label + ". ";
  if (!figure.y_label.empty()) text += "Vertical axis: " + figure.y_label + ". ";
  std::string curves;
  for (const Curve& curve : figure.curves) {
    if (!curve.label.empty()) curves += (curves.empty() ? "Curves: " : "; ") + curve.label;
  }
  if (!curves.empty()) return text + curves + ".";
  if (!text.empty()) text.pop_back();
  return text;
}

std::vector<FileEntry> figures_of(const Outcome& outcome) {
  std::vector<FileEntry> entries;
  for (const Figure& figure : outcome.results.figures) {
    entries.push_back({figure.name, outcome.experiment->name, figure.title, shown_by(figure), figure.claims});
  }
  return entries;
}

/// What an earlier run wrote; empty where there is nothing.
std::string written_before(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored) ? read_file(path) : "";
}

template <class Path>
void add_obsolete(std::vector<fs::path>& obsolete, const std::vector<FileEntry>& old,
                  const std::vector<FileEntry>& merged, Path path) {
  for (const FileEntry& entry : old) {
    const bool kept =
        std::any_of(merged.begin(), merged.end(), [&](const FileEntry& m) { return m.name == entry.name; });
    if (!kept) obsolete.push_back(path(entry.name));
  }
}

}  // namespace

fs::path series_path(const fs::path& folder, const std::string& name) {
  return folder / "series" / (name + ".csv");
}

fs::path figure_path(const fs::path& folder, const std::string& name) {
  return folder / "figures" / (name + ".svg");
}

fs::path certificate_path(const fs::path& folder, const std::string& claim) {
  return folder / "certificates" / (claim + ".txt");
}

std::optional<ResultsFolder> load_results_if_any(const fs::path& folder) {
  std::error_code ignored;
  const fs::path claims = folder / "claims.json";
  if (!fs::exists(claims, ignored)) return std::nullopt;
  ResultsFolder result;
  result.claims = claims_from_json(read_file(claims), claims.string());
  const fs::path manifest = folder / "manifest.json";
  if (fs::exists(manifest, ignored))
    result.manifest = manifest_from_json(read_file(manifest), manifest.string());
  return result;
}

ResultsFolder load_results(const fs::path& folder) {
  auto result = load_results_if_any(folder);
  if (!result) {
    throw InputError(
        (folder / "claims.json").string() +
        ": there is no such file; 'subdivlab reproduce' writes one, --against names another folder");
  }
  return *std::move(result);
}

ResultsFolder merge(std::span<const Experiment> all, std::span<const Outcome> outcomes,
                    const ResultsFolder& old, bool ran_everything) {
  return {merge_claims(all, outcomes, old.claims, ran_everything),
          {merge_entries(all, outcomes, old.manifest.series, ran_everything, series_of),
           merge_entries(all, outcomes, old.manifest.figures, ran_everything, figures_of),
           {},
           page_names()}};
}

void list_certificates(ResultsFolder& merged, const ResultsFolder& old,
                       std::span<const ClaimRecord> looked_at,
                       std::span<const ClaimCertificate> certificates) {
  std::set<std::string> ids(old.manifest.certificates.begin(), old.manifest.certificates.end());
  for (const ClaimRecord& claim : looked_at) ids.erase(claim.id);
  for (const ClaimCertificate& certificate : certificates) {
    if (!certificate.text.empty()) ids.insert(certificate.claim);
  }
  for (const ClaimRecord& claim : merged.claims) {
    if (ids.contains(claim.id)) merged.manifest.certificates.push_back(claim.id);
  }
}

std::vector<std::string> certificate_differences(const fs::path& folder, const ResultsFolder& committed,
                                                 std::span<const ClaimRecord> looked_at,
                                                 std::span<const ClaimCertificate> certificates) {
  std::vector<std::string> result;
  const auto& listed = committed.manifest.certificates;
  std::set<std::string> left;
  for (const ClaimRecord& claim : looked_at) {
    if (std::ranges::find(listed, claim.id) != listed.end()) left.insert(claim.id);
  }
  for (const ClaimCertificate& certificate : certificates) {
    if (!certificate.failure.empty()) {
      result.push_back(certificate.claim + ": no certificate was found: " + certificate.failure);
    } else if (left.erase(certificate.claim) == 0) {
      result.push_back(certificate.claim + ": the folder lists no certificate, the run found one");
    } else if (written_before(certificate_path(folder, certificate.claim)) != certificate.text) {
      result.push_back(certificate.claim + ": the certificate is another one");
    }
  }
  for (const std::string& claim : left)
    result.push_back(claim + ": the folder has a certificate, the run found none");
  return result;
}

void write_results(const fs::path& folder, std::span<const Experiment> all, std::span<const Outcome> outcomes,
                   const ResultsFolder& old, const ResultsFolder& merged,
                   std::span<const ClaimCertificate> certificates) {
  std::vector<NewFile> files;
  for (const ClaimCertificate& certificate : certificates) {
    if (!certificate.text.empty())
      files.push_back({certificate_path(folder, certificate.claim), certificate.text});
  }
  std::map<std::string, std::string> drawn;
  std::map<std::string, std::string> tables;
  for (const Outcome& outcome : outcomes) {
    for (const Series& series : outcome.results.series) {
      tables[series.name] = series_to_csv(series);
      files.push_back({series_path(folder, series.name), tables[series.name]});
    }
    for (const Figure& figure : outcome.results.figures) {
      drawn[figure.name] = draw_svg(figure, outcome.results.series);
      files.push_back({figure_path(folder, figure.name), drawn[figure.name]});
    }
  }
  const auto picture = [&](const std::string& name) {
    const auto found = drawn.find(name);
    return found == drawn.end() ? written_before(figure_path(folder, name)) : found->second;
  };
  const auto table = [&](const std::string& name) {
    const auto found = tables.find(name);
    return found == tables.end() ? written_before(series_path(folder, name)) : found->second;
  };
  for (Page& page : derived_pages({all, merged.claims, &merged.manifest, picture, table})) {
    files.push_back({folder / page.name, std::move(page.text)});
  }
  files.push_back({folder / "claims.csv", claims_to_csv(merged.claims)});
  files.push_back({folder / "manifest.json", manifest_to_json(merged.manifest)});
  files.push_back({folder / "claims.json", claims_to_json(merged.claims)});

  std::vector<fs::path> obsolete;
  add_obsolete(obsolete, old.manifest.series, merged.manifest.series,
               [&](const std::string& name) { return series_path(folder, name); });
  add_obsolete(obsolete, old.manifest.figures, merged.manifest.figures,
               [&](const std::string& name) { return figure_path(folder, name); });
  for (const std::string& claim : old.manifest.certificates) {
    const auto& kept = merged.manifest.certificates;
    if (std::ranges::find(kept, claim) == kept.end()) obsolete.push_back(certificate_path(folder, claim));
  }
  for (const std::string& page : old.manifest.pages) {
    if (std::ranges::find(merged.manifest.pages, page) == merged.manifest.pages.end())
      obsolete.push_back(folder / page);
  }
  for (const char* part : {"certificates", "series", "figures", "report"}) prepare_folder(folder / part);
  write_files(files, obsolete);
}

std::vector<std::string> page_differences(const fs::path& folder, std::span<const Experiment> all,
                                          const ResultsFolder& committed) {
  std::vector<std::string> result;
  const auto picture = [&](const std::string& name) { return written_before(figure_path(folder, name)); };
  const auto table = [&](const std::string& name) { return written_before(series_path(folder, name)); };
  for (const Page& page : derived_pages({all, committed.claims, &committed.manifest, picture, table})) {
    const fs::path path = folder / page.name;
    std::error_code ignored;
    if (!fs::exists(path, ignored)) {
      result.push_back(path.string() + ": is missing");
    } else if (read_file(path) != page.text) {
      result.push_back(path.string() + ": is not what follows from the claims and figures of the folder");
    }
  }
  return result;
}

}  // namespace subdiv
