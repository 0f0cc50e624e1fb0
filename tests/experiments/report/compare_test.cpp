#include "experiments/report/compare.h"

#include <gtest/gtest.h>

namespace subdiv {
namespace {

ClaimRecord record_of(const Enclosure& value) {
  return to_record(settle({"test.claim", "jsplines", "1", "0.46", ClaimKind::rounded, "a number"}, value));
}

ClaimRecord proved() {
  return record_of(certified(Rational::parse("0.4641509"), Rational::parse("0.4641511"), ""));
}

/// All differences in one text.
std::string difference(const ClaimRecord& committed, const ClaimRecord& found) {
  std::string text;
  for (const std::string& line : differences(committed, found)) text += line + "\n";
  return text;
}

void expect_difference(const ClaimRecord& committed, const ClaimRecord& found, const std::string& part) {
  const std::string text = difference(committed, found);
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in: " << text;
}

TEST(Differences, NoneBetweenARecordAndItself) {
  EXPECT_EQ(difference(proved(), proved()), "");
  EXPECT_EQ(difference(record_of(exact(Rational(1, 3))), record_of(exact(Rational(1, 3)))), "");
}

TEST(Differences, VerdictRigourAndHeadAreComparedAsText) {
  for (const auto member : {&ClaimRecord::verdict, &ClaimRecord::rigour, &ClaimRecord::document,
                            &ClaimRecord::section, &ClaimRecord::kind, &ClaimRecord::definition}) {
    ClaimRecord tampered = proved();
    tampered.*member = "something else";
    expect_difference(tampered, proved(), "'something else' is committed");
  }
  ClaimRecord unprinted = proved();
  unprinted.printed.reset();
  expect_difference(unprinted, proved(), "printed: nothing is committed, '0.46' is found");
}

TEST(Differences, NotesAreNotCompared) {
  ClaimRecord other = proved();
  other.note = "another wording";
  EXPECT_EQ(difference(other, proved()), "");
}

TEST(Differences, AnyDigitOfAnExactValueCounts) {
  ClaimRecord tampered = record_of(exact(Rational(-33, 26)));
  tampered.exact = "-33/25";
  expect_difference(tampered, record_of(exact(Rational(-33, 26))), "exact value: '-33/25' is committed");
  tampered = record_of(exact(Rational(-33, 26)));
  tampered.lower->back() = tampered.lower->back() == '1' ? '2' : '1';
  expect_difference(tampered, record_of(exact(Rational(-33, 26))), "value:");
  tampered = record_of(exact(Rational(-33, 26)));
  tampered.lower.reset();
  tampered.upper.reset();
  expect_difference(tampered, record_of(exact(Rational(-33, 26))), "no number is committed");
}

TEST(Differences, EnclosuresMustOverlap) {
  ClaimRecord moved = proved();
  moved.lower = "0.464160000000000000";
  moved.upper = "0.464160200000000000";
  expect_difference(moved, proved(), "do not overlap");
  ClaimRecord digit = proved();
  digit.lower->at(4) = '9';  // 0.469..: above the upper end
  expect_difference(digit, proved(), "do not overlap");
}

TEST(Differences, NoLossOfWidth) {
  const ClaimRecord wider =
      record_of(certified(Rational::parse("0.464150"), Rational::parse("0.464152"), ""));
  expect_difference(proved(), wider, "has become wider");
  EXPECT_EQ(difference(wider, proved()), "") << "a narrower enclosure is welcome";
  const ClaimRecord far_wider = record_of(certified(Rational(1, 10), Rational(9, 10), ""));
  expect_difference(far_wider, proved(), "far wider than need be");
}

TEST(Differences, RoundingOfThePrintedEndsIsNoLoss) {
  ClaimRecord tight = proved();
  tight.lower = "0.464150900000000001";
  EXPECT_EQ(difference(tight, proved()), "");
}

TEST(Differences, ApproximateValuesAgreeToTheirStatedDigits) {
  const ClaimRecord a = record_of(approximate(0.46411, 4, ""));
  const ClaimRecord b = record_of(approximate(0.46409, 4, ""));
  EXPECT_EQ(difference(a, b), "");
  expect_difference(a, record_of(approximate(0.4661, 4, "")), "do not overlap");
}

TEST(SeriesDifferences, CellsAgreeToTheLastDigit) {
  const std::string series = "k,norm\n1,0.125\n2,0.0625\n";
  EXPECT_TRUE(series_differences("s.csv", series, series).empty());
  EXPECT_TRUE(series_differences("s.csv", "k,norm\n1,0.126\n2,0.0625\n", series).empty());
  EXPECT_EQ(series_differences("s.csv", "k,norm\n1,0.127\n2,0.0625\n", series),
            std::vector<std::string>{"s.csv:2: '0.127' is committed, '0.125' is found"});
  EXPECT_EQ(series_differences("s.csv", "k,norm\n1,0.125\n3,0.0625\n", series).size(), 1U)
      << "whole numbers are exact";
  EXPECT_EQ(series_differences("s.csv", "k,max\n1,0.125\n2,0.0625\n", series).size(), 1U);
  EXPECT_EQ(series_differences("s.csv", "k,norm\n1,0.125\n", series).size(), 1U);
  EXPECT_EQ(series_differences("s.csv", "k,norm\n1,0.125,7\n2,0.0625\n", series).size(), 1U);
}

}  // namespace
}  // namespace subdiv
