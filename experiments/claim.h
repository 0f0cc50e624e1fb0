#pragma once

#include <optional>
#include <string>

#include "analysis/enclosure.h"

namespace subdiv {

/// What a claim asserts, and thereby what settles it: exact: equality; rounded: half a unit in the last
/// printed digit; bound: an inequality; tendency: a share over a stated family of polygons; not_reproducible:
/// a lost figure or formula.
enum class ClaimKind { exact, rounded, bound, tendency, not_reproducible };

/// reproduced and refuted need exact or certified values; consistent and inconsistent are all that
/// approximate values may say; established marks a finding of this project (nothing printed) with a proof.
/// not_reproducible is the verdict of that kind.
enum class Verdict {
  reproduced,
  refuted,
  undecided,
  consistent,
  inconsistent,
  established,
  not_reproducible
};

/// A claim as registered, before anything is computed.
struct ClaimHead {
  std::string id;        // "area.rs.r"
  std::string document;  // js-report, jsplines, polyloops, notes, speed; "subdivlab" for findings of the
                         // project's own
  std::string section;   // "8", "3 and abstract"
  std::optional<std::string> printed;  // the document's own string; none for findings
  ClaimKind kind = ClaimKind::exact;
  std::string definition;  // what is computed, precise enough to redo it
};

/// The head of a finding of the project's own; the section is the one that it belongs to, "jsplines 3".
[[nodiscard]] ClaimHead finding(std::string id, std::string section, std::string definition);

/// A claim with its verdict. Values that are no numbers (a mask, a factorisation, "true") are exact text
/// without ends.
struct Claim {
  ClaimHead head;
  std::string exact;  // exact value as text; empty when there is none
  std::optional<Rational> lower;
  std::optional<Rational> upper;
  Rigour rigour = Rigour::approximate;
  Verdict verdict = Verdict::undecided;
  std::string note;  // for a refuted claim: what is true, in full sentences
};

/// Settles a claim about one number from its enclosure. Printed text must be a number (see printed_value) and
/// the kind exact or rounded, else std::logic_error. exact: the value is that number; rounded: the whole
/// enclosure lies within half a unit of the last printed digit; otherwise refuted when it lies wholly
/// outside, undecided when it straddles. Approximate values are consistent, inconsistent or undecided in the
/// same cases. A finding (nothing printed) is established when it is exact or certified and closed, else
/// undecided. An enclosure whose status is not closed still decides a printed claim when it lies wholly
/// inside or outside.
[[nodiscard]] Claim settle(const ClaimHead& head, const Enclosure& value, std::string note = "");

/// Settles a claim of kind bound: at_most when the document says "value <= printed", at_least for "value >=
/// printed"; an enclosure that touches the bound satisfies it.
enum class BoundSide { at_most, at_least };
[[nodiscard]] Claim settle_bound(const ClaimHead& head, BoundSide side, const Enclosure& value,
                                 std::string note = "");

/// Settles a claim about a statement or an identity, proved or disproved: `exact` says what was found
/// ("true", a mask, a factored polynomial). Printed: reproduced or refuted; a finding must hold
/// (std::logic_error) and is established. Rigour approximate gives consistent or inconsistent, and undecided
/// for a finding.
[[nodiscard]] Claim settle_statement(const ClaimHead& head, bool holds, std::string exact,
                                     std::string note = "", Rigour rigour = Rigour::exact);

/// Settles a claim by a decision that the experiment took itself, with the value that shows it. reproduced,
/// refuted and established need an exact or certified value (std::logic_error).
[[nodiscard]] Claim settle_as(const ClaimHead& head, Verdict verdict, const Enclosure& value,
                              std::string note);

/// A claim that cannot be recomputed; the note says which figure or formula is missing.
[[nodiscard]] Claim settle_not_reproducible(const ClaimHead& head, std::string note);

/// The number that a document prints: integer, p/q, decimal (".689"), any of them with "%" (a hundredth) and
/// with a hyphen, minus sign or dash before it. Anything else is a std::logic_error.
[[nodiscard]] Rational printed_value(const std::string& printed);
/// Half a unit in the last printed digit: "0.46415" gives 5e-6, "0.79%" gives 5e-5, "12" gives 1/2. Kind
/// exact and fractions p/q give 0.
[[nodiscard]] Rational printed_tolerance(const std::string& printed, ClaimKind kind = ClaimKind::rounded);

/// "exact", "rounded", "bound", "tendency", "not-reproducible".
[[nodiscard]] std::string to_string(ClaimKind kind);
/// "reproduced", .., "not-reproducible".
[[nodiscard]] std::string to_string(Verdict verdict);

}  // namespace subdiv
