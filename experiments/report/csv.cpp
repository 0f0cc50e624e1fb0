#include "experiments/report/csv.h"

#include <cstddef>
#include <stdexcept>

namespace subdiv {
namespace {

std::string field_text(const std::string& field) {
  if (field.find_first_of(",\"\r\n") == std::string::npos) return field;
  std::string quoted = "\"";
  for (const char c : field) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

/// Reads one field from text[i] on; leaves i at the comma or line feed after it, or at the end.
std::string read_field(std::string_view text, std::size_t& i) {
  std::string field;
  bool quoted = false;
  for (; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
      field += text[++i];
    } else if (c == '"' && (quoted || field.empty())) {
      quoted = !quoted;
    } else if (!quoted && (c == ',' || c == '\n')) {
      break;
    } else {
      field += c;
    }
  }
  return field;
}

}  // namespace

std::string to_csv(const CsvRows& rows) {
  std::string text;
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) text += (i == 0 ? "" : ",") + field_text(row[i]);
    text += '\n';
  }
  return text;
}

CsvRows from_csv(std::string_view text) {
  CsvRows rows;
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::vector<std::string> row{read_field(text, i)};
    while (i < text.size() && text[i] == ',') row.push_back(read_field(text, ++i));
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string series_to_csv(const Series& series) {
  CsvRows rows{series.columns};
  for (const auto& row : series.rows) {
    if (row.size() != series.columns.size()) {
      throw std::logic_error("series '" + series.name + "': row " + std::to_string(rows.size()) + " has " +
                             std::to_string(row.size()) + " cells for " +
                             std::to_string(series.columns.size()) + " columns");
    }
    rows.push_back(row);
  }
  return to_csv(rows);
}

std::string claims_to_csv(std::span<const ClaimRecord> claims) {
  CsvRows rows{{"id", "document", "section", "printed", "kind", "definition", "exact", "lower", "upper",
                "rigour", "verdict", "note"}};
  for (const ClaimRecord& c : claims) {
    rows.push_back({c.id, c.document, c.section, c.printed.value_or(""), c.kind, c.definition,
                    c.exact.value_or(""), c.lower.value_or(""), c.upper.value_or(""), c.rigour, c.verdict,
                    c.note});
  }
  return to_csv(rows);
}

}  // namespace subdiv
