#include "experiments/report/html_figure.h"

#include <algorithm>
#include <sstream>

#include "experiments/report/html_text.h"

namespace subdiv {
namespace {

bool shows(const FileEntry& figure, const std::string& id) {
  return std::ranges::any_of(figure.claims, [&](const std::string& claim) {
    return claim == id || (claim.ends_with('.') && id.starts_with(claim));
  });
}

/// Width and height from the picture's viewBox, as attributes, so that the page keeps their room.
std::string size_attributes(const std::string& svg) {
  const std::size_t at = svg.find("viewBox=\"");
  if (at == std::string::npos) return "";
  std::istringstream numbers(svg.substr(at + 9, 64));
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
  if (!(numbers >> x >> y >> width >> height)) return "";
  return " width=\"" + std::to_string(width) + "\" height=\"" + std::to_string(height) + "\"";
}

}  // namespace

FigurePlaces place_figures(std::span<const FileEntry> figures, std::span<const ClaimRecord> claims) {
  FigurePlaces places;
  for (const FileEntry& figure : figures) {
    bool placed = false;
    for (const ClaimRecord& claim : claims) {
      if (!shows(figure, claim.id)) continue;
      (placed ? places.mentioned : places.beside)[claim.id].push_back(&figure);
      placed = true;
    }
    if (!placed) places.of_experiment[figure.experiment].push_back(&figure);
  }
  return places;
}

std::string figure_anchor(const FileEntry& figure) { return "figure:" + figure.name; }

std::string html_figure(const FileEntry& figure, const std::string& svg) {
  const std::string caption = html_text(figure.title.empty() ? figure.name : figure.title);
  std::string text =
      "<figure id=\"" + html_text(figure_anchor(figure)) + "\" aria-label=\"" + caption + "\">";
  if (svg.empty()) {
    text += "<p>This figure has not been drawn.</p>";
  } else {
    text += "<img" + size_attributes(svg) + " loading=\"lazy\" decoding=\"async\" alt=\"" + caption +
            (figure.shows.empty() ? "" : ". " + html_text(figure.shows)) + "\" src=\"" + svg_address(svg) +
            "\">";
  }
  return text + "<figcaption>" + caption + " <a href=\"../figures/" + html_text(figure.name) + ".svg\">(" +
         html_text(figure.name) + ".svg)</a></figcaption></figure>\n";
}

}  // namespace subdiv
