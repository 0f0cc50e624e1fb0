#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace subdiv {

/// How figures write text: plain, but that "_" and "^" make an index or a power of the group in braces behind
/// them, or of the run of letters, digits and "-+./," (without a comma or point at its end): "J_{3/8}",
/// "*J_0.5, and". Other braces stand for themselves.

/// In the signs of gnuplot's enhanced text, quoted for its commands.
[[nodiscard]] std::string gnuplot_text(std::string_view text);
/// As it is read aloud, and as long as it is drawn: without the signs for indices. (Powers keep theirs.)
[[nodiscard]] std::string plain_text(std::string_view text);
/// Broken at spaces into as few lines as possible of at most `width` characters as drawn, where words allow
/// it, about equally long.
[[nodiscard]] std::vector<std::string> wrapped(const std::string& text, std::size_t width);

}  // namespace subdiv
