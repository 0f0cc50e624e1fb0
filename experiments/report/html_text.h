#pragma once

#include <set>
#include <string>
#include <string_view>

namespace subdiv {

/// Text that HTML shows as it stands, between tags and in quoted attributes alike.
[[nodiscard]] std::string html_text(std::string_view text);

/// The same, each id of a claim in it turned into a link: `page` is the page that holds the claims, empty for
/// the page itself.
[[nodiscard]] std::string html_with_links(std::string_view text, const std::set<std::string>& ids,
                                          const std::string& page = "");

/// An SVG picture as the address of an image, quoted for an attribute: "data:image/svg+xml,...". Runs of
/// white space become one space.
[[nodiscard]] std::string svg_address(std::string_view svg);

}  // namespace subdiv
