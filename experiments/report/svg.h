#pragma once

#include <string>
#include <string_view>

namespace subdiv {

/// gnuplot's SVG as a document that stands on its own: title and description are what screen readers say of
/// it; names of fonts with their replacements; a white edge about text, so that no line crosses it; no empty
/// groups, no raster filters, no version of gnuplot; polygons as short paths, with a hairline in their own
/// colour that closes the seams between neighbours. `id` begins the ids of title and description.
[[nodiscard]] std::string finished_svg(const std::string& text, const std::string& id,
                                       const std::string& title, const std::string& description);

/// With &, <, > and quotes as entities.
[[nodiscard]] std::string xml_text(std::string_view text);

}  // namespace subdiv
