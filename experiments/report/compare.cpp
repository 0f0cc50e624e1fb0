#include "experiments/report/compare.h"

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>

#include "experiments/report/csv.h"
#include "experiments/report/files.h"
#include "schemes/input_error.h"

namespace subdiv {
namespace {

namespace fs = std::filesystem;

std::string shown(const std::optional<std::string>& text) { return text ? "'" + *text + "'" : "nothing"; }

/// One unit in the last digit of a decimal string: 1e-3 for "0.125", 1e-10 for "1.5e-9".
Rational last_unit(const std::string& decimal) {
  const auto e = decimal.find_first_of("eE");
  const std::string mantissa = decimal.substr(0, e);
  const auto point = mantissa.find('.');
  const auto decimals = point == std::string::npos ? 0 : static_cast<long>(mantissa.size() - point - 1);
  const Rational scale = e == std::string::npos ? 1 : Rational::parse("1" + decimal.substr(e));
  return scale * pow(Rational(10), -decimals);
}

struct Ends {
  Rational lower;
  Rational upper;
  Rational rounding;  // what printing may have added to the width

  [[nodiscard]] Rational width() const { return upper - lower; }
};

Ends ends_of(const ClaimRecord& record) {
  return {Rational::parse(*record.lower), Rational::parse(*record.upper),
          last_unit(*record.lower) + last_unit(*record.upper)};
}

std::string interval_text(const ClaimRecord& record) {
  return record.lower ? "[" + *record.lower + ", " + *record.upper + "]" : "no number";
}

/// Exact rationals are printed in one way only, so their ends must be the same text.
bool is_exact_rational(const ClaimRecord& record) {
  if (!record.exact || record.rigour != to_string(Rigour::exact)) return false;
  try {
    (void)Rational::parse(*record.exact);
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

std::optional<std::string> end_difference(const ClaimRecord& committed, const ClaimRecord& found) {
  const std::string both = interval_text(committed) + " is committed, " + interval_text(found) + " is found";
  if (committed.lower == found.lower && committed.upper == found.upper) return std::nullopt;
  if (committed.lower.has_value() != found.lower.has_value() || is_exact_rational(found))
    return "value: " + both;
  const Ends old_ends = ends_of(committed);
  const Ends new_ends = ends_of(found);
  if (std::max(old_ends.lower, new_ends.lower) > std::min(old_ends.upper, new_ends.upper)) {
    return "enclosures do not overlap: " + both;
  }
  const Rational rounding = old_ends.rounding + new_ends.rounding;
  if (new_ends.width() > old_ends.width() + rounding) return "the enclosure has become wider: " + both;
  constexpr int stale = 1000;
  if (old_ends.width() > Rational(stale) * (new_ends.width() + rounding)) {
    return "the committed enclosure is far wider than need be: " + both;
  }
  return std::nullopt;
}

bool is_decimal_with_point(const std::string& cell) {
  if (cell.find('.') == std::string::npos || cell.find('/') != std::string::npos) return false;
  try {
    (void)Rational::parse(cell);
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

bool cells_agree(const std::string& a, const std::string& b) {
  if (a == b) return true;
  if (!is_decimal_with_point(a) || !is_decimal_with_point(b)) return false;
  return abs(Rational::parse(a) - Rational::parse(b)) <= std::max(last_unit(a), last_unit(b));
}

void compare_claims(std::vector<std::string>& result, const ResultsFolder& committed,
                    std::span<const Outcome> outcomes,
                    const std::function<bool(const std::string&)>& chosen) {
  std::set<std::string> owned;
  for (const Outcome& outcome : outcomes) {
    for (const ClaimHead& head : outcome.experiment->heads()) owned.insert(head.id);
    for (const Claim& claim : outcome.results.claims) {
      if (!chosen(claim.head.id)) continue;
      const auto old = std::find_if(committed.claims.begin(), committed.claims.end(),
                                    [&](const ClaimRecord& c) { return c.id == claim.head.id; });
      if (old == committed.claims.end()) {
        result.push_back(claim.head.id + ": is missing in claims.json");
        continue;
      }
      for (const std::string& difference : differences(*old, to_record(claim))) {
        result.push_back(claim.head.id + ": " + difference);
      }
    }
  }
  for (const ClaimRecord& record : committed.claims) {
    if (chosen(record.id) && !owned.contains(record.id)) {
      result.push_back(record.id + ": stands in claims.json, but no experiment has such a claim");
    }
  }
}

void compare_files(std::vector<std::string>& result, const fs::path& folder, const Outcome& outcome) {
  const auto text_of = [&](const fs::path& path) -> std::optional<std::string> {
    try {
      return read_file(path);
    } catch (const InputError& error) {
      result.emplace_back(error.what());
      return std::nullopt;
    }
  };
  for (const Series& series : outcome.results.series) {
    const fs::path path = series_path(folder, series.name);
    if (const auto text = text_of(path)) {
      for (std::string& difference : series_differences(path.string(), *text, series_to_csv(series))) {
        result.push_back(std::move(difference));
      }
    }
  }
  for (const Figure& figure : outcome.results.figures) {
    const fs::path path = figure_path(folder, figure.name);
    const auto text = text_of(path);
    if (text && text->find("</svg>") == std::string::npos)
      result.push_back(path.string() + ": is no whole SVG");
  }
}

}  // namespace

std::vector<std::string> differences(const ClaimRecord& committed, const ClaimRecord& found) {
  std::vector<std::string> result;
  const auto compare_text = [&](const char* what, const auto& old_text, const auto& new_text) {
    if (old_text == new_text) return;
    result.push_back(std::string(what) + ": " + shown(old_text) + " is committed, " + shown(new_text) +
                     " is found");
  };
  compare_text("verdict", committed.verdict, found.verdict);
  compare_text("rigour", committed.rigour, found.rigour);
  compare_text("exact value", committed.exact, found.exact);
  if (auto difference = end_difference(committed, found)) result.push_back(*std::move(difference));
  compare_text("document", committed.document, found.document);
  compare_text("section", committed.section, found.section);
  compare_text("printed", committed.printed, found.printed);
  compare_text("kind", committed.kind, found.kind);
  compare_text("definition", committed.definition, found.definition);
  return result;
}

std::vector<std::string> series_differences(const std::string& file, const std::string& committed,
                                            const std::string& found) {
  std::vector<std::string> result;
  const CsvRows old_rows = from_csv(committed);
  const CsvRows new_rows = from_csv(found);
  if (old_rows.size() != new_rows.size()) {
    return {file + ": has " + std::to_string(old_rows.size()) + " lines, " + std::to_string(new_rows.size()) +
            " are found"};
  }
  constexpr std::size_t most = 3;  // lines shown of one file
  for (std::size_t i = 0; i < old_rows.size() && result.size() < most; ++i) {
    const auto& old_row = old_rows[i];
    const auto& new_row = new_rows[i];
    const std::string line = file + ":" + std::to_string(i + 1) + ": ";
    if (old_row.size() != new_row.size()) {
      result.push_back(line + "has " + std::to_string(old_row.size()) + " cells, " +
                       std::to_string(new_row.size()) + " are found");
      continue;
    }
    const auto [a, b] = std::mismatch(old_row.begin(), old_row.end(), new_row.begin(), cells_agree);
    if (a != old_row.end()) result.push_back(line + "'" + *a + "' is committed, '" + *b + "' is found");
  }
  return result;
}

std::vector<std::string> compare(const fs::path& folder, const ResultsFolder& committed,
                                 std::span<const Outcome> outcomes,
                                 const std::function<bool(const std::string& id)>& chosen) {
  std::vector<std::string> result;
  compare_claims(result, committed, outcomes, chosen);
  for (const Outcome& outcome : outcomes) compare_files(result, folder, outcome);
  return result;
}

}  // namespace subdiv
