#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace subdiv {

/// User input made fit for a message: in single quotes, control and non-ASCII bytes shown as '?', long text
/// cut with "...".
[[nodiscard]] std::string in_quotes(std::string_view text);

/// The text without white space at both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// "a", "a or b", "a, b or c"; the last separator is a word of choice.
[[nodiscard]] std::string joined(std::span<const std::string> words,
                                 const std::string& last_separator = "or");

/// The known word nearest to `word` by edit distance (insertions, deletions, substitutions, swaps of
/// neighbours; case does not count); empty when none is nearer than half of the word's length.
[[nodiscard]] std::string nearest(std::string_view word, std::span<const std::string> known);

/// The end of a sentence about an unknown word: "; did you mean 'jspline'?" when a known one is near, else
/// ".".
[[nodiscard]] std::string suggestion(std::string_view word, std::span<const std::string> known);

/// "column 5 of '1/(6+s)': what", columns counted from 1; long text is shown around the column.
[[nodiscard]] std::string located(std::string_view text, std::size_t position, const std::string& what);

}  // namespace subdiv
