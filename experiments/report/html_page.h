#pragma once

#include <string>

namespace subdiv {

/// A whole page of the report: head with style sheet and, where there is one, script, a link that skips to
/// the content, a header with the title and links to the other pages, `main`, a footer. Nothing is loaded
/// from elsewhere: the page's own content security policy forbids it.
struct HtmlPage {
  std::string title;
  std::string lead;     // HTML below the title
  std::string aside;    // HTML beside the content: navigation, filters; may be empty
  std::string content;  // HTML
  bool with_script = false;
  std::string name;          // "index.html", which the links leave out
  std::string style = {};    // CSS behind the common style sheet
  std::string scripts = {};  // script elements at the end of the page
  std::string policy =
      "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'";
};

[[nodiscard]] std::string html_page(const HtmlPage& page);

/// The style sheet of all pages, light and dark, wide, narrow and printed.
[[nodiscard]] const std::string& html_style();
/// The script of the report: filters kept in the address, deep links.
[[nodiscard]] const std::string& html_script();

}  // namespace subdiv
