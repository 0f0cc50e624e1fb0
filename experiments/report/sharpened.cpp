#include "experiments/report/sharpened.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "experiments/report/html_documents.h"

namespace subdiv {
namespace {

/// Whether `word` stands in the text as a whole word; letters, digits, '-' and '.' between letters make
/// words.
bool names(std::string_view text, std::string_view word) {
  const auto joins = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
  };
  for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool begins = at == 0 || !(joins(text[at - 1]) || text[at - 1] == '.');
    const bool goes_on =
        end < text.size() &&
        (joins(text[end]) || (text[end] == '.' && end + 1 < text.size() && joins(text[end + 1])));
    if (begins && !goes_on) return true;
  }
  return false;
}

bool is_bound_or_range(const ClaimRecord& claim) {
  if (claim.kind == to_string(ClaimKind::bound)) return true;
  for (const char* sign : {"<", ">", "\u2264", "\u2265"}) {
    if (claim.printed->find(sign) != std::string::npos) return true;
  }
  return names(*claim.printed, "range");
}

/// Whether the enclosure leaves the printed bound out; false where that is no number.
bool lies_strictly_inside(const ClaimRecord& claim) {
  if (claim.kind != to_string(ClaimKind::bound) || !claim.lower || !claim.upper) return false;
  try {
    const Rational printed = printed_value(*claim.printed);
    return printed < Rational::parse(*claim.lower) || Rational::parse(*claim.upper) < printed;
  } catch (const std::logic_error&) {
    return false;
  }
}

std::vector<std::string> parts(const std::string& id) {
  std::vector<std::string> result;
  for (std::size_t begin = 0; begin <= id.size();) {
    const std::size_t end = std::min(id.find('.', begin), id.size());
    result.push_back(id.substr(begin, end - begin));
    begin = end + 1;
  }
  return result;
}

/// The first part of the ids and, after the second, all that the claim has agree.
bool is_about_the_same(const std::string& claim, const std::string& finding) {
  const auto a = parts(claim);
  const auto b = parts(finding);
  return a.size() > 2 && b.size() >= a.size() && a[0] == b[0] &&
         std::equal(a.begin() + 2, a.end(), b.begin() + 2);
}

/// "3" of "3, equation (1)".
std::string number(const ClaimRecord& claim) {
  const std::string section = own_section(claim);
  return section.substr(0, section.find_first_of(", "));
}

}  // namespace

std::vector<std::string> sharper_findings(const ClaimRecord& claim, std::span<const ClaimRecord> claims) {
  std::vector<std::string> result;
  for (const ClaimRecord& finding : claims) {
    if (finding.verdict != to_string(Verdict::established)) continue;
    const bool same_section = subject_of(finding) == claim.document && number(finding) == number(claim);
    if (finding.id.starts_with(claim.id + ".") || names(claim.note, finding.id) ||
        names(claim.definition, finding.id) || (same_section && is_about_the_same(claim.id, finding.id))) {
      result.push_back(finding.id);
    }
  }
  return result;
}

bool is_sharpened(const ClaimRecord& claim, std::span<const ClaimRecord> claims) {
  if (!claim.printed || claim.verdict != to_string(Verdict::reproduced) || !is_bound_or_range(claim))
    return false;
  return lies_strictly_inside(claim) || !sharper_findings(claim, claims).empty();
}

std::string sharpened_definition() {
  return "A printed bound or range that holds and for which more is proved: a bound whose value lies "
         "strictly inside, or "
         "a bound or range on which an established finding says more, such as where it ends. Printed strings "
         "with "
         "<, >, \u2264, \u2265 or the word \u201crange\u201d count as ranges; the findings are those listed "
         "at the claim.";
}

}  // namespace subdiv
