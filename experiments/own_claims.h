#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/definitions.h"
#include "experiments/experiment.h"

namespace subdiv {

/// Claims of a user's own, from a JSON file (experiments/docs/own-claims.schema.json):
///
///     { "document": "hassan2002",
///       "claims": [
///         { "id": "ternary.c2", "printed": "1/15 < mu < 1/9", "section": "3",
///           "definition": { "name": "smooth-range", "scheme": "ternary.json:mu=mu", "over": "mu=-1..1",
///                           "continuity": 2 } } ],
///       "figures": [
///         { "name": "exponent", "scheme": "ternary.json:mu=mu", "over": "mu=0..1/5" } ] }
///
/// Names of files start at the folder of the file. A claim without "printed" is a finding.

/// What a claim asserts of a number; of other definitions only equality can be claimed.
enum class OwnKind { exact, rounded, at_most, at_least };

/// A claim that has been checked as far as that goes without computing.
struct OwnClaim {
  ClaimHead head;                 ///< with the definition in words
  OwnKind kind = OwnKind::exact;  ///< at_most and at_least are bounds in the head
  DefinitionCall call;            ///< what is computed
};

/// A figure of a scheme (scheme_figures.h).
struct OwnFigure {
  std::string name;    ///< of the file in figures/
  std::string scheme;  ///< with the names of its files as the program finds them
  std::string over;    ///< empty: the basis function; else the range of the free parameter
};

/// All that a file holds, in its order.
struct OwnClaims {
  std::vector<OwnClaim> claims;
  std::vector<OwnFigure> figures;
};

/// Reads such a file. Throws InputError with every mistake in it, a line each: file, line, what is wrong and
/// what would be right.
[[nodiscard]] OwnClaims read_own_claims(const std::filesystem::path& path);
/// The same for its text; `path` opens the messages, and its folder is where names of files start.
[[nodiscard]] OwnClaims parse_own_claims(std::string_view text, const std::filesystem::path& path);

/// One experiment for each claim and figure, so that they run side by side and one that breaks breaks no
/// other.
[[nodiscard]] std::vector<Experiment> own_experiments(const OwnClaims& own);

/// The claim with its verdict. Numbers: as settle() and settle_bound() have it. A printed closed form
/// ("log3(11)", "(1+sqrt(5))/4") is reproduced when it is the exact value, refuted when it is another number.
[[nodiscard]] Claim settle_own(const OwnClaim& claim);

}  // namespace subdiv
