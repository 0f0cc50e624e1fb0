#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace subdiv {

/// Columns that a UTF-8 text takes on a terminal: its code points, combining marks left out (the texts here
/// have no wide characters).
[[nodiscard]] std::size_t display_width(std::string_view text);

/// The text when it is at most `width` columns wide, else its beginning and an ellipsis, `width` columns
/// together; never cuts a code point. Line breaks become spaces.
[[nodiscard]] std::string clipped(std::string_view text, std::size_t width);

/// Filled up with spaces on the right to `width` columns.
[[nodiscard]] std::string padded(std::string text, std::size_t width);

}  // namespace subdiv
