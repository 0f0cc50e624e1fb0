#include "experiments/report/folder.h"

#include <gtest/gtest.h>

#include "experiments/report/compare.h"
#include "experiments/report/csv.h"
#include "experiments/report/files.h"
#include "experiments/report/markdown.h"
#include "experiments/report/pages.h"
#include "experiments/report/table.h"
#include "experiments/report/utf8.h"
#include "schemes/input_error.h"
#include "tests/experiments/sample_experiments.h"
#include "tests/experiments/temporary_folder.h"

namespace subdiv {
namespace {

const std::array all{letters, numbers};

std::vector<Outcome> outcomes_of(const std::vector<const Experiment*>& chosen) { return run(chosen, 1); }

/// Merges and writes, as a run of the program does; the folder as written.
ResultsFolder write(const std::filesystem::path& folder, const std::vector<const Experiment*>& chosen,
                    bool everything) {
  const ResultsFolder old = load_results_if_any(folder).value_or(ResultsFolder{});
  const auto outcomes = outcomes_of(chosen);
  const ResultsFolder merged = merge(all, outcomes, old, everything);
  write_results(folder, all, outcomes, old, merged);
  return load_results(folder);
}

std::vector<std::string> ids(const ResultsFolder& folder) {
  std::vector<std::string> result;
  for (const ClaimRecord& claim : folder.claims) result.push_back(claim.id);
  return result;
}

/// What check says when the committed claims are changed by `tamper`.
template <class Tamper>
std::vector<std::string> differences_after(Tamper tamper) {
  const TemporaryFolder folder;
  ResultsFolder results = write(folder.path(), {&letters, &numbers}, true);
  tamper(results, folder.path());
  return compare(folder.path(), results, outcomes_of({&letters, &numbers}),
                 [](const std::string&) { return true; });
}

using Ids = std::vector<std::string>;
const std::filesystem::path series_file = std::filesystem::path("series") / "letters-series.csv";
const std::filesystem::path figure_file = std::filesystem::path("figures") / "letters-figure.svg";

TEST(WriteResults, WritesEverythingAndTheSameBytesAgain) {
  const TemporaryFolder folder;
  const ResultsFolder results = write(folder.path(), {&letters, &numbers}, true);
  std::set<std::string> files{"claims.csv", "claims.json", "manifest.json", series_file.string(),
                              figure_file.string()};
  for (const std::string& page : page_names()) files.insert(page);
  EXPECT_EQ(folder.files(), files);
  EXPECT_EQ(ids(results), (Ids{"letters.a", "letters.b", "numbers.one"}));
  std::vector<std::string> first;
  for (const std::string& file : files) first.push_back(read_file(folder.path() / file));
  (void)write(folder.path(), {&numbers, &letters}, true);
  std::size_t i = 0;
  for (const std::string& file : files) EXPECT_EQ(read_file(folder.path() / file), first[i++]) << file;
}

TEST(WriteResults, PagesAreThoseThatFollowFromTheFolder) {
  const TemporaryFolder folder;
  const ResultsFolder results = write(folder.path(), {&letters, &numbers}, true);
  EXPECT_EQ(results.manifest.pages, page_names());
  EXPECT_EQ(page_differences(folder.path(), all, results), std::vector<std::string>{});
  ResultsFolder tampered = results;
  tampered.claims[0].note += "!";  // README.md does not show it
  EXPECT_EQ(page_differences(folder.path(), all, tampered).size(), 1U);
  std::filesystem::remove(folder.path() / "report" / "errata.html");
  const auto differences = page_differences(folder.path(), all, results);
  ASSERT_EQ(differences.size(), 1U);
  EXPECT_TRUE(differences[0].ends_with("errata.html: is missing")) << differences[0];
}

TEST(WriteResults, APartialRunKeepsTheReport) {
  const TemporaryFolder folder;
  (void)write(folder.path(), {&letters, &numbers}, true);
  const std::string before = read_file(folder.path() / "report" / "index.html");
  const ResultsFolder results = write(folder.path(), {&numbers}, false);
  EXPECT_EQ(read_file(folder.path() / "report" / "index.html"), before);
  EXPECT_NE(before.find("data:image/svg+xml"), std::string::npos);
  EXPECT_EQ(page_differences(folder.path(), all, results), std::vector<std::string>{});
}

TEST(WriteResults, APartialRunKeepsTheOtherClaims) {
  const TemporaryFolder folder;
  (void)write(folder.path(), {&numbers}, false);
  const ResultsFolder results = write(folder.path(), {&letters}, false);
  EXPECT_EQ(ids(results), (Ids{"letters.a", "letters.b", "numbers.one"}));
  const ResultsFolder again = write(folder.path(), {&numbers}, false);
  EXPECT_EQ(again.claims, results.claims);
  EXPECT_EQ(again.manifest.figures, results.manifest.figures);
  EXPECT_TRUE(folder.files().contains(figure_file.string()));
}

TEST(WriteResults, ARunOfEverythingRemovesWhatNoExperimentWrites) {
  const TemporaryFolder folder;
  const ResultsFolder old = write(folder.path(), {&letters, &numbers}, true);
  const std::array fewer{numbers};
  const auto outcomes = outcomes_of({&numbers});
  write_results(folder.path(), fewer, outcomes, old, merge(fewer, outcomes, old, true));
  EXPECT_EQ(ids(load_results(folder.path())), Ids{"numbers.one"});
  EXPECT_FALSE(folder.files().contains(figure_file.string()));
  EXPECT_FALSE(folder.files().contains(series_file.string()));
}

TEST(WriteResults, ABrokenExperimentKeepsItsClaims) {
  const TemporaryFolder folder;
  const ResultsFolder before = write(folder.path(), {&letters, &numbers}, true);
  const Experiment broken{"letters", "Letters", letters_heads, run_broken};
  const std::array experiments_now{broken, numbers};
  const auto outcomes = outcomes_of({&broken, &numbers});
  const ResultsFolder merged = merge(experiments_now, outcomes, before, true);
  EXPECT_EQ(merged.claims, before.claims);
  EXPECT_EQ(merged.manifest.figures, before.manifest.figures);
}

TEST(WriteResults, NothingChangesWhenAFigureFails) {
  const TemporaryFolder folder;
  const ResultsFolder before = write(folder.path(), {&letters, &numbers}, true);
  auto outcomes = outcomes_of({&letters});
  outcomes[0].results.figures[0].setup = "set nonsense";
  outcomes[0].results.series[0].rows.clear();
  EXPECT_THROW(write_results(folder.path(), all, outcomes, before, before), std::runtime_error);
  EXPECT_EQ(read_file(folder.path() / series_file), series_to_csv(run_letters().series[0]));
}

TEST(WriteResults, TwoExperimentsMayNotWriteTheSameFile) {
  const Experiment twin{"twin", "Twin", letters_heads, run_letters};
  const std::array both{letters, twin};
  EXPECT_THROW((void)merge(both, outcomes_of({&letters, &twin}), {}, true), std::logic_error);
}

TEST(LoadResults, SaysWhatToDoWithoutClaims) {
  const TemporaryFolder folder;
  EXPECT_FALSE(load_results_if_any(folder.path()).has_value());
  EXPECT_THROW((void)load_results(folder.path()), InputError);
}

TEST(Compare, NothingDiffersAfterWriting) {
  EXPECT_EQ(differences_after([](ResultsFolder&, const std::filesystem::path&) {}), Ids{});
}

TEST(Compare, DetectsEachKindOfTampering) {
  const auto claims = [](auto change) {
    return differences_after(
        [&](ResultsFolder& results, const std::filesystem::path&) { change(results.claims); });
  };
  EXPECT_EQ(claims([](auto& c) { c[0].verdict = "refuted"; }),
            Ids{"letters.a: verdict: 'refuted' is committed, 'reproduced' is found"});
  EXPECT_EQ(claims([](auto& c) { c[0].lower->back() = '0'; }).size(), 1U);
  EXPECT_EQ(claims([](auto& c) { c[1].exact = "true"; }).size(), 1U);
  EXPECT_EQ(claims([](auto& c) { c.pop_back(); }), Ids{"numbers.one: is missing in claims.json"});
  EXPECT_EQ(claims([](auto& c) {
              c.push_back(c.back());
              c.back().id = "numbers.two";
            }),
            Ids{"numbers.two: stands in claims.json, but no experiment has such a claim"});
}

TEST(Compare, DetectsMissingAndChangedFiles) {
  const auto files = [](auto change) {
    return differences_after([&](ResultsFolder&, const std::filesystem::path& folder) { change(folder); });
  };
  EXPECT_EQ(files([](const auto& folder) { std::filesystem::remove(folder / series_file); }).size(), 1U);
  EXPECT_EQ(files([](const auto& folder) { std::filesystem::remove(folder / figure_file); }).size(), 1U);
  EXPECT_EQ(files([](const auto& folder) { write_files({{folder / figure_file, "<svg>"}}); }).size(), 1U);
  EXPECT_EQ(
      files([](const auto& folder) { write_files({{folder / series_file, "x,y\n0,1.7\n1,2.5\n"}}); }).size(),
      1U);
}

TEST(ResultsPage, HasTheTableTheRefutedClaimsAndTheFigures) {
  const TemporaryFolder folder;
  (void)write(folder.path(), {&letters, &numbers}, true);
  const std::string page = read_file(folder.path() / "README.md");
  for (const char* part :
       {"3 claims: 1 reproduced, 1 refuted, 1 established, 0 undecided", "## Letters (jsplines 1)",
        "| letters.a | jsplines 1 | 0.33 | 1/3 | exact | reproduced |",
        "**letters.b** (jsplines 1, printed: so).", "it is \\*otherwise\\*",
        "![Letters](figures/letters-figure.svg)"}) {
    EXPECT_NE(page.find(part), std::string::npos) << part << "\n" << page;
  }
}

TEST(VerdictCount, NamesRareVerdictsOnlyWhereTheyOccur) {
  ClaimRecord claim = to_record(run_numbers().claims[0]);
  EXPECT_EQ(verdict_count({&claim, 1}), "1 claim: 0 reproduced, 0 refuted, 1 established, 0 undecided");
  claim.verdict = "consistent";
  EXPECT_EQ(verdict_count({&claim, 1}),
            "1 claim: 0 reproduced, 0 refuted, 0 established, 0 undecided, 1 consistent");
}

TEST(ClaimsTable, FitsTheWidthAndAlignsItsColumns) {
  ClaimRecord claim = to_record(run_numbers().claims[0]);
  ClaimRecord wide = claim;
  wide.id = "numbers.φ";
  wide.printed = std::string(200, 'p');
  wide.exact = std::string(200, 'v');
  const std::array claims{claim, wide};
  const std::string table = claims_table(claims, 100);
  const std::string first_line = table.substr(0, table.find('\n'));
  std::size_t begin = 0;
  while (begin < table.size()) {
    const std::size_t end = table.find('\n', begin);
    const std::string line = table.substr(begin, end - begin);
    EXPECT_LE(display_width(line), 100U) << line;
    begin = end + 1;
  }
  const auto column = [](const std::string& line, const std::string& word) {
    return display_width(line.substr(0, line.find(word)));
  };
  const std::string last_line = table.substr(table.rfind('\n', table.size() - 2) + 1);
  EXPECT_EQ(column(first_line, "verdict"), column(last_line, "established"));
  EXPECT_EQ(column(first_line, "printed"), column(last_line, "ppp"));
}

}  // namespace
}  // namespace subdiv
