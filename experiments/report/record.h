#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "experiments/claim.h"

namespace subdiv {

/// A claim as the results folder holds it: everything is text, so that what was written is kept and compared
/// verbatim. Ends are decimal strings; a statement has none.
struct ClaimRecord {
  std::string id;
  std::string document;
  std::string section;
  std::optional<std::string> printed;
  std::string kind;
  std::string definition;
  std::optional<std::string> exact;
  std::optional<std::string> lower;
  std::optional<std::string> upper;
  std::string rigour;
  std::string verdict;
  std::string note;

  friend bool operator==(const ClaimRecord&, const ClaimRecord&) = default;
};

[[nodiscard]] ClaimRecord to_record(const Claim& claim);

/// The two ends of an enclosure as decimal strings. exact and certified: rounded outward (lower end down,
/// upper end up) to 18 significant digits, or as many more (40 at most) as keep the rounding below a
/// hundredth of the width. approximate: rounded outward to the decimals that the width lets one believe.
struct DecimalEnds {
  std::string lower;
  std::string upper;
};
[[nodiscard]] DecimalEnds decimal_ends(const Rational& lower, const Rational& upper, Rigour rigour);

/// A record's value for people, at most `width` characters wide: the exact text when it fits; else the digits
/// on which both ends agree (15 at most), the interval "[lo, hi]" when they agree on fewer than 4, "~0.4641"
/// for approximate values; "-" when there is none.
[[nodiscard]] std::string value_text(const ClaimRecord& record, std::size_t width);

}  // namespace subdiv
