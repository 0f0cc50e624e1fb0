#include "experiments/report/html_overview.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "experiments/report/html_text.h"
#include "experiments/report/markdown.h"
#include "experiments/report/sharpened.h"

namespace subdiv {
namespace {

constexpr std::array verdicts{Verdict::reproduced,      Verdict::refuted,    Verdict::established,
                              Verdict::undecided,       Verdict::consistent, Verdict::inconsistent,
                              Verdict::not_reproducible};
constexpr std::array rigours{Rigour::exact, Rigour::certified, Rigour::approximate};

std::size_t count(std::span<const ClaimRecord> claims, std::string ClaimRecord::* field,
                  const std::string& value) {
  return static_cast<std::size_t>(std::ranges::count(claims, value, field));
}

std::string choice(const std::string& name, const std::string& value, const std::string& text,
                   std::size_t count) {
  return "<label><input type=\"checkbox\" name=\"" + name + "\" value=\"" + html_text(value) + "\"> " +
         html_text(text) + " <span class=\"count\">" + std::to_string(count) + "</span></label>\n";
}

}  // namespace

std::string document_anchor(const Document& document) {
  std::string anchor = "document:" + document.key;
  for (char& c : anchor) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 &&
        std::string_view(":._-").find(c) == std::string_view::npos)
      c = '-';
  }
  return anchor;
}

std::string html_filters(const ReportSource& source, std::span<const Document> documents) {
  std::string text =
      "<form id=\"filters\" role=\"search\" aria-label=\"Filter the claims\" hidden>\n"
      "<p><label for=\"words\">Search</label> <input type=\"search\" id=\"words\" name=\"q\" "
      "autocomplete=\"off\" "
      "placeholder=\"words, numbers, ids\"></p>\n<details id=\"choices\" aria-label=\"Choices\" "
      "open><summary>Choices</summary>\n<fieldset><legend>Verdict</legend>\n";
  for (const Verdict verdict : verdicts) {
    const std::string word = to_string(verdict);
    text += choice("verdict", word, word, count(source.claims, &ClaimRecord::verdict, word));
  }
  const auto count_if = [&](const auto& wanted) {
    return static_cast<std::size_t>(std::ranges::count_if(source.claims, wanted));
  };
  text += "</fieldset>\n<fieldset><legend>With</legend>\n";
  text += choice("sharpened", "yes", "sharpened bound or range",
                 count_if([&](const ClaimRecord& c) { return is_sharpened(c, source.claims); }));
  text += choice("certificate", "yes", "certificate", count_if([&](const ClaimRecord& c) {
                   return certificate_address(c, *source.manifest).has_value();
                 }));
  text += "</fieldset>\n<fieldset><legend>Rigour</legend>\n";
  for (const Rigour rigour : rigours) {
    const std::string word = to_string(rigour);
    text += choice("rigour", word, word, count(source.claims, &ClaimRecord::rigour, word));
  }
  text += "</fieldset>\n<fieldset><legend>Document</legend>\n";
  for (const Document& document : documents) {
    text += choice("document", document.key, document.key,
                   count(source.claims, &ClaimRecord::document, document.key));
  }
  return text +
         "</fieldset>\n</details>\n<p class=\"result\"><output id=\"status\" role=\"status\" "
         "aria-live=\"polite\"></output> "
         "<button type=\"reset\">Show all</button></p>\n</form>\n"
         "<p class=\"no-script\">Without JavaScript all claims are shown; the browser's own search finds "
         "words.</p>\n";
}

std::string html_contents(std::span<const Document> documents) {
  std::string text = "<nav aria-label=\"Documents\"><ul>";
  for (const Document& document : documents) {
    text += "<li><a href=\"#" + document_anchor(document) + "\">" + html_text(document.title) + "</a></li>";
  }
  return text + "</ul></nav>\n";
}

std::string html_overview(const ReportSource& source, std::span<const Document> documents) {
  std::string text = "<section id=\"overview\">\n<h2>Overview</h2>\n<p>" +
                     html_text(verdict_count(source.claims)) +
                     ".</p>\n<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"Verdicts by "
                     "document\"><table><caption>Verdicts by document; a number "
                     "leads to its claims</caption>\n<thead><tr><th scope=\"col\">Document</th>";
  for (const Verdict verdict : verdicts) text += "<th scope=\"col\">" + to_string(verdict) + "</th>";
  text += "</tr></thead>\n<tbody>\n";
  for (const Document& document : documents) {
    text += "<tr><th scope=\"row\">" + html_text(document.key) + "</th>";
    for (const Verdict verdict : verdicts) {
      const std::string word = to_string(verdict);
      const auto number = std::ranges::count_if(source.claims, [&](const ClaimRecord& c) {
        return c.document == document.key && c.verdict == word;
      });
      text += "<td>";
      if (number > 0) {
        text += "<a href=\"" +
                html_text("?verdict=" + word + "&document=" + url_text(document.key) + "#" +
                          document_anchor(document)) +
                "\">" + std::to_string(number) + "</a>";
      } else {
        text += "0";
      }
      text += "</td>";
    }
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n" +
         "<h3>What the words mean</h3>\n<dl class=\"words\">\n"
         "<div><dt>reproduced</dt><dd>The printed value or statement holds, proved.</dd></div>\n"
         "<div><dt>refuted</dt><dd>It does not hold; what is true stands beside it. See also <a "
         "href=\"errata.html\">the errata</a>.</dd></div>\n"
         "<div><dt>established</dt><dd>A finding of subdivlab, which no document prints, proved.</dd></div>\n"
         "<div><dt>undecided</dt><dd>The budget of the computation ended; the enclosure reached is "
         "shown.</dd></div>\n"
         "<div><dt>consistent, inconsistent</dt><dd>All that an approximate value may say.</dd></div>\n"
         "<div><dt>not-reproducible</dt><dd>A figure or formula is lost; the note says which.</dd></div>\n"
         "<div><dt>exact, certified, approximate</dt><dd>Decided in exact arithmetic; proved with outward "
         "rounding; "
         "computed in floating point without proof.</dd></div>\n<div><dt>certificate</dt><dd>A file "
         "that proves the value or statement on its own; <code>subdivlab verify</code> checks all of "
         "them.</dd></div>\n<div><dt>sharpened</dt><dd>" +
         html_text(sharpened_definition()) + "</dd></div>\n</dl>\n</section>\n";
}

}  // namespace subdiv
