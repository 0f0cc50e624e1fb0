#include "experiments/report/html_claim.h"

#include <algorithm>
#include <array>

#include "experiments/report/html_documents.h"
#include "experiments/report/html_text.h"
#include "experiments/report/sharpened.h"

namespace subdiv {
namespace {

std::string row(const std::string& term, const std::string& html) {
  return "<div><dt>" + term + "</dt><dd>" + html + "</dd></div>\n";
}

std::string code(const std::string& text) { return "<code>" + html_text(text) + "</code>"; }

std::string figures_of(const std::map<std::string, std::vector<const FileEntry*>>& places,
                       const std::string& id, const std::function<std::string(const FileEntry&)>& html) {
  std::string text;
  const auto found = places.find(id);
  if (found == places.end()) return text;
  for (const FileEntry* figure : found->second) text += html(*figure);
  return text;
}

std::string list_of(const std::vector<std::string>& items) {
  std::string text;
  for (const std::string& item : items) text += (text.empty() ? "" : ", ") + item;
  return text;
}

/// The digits that are certain, 15 at most, without the noughts that only fill up.
std::string digits_of(const ClaimRecord& claim) {
  constexpr std::size_t any_width = 200;
  ClaimRecord number = claim;
  number.exact.reset();
  std::string digits = value_text(number, any_width);
  const bool is_decimal =
      digits.find('.') != std::string::npos && digits.find_first_of("e[") == std::string::npos;
  if (claim.lower != claim.upper || !is_decimal) return digits;
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.back() == '.') digits.pop_back();
  return digits;
}

std::string note_term(const ClaimRecord& claim) {
  return claim.verdict == to_string(Verdict::refuted) ? "What is true" : "Note";
}

std::string rows(const ClaimRecord& claim, const ClaimContext& context, bool sharpened) {
  std::string text;
  if (claim.printed) text += row("Printed", "<q>" + html_text(*claim.printed) + "</q>");
  text += row("Value", html_value(claim));
  if (!claim.note.empty()) text += row(note_term(claim), html_with_links(claim.note, context.ids));
  text += row("Definition", html_with_links(claim.definition, context.ids));
  if (sharpened) {
    std::vector<std::string> links;
    for (const std::string& id : sharper_findings(claim, context.source.claims))
      links.push_back(html_link("#" + id, id));
    text +=
        row("More is proved", links.empty() ? "The value lies strictly inside the bound." : list_of(links));
  }
  const std::string mentioned = figures_of(context.figures.mentioned, claim.id, [](const FileEntry& figure) {
    return "<li>" + html_link("#" + figure_anchor(figure), figure.title) + "</li>";
  });
  if (!mentioned.empty()) text += row("Figure", "<ul>" + mentioned + "</ul>");
  if (is_erratum(claim))
    text += row("For the authors", html_link("errata.html#" + claim.id, "the entry in the errata"));
  if (const auto certificate = certificate_address(claim, *context.source.manifest)) {
    text += row("Certificate", html_link(*certificate, claim.id + ".txt"));
  }
  return text;
}

}  // namespace

bool is_erratum(const ClaimRecord& claim) {
  constexpr std::array verdicts{Verdict::refuted, Verdict::inconsistent, Verdict::not_reproducible};
  return claim.printed &&
         std::ranges::any_of(verdicts, [&](Verdict v) { return claim.verdict == to_string(v); });
}

ClaimContext context_of(const ReportSource& source) {
  ClaimContext context{source, place_figures(source.manifest->figures, source.claims), {}};
  for (const ClaimRecord& claim : source.claims) context.ids.insert(claim.id);
  return context;
}

std::optional<std::string> certificate_address(const ClaimRecord& claim, const Manifest& manifest) {
  if (std::ranges::find(manifest.certificates, claim.id) == manifest.certificates.end()) return std::nullopt;
  return "../certificates/" + claim.id + ".txt";
}

std::string html_value(const ClaimRecord& claim, ValueLength length) {
  const bool brief = length == ValueLength::brief;
  const bool has_ends = claim.lower && claim.upper;
  // An integer is its own digits; a fraction, a root and an expression are easier to compare as decimals.
  const bool is_integer = claim.exact && claim.exact->find_first_not_of("-0123456789") == std::string::npos;
  constexpr std::size_t brief_width = 60;
  const bool too_long = brief && has_ends && claim.exact && claim.exact->size() > brief_width;
  std::string text = claim.exact && !too_long ? code(*claim.exact) : "";
  if (!has_ends || is_integer) return text.empty() ? "none" : text;
  std::string digits = digits_of(claim);
  if (claim.exact && digits.starts_with('~')) digits.erase(0, 1);  // a counted share, itself exact
  text += (text.empty() ? "" : " = ") + code(digits);
  if (!brief && claim.lower != claim.upper) {
    text +=
        "<br><span class=\"ends\">between " + code(*claim.lower) + " and " + code(*claim.upper) + "</span>";
  }
  return text;
}

std::string html_claim(const ClaimRecord& claim, const ClaimContext& context) {
  const bool sharpened = is_sharpened(claim, context.source.claims);
  const std::string id = html_text(claim.id);
  const std::string figures = figures_of(context.figures.beside, claim.id, [&](const FileEntry& figure) {
    return html_figure(figure, context.source.picture(figure.name));
  });
  std::string text =
      "<article class=\"claim" + std::string(figures.empty() ? "" : " illustrated") + "\" id=\"" + id +
      "\" data-document=\"" + html_text(claim.document) + "\" data-verdict=\"" + html_text(claim.verdict) +
      "\" data-rigour=\"" + html_text(claim.rigour) + "\"" + (sharpened ? " data-sharpened=\"yes\"" : "") +
      (certificate_address(claim, *context.source.manifest) ? " data-certificate=\"yes\"" : "") +
      ">\n<div class=\"text\">\n<h4><a class=\"deep\" href=\"#" + id + "\">" + id + "</a></h4>\n";
  text += "<p class=\"marks\"><span class=\"mark " + html_text(claim.verdict) + "\">" +
          html_text(claim.verdict) + "</span> <span class=\"mark\">" + html_text(claim.rigour) + "</span> " +
          (sharpened ? "<span class=\"mark sharpened\">sharpened</span> " : "") + "<span class=\"place\">" +
          html_text(place_of(claim)) + "</span></p>\n<dl>\n" + rows(claim, context, sharpened) +
          "</dl>\n</div>\n";
  if (!figures.empty()) text += "<div class=\"figures\">\n" + figures + "</div>\n";
  return text + "</article>\n";
}

}  // namespace subdiv
