#include "experiments/report/html_page.h"

#include <array>

#include "experiments/report/html_text.h"

namespace subdiv {
namespace {

struct Link {
  const char* page;
  const char* text;
};

std::string links(const std::string& name) {
  constexpr std::array<Link, 4> pages{{{"index.html", "Claims"},
                                       {"errata.html", "Errata"},
                                       {"explorer.html", "Explorer"},
                                       {"../README.md", "Tables"}}};
  std::string text = "<nav class=\"pages\" aria-label=\"Pages\"><ul>";
  for (const Link& link : pages) {
    text += "<li><a href=\"" + std::string(link.page) + "\"" +
            (name == link.page ? " aria-current=\"page\"" : "") + ">" + link.text + "</a></li>";
  }
  return text + "</ul></nav>\n";
}

}  // namespace

std::string html_page(const HtmlPage& page) {
  std::string text =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"" +
      page.policy +
      "\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n"
      "<link rel=\"icon\" href=\"data:,\">\n<title>" +
      html_text(page.title) + "</title>\n<style>\n" + html_style() + page.style +
      "</style>\n</head>\n<body>\n";
  text += "<a class=\"skip\" href=\"#content\">Skip to the content</a>\n<header>\n<h1>" +
          html_text(page.title) + "</h1>\n" + page.lead + links(page.name) +
          "</header>\n<div class=\"columns\">\n";
  if (!page.aside.empty()) text += "<div class=\"aside\">\n" + page.aside + "</div>\n";
  text +=
      "<main id=\"content\" tabindex=\"-1\">\n" + page.content +
      "</main>\n</div>\n<footer><p>Written by <code>subdivlab reproduce</code>. The same in other forms: "
      "<a href=\"../claims.json\">claims.json</a>, <a href=\"../claims.csv\">claims.csv</a>.</p></footer>\n";
  if (page.with_script) text += "<script>\n" + html_script() + "</script>\n";
  return text + page.scripts + "</body>\n</html>\n";
}

}  // namespace subdiv
