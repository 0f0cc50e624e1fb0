#include <algorithm>
#include <array>
#include <regex>
#include <set>

#include <gtest/gtest.h>

#include "experiments/report/html_documents.h"
#include "experiments/report/html_errata.h"
#include "experiments/report/html_page.h"
#include "experiments/report/html_report.h"
#include "experiments/report/html_text.h"
#include "experiments/report/pages.h"
#include "experiments/report/sharpened.h"

namespace subdiv {
namespace {

const char* const picture =
    "<?xml version=\"1.0\"?>\n<svg viewBox=\"0 0 800 500\" xmlns=\"http://www.w3.org/2000/svg\">\n\t<path "
    "stroke='#fff' d='M0,0\n1,1'/>100% &amp;</svg>\n";

ClaimRecord claim(const std::string& id, const std::string& document, const std::string& section,
                  const std::string& verdict, std::optional<std::string> printed,
                  const std::string& note = "") {
  return {.id = id,
          .document = document,
          .section = section,
          .printed = std::move(printed),
          .kind = "exact",
          .definition = "the definition of " + id + ".",
          .exact = "true",
          .lower = std::nullopt,
          .upper = std::nullopt,
          .rigour = "exact",
          .verdict = verdict,
          .note = note};
}

std::span<const ClaimHead> sample_heads() {
  static const std::array heads{
      ClaimHead{"a.bound.c1", "jsplines", "3 (js-report 3)", "s < 2 & \"more\"", ClaimKind::exact, ""},
      ClaimHead{"a.refuted", "jsplines", "V-B, (12)", "<script>alert('x')</script>", ClaimKind::exact, ""},
      ClaimHead{"a.exact.c1", "subdivlab", "jsplines 3", std::nullopt, ClaimKind::exact, ""},
      ClaimHead{"b.lost", "notes", "figure 2", "a figure", ClaimKind::not_reproducible, ""}};
  return heads;
}

/// Two experiments' worth of claims, one of them unknown to all experiments, and figures of every place.
struct Sample {
  std::array<Experiment, 1> experiments{
      Experiment{"first", "First & foremost (jsplines 3; notes 1)", sample_heads, nullptr}};
  std::vector<ClaimRecord> claims{
      claim("a.bound.c1", "jsplines", "3 (js-report 3)", "reproduced", "s < 2 & \"more\""),
      claim("a.refuted", "jsplines", "V-B, (12)", "refuted", "<script>alert('x')</script>",
            "It is 3 < 4, see a.exact.c1, and not e.g. a.exact."),
      claim("a.exact.c1", "subdivlab", "jsplines 3", "established", std::nullopt),
      claim("b.lost", "notes", "figure 2", "not-reproducible", "a figure", "Its coordinates are lost."),
      claim("own.claim", "a paper of one's own", "1", "inconsistent", "\xE2\x89\xA4 1/2",
            "It was measured.")};
  Manifest manifest{{},
                    {{"beside", "first", "Beside", "Horizontal axis: s.", {"a.bound."}},
                     {"shared", "first", "Shared", "", {"a.refuted", "a.exact.c1"}},
                     {"free", "first", "Free & easy", "", {}},
                     {"gone", "first", "Gone", "", {"no.such.claim"}}},
                    {"a.bound.c1", "a.refuted"},
                    page_names()};

  [[nodiscard]] ReportSource source() const {
    return {experiments, claims, &manifest,
            [](const std::string& name) { return std::string(name == "gone" ? "" : picture); }};
  }
};

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// The part of a page from `begin` to the next `end`.
std::string part(const std::string& page, const std::string& begin, const std::string& end) {
  const std::size_t at = page.find(begin);
  if (at == std::string::npos) return "";
  return page.substr(at, page.find(end, at) - at);
}

TEST(HtmlText, EscapesWhatIsMarkup) {
  EXPECT_EQ(html_text("1 < s & \"t\" > 'u'"), "1 &lt; s &amp; &quot;t&quot; &gt; &#39;u&#39;");
  EXPECT_EQ(html_text("\xE2\x89\xA4 \xCF\x83"), "\xE2\x89\xA4 \xCF\x83");
}

TEST(UrlText, KeepsQueriesApart) { EXPECT_EQ(url_text("a-b.c_1 & \xC3\xA9#"), "a-b.c_1%20%26%20%C3%A9%23"); }

TEST(HtmlText, LinksIdsAndNothingElse) {
  const std::set<std::string> ids{"fit.b2", "fit.b2.l1"};
  EXPECT_EQ(html_with_links("See fit.b2.l1.", ids), "See <a href=\"#fit.b2.l1\">fit.b2.l1</a>.");
  EXPECT_EQ(html_with_links("(fit.b2)", ids), "(<a href=\"#fit.b2\">fit.b2</a>)");
  for (const char* text : {"fit.b2.l2", "benefit.b2", "a/fit.b2", "fit.b2x", "Fit", "1.5", ""}) {
    EXPECT_EQ(html_with_links(text, ids), text);
  }
  EXPECT_EQ(html_with_links("1 < fit.b2", ids), "1 &lt; <a href=\"#fit.b2\">fit.b2</a>");
}

TEST(SvgAddress, IsQuotedForAnAttribute) {
  EXPECT_EQ(svg_address(picture),
            "data:image/svg+xml,<?xml version=&quot;1.0&quot;?> <svg viewBox=&quot;0 0 800 500&quot; "
            "xmlns=&quot;http://www.w3.org/2000/svg&quot;> <path stroke='%23fff' d='M0,0 1,1'/>100%25 "
            "&amp;amp;</svg>");
}

TEST(Documents, SectionsInWords) {
  const auto place = [](const std::string& document, const std::string& section) {
    return place_of(claim("x", document, section, "reproduced", "y"));
  };
  EXPECT_EQ(place("jsplines", "3 (js-report 3)"), "section 3; also js-report, section 3");
  EXPECT_EQ(place("js-report", "abstract"), "abstract");
  EXPECT_EQ(place("js-report", "figure 10 (jsplines figure 9)"), "figure 10; also jsplines, figure 9");
  EXPECT_EQ(place("speed", "V-B, (12)"), "section V-B, (12)");
  EXPECT_EQ(place("js-report", "12 (13)"), "section 12 (13)");
  EXPECT_EQ(place("subdivlab", "jsplines 3"), "on jsplines, section 3");
  EXPECT_EQ(place("subdivlab", "jsplines 4 (js-report 4)"),
            "on jsplines, section 4; also js-report, section 4");
  EXPECT_EQ(place("a paper of one's own", "2"), "section 2");
}

TEST(Sharpened, IsComputedFromTheClaims) {
  Sample sample;
  const auto sharpened = [&](std::size_t i) { return is_sharpened(sample.claims[i], sample.claims); };
  EXPECT_TRUE(sharpened(0));  // "<", and a.exact.c1 is about c1 in the same section
  EXPECT_EQ(sharper_findings(sample.claims[0], sample.claims), std::vector<std::string>{"a.exact.c1"});
  for (std::size_t i = 1; i < sample.claims.size(); ++i) EXPECT_FALSE(sharpened(i)) << sample.claims[i].id;
  sample.claims[2].section = "jsplines 4";
  EXPECT_FALSE(sharpened(0));
  sample.claims[0].note = "It ends where a.exact.c1 says.";
  EXPECT_TRUE(sharpened(0));
  sample.claims[0].note = "It ends where a.exact.c1.lower says.";
  EXPECT_FALSE(sharpened(0));
  sample.claims[0].kind = "bound";
  sample.claims[0].printed = "-1.7";
  sample.claims[0].lower = "-1.71";
  sample.claims[0].upper = "-1.705";
  EXPECT_TRUE(sharpened(0));
  sample.claims[0].upper = "-1.70";
  EXPECT_FALSE(sharpened(0));  // the enclosure touches the bound
}

TEST(ReportPage, HoldsEveryClaimInTheOrderOfDocuments) {
  const Sample sample;
  const std::string page = report_page(sample.source());
  std::size_t last = 0;
  for (const char* id : {"a.bound.c1", "a.refuted", "b.lost", "own.claim", "a.exact.c1"}) {
    const std::string anchor = " id=\"" + std::string(id) + "\"";
    ASSERT_EQ(occurrences(page, anchor), 1U) << id;
    EXPECT_GT(page.find(anchor), last) << id;
    last = page.find(anchor);
  }
  EXPECT_TRUE(contains(page, "<h3>First &amp; foremost <span class=\"sections\">§3, §V-B</span></h3>"));
  EXPECT_TRUE(contains(page, "<h2>a paper of one&#39;s own</h2>"));
}

TEST(ReportPage, EscapesClaims) {
  const Sample sample;
  const std::string page = report_page(sample.source());
  EXPECT_FALSE(contains(page, "<script>alert"));
  EXPECT_TRUE(contains(page, "<q>&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt;</q>"));
  EXPECT_TRUE(contains(page, "<q>s &lt; 2 &amp; &quot;more&quot;</q>"));
  EXPECT_TRUE(
      contains(page, "3 &lt; 4, see <a href=\"#a.exact.c1\">a.exact.c1</a>, and not e.g. a.exact.</dd>"));
}

TEST(ReportPage, FiguresStandBesideTheFirstClaimThatTheyName) {
  const Sample sample;
  const std::string page = report_page(sample.source());
  EXPECT_TRUE(contains(part(page, "id=\"a.bound.c1\"", "</article>"), "id=\"figure:beside\""));
  EXPECT_TRUE(contains(part(page, "id=\"a.refuted\"", "</article>"), "id=\"figure:shared\""));
  EXPECT_TRUE(
      contains(part(page, "id=\"a.exact.c1\"", "</article>"), "<a href=\"#figure:shared\">Shared</a>"));
  const std::string gallery = part(page, "class=\"gallery\"", "</section>");
  EXPECT_TRUE(contains(gallery, "id=\"figure:free\""));
  EXPECT_TRUE(contains(gallery, "This figure has not been drawn."));
  for (const char* name : {"beside", "shared", "free", "gone"}) {
    EXPECT_EQ(occurrences(page, "id=\"figure:" + std::string(name) + "\""), 1U) << name;
  }
  EXPECT_TRUE(contains(page, "alt=\"Beside. Horizontal axis: s.\""));
  EXPECT_TRUE(contains(page, "width=\"800\" height=\"500\""));
}

TEST(ReportPage, LinksToCertificates) {
  const Sample sample;
  const std::string page = report_page(sample.source());
  EXPECT_TRUE(
      contains(part(page, "id=\"a.bound.c1\"", "</article>"), "<a href=\"../certificates/a.bound.c1.txt\">"));
  EXPECT_EQ(occurrences(page, "data-certificate=\"yes\""), 2U);
  const std::string errata = errata_page(sample.source());
  EXPECT_TRUE(contains(errata, "<a href=\"../certificates/a.refuted.txt\">"));
  EXPECT_EQ(occurrences(errata, "../certificates/"), 1U);
}

TEST(ReportPage, LinksToTheErrata) {
  const Sample sample;
  const std::string page = report_page(sample.source());
  for (const char* id : {"a.refuted", "b.lost", "own.claim"}) {
    EXPECT_TRUE(contains(page, "<a href=\"errata.html#" + std::string(id) + "\">")) << id;
  }
  for (const char* id : {"a.bound.c1", "a.exact.c1"}) {
    EXPECT_FALSE(contains(page, "<a href=\"errata.html#" + std::string(id) + "\">")) << id;
  }
}

TEST(ReportPage, MarksVerdictRigourAndSharpened) {
  const Sample sample;
  const std::string page = report_page(sample.source());
  EXPECT_TRUE(contains(page,
                       "id=\"a.bound.c1\" data-document=\"jsplines\" data-verdict=\"reproduced\" "
                       "data-rigour=\"exact\" data-sharpened=\"yes\" data-certificate=\"yes\""));
  EXPECT_TRUE(contains(page,
                       "id=\"a.refuted\" data-document=\"jsplines\" data-verdict=\"refuted\" "
                       "data-rigour=\"exact\" data-certificate=\"yes\">"));
}

TEST(HtmlValue, ShowsTextDigitsAndEnds) {
  ClaimRecord record = claim("x", "jsplines", "1", "reproduced", "y");
  EXPECT_EQ(html_value(record), "<code>true</code>");
  record.exact = "1/3";
  record.lower = "0.333333333333333333";
  record.upper = "0.333333333333333334";
  EXPECT_EQ(html_value(record),
            "<code>1/3</code> = <code>0.333333333333333</code><br><span class=\"ends\">between "
            "<code>0.333333333333333333</code> and <code>0.333333333333333334</code></span>");
  EXPECT_EQ(html_value(record, ValueLength::brief), "<code>1/3</code> = <code>0.333333333333333</code>");
  record.exact = std::string(61, '1') + "/3";
  EXPECT_EQ(html_value(record, ValueLength::brief), "<code>0.333333333333333</code>");
  record.exact = "193/200";
  record.lower = record.upper = "0.965000000000000000";
  EXPECT_EQ(html_value(record), "<code>193/200</code> = <code>0.965</code>");
  record.exact = "-2";
  record.lower = record.upper = "-2";
  EXPECT_EQ(html_value(record), "<code>-2</code>");
  record.exact.reset();
  record.lower.reset();
  record.upper.reset();
  EXPECT_EQ(html_value(record), "none");
}

TEST(ErrataPage, SaysWhatIsPrintedTrueAndHowToRedoIt) {
  const Sample sample;
  const std::string page = errata_page(sample.source());
  const std::string entry = part(page, "id=\"a.refuted\"", "</article>");
  EXPECT_TRUE(contains(entry, "<h4>1. Section V-B, (12)</h4>"));
  EXPECT_TRUE(
      contains(entry, "<blockquote><p>&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt;</p></blockquote>"));
  EXPECT_TRUE(contains(entry, "It is 3 &lt; 4, see <a href=\"index.html#a.exact.c1\">[1]</a>, and"));
  EXPECT_TRUE(contains(entry, "Decided in exact arithmetic."));
  EXPECT_TRUE(contains(entry, "<code>build/subdivlab reproduce a.refuted</code>"));
  EXPECT_TRUE(contains(entry, "href=\"index.html#a.refuted\""));
  EXPECT_TRUE(contains(part(page, "id=\"b.lost\"", "</article>"), "<dt>What is missing</dt>"));
  EXPECT_TRUE(contains(part(page, "id=\"own.claim\"", "</article>"), "<dt>What was measured</dt>"));
  for (const char* id : {"a.bound.c1", "a.exact.c1"})
    EXPECT_FALSE(contains(page, "id=\"" + std::string(id) + "\""));
}

TEST(ErrataPage, OneNoteMakesOneEntry) {
  Sample sample;
  sample.claims[0].verdict = "refuted";
  sample.claims[0].note = sample.claims[1].note;
  EXPECT_EQ(occurrences(errata_page(sample.source()), "class=\"erratum\""),
            4U);  // in different sections: apart
  sample.claims[0].section = sample.claims[1].section;
  const std::string page = errata_page(sample.source());
  EXPECT_EQ(occurrences(page, "class=\"erratum\""), 3U);
  EXPECT_TRUE(contains(page, "reproduce a.bound.c1 a.refuted</code>"));
  EXPECT_TRUE(contains(page, "<blockquote id=\"a.refuted\">"));
  EXPECT_TRUE(contains(page, "more&quot;</q>: the definition of <a href=\"index.html#a.bound.c1\">"));
}

TEST(ErrataPage, SaysWhenThereIsNone) {
  Sample sample;
  sample.claims.resize(1);
  EXPECT_TRUE(contains(errata_page(sample.source()), "No claim is refuted"));
}

TEST(Pages, AreWholeTheSameAgainAndNeedNothingElse) {
  const Sample sample;
  const auto pages = derived_pages(sample.source());
  const auto again = derived_pages(sample.source());
  ASSERT_EQ(pages.size(), page_names().size());
  for (std::size_t i = 0; i < pages.size(); ++i) {
    EXPECT_EQ(pages[i].name, page_names()[i]);
    EXPECT_EQ(pages[i].text, again[i].text);
    if (!pages[i].name.ends_with(".html") || pages[i].name.ends_with("explorer.html")) continue;
    const std::string& text = pages[i].text;
    EXPECT_TRUE(text.starts_with("<!DOCTYPE html>\n<html lang=\"en\">"));
    EXPECT_TRUE(text.ends_with("</html>\n"));
    // Names of XML's vocabularies inside pictures are no addresses that a browser would ask for.
    const std::string outside = std::regex_replace(text, std::regex("src=\"data:[^\"]*\""), "");
    EXPECT_FALSE(std::regex_search(outside, std::regex("https?:|(src|href)=\"//|@import|url\\(")))
        << pages[i].name;
    EXPECT_FALSE(std::regex_search(outside, std::regex("\\b20[0-9][0-9]-[0-9][0-9]"))) << pages[i].name;
    std::set<std::string> ids;
    const std::regex id(" id=\"([^\"]*)\"");
    for (auto at = std::sregex_iterator(text.begin(), text.end(), id); at != std::sregex_iterator(); ++at) {
      EXPECT_TRUE(ids.insert((*at)[1]).second) << "twice: " << (*at)[1];
    }
    for (const char* tag :
         {"section", "article", "div", "dl", "dd", "ul", "li", "p", "figure", "main", "form"}) {
      EXPECT_EQ(
          occurrences(text, "<" + std::string(tag) + ">") + occurrences(text, "<" + std::string(tag) + " "),
          occurrences(text, "</" + std::string(tag) + ">"))
          << tag << " in " << pages[i].name;
    }
  }
}

}  // namespace
}  // namespace subdiv
