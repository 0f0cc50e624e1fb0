#include "experiments/report/record.h"

#include <gtest/gtest.h>

#include "experiments/report/utf8.h"

namespace subdiv {
namespace {

ClaimRecord record_of(const Enclosure& value) {
  return to_record(settle({"test.claim", "jsplines", "1", std::nullopt, ClaimKind::rounded, ""}, value));
}

TEST(DecimalEnds, AreRoundedOutward) {
  const DecimalEnds ends = decimal_ends(Rational(1, 3), Rational(1, 3), Rigour::exact);
  EXPECT_EQ(ends.lower, "0.333333333333333333");
  EXPECT_EQ(ends.upper, "0.333333333333333334");
  const DecimalEnds negative = decimal_ends(Rational(-2, 3), Rational(-2, 3), Rigour::exact);
  EXPECT_EQ(negative.lower, "-0.666666666666666667");
  EXPECT_EQ(negative.upper, "-0.666666666666666666");
}

TEST(DecimalEnds, ContainTheEnclosureAndHardlyWidenIt) {
  const Rational width = Rational::parse("3e-25");
  for (const Rational& lower :
       {Rational(1, 7), Rational(-22, 7), Rational(1, 1000003), Rational(123456789, 7)}) {
    const DecimalEnds ends = decimal_ends(lower, lower + width, Rigour::certified);
    const Rational low = Rational::parse(ends.lower);
    const Rational high = Rational::parse(ends.upper);
    EXPECT_LE(low, lower);
    EXPECT_GE(high, lower + width);
    EXPECT_LT(high - low, width * Rational(102, 100)) << ends.lower;
  }
}

TEST(DecimalEnds, HaveAtLeast15DigitsWhenProved) {
  const DecimalEnds ends = decimal_ends(Rational(1, 10), Rational(1, 5), Rigour::certified);
  EXPECT_EQ(ends.lower, "0.100000000000000000");
  EXPECT_EQ(ends.upper, "0.200000000000000000");
}

TEST(DecimalEnds, OfApproximateValuesShowBelievedDigitsOnly) {
  const Enclosure value = approximate(0.46875, 4, "test");  // 0.46870 .. 0.46880
  const DecimalEnds ends = decimal_ends(value.lower, value.upper, value.rigour);
  EXPECT_EQ(ends.lower, "0.4687");
  EXPECT_EQ(ends.upper, "0.4688");
}

TEST(DecimalEnds, AroundZero) {
  const DecimalEnds ends = decimal_ends(Rational(-1, 3), Rational(0), Rigour::certified);
  EXPECT_EQ(ends.lower, "-0.333333333333333334");
  EXPECT_EQ(ends.upper, "0");
}

TEST(ToRecord, StatementsHaveNoEnds) {
  const ClaimHead head{"test.claim", "jsplines", "1", "so", ClaimKind::exact, ""};
  const ClaimRecord record = to_record(settle_statement(head, true, "true"));
  EXPECT_EQ(record.exact, "true");
  EXPECT_FALSE(record.lower || record.upper);
  EXPECT_EQ(record.kind, "exact");
  EXPECT_EQ(record.verdict, "reproduced");
}

TEST(ValueText, ShowsTheDigitsThatBothEndsShare) {
  EXPECT_EQ(value_text(record_of(exact(Rational(-33, 26))), 30), "-33/26");
  const Rational third = Rational(1, 3);
  EXPECT_EQ(value_text(record_of(certified(third, third + Rational::parse("1e-8"), "")), 30), "0.3333333");
  EXPECT_EQ(value_text(record_of(certified(third, third + Rational::parse("1e-30"), "")), 30),
            "0.333333333333333");
  EXPECT_EQ(value_text(record_of(certified(Rational(-17, 10), Rational(-8, 5), "")), 30),
            "[-1.70000, -1.60000]");
  EXPECT_EQ(value_text(record_of(approximate(0.25, 3, "")), 30), "~0.250");
}

TEST(ValueText, NeverCutsOffAnExponent) {
  const Rational tiny = Rational::parse("1.23456789012345678e-20");
  const ClaimRecord record = record_of(certified(tiny, tiny + Rational::parse("1e-45"), ""));
  EXPECT_EQ(value_text(record, 30), "1.23456789012346e-20");
  EXPECT_EQ(value_text(record, 12), "1.23456…e-20");
}

TEST(ValueText, ReplacesALongExactTextByDigits) {
  Enclosure value = exact(Rational(1, 3));
  value.exact = "(a closed form that is much too long for a table)";
  EXPECT_EQ(value_text(record_of(value), 20), "0.333333333333333");
}

TEST(Utf8, CountsCodePointsAndCutsBetweenThem) {
  EXPECT_EQ(display_width("φ_s"), 3U);
  EXPECT_EQ(display_width("e\u0301"), 1U) << "a combining accent takes no column";
  EXPECT_EQ(clipped("φφφφ", 4), "φφφφ");
  EXPECT_EQ(clipped("φφφφφ", 4), "φφφ…");
  EXPECT_EQ(clipped("a\nb", 4), "a b");
  EXPECT_EQ(padded("φ", 3), "φ  ");
}

}  // namespace
}  // namespace subdiv
