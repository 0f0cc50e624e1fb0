#include "experiments/claim.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace subdiv {
namespace {

ClaimHead make_head(std::optional<std::string> printed, ClaimKind kind) {
  return {"test.claim", "jsplines", "1", std::move(printed), kind, "a number"};
}

Enclosure proved(const std::string& lower, const std::string& upper) {
  return certified(Rational::parse(lower), Rational::parse(upper), "test");
}

Verdict rounded(const std::string& printed, const Enclosure& value) {
  return settle(make_head(printed, ClaimKind::rounded), value).verdict;
}

TEST(PrintedValue, ReadsTheWaysInWhichDocumentsPrintNumbers) {
  EXPECT_EQ(printed_value(".689"), Rational(689, 1000));
  EXPECT_EQ(printed_value("-33/26"), Rational(-33, 26));
  EXPECT_EQ(printed_value("0.79%"), Rational(79, 10000));
  EXPECT_EQ(printed_value("\u20131.7"), Rational(-17, 10));  // en dash
  EXPECT_EQ(printed_value("\u22120.0299"), Rational(-299, 10000));
  EXPECT_EQ(printed_value("12"), Rational(12));
  EXPECT_EQ(printed_value("1.5e-3"), Rational(15, 10000));
}

TEST(PrintedValue, RejectsWhatIsNoNumber) {
  for (const char* text : {"", "about 3", "--5", "s=3/2", "1/0", "3 4", "%", "-"}) {
    EXPECT_THROW((void)printed_value(text), std::logic_error) << text;
  }
}

TEST(PrintedTolerance, IsHalfAUnitInTheLastPrintedDigit) {
  EXPECT_EQ(printed_tolerance("0.46415"), Rational(5, 1000000));
  EXPECT_EQ(printed_tolerance(".689"), Rational(5, 10000));
  EXPECT_EQ(printed_tolerance("0.79%"), Rational(5, 100000));
  EXPECT_EQ(printed_tolerance("3.4%"), Rational(5, 10000));
  EXPECT_EQ(printed_tolerance("12"), Rational(1, 2));
  EXPECT_EQ(printed_tolerance("1.5e-3"), Rational(5, 100000));
  EXPECT_EQ(printed_tolerance("-33/26"), Rational(0));
  EXPECT_EQ(printed_tolerance("12", ClaimKind::exact), Rational(0));
}

TEST(SettleExact, EqualityAlone) {
  const ClaimHead head = make_head("-33/26", ClaimKind::exact);
  EXPECT_EQ(settle(head, exact(Rational(-33, 26))).verdict, Verdict::reproduced);
  EXPECT_EQ(settle(head, exact(Rational(-34, 26))).verdict, Verdict::refuted);
  EXPECT_EQ(settle(head, proved("-1.27", "-1.26")).verdict, Verdict::undecided);
  EXPECT_EQ(settle(head, proved("-1.26", "-1.25")).verdict, Verdict::refuted);
  EXPECT_EQ(settle(head, approximate(-1.2692307, 6, "test")).verdict, Verdict::undecided);
  EXPECT_EQ(settle(head, approximate(-1.3, 6, "test")).verdict, Verdict::inconsistent);
}

TEST(SettleRounded, TheWholeEnclosureMustLieWithinHalfAUnit) {
  EXPECT_EQ(rounded(".689", proved("0.6889", "0.6891")), Verdict::reproduced);
  EXPECT_EQ(rounded(".689", proved("0.6885", "0.6895")), Verdict::reproduced) << "both ends touch";
  EXPECT_EQ(rounded(".689", proved("0.6894", "0.6896")), Verdict::undecided) << "straddles";
  EXPECT_EQ(rounded(".689", proved("0.68951", "0.6896")), Verdict::refuted);
  EXPECT_EQ(rounded(".689", proved("0.5", "0.68849")), Verdict::refuted);
  EXPECT_EQ(rounded(".689", proved("0", "1")), Verdict::undecided) << "contains everything";
  EXPECT_EQ(rounded("0.79%", proved("0.00789", "0.00791")), Verdict::reproduced);
  EXPECT_EQ(rounded("0.79%", proved("0.789", "0.791")), Verdict::refuted) << "per cent are hundredths";
  EXPECT_EQ(rounded("-33/26", exact(Rational(-33, 26))), Verdict::reproduced);
}

TEST(SettleRounded, ApproximateValuesProveNothing) {
  EXPECT_EQ(rounded("0.46", approximate(0.4601, 3, "test")), Verdict::consistent);
  EXPECT_EQ(rounded("0.46", approximate(0.4701, 3, "test")), Verdict::inconsistent);
  EXPECT_EQ(rounded("0.46", approximate(0.4651, 3, "test")), Verdict::undecided);
}

TEST(SettleRounded, ABudgetThatRanOutStillDecidesWhenTheEnclosureDoes) {
  Enclosure value = proved("0.6889", "0.6891");
  value.status = Status::out_of_depth;
  EXPECT_EQ(rounded(".689", value), Verdict::reproduced);
  EXPECT_EQ(settle(make_head(std::nullopt, ClaimKind::rounded), value).verdict, Verdict::undecided);
}

TEST(SettleFinding, IsEstablishedWhenProved) {
  const ClaimHead head = make_head(std::nullopt, ClaimKind::rounded);
  EXPECT_EQ(settle(head, proved("0.1", "0.2")).verdict, Verdict::established);
  EXPECT_EQ(settle(head, exact(Rational(1, 3))).verdict, Verdict::established);
  EXPECT_EQ(settle(head, approximate(0.5, 3, "test")).verdict, Verdict::undecided);
}

TEST(SettleBound, ComparesWithThePrintedNumber) {
  const ClaimHead head = make_head("1/5", ClaimKind::bound);
  EXPECT_EQ(settle_bound(head, BoundSide::at_most, proved("0.019", "0.02")).verdict, Verdict::reproduced);
  EXPECT_EQ(settle_bound(head, BoundSide::at_most, proved("0.1", "0.2")).verdict, Verdict::reproduced);
  EXPECT_EQ(settle_bound(head, BoundSide::at_most, proved("0.19", "0.21")).verdict, Verdict::undecided);
  EXPECT_EQ(settle_bound(head, BoundSide::at_most, proved("0.21", "0.22")).verdict, Verdict::refuted);
  EXPECT_EQ(settle_bound(head, BoundSide::at_least, proved("0.21", "0.22")).verdict, Verdict::reproduced);
  EXPECT_EQ(settle_bound(head, BoundSide::at_least, proved("0.1", "0.19")).verdict, Verdict::refuted);
  EXPECT_EQ(settle_bound(head, BoundSide::at_most, approximate(0.1, 2, "test")).verdict, Verdict::consistent);
  EXPECT_THROW((void)settle_bound(make_head("1/5", ClaimKind::exact), BoundSide::at_most, proved("0", "1")),
               std::logic_error);
}

TEST(SettleStatement, HoldsOrNot) {
  const ClaimHead printed = make_head("it is so", ClaimKind::exact);
  const Claim holds = settle_statement(printed, true, "true");
  EXPECT_EQ(holds.verdict, Verdict::reproduced);
  EXPECT_EQ(holds.exact, "true");
  EXPECT_FALSE(holds.lower.has_value());
  EXPECT_EQ(settle_statement(printed, false, "false", "it is otherwise").verdict, Verdict::refuted);
  EXPECT_EQ(settle_statement(printed, true, "", "", Rigour::approximate).verdict, Verdict::consistent);
  const ClaimHead finding = make_head(std::nullopt, ClaimKind::exact);
  EXPECT_EQ(settle_statement(finding, true, "true").verdict, Verdict::established);
  EXPECT_EQ(settle_statement(finding, true, "", "", Rigour::approximate).verdict, Verdict::undecided);
  EXPECT_THROW((void)settle_statement(finding, false, ""), std::logic_error);
}

TEST(SettleAs, NeedsAProofForAProvedVerdict) {
  const ClaimHead head = make_head("usually", ClaimKind::tendency);
  EXPECT_EQ(settle_as(head, Verdict::refuted, proved("0.2", "0.3"), "").verdict, Verdict::refuted);
  EXPECT_EQ(settle_as(head, Verdict::consistent, approximate(0.9, 2, ""), "").verdict, Verdict::consistent);
  EXPECT_THROW((void)settle_as(head, Verdict::reproduced, approximate(0.9, 2, ""), ""), std::logic_error);
}

TEST(Settle, RejectsKindsThatOneNumberCannotSettle) {
  for (const ClaimKind kind : {ClaimKind::bound, ClaimKind::tendency, ClaimKind::not_reproducible}) {
    EXPECT_THROW((void)settle(make_head("0.5", kind), exact(Rational(1, 2))), std::logic_error);
  }
}

TEST(SettleNotReproducible, HasNoValue) {
  const Claim claim =
      settle_not_reproducible(make_head("a figure", ClaimKind::not_reproducible), "the figure is lost");
  EXPECT_EQ(claim.verdict, Verdict::not_reproducible);
  EXPECT_FALSE(claim.lower.has_value());
}

}  // namespace
}  // namespace subdiv
