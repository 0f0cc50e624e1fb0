#include "experiments/claim.h"

#include <stdexcept>
#include <string_view>
#include <utility>

namespace subdiv {
namespace {

/// A printed number without its sign and per cent mark, in ASCII.
struct PrintedNumber {
  std::string digits;
  bool negative = false;
  bool percent = false;
};

PrintedNumber take_apart(std::string_view text) {
  PrintedNumber result;
  constexpr std::string_view minus_signs[] = {"-", "\u2212", "\u2013"};
  for (const std::string_view minus : minus_signs) {
    if (!text.starts_with(minus)) continue;
    result.negative = true;
    text.remove_prefix(minus.size());
    break;
  }
  if (text.ends_with('%')) {
    result.percent = true;
    text.remove_suffix(1);
  }
  result.digits = text;
  return result;
}

/// Where an enclosure lies with respect to the closed interval of values that a printed string allows.
enum class Position { inside, outside, straddling };

Position position(const Enclosure& value, const Rational& low, const Rational& high) {
  if (low <= value.lower && value.upper <= high) return Position::inside;
  if (value.upper < low || high < value.lower) return Position::outside;
  return Position::straddling;
}

Verdict verdict_of(Position position, Rigour rigour) {
  if (position == Position::straddling) return Verdict::undecided;
  const bool holds = position == Position::inside;
  if (rigour == Rigour::approximate) return holds ? Verdict::consistent : Verdict::inconsistent;
  return holds ? Verdict::reproduced : Verdict::refuted;
}

Claim with_value(const ClaimHead& head, Verdict verdict, const Enclosure& value, std::string note) {
  return {head, value.exact, value.lower, value.upper, value.rigour, verdict, std::move(note)};
}

[[noreturn]] void misuse(const ClaimHead& head, const std::string& what) {
  throw std::logic_error("claim '" + head.id + "': " + what);
}

}  // namespace

ClaimHead finding(std::string id, std::string section, std::string definition) {
  return {std::move(id), "subdivlab",      std::move(section),
          std::nullopt,  ClaimKind::exact, std::move(definition)};
}

Claim settle(const ClaimHead& head, const Enclosure& value, std::string note) {
  if (!head.printed) {
    const bool proved = value.rigour != Rigour::approximate && value.status == Status::closed;
    return with_value(head, proved ? Verdict::established : Verdict::undecided, value, std::move(note));
  }
  if (head.kind != ClaimKind::exact && head.kind != ClaimKind::rounded) {
    misuse(head, "settle() takes kinds exact and rounded; use settle_bound() or settle_as()");
  }
  const Rational printed = printed_value(*head.printed);
  const Rational tolerance = printed_tolerance(*head.printed, head.kind);
  const Position where = position(value, printed - tolerance, printed + tolerance);
  return with_value(head, verdict_of(where, value.rigour), value, std::move(note));
}

Claim settle_bound(const ClaimHead& head, BoundSide side, const Enclosure& value, std::string note) {
  if (!head.printed || head.kind != ClaimKind::bound) misuse(head, "settle_bound() takes printed bounds");
  const Rational bound = printed_value(*head.printed);
  const bool at_most = side == BoundSide::at_most;
  Position where = Position::straddling;
  if (at_most ? value.upper <= bound : value.lower >= bound) where = Position::inside;
  if (at_most ? value.lower > bound : value.upper < bound) where = Position::outside;
  return with_value(head, verdict_of(where, value.rigour), value, std::move(note));
}

Claim settle_statement(const ClaimHead& head, bool holds, std::string exact, std::string note,
                       Rigour rigour) {
  Verdict verdict = verdict_of(holds ? Position::inside : Position::outside, rigour);
  if (!head.printed) {
    if (!holds) misuse(head, "a finding of the project's own does not hold");
    verdict = rigour == Rigour::approximate ? Verdict::undecided : Verdict::established;
  }
  return {head, std::move(exact), std::nullopt, std::nullopt, rigour, verdict, std::move(note)};
}

Claim settle_as(const ClaimHead& head, Verdict verdict, const Enclosure& value, std::string note) {
  const bool needs_proof =
      verdict == Verdict::reproduced || verdict == Verdict::refuted || verdict == Verdict::established;
  if (needs_proof && value.rigour == Rigour::approximate) misuse(head, "an approximate value proves nothing");
  return with_value(head, verdict, value, std::move(note));
}

Claim settle_not_reproducible(const ClaimHead& head, std::string note) {
  return {head,           "", std::nullopt, std::nullopt, Rigour::approximate, Verdict::not_reproducible,
          std::move(note)};
}

Rational printed_value(const std::string& printed) {
  const PrintedNumber number = take_apart(printed);
  if (number.digits.starts_with('-')) throw std::logic_error("printed '" + printed + "' has two signs");
  try {
    const Rational value = Rational::parse(number.digits) / Rational(number.percent ? 100 : 1);
    return number.negative ? -value : value;
  } catch (const std::invalid_argument& error) {
    throw std::logic_error("printed '" + printed + "': " + error.what());
  }
}

Rational printed_tolerance(const std::string& printed, ClaimKind kind) {
  const PrintedNumber number = take_apart(printed);
  if (kind == ClaimKind::exact || number.digits.find('/') != std::string::npos) return 0;
  const auto e = number.digits.find_first_of("eE");
  const std::string mantissa = number.digits.substr(0, e);
  const Rational scale = e == std::string::npos ? 1 : Rational::parse("1" + number.digits.substr(e));
  const auto point = mantissa.find('.');
  const auto decimals = point == std::string::npos ? 0 : static_cast<long>(mantissa.size() - point - 1);
  return scale * pow(Rational(10), -decimals) / Rational(number.percent ? 200 : 2);
}

std::string to_string(ClaimKind kind) {
  switch (kind) {
    case ClaimKind::exact:
      return "exact";
    case ClaimKind::rounded:
      return "rounded";
    case ClaimKind::bound:
      return "bound";
    case ClaimKind::tendency:
      return "tendency";
    case ClaimKind::not_reproducible:
      break;
  }
  return "not-reproducible";
}

std::string to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::reproduced:
      return "reproduced";
    case Verdict::refuted:
      return "refuted";
    case Verdict::undecided:
      return "undecided";
    case Verdict::consistent:
      return "consistent";
    case Verdict::inconsistent:
      return "inconsistent";
    case Verdict::established:
      return "established";
    case Verdict::not_reproducible:
      break;
  }
  return "not-reproducible";
}

}  // namespace subdiv
