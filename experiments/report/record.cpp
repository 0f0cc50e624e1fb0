#include "experiments/report/record.h"

#include <algorithm>

#include "experiments/report/utf8.h"

namespace subdiv {
namespace {

constexpr long least_digits = 18;
constexpr long most_digits = 40;
constexpr long shown_digits = 15;

/// The largest e with 10^e <= x, for x > 0.
long decimal_exponent(const Rational& x) {
  long e = 0;
  while (pow(Rational(10), e) <= x) ++e;
  while (pow(Rational(10), e) > x) --e;
  return e;
}

Rational magnitude(const Rational& lower, const Rational& upper) { return std::max(abs(lower), abs(upper)); }

/// Significant digits that distinguish values at the scale of the width.
long significant_digits(const Rational& lower, const Rational& upper) {
  return decimal_exponent(magnitude(lower, upper)) - decimal_exponent(upper - lower);
}

std::string short_interval(const Rational& lower, const Rational& upper) {
  constexpr int digits = 6;
  return "[" + to_significant(lower, digits, -1) + ", " + to_significant(upper, digits, 1) + "]";
}

std::string digits_text(const Rational& lower, const Rational& upper, bool approximate) {
  const std::string prefix = approximate ? "~" : "";
  const Rational middle = (lower + upper) / Rational(2);
  if (lower == upper) return prefix + to_significant(middle, static_cast<int>(shown_digits));
  // The last digit of an approximate value is the last believed one; of a proved value it is certain but for
  // rounding.
  const long digits = std::min(significant_digits(lower, upper) + (approximate ? 1 : 0), shown_digits);
  constexpr long least_shown = 4;
  if (digits < least_shown && !(approximate && digits > 0)) return prefix + short_interval(lower, upper);
  return prefix + to_significant(middle, static_cast<int>(digits));
}

}  // namespace

DecimalEnds decimal_ends(const Rational& lower, const Rational& upper, Rigour rigour) {
  if (rigour == Rigour::approximate && lower != upper) {
    const auto decimals = static_cast<int>(std::max(0L, -decimal_exponent(upper - lower)));
    return {to_decimal(lower, decimals, -1), to_decimal(upper, decimals, 1)};
  }
  long digits = least_digits;
  if (lower != upper) digits = std::clamp(significant_digits(lower, upper) + 3, least_digits, most_digits);
  const auto count = static_cast<int>(digits);
  return {to_significant(lower, count, -1), to_significant(upper, count, 1)};
}

ClaimRecord to_record(const Claim& claim) {
  ClaimRecord record{.id = claim.head.id,
                     .document = claim.head.document,
                     .section = claim.head.section,
                     .printed = claim.head.printed,
                     .kind = to_string(claim.head.kind),
                     .definition = claim.head.definition,
                     .exact = std::nullopt,
                     .lower = std::nullopt,
                     .upper = std::nullopt,
                     .rigour = to_string(claim.rigour),
                     .verdict = to_string(claim.verdict),
                     .note = claim.note};
  if (!claim.exact.empty()) record.exact = claim.exact;
  if (claim.lower && claim.upper) {
    const DecimalEnds ends = decimal_ends(*claim.lower, *claim.upper, claim.rigour);
    record.lower = ends.lower;
    record.upper = ends.upper;
  }
  return record;
}

std::string value_text(const ClaimRecord& record, std::size_t width) {
  const bool has_ends = record.lower && record.upper;
  if (record.exact && (!has_ends || display_width(*record.exact) <= width))
    return clipped(*record.exact, width);
  if (!has_ends) return "-";
  const std::string text = digits_text(Rational::parse(*record.lower), Rational::parse(*record.upper),
                                       record.rigour == to_string(Rigour::approximate));
  const std::size_t exponent = text.find('e');  // of one number: cut off, it would be another one
  const bool one_number = exponent != std::string::npos && text.find('[') == std::string::npos;
  const std::size_t tail = one_number ? text.size() - exponent : 0;
  if (tail == 0 || text.size() <= width || tail + 2 > width) return clipped(text, width);
  return clipped(text.substr(0, exponent), width - tail) + text.substr(exponent);
}

}  // namespace subdiv
