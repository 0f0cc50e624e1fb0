#include "experiments/report/html_documents.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace subdiv {
namespace {

const std::string own = "subdivlab";

const std::array<Document, 5>& papers() {
  static const std::array<Document, 5> all{{
      {"js-report", "Technical report on J_s refinements",
       "The long first version of the work on J-splines, with the evaluator Ringing and its code."},
      {"jsplines", "J-splines (Rossignac & Schaefer)",
       "The published paper on J-splines, with meshes of quads and the popping schedule."},
      {"polyloops", "Smoothing and refining polyloops (Rossignac)",
       "A chapter on smoothing and refining closed polygons; its J(t) is J_{1-t/8} here."},
      {"notes", "Lecture notes on subdivision",
       "Bezier curves, B-splines by doubling and averaging, the four-point rule, Loop and butterfly "
       "surfaces."},
      {"speed", "Adjustable speed surface subdivision (Karciauskas & Peters)",
       "Surface rings around extraordinary vertices whose widths a speed sigma sets; 1/2 is Catmull-Clark."},
  }};
  return all;
}

bool is_document(const std::string& word) {
  return word == own || std::ranges::any_of(papers(), [&](const Document& d) { return d.key == word; });
}

std::string first_word(const std::string& text) { return text.substr(0, text.find_first_of(" ,")); }

std::string after_first_word(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" ,", first_word(text).size());
  return begin == std::string::npos ? "" : text.substr(begin);
}

/// "section 3" of "3", "section V-B, (12)" of "V-B, (12)"; "abstract" and "figure 10" name themselves.
std::string section_words(const std::string& section) {
  if (section.empty()) return "";
  const bool numbered =
      std::isdigit(static_cast<unsigned char>(section[0])) != 0 || section[0] == 'I' || section[0] == 'V';
  return (numbered ? "section " : "") + section;
}

struct Section {
  std::string own;    // "3"
  std::string other;  // "js-report 3"; empty without other documents
};

/// Takes "3 (js-report 3)" apart; parentheses that name no document belong to the section.
Section take_apart(const std::string& section) {
  const std::size_t open = section.rfind(" (");
  if (open == std::string::npos || section.back() != ')') return {section, ""};
  const std::string inner = section.substr(open + 2, section.size() - open - 3);
  if (!is_document(first_word(inner))) return {section, ""};
  return {section.substr(0, open), inner};
}

/// "js-report, section 3" of "js-report 3".
std::string elsewhere(const std::string& text) {
  if (!is_document(first_word(text))) return text;
  const std::string section = section_words(after_first_word(text));
  return first_word(text) + (section.empty() ? "" : ", " + section);
}

}  // namespace

std::vector<Document> documents_of(std::span<const ClaimRecord> claims) {
  const auto occurs = [&](const std::string& key) {
    return std::ranges::any_of(claims, [&](const ClaimRecord& c) { return c.document == key; });
  };
  std::vector<Document> result;
  for (const Document& paper : papers()) {
    if (occurs(paper.key)) result.push_back(paper);
  }
  for (const ClaimRecord& claim : claims) {
    const bool known = claim.document == own || std::ranges::any_of(result, [&](const Document& d) {
                         return d.key == claim.document;
                       });
    if (!known) result.push_back({claim.document, claim.document, ""});
  }
  if (occurs(own)) {
    result.push_back(
        {own, "Findings of subdivlab", "What no document prints, proved here, with what it belongs to."});
  }
  return result;
}

std::string own_section(const ClaimRecord& claim) {
  const std::string section = take_apart(claim.section).own;
  return claim.document == own && is_document(first_word(section)) ? after_first_word(section) : section;
}

std::string subject_of(const ClaimRecord& claim) {
  const std::string word = first_word(claim.section);
  return claim.document == own && is_document(word) ? word : claim.document;
}

std::string place_of(const ClaimRecord& claim) {
  const auto [section, other] = take_apart(claim.section);
  const std::string place = claim.document == own ? "on " + elsewhere(section) : section_words(section);
  return other.empty() ? place : place + "; also " + elsewhere(other);
}

}  // namespace subdiv
