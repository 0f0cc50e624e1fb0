#include "schemes/algebra/rational.h"

#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "tests/schemes/algebra/random_elements.h"

namespace subdiv {
namespace {

using testing::Generator;
using testing::random_int;
using testing::random_rational;

TEST(Rational, IsKeptInLowestTermsWithPositiveDenominator) {
  EXPECT_EQ(Rational(6, -4).to_string(), "-3/2");
  EXPECT_EQ(Rational(-6, -3).to_string(), "2");
  EXPECT_EQ(Rational(0, 7).to_string(), "0");
  EXPECT_TRUE(Rational(14, 7).is_integer());
  EXPECT_FALSE(Rational(15, 7).is_integer());
  EXPECT_THROW(Rational(1, 0), std::domain_error);
  EXPECT_THROW(Rational(1) / Rational(0), std::domain_error);
}

TEST(Rational, IsOrderedByValue) {
  EXPECT_LT(Rational(-33, 26), Rational(-5, 4));
  EXPECT_GT(Rational(1, 3), Rational(33333333, 100000000));
  EXPECT_EQ(Rational(-2, 6), Rational(1, -3));
  EXPECT_EQ(Rational(-7, 9).sign(), -1);
  EXPECT_EQ(Rational(0).sign(), 0);
  EXPECT_EQ(Rational(7, 9).sign(), 1);
}

TEST(Rational, ParsesIntegersFractionsAndDecimalsExactly) {
  EXPECT_EQ(Rational::parse("-33/26"), Rational(-33, 26));
  EXPECT_EQ(Rational::parse("0.46415"), Rational(46415, 100000));
  EXPECT_EQ(Rational::parse("-1.5e-3"), Rational(-15, 10000));
  EXPECT_EQ(Rational::parse("+2E2"), Rational(200));
  EXPECT_EQ(Rational::parse("1e+1"), Rational(10));
  EXPECT_EQ(Rational::parse(".5"), Rational(1, 2));
  EXPECT_EQ(Rational::parse("5."), Rational(5));
  EXPECT_EQ(Rational::parse("  7 "), Rational(7));
  EXPECT_EQ(Rational::parse("0.1") + Rational::parse("0.2"), Rational::parse("0.3"));
  EXPECT_EQ(Rational::parse("00012"), Rational(12));
  const std::string large = "123456789012345678901234567890";
  EXPECT_EQ(Rational::parse(large).to_string(), large);
}

TEST(Rational, RejectsWhatIsNoNumber) {
  for (const char* text :
       {"",    " ",     ".",     "-",     "+",   "+-1", "--1",     "1/",       "/2",
        "1/0", "1/-2",  "1/2/3", "1/2.5", "abc", "1a",  "0x10",    "1e",       "1e+",
        "e5",  "1e1.5", "1 2",   "1,5",   "nan", "inf", "1e99999", "1e-99999", "1e999999999999999999999",
        "1/ 2"}) {
    EXPECT_THROW(Rational::parse(text), std::invalid_argument) << "'" << text << "'";
  }
  try {
    Rational::parse("1,5");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("'1,5'"), std::string::npos) << error.what();
  }
}

TEST(Rational, PrintsWhatItParses) {
  Generator generator(1);
  for (int i = 0; i < 500; ++i) {
    const Rational q = random_rational(generator) * random_rational(generator);
    EXPECT_EQ(Rational::parse(q.to_string()), q);
  }
}

TEST(Rational, TakesTheExactValueOfADouble) {
  EXPECT_EQ(Rational::from_double(0.1), Rational::parse("3602879701896397") * Rational::power_of_two(-55));
  EXPECT_EQ(Rational::from_double(-0.375), Rational(-3, 8));
  EXPECT_EQ(Rational::from_double(0.0), Rational(0));
  EXPECT_EQ(Rational::from_double(std::numeric_limits<double>::denorm_min()), Rational::power_of_two(-1074));
  EXPECT_EQ(Rational::from_double(std::ldexp(1.0, 1000)), Rational::power_of_two(1000));
  EXPECT_THROW(Rational::from_double(std::numeric_limits<double>::infinity()), std::domain_error);
  EXPECT_THROW(Rational::from_double(std::numeric_limits<double>::quiet_NaN()), std::domain_error);
  Generator generator(2);
  for (int i = 0; i < 200; ++i) {
    const double x = std::ldexp(static_cast<double>(random_int(generator, -1'000'000, 1'000'000)),
                                random_int(generator, -60, 60));
    EXPECT_EQ(Rational::from_double(x).to_double(), x);
  }
}

TEST(Rational, ConvertsToIntegersOnlyWhenItIsOne) {
  EXPECT_EQ(Rational(-14, 2).to_integer(), -7);
  EXPECT_EQ(Rational(std::numeric_limits<std::int64_t>::min()).to_integer(),
            std::numeric_limits<std::int64_t>::min());
  EXPECT_THROW(static_cast<void>(Rational(1, 2).to_integer()), std::domain_error);
  EXPECT_THROW(static_cast<void>(pow(Rational(2), 63).to_integer()), std::domain_error);
}

TEST(Rational, PowersOfAnySign) {
  EXPECT_EQ(pow(Rational(-2, 3), 3), Rational(-8, 27));
  EXPECT_EQ(pow(Rational(-2, 3), -2), Rational(9, 4));
  EXPECT_EQ(pow(Rational(0), 0), Rational(1));
  EXPECT_THROW(pow(Rational(0), -1), std::domain_error);
  EXPECT_EQ(Rational::power_of_two(-3), Rational(1, 8));
  EXPECT_EQ(Rational::power_of_two(5), Rational(32));
}

TEST(Rational, FloorAndAbsoluteValue) {
  EXPECT_EQ(floor(Rational(7, 2)), Rational(3));
  EXPECT_EQ(floor(Rational(-7, 2)), Rational(-4));
  EXPECT_EQ(floor(Rational(-4)), Rational(-4));
  EXPECT_EQ(abs(Rational(-3, 5)), Rational(3, 5));
}

TEST(Rational, SimplestFractionBetween) {
  EXPECT_EQ(simplest_between(Rational::parse("3.1"), Rational::parse("3.2")), Rational(16, 5));
  EXPECT_EQ(simplest_between(Rational::parse("3.14"), Rational::parse("3.15")), Rational(22, 7));
  EXPECT_EQ(simplest_between(Rational::parse("-0.34"), Rational::parse("-0.33")), Rational(-1, 3));
  EXPECT_EQ(simplest_between(Rational(-1, 2), Rational(1, 3)), Rational(0));
  EXPECT_EQ(simplest_between(Rational(5, 7), Rational(5, 7)), Rational(5, 7));
  EXPECT_THROW(simplest_between(Rational(1), Rational(0)), std::domain_error);
}

TEST(RationalText, DecimalsRoundInTheDirectionAsked) {
  const Rational x(-2, 3);
  EXPECT_EQ(to_decimal(x, 4, -1), "-0.6667");
  EXPECT_EQ(to_decimal(x, 4, 1), "-0.6666");
  EXPECT_EQ(to_decimal(x, 4), "-0.6667");
  EXPECT_EQ(to_decimal(Rational(2, 3), 4, -1), "0.6666");
  EXPECT_EQ(to_decimal(Rational(2, 3), 4, 1), "0.6667");
  EXPECT_EQ(to_decimal(Rational(1, 2), 0), "1");  // ties away from zero
  EXPECT_EQ(to_decimal(Rational(-1, 2), 0), "-1");
  EXPECT_EQ(to_decimal(Rational(-1, 2), 0, 1), "0");
  EXPECT_EQ(to_decimal(Rational(1, 1000), 2), "0.00");
  EXPECT_EQ(to_decimal(Rational(-5, 1000), 2, 1), "0.00");
  EXPECT_EQ(to_decimal(Rational(12345), 2), "12345.00");
  EXPECT_EQ(to_decimal(Rational(19999, 10000), 3), "2.000");
}

TEST(RationalText, SignificantDigitsRoundInTheDirectionAsked) {
  EXPECT_EQ(to_significant(Rational(1, 3), 5), "0.33333");
  EXPECT_EQ(to_significant(Rational(1, 3), 5, 1), "0.33334");
  EXPECT_EQ(to_significant(Rational(-1, 3), 5, -1), "-0.33334");
  EXPECT_EQ(to_significant(Rational(-1, 3), 5, 1), "-0.33333");
  EXPECT_EQ(to_significant(Rational(0), 5), "0");
  EXPECT_EQ(to_significant(Rational(999, 1000), 2), "1.0");
  EXPECT_EQ(to_significant(Rational(9999), 2), "10000");
  EXPECT_EQ(to_significant(Rational(12345), 2, -1), "12000");
  EXPECT_EQ(to_significant(Rational(12345), 2, 1), "13000");
  EXPECT_EQ(to_significant(Rational(1), 3), "1.00");
  EXPECT_EQ(to_significant(Rational(10), 3), "10.0");
  EXPECT_EQ(to_significant(Rational::parse("1.2345e-9"), 3), "1.23e-9");
  EXPECT_EQ(to_significant(Rational::parse("9.999e-9"), 3), "1.00e-8");
  EXPECT_EQ(to_significant(Rational::parse("1e-6"), 1), "0.000001");
  EXPECT_EQ(to_significant(Rational::parse("9.99e-7"), 3), "9.99e-7");
}

// Rounding down never exceeds the value, rounding up never falls short, both by less than one unit; the
// nearest is within half a unit. The text itself is read back to say so.
TEST(RationalText, RoundingIsCorrectForRandomNumbers) {
  Generator generator(3);
  for (int i = 0; i < 2000; ++i) {
    const Rational x = random_rational(generator) * pow(Rational(7, 3), random_int(generator, -20, 20));
    const int digits = random_int(generator, 0, 12);
    const Rational unit = pow(Rational(10), -digits);
    const Rational down = Rational::parse(to_decimal(x, digits, -1));
    const Rational up = Rational::parse(to_decimal(x, digits, 1));
    EXPECT_TRUE(down <= x && x - down < unit) << x.to_string() << " to " << digits;
    EXPECT_TRUE(x <= up && up - x < unit) << x.to_string() << " to " << digits;
    EXPECT_LE(abs(Rational::parse(to_decimal(x, digits)) - x), unit / Rational(2));
  }
}

TEST(RationalText, SignificantDigitsAreThatManyForRandomNumbers) {
  Generator generator(4);
  for (int i = 0; i < 2000; ++i) {
    const Rational x = random_rational(generator) * pow(Rational(7, 3), random_int(generator, -40, 40));
    if (x.sign() == 0) continue;
    const int digits = random_int(generator, 1, 20);
    const Rational nearest = Rational::parse(to_significant(x, digits));
    // Relative error of at most half a unit in the last of the digits.
    EXPECT_LE(abs(nearest - x), abs(x) * pow(Rational(10), 1 - digits) / Rational(2)) << x.to_string();
    EXPECT_LE(Rational::parse(to_significant(x, digits, -1)), x);
    EXPECT_GE(Rational::parse(to_significant(x, digits, 1)), x);
  }
}

}  // namespace
}  // namespace subdiv
