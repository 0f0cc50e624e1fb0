#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/experiment.h"
#include "experiments/report/record.h"

namespace subdiv {

using CsvRows = std::vector<std::vector<std::string>>;

/// Comma-separated values after RFC 4180, with line feeds alone: a field with a comma, quote or line break
/// stands in quotes, quotes within are doubled.
[[nodiscard]] std::string to_csv(const CsvRows& rows);
/// Reads it back; a quoted field that does not end takes the rest of the text.
[[nodiscard]] CsvRows from_csv(std::string_view text);

/// series/NAME.csv: the header, then the rows. Throws std::logic_error when a row's length differs from the
/// header's.
[[nodiscard]] std::string series_to_csv(const Series& series);
/// claims.csv: id, document, section, printed, kind, definition, exact, lower, upper, rigour, verdict, note.
[[nodiscard]] std::string claims_to_csv(std::span<const ClaimRecord> claims);

}  // namespace subdiv
