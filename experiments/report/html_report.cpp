#include "experiments/report/html_report.h"

#include <algorithm>
#include <array>

#include "experiments/report/html_documents.h"
#include "experiments/report/html_page.h"
#include "experiments/report/html_text.h"
#include "experiments/report/markdown.h"
#include "experiments/report/sharpened.h"

namespace subdiv {
namespace {

constexpr std::array verdicts{Verdict::reproduced,      Verdict::refuted,    Verdict::established,
                              Verdict::undecided,       Verdict::consistent, Verdict::inconsistent,
                              Verdict::not_reproducible};
constexpr std::array rigours{Rigour::exact, Rigour::certified, Rigour::approximate};

using Claims = std::vector<const ClaimRecord*>;

/// The claims of one document that one experiment settles.
struct Group {
  std::string name;   // the experiment's
  std::string title;  // without the documents and sections in parentheses
  Claims claims;
};

std::string short_title(const Experiment& experiment) {
  const std::size_t open = experiment.title.rfind(" (");
  return experiment.title.substr(0, open);
}

/// The groups of a document in the order of the experiments; claims of no experiment make a last one.
std::vector<Group> groups_of(const Document& document, const ReportSource& source) {
  std::vector<Group> groups;
  std::set<std::string> owned;
  for (const Experiment& experiment : source.experiments) {
    Group group{experiment.name, short_title(experiment), {}};
    for (const ClaimHead& head : experiment.heads()) {
      owned.insert(head.id);
      const auto claim = std::ranges::find(source.claims, head.id, &ClaimRecord::id);
      if (claim != source.claims.end() && claim->document == document.key) group.claims.push_back(&*claim);
    }
    if (!group.claims.empty()) groups.push_back(std::move(group));
  }
  Group others{"others", "Other claims", {}};
  for (const ClaimRecord& claim : source.claims) {
    if (claim.document == document.key && !owned.contains(claim.id)) others.claims.push_back(&claim);
  }
  if (!others.claims.empty()) groups.push_back(std::move(others));
  return groups;
}

std::string group_anchor(const Document& document, const Group& group) {
  return "section:" + document.key + ":" + group.name;
}

/// "§3, abstract": the sections of a group's claims, each once, without figures and equations; those
/// of findings with their documents.
std::string sections_of(const Group& group) {
  std::vector<std::string> sections;
  for (const ClaimRecord* claim : group.claims) {
    const std::string section = own_section(*claim);
    std::string words = subject_of(*claim) == claim->document ? "" : subject_of(*claim) + " ";
    const bool numbered = section.find_first_of("0123456789IV") == 0;
    words += (numbered ? "§" : "") + section.substr(0, std::min(section.find(','), section.find(" (")));
    if (std::ranges::find(sections, words) == sections.end()) sections.push_back(words);
  }
  std::string text;
  for (const std::string& section : sections) text += (text.empty() ? "" : ", ") + section;
  return text;
}

/// A link from the claims of a document to the findings of the same experiment.
std::string link_to_findings(const Document& document, const Group& group, const ReportSource& source) {
  if (document.key == "subdivlab") return "";
  const auto experiment = std::ranges::find(source.experiments, group.name, &Experiment::name);
  if (experiment == source.experiments.end()) return "";
  const auto found = std::ranges::count_if(experiment->heads(), [&](const ClaimHead& head) {
    return head.document == "subdivlab" &&
           std::ranges::find(source.claims, head.id, &ClaimRecord::id) != source.claims.end();
  });
  if (found == 0) return "";
  return "<p><a href=\"" + html_text("#section:subdivlab:" + group.name) + "\">" + std::to_string(found) +
         (found == 1 ? " finding" : " findings") + " of subdivlab beside these claims</a></p>\n";
}

std::string html_group(const Document& document, const Group& group, const ClaimContext& context,
                       std::set<std::string>& shown) {
  std::string text = "<section class=\"group\" id=\"" + html_text(group_anchor(document, group)) +
                     "\">\n<h3>" + html_text(group.title) + " <span class=\"sections\">" +
                     html_text(sections_of(group)) + "</span></h3>\n" +
                     link_to_findings(document, group, context.source);
  for (const ClaimRecord* claim : group.claims) text += html_claim(*claim, context);
  const auto figures = context.figures.of_experiment.find(group.name);
  if (figures != context.figures.of_experiment.end() && shown.insert(group.name).second) {
    text += "<div class=\"gallery\">\n";
    for (const FileEntry* figure : figures->second)
      text += html_figure(*figure, context.source.picture(figure->name));
    text += "</div>\n";
  }
  return text + "</section>\n";
}

/// Figures of experiments without any claim on the page.
std::string other_figures(const ClaimContext& context, const std::set<std::string>& shown) {
  std::string figures;
  for (const auto& [experiment, entries] : context.figures.of_experiment) {
    if (shown.contains(experiment)) continue;
    for (const FileEntry* figure : entries)
      figures += html_figure(*figure, context.source.picture(figure->name));
  }
  if (figures.empty()) return "";
  return "<section id=\"document:figures\"><h2>Other figures</h2>\n<div class=\"gallery\">\n" + figures +
         "</div>\n</section>\n";
}

std::string html_document(const Document& document, const ClaimContext& context,
                          std::set<std::string>& shown) {
  const std::vector<Group> groups = groups_of(document, context.source);
  std::string text = "<section class=\"document\" id=\"" + html_text("document:" + document.key) +
                     "\">\n<h2>" + html_text(document.title) + "</h2>\n<p>" + html_text(document.about) +
                     "</p>\n<ul class=\"contents\">";
  for (const Group& group : groups) {
    text += "<li><a href=\"" + html_text("#" + group_anchor(document, group)) + "\">" +
            html_text(group.title) + "</a> <span class=\"count\">" + std::to_string(group.claims.size()) +
            "</span></li>";
  }
  text += "</ul>\n";
  for (const Group& group : groups) text += html_group(document, group, context, shown);
  return text + "</section>\n";
}

std::size_t count(std::span<const ClaimRecord> claims, std::string ClaimRecord::* field,
                  const std::string& value) {
  return static_cast<std::size_t>(std::ranges::count(claims, value, field));
}

std::string choice(const std::string& name, const std::string& value, const std::string& text,
                   std::size_t count) {
  return "<label><input type=\"checkbox\" name=\"" + name + "\" value=\"" + html_text(value) + "\"> " +
         html_text(text) + " <span class=\"count\">" + std::to_string(count) + "</span></label>\n";
}

std::string filters(const ReportSource& source, std::span<const Document> documents) {
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
  text += "</fieldset>\n<fieldset><legend>More is proved</legend>\n";
  text += choice("sharpened", "yes", "sharpened",
                 static_cast<std::size_t>(std::ranges::count_if(
                     source.claims, [&](const ClaimRecord& c) { return is_sharpened(c, source.claims); })));
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

std::string contents(std::span<const Document> documents) {
  std::string text = "<nav aria-label=\"Documents\"><ul>";
  for (const Document& document : documents) {
    text += "<li><a href=\"" + html_text("#document:" + document.key) + "\">" + html_text(document.title) +
            "</a></li>";
  }
  return text + "</ul></nav>\n";
}

/// A table of verdicts by documents; each number links to its claims.
std::string overview(const ReportSource& source, std::span<const Document> documents) {
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
                html_text("?verdict=" + word + "&document=" + document.key + "#document:" + document.key) +
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
         "computed in floating point without proof.</dd></div>\n<div><dt>sharpened</dt><dd>" +
         html_text(sharpened_definition()) + "</dd></div>\n</dl>\n</section>\n";
}

}  // namespace

std::string report_page(const ReportSource& source) {
  const ClaimContext context = context_of(source);
  const std::vector<Document> documents = documents_of(source.claims);
  std::string content = overview(source, documents);
  std::set<std::string> shown;
  for (const Document& document : documents) content += html_document(document, context, shown);
  content += other_figures(context, shown);
  return html_page(
      {.title = "subdivlab: printed claims, checked",
       .lead = "<p>Constants and statements of papers on subdivision curves and surfaces, recomputed: with "
               "proof, or with what is true instead.</p>\n",
       .aside = contents(documents) + filters(source, documents),
       .content = content,
       .with_script = true,
       .name = "index.html"});
}

}  // namespace subdiv
