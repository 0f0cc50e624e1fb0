#include "experiments/report/html_report.h"

#include <algorithm>

#include "experiments/report/html_documents.h"
#include "experiments/report/html_overview.h"
#include "experiments/report/html_page.h"
#include "experiments/report/html_text.h"

namespace subdiv {
namespace {

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
  return "section:" + document_anchor(document).substr(9) + ":" + group.name;
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
  return "<section id=\"other:figures\"><h2>Other figures</h2>\n<div class=\"gallery\">\n" + figures +
         "</div>\n</section>\n";
}

std::string html_document(const Document& document, const ClaimContext& context,
                          std::set<std::string>& shown) {
  const std::vector<Group> groups = groups_of(document, context.source);
  std::string text = "<section class=\"document\" id=\"" + document_anchor(document) + "\">\n<h2>" +
                     html_text(document.title) + "</h2>\n<p>" + html_text(document.about) +
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

}  // namespace

std::string report_page(const ReportSource& source) {
  const ClaimContext context = context_of(source);
  const std::vector<Document> documents = documents_of(source.claims);
  std::string content = html_overview(source, documents);
  std::set<std::string> shown;
  for (const Document& document : documents) content += html_document(document, context, shown);
  content += other_figures(context, shown);
  return html_page(
      {.title = "subdivlab: printed claims, checked",
       .lead = "<p>Constants and statements of papers on subdivision curves and surfaces, recomputed: with "
               "proof, or with what is true instead.</p>\n",
       .aside = html_contents(documents) + html_filters(source, documents),
       .content = content,
       .with_script = true,
       .name = "index.html"});
}

}  // namespace subdiv
