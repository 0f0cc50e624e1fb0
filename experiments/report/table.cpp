#include "experiments/report/table.h"

#include <algorithm>
#include <array>
#include <vector>

#include "experiments/report/utf8.h"

namespace subdiv {
namespace {

using Row = std::array<std::string, 5>;
enum Column : std::size_t { id, printed, value, rigour, verdict };

constexpr std::size_t gap = 2;
constexpr std::size_t least_printed = 10;
constexpr std::size_t least_value = 16;
constexpr std::size_t most_value = 60;

std::array<std::size_t, 5> natural_widths(const std::vector<Row>& rows) {
  std::array<std::size_t, 5> widths{};
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], display_width(row[i]));
  }
  return widths;
}

/// Takes from printed and value what the table is too wide, from the wider one first.
void fit(std::array<std::size_t, 5>& widths, std::size_t total) {
  const auto used = [&] {
    std::size_t sum = gap * (widths.size() - 1);
    for (const std::size_t width : widths) sum += width;
    return sum;
  };
  while (used() > total && (widths[printed] > least_printed || widths[value] > least_value)) {
    const bool from_value =
        widths[printed] <= least_printed || (widths[value] > least_value && widths[value] > widths[printed]);
    --widths[from_value ? value : printed];
  }
}

}  // namespace

std::string claims_table(std::span<const ClaimRecord> claims, std::size_t width) {
  std::vector<Row> rows{{"id", "printed", "value", "rigour", "verdict"}};
  for (const ClaimRecord& claim : claims) {
    rows.push_back({claim.id, clipped(claim.printed.value_or("-"), width), value_text(claim, most_value),
                    claim.rigour, claim.verdict});
  }
  auto widths = natural_widths(rows);
  fit(widths, width);
  for (std::size_t i = 0; i < claims.size(); ++i) rows[i + 1][value] = value_text(claims[i], widths[value]);

  std::string text;
  for (const Row& row : rows) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      text += padded(i == id ? row[i] : clipped(row[i], widths[i]), widths[i] + gap);
    }
    text += row.back() + "\n";
  }
  return text;
}

}  // namespace subdiv
