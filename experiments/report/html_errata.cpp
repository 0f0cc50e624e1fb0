#include "experiments/report/html_errata.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "experiments/report/html_documents.h"
#include "experiments/report/html_overview.h"
#include "experiments/report/html_page.h"
#include "experiments/report/html_text.h"

namespace subdiv {
namespace {

/// Claims of one document that one note settles: they make one entry.
using Entry = std::vector<const ClaimRecord*>;

std::vector<Entry> entries_of(const Document& document, const ReportSource& source, Verdict verdict) {
  std::vector<Entry> entries;
  for (const ClaimRecord& claim : source.claims) {
    if (claim.document != document.key || claim.verdict != to_string(verdict)) continue;
    const auto same = std::ranges::find_if(entries, [&](const Entry& e) {
      return e.front()->note == claim.note && place_of(*e.front()) == place_of(claim);
    });
    if (same == entries.end()) {
      entries.push_back({&claim});
    } else {
      same->push_back(&claim);
    }
  }
  return entries;
}

std::string capitalised(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

/// What the decision rests on, as a sentence.
std::string how(const ClaimRecord& claim) {
  if (claim.rigour == to_string(Rigour::exact)) return "Decided in exact arithmetic.";
  if (claim.rigour == to_string(Rigour::certified)) return "Proved by enclosures with outward rounding.";
  return "Computed in floating point; this is evidence and no proof.";
}

/// Whether the value says more than the verdict does.
bool tells(const ClaimRecord& claim) {
  return (claim.exact && *claim.exact != "false" && *claim.exact != "true") || (!claim.exact && claim.lower);
}

std::string row(const std::string& term, const std::string& html) {
  return "<div><dt>" + term + "</dt><dd>" + html + "</dd></div>\n";
}

/// Texts of one entry. Ids of other claims become references [1], [2], .., which stand below the entry.
class EntryText {
 public:
  EntryText(const Entry& entry, const std::set<std::string>& ids) : entry_(entry), ids_(ids) {}

  [[nodiscard]] std::string with_references(const std::string& text) {
    return html_with_ids(text, ids_, [&](const std::string& id) {
      const auto known = std::ranges::find(references_, id);
      const auto number = std::to_string(known - references_.begin() + 1);
      if (known == references_.end()) references_.push_back(id);
      return html_link("index.html#" + id, "[" + number + "]");
    });
  }

  /// What each claim of the entry adds of its own; the printed string leads where there are several.
  [[nodiscard]] std::string each(const std::function<std::string(const ClaimRecord&)>& html) const {
    if (entry_.size() == 1) return html(*entry_.front());
    std::string text = "<ul>";
    for (const ClaimRecord* claim : entry_) {
      text += "<li><q>" + html_text(claim->printed.value_or("")) + "</q>: " + html(*claim) + "</li>";
    }
    return text + "</ul>";
  }

  /// The sentences that all definitions have, then those of each claim.
  [[nodiscard]] std::string definitions() {
    if (entry_.size() == 1) return with_references(entry_.front()->definition);
    const auto is_common = [&](const std::string& sentence) {
      return std::ranges::all_of(entry_, [&](const ClaimRecord* claim) {
        const auto own = sentences(claim->definition);
        return std::ranges::find(own, sentence) != own.end();
      });
    };
    std::string common;
    for (const std::string& sentence : sentences(entry_.front()->definition)) {
      if (is_common(sentence)) common += sentence + " ";
    }
    std::string text = with_references(common);
    text += each([&](const ClaimRecord& claim) {
      std::string own;
      for (const std::string& sentence : sentences(claim.definition)) {
        if (!is_common(sentence)) own += sentence + " ";
      }
      return with_references(own);
    });
    return text;
  }

  /// Links to the proofs that stand on their own; empty without them.
  [[nodiscard]] std::string certificates(const Manifest& manifest) const {
    std::string links;
    for (const ClaimRecord* claim : entry_) {
      const auto address = certificate_address(*claim, manifest);
      if (address) links += (links.empty() ? "" : ", ") + html_link(*address, claim->id + ".txt");
    }
    return links.empty() ? "" : " A proof that stands on its own: " + links + ".";
  }

  /// Links to the claim in the report and to what the texts refer to.
  [[nodiscard]] std::string references() const {
    std::string text = html_link("index.html#" + entry_.front()->id, entry_.front()->id);
    for (std::size_t i = 0; i < references_.size(); ++i) {
      text +=
          ", [" + std::to_string(i + 1) + "] " + html_link("index.html#" + references_[i], references_[i]);
    }
    return text;
  }

 private:
  static std::vector<std::string> sentences(const std::string& text) {
    std::vector<std::string> result;
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = std::min(text.find(". ", begin), text.size() - 1) + 1;
      result.push_back(text.substr(begin, end - begin));
      begin = text.find_first_not_of(' ', end);
    }
    return result;
  }

  const Entry& entry_;
  const std::set<std::string>& ids_;
  std::vector<std::string> references_;
};

std::string redo(const Entry& entry) {
  std::string command = "build/subdivlab reproduce";
  for (const ClaimRecord* claim : entry) command += " " + claim->id;
  return "<pre tabindex=\"0\" role=\"region\" aria-label=\"Command\"><code>" + html_text(command) +
         "</code></pre>";
}

struct Terms {
  const char* note;
  const char* value;
};

std::string html_entry(const Entry& entry, const Terms& terms, const Manifest& manifest,
                       const std::string& number, const std::set<std::string>& ids) {
  std::string text = "<article class=\"erratum\" id=\"" + html_text(entry.front()->id) + "\">\n<h4>" +
                     number + ". " + html_text(capitalised(place_of(*entry.front()))) + "</h4>\n";
  for (const ClaimRecord* claim : entry) {
    const std::string anchor = claim == entry.front() ? "" : " id=\"" + html_text(claim->id) + "\"";
    text += "<blockquote" + anchor + "><p>" + html_text(claim->printed.value_or("")) + "</p></blockquote>\n";
  }
  EntryText own(entry, ids);
  text += "<dl>\n" + row(terms.note, own.with_references(entry.front()->note));
  if (std::ranges::any_of(entry, [](const ClaimRecord* c) { return tells(*c); })) {
    text +=
        row(terms.value, own.each([](const ClaimRecord& c) { return html_value(c, ValueLength::brief); }));
  }
  text += row("What we examined", own.definitions());
  if (entry.front()->verdict != to_string(Verdict::not_reproducible))
    text += row("How decided", how(*entry.front()) + own.certificates(manifest));
  text += row("To redo it", redo(entry));
  return text + row("In the report", own.references()) + "</dl>\n</article>\n";
}

struct Kind {
  Verdict verdict;
  const char* title;
  Terms terms;
  const char* about;
};

std::string html_document(const Document& document, const ReportSource& source,
                          const std::set<std::string>& ids) {
  constexpr std::array<Kind, 3> kinds{{
      {Verdict::refuted, "What does not hold as printed", {"What is true", "Found"}, ""},
      {Verdict::inconsistent,
       "What measurements do not support",
       {"What was measured", "Share or value"},
       "These statements are matters of degree; what we measured speaks against them and proves nothing."},
      {Verdict::not_reproducible,
       "What could not be recomputed",
       {"What is missing", "Our value"},
       "We would be grateful for the missing data or formulas."},
  }};
  std::string text;
  std::size_t number = 0;
  for (const Kind& kind : kinds) {
    const std::vector<Entry> entries = entries_of(document, source, kind.verdict);
    if (entries.empty()) continue;
    text += "<section>\n<h3>" + std::string(kind.title) + "</h3>\n";
    if (*kind.about != '\0') text += "<p>" + std::string(kind.about) + "</p>\n";
    for (const Entry& entry : entries) {
      text += html_entry(entry, kind.terms, *source.manifest, std::to_string(++number), ids);
    }
    text += "</section>\n";
  }
  if (text.empty()) return "";
  return "<section class=\"document\" id=\"" + document_anchor(document) + "\">\n<h2>" +
         html_text(document.title) + "</h2>\n" + text + "</section>\n";
}

std::string introduction(std::span<const ClaimRecord> claims) {
  const auto printed =
      std::ranges::count_if(claims, [](const ClaimRecord& c) { return c.printed.has_value(); });
  const auto reproduced = std::ranges::count(claims, to_string(Verdict::reproduced), &ClaimRecord::verdict);
  return "<section>\n<h2>About these errata</h2>\n<p>We recomputed " + std::to_string(printed) +
         " constants and statements of these documents with the library and program subdivlab; " +
         std::to_string(reproduced) + R"html( hold, with a proof. Below
is what does not hold as printed, what is true instead, and what we could not recompute because a figure or a formula is
lost in the copy at hand. Quotations are verbatim, but for superscripts and subscripts that became plain text. Should an
entry rest on a misreading of ours, we would be glad to learn of it.</p>
<p>Every entry names the command that decides it anew, after <code>experiments/reproduce</code> has built the program,
and links to the claim in the report. Of exact and enclosed numbers all digits shown are certain, but for the rounding
of the last; the report has more.</p>
<h3>Notation</h3>
<p><code>J_s</code> is one step of the J-spline scheme with the tension s: 0 is the four-point scheme, 1 the cubic and 3/2
the quintic B-spline scheme. <code>J_{a,b}</code> has a parameter for the vertex rule and one for the edge rule.
<code>*J_s</code> is that step repeated without end, and <code>{J_r, *J_s}</code> one step <code>J_r</code> before it. In
the chapter on polyloops <code>J5</code> and so on are written in its older parameter: J(t) there is
<code>J_{1-t/8}</code> here.</p>
</section>
)html";
}

}  // namespace

std::string errata_page(const ReportSource& source) {
  std::set<std::string> ids;
  for (const ClaimRecord& claim : source.claims) ids.insert(claim.id);
  const std::vector<Document> documents = documents_of(source.claims);
  std::string content;
  std::vector<Document> listed;
  for (const Document& document : documents) {
    const std::string text = html_document(document, source, ids);
    if (!text.empty()) listed.push_back(document);
    content += text;
  }
  const bool none = content.empty();
  if (none) content = "<p>No claim is refuted, inconsistent or not reproducible.</p>\n";
  return html_page({.title = "Errata and open points",
                    .lead = "<p>What subdivlab found in documents on subdivision curves and surfaces.</p>\n",
                    .aside = none ? "" : html_contents(listed),
                    .content = introduction(source.claims) + content,
                    .name = "errata.html"});
}

}  // namespace subdiv
