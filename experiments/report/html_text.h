#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>

namespace subdiv {

/// Text that HTML shows as it stands, between tags and in quoted attributes alike.
[[nodiscard]] std::string html_text(std::string_view text);

/// The same, each id of a claim in it replaced by what `html` makes of it.
[[nodiscard]] std::string html_with_ids(std::string_view text, const std::set<std::string>& ids,
                                        const std::function<std::string(const std::string& id)>& html);

/// The same, each id of a claim in it turned into a link to the claim on the same page.
[[nodiscard]] std::string html_with_links(std::string_view text, const std::set<std::string>& ids);

/// Text as a value in an address' query: all but letters, digits and - . _ as %XX.
[[nodiscard]] std::string url_text(std::string_view text);

/// A link: `text` is text, not HTML.
[[nodiscard]] std::string html_link(const std::string& address, const std::string& text);

/// An SVG picture as the address of an image, quoted for an attribute: "data:image/svg+xml,...". Runs of
/// white space become one space.
[[nodiscard]] std::string svg_address(std::string_view svg);

}  // namespace subdiv
