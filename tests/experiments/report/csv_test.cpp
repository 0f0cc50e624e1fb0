#include "experiments/report/csv.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace subdiv {
namespace {

TEST(Csv, RoundTripWithEverythingThatNeedsQuotes) {
  const CsvRows rows{{"a", "b,c", "d\"e\"", ""}, {"line\nbreak", "φ", "", "\"\""}, {""}};
  EXPECT_EQ(from_csv(to_csv(rows)), rows);
}

TEST(Csv, QuotesOnlyWhatNeedsIt) { EXPECT_EQ(to_csv({{"1.5", "a,b", "c\"d"}}), "1.5,\"a,b\",\"c\"\"d\"\n"); }

TEST(Csv, ReadsATextWithoutItsLastLineBreak) {
  EXPECT_EQ(from_csv("a,b\n1,2"), (CsvRows{{"a", "b"}, {"1", "2"}}));
  EXPECT_EQ(from_csv("a,\n"), (CsvRows{{"a", ""}}));
  EXPECT_TRUE(from_csv("").empty());
}

TEST(Csv, SeriesHaveAHeaderAndRowsOfItsLength) {
  EXPECT_EQ(series_to_csv({"norms", {"k", "norm"}, {{"1", "0.5"}, {"2", "0.25"}}}),
            "k,norm\n1,0.5\n2,0.25\n");
  EXPECT_THROW((void)series_to_csv({"norms", {"k", "norm"}, {{"1"}}}), std::logic_error);
}

TEST(Csv, ClaimsHaveOneLineEach) {
  const ClaimHead head{"a.b", "jsplines", "1", std::nullopt, ClaimKind::exact, "x, y"};
  const std::vector<ClaimRecord> claims{to_record(settle(head, exact(Rational(1, 2))))};
  const CsvRows rows = from_csv(claims_to_csv(claims));
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].size(), rows[1].size());
  EXPECT_EQ(rows[1][0], "a.b");
  EXPECT_EQ(rows[1][5], "x, y");
  EXPECT_EQ(rows[1][6], "1/2");
}

}  // namespace
}  // namespace subdiv
