#pragma once

#include <optional>
#include <string>

#include "analysis/enclosure.h"

namespace subdiv {

/// What a claim asserts, and thereby what settles it: exact: equality; rounded: half a unit in the last printed digit;
/// bound: an inequality; tendency: a share over a stated family of polygons; not_reproducible: a lost figure or formula.
enum class ClaimKind { exact, rounded, bound, tendency, not_reproducible };

/// reproduced and refuted need exact or certified values; consistent and inconsistent are all that approximate values
/// may say; established marks a finding of this project (nothing printed) with a proof. not_reproducible is the verdict of
/// that kind.
enum class Verdict { reproduced, refuted, undecided, consistent, inconsistent, established, not_reproducible };

/// A claim as registered, before anything is computed.
struct ClaimHead {
  std::string id;        // "area.rs.r"
  std::string document;  // js-report, jsplines, polyloops, notes, speed; "subdivlab" for findings of the project's own
  std::string section;   // "8", "3 and abstract"
  std::optional<std::string> printed;  // the document's own string; none for findings
  ClaimKind kind = ClaimKind::exact;
  std::string definition;  // what is computed, precise enough to redo it
};

/// A claim with its verdict. Values that are no numbers (a mask, a factorisation, "true") are exact text without ends.
struct Claim {
  ClaimHead head;
  std::string exact;  // exact value as text; empty when there is none
  std::optional<Rational> lower;
  std::optional<Rational> upper;
  Rigour rigour = Rigour::approximate;
  Verdict verdict = Verdict::undecided;
  std::string note;  // for a refuted claim: what is true, in full sentences
};

/// Settles a claim about one number from its enclosure. Printed text must be a number (integer, p/q or decimal), else
/// std::logic_error. exact: the value is that number; rounded: the whole enclosure lies within half a unit of the last
/// printed digit; otherwise refuted when it lies wholly outside, undecided when it straddles. A finding is established when
/// proved. Status other than closed is undecided unless the enclosure already decides.
[[nodiscard]] Claim settle(const ClaimHead& head, const Enclosure& value, std::string note = "");

/// Settles a claim about a statement or an identity, proved or disproved exactly: `exact` says what was found ("true", a
/// mask, a factored polynomial).
[[nodiscard]] Claim settle_statement(const ClaimHead& head, bool holds, std::string exact, std::string note = "",
                                     Rigour rigour = Rigour::exact);

/// Settles a claim by a decision that the experiment took itself, with the value that shows it.
[[nodiscard]] Claim settle_as(const ClaimHead& head, Verdict verdict, const Enclosure& value, std::string note);

/// Half a unit in the last printed digit: "0.46415" gives 5e-6, "-33/26" and integers written as such give 0 for exact
/// kinds and 1/2 for rounded integers.
[[nodiscard]] Rational printed_tolerance(const std::string& printed);

[[nodiscard]] std::string to_string(ClaimKind kind);
[[nodiscard]] std::string to_string(Verdict verdict);

}  // namespace subdiv
