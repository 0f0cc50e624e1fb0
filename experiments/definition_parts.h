#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/real_set.h"
#include "experiments/definitions.h"
#include "schemes/algebra/rational_function.h"
#include "schemes/expression.h"
#include "schemes/scheme_description.h"

namespace subdiv {

/// What several definitions share.

/// SCHEME with the names of its files made relative to a folder.
[[nodiscard]] std::string located_scheme(const std::string& text, const std::filesystem::path& folder);
/// The scheme of the argument "scheme"; names of files start at the call's folder.
[[nodiscard]] SchemeDescription scheme_of(const DefinitionCall& call);
/// The same, with a value for every parameter. Throws InputError that names those without.
[[nodiscard]] SchemeDescription fixed_scheme_of(const DefinitionCall& call);

/// A number that is known exactly, a text, a property.
[[nodiscard]] Answer number_answer(Enclosure value, std::string note = "");
[[nodiscard]] Answer property_answer(Decision holds, Rigour rigour, std::string note = "");

/// A set of real numbers; or one end of it as a number where the call has the argument "end".
[[nodiscard]] Answer set_answer(const DefinitionCall& call, const RealSet& set, std::string note = "");
[[nodiscard]] AnswerKind set_kind(const DefinitionCall& call);
/// A set as documents print it: "(1/15, 1/9)", "[0, 1) u {2}", "1/15 < mu <= 1/9". Throws InputError.
[[nodiscard]] RealSet parse_set(std::string_view printed);
/// The same as a check.
void check_set(const DefinitionCall& call, const std::string& printed);

/// "1/16, -5/8, 0", with or without brackets around it, as its parts.
[[nodiscard]] std::vector<Expression> parse_list(std::string_view printed);
void check_list(const DefinitionCall& call, const std::string& printed);

[[nodiscard]] DefinitionArgument scheme_argument();
[[nodiscard]] DefinitionArgument over_argument();
[[nodiscard]] DefinitionArgument continuity_argument();
[[nodiscard]] DefinitionArgument end_argument();
[[nodiscard]] DefinitionArgument seconds_argument(std::string seconds);

[[nodiscard]] inline AnswerKind always_number(const DefinitionCall& /*call*/) { return AnswerKind::number; }
inline void nothing_to_check(const DefinitionCall& /*call*/) {}

}  // namespace subdiv
