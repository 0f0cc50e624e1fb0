#include "analysis/sign_on_domain.h"

#include <gtest/gtest.h>

#include <array>

namespace subdiv {
namespace {

using Kind = DomainSign::Kind;

const Polynomial& x() {
  static const Polynomial value = Polynomial::variable(0);
  return value;
}
const Polynomial& y() {
  static const Polynomial value = Polynomial::variable(1);
  return value;
}

PlaneDomain square(std::vector<Polynomial> positive = {}) {
  return {{{Rational(0), Rational(0)}, {Rational(1), Rational(1)}}, std::move(positive)};
}
/// Inside the unit circle.
PlaneDomain disc() {
  return {{{Rational(-1), Rational(-1)}, {Rational(1), Rational(1)}},
          {Polynomial(1) - x() * x() - y() * y()}};
}

Kind sign_of(const RationalFunction& f, const PlaneDomain& domain) {
  return DomainSigns(domain).sign(f).kind;
}

TEST(SignOnDomain, ProvesStrictSigns) {
  EXPECT_EQ(sign_of(x() * x() - x() * y() + y() * y() + Polynomial(Rational(1, 100)), square()),
            Kind::positive);
  EXPECT_EQ(sign_of(x() * y() - Polynomial(Rational(9, 8)), disc()), Kind::negative);
  // The largest x y on the disc is 1/2, beyond which the square goes.
  EXPECT_EQ(sign_of(x() * y() - Polynomial(Rational(501, 1000)), disc()), Kind::negative);
  EXPECT_EQ(sign_of(x() * y() - Polynomial(Rational(501, 1000)), square()), Kind::not_strict);
  EXPECT_EQ(sign_of(Polynomial(-3), square()), Kind::negative);
}

TEST(SignOnDomain, EachSideOfTheBoxHasItsSign) {
  const Polynomial one(1);
  EXPECT_EQ(sign_of(x(), square()), Kind::positive);
  EXPECT_EQ(sign_of(y(), square()), Kind::positive);
  EXPECT_EQ(sign_of(one - x(), square()), Kind::positive);
  EXPECT_EQ(sign_of(one - y(), square()), Kind::positive);
  EXPECT_EQ(sign_of(x() - one, square()), Kind::negative);
  EXPECT_EQ(sign_of(Polynomial(-2) * y(), square()), Kind::negative);
  EXPECT_EQ(sign_of(x() + one, disc()), Kind::positive);
  EXPECT_EQ(sign_of(y() - one, disc()), Kind::negative);
}

TEST(SignOnDomain, FactorsOfTheDomainHaveTheirSign) {
  const Polynomial one(1);
  EXPECT_EQ(sign_of(x() * (one - x()) * (y() - one), square()), Kind::negative);
  EXPECT_EQ(sign_of(x() * x() * (y() - one) * (y() - one), square()), Kind::positive);
  const Polynomial g = one - x() * x() - y() * y();
  EXPECT_EQ(sign_of(Polynomial(-2) * g * g * g, disc()), Kind::negative);
  EXPECT_EQ(sign_of(RationalFunction(g) / RationalFunction(x() - Polynomial(2)), disc()), Kind::negative);
}

TEST(SignOnDomain, ValuesZeroAtCornersOutsideTheDomainAreAllowed) {
  EXPECT_EQ(sign_of(x() + y(), square()), Kind::positive);
  EXPECT_EQ(sign_of(Polynomial(2) - x() - y() * y(), square()), Kind::positive);
}

TEST(SignOnDomain, ValuesZeroAtCornersInsideTheDomainAreNot) {
  // 0 at (1/2, 1/4) alone, which is a corner of cells, and all other coefficients there are positive.
  const Polynomial a = x() - Polynomial(Rational(1, 2));
  const Polynomial b = y() - Polynomial(Rational(1, 4));
  const DomainSign found = DomainSigns(square()).sign(a * a + b * b);
  EXPECT_EQ(found.kind, Kind::not_strict);
  const std::vector<std::vector<Rational>> zero{{Rational(1, 2), Rational(1, 4)}};
  EXPECT_EQ(found.witnesses, zero);
  // A line of zeros whose ends on the box are outside the domain; a rational zero in one variable.
  EXPECT_EQ(sign_of(x(), disc()), Kind::not_strict);
  EXPECT_EQ(sign_of(y() * y() - Polynomial(Rational(1, 4)), disc()), Kind::not_strict);
  EXPECT_EQ(sign_of(x() - y(), disc()), Kind::not_strict);
}

TEST(SignOnDomain, FindsSignChangesAndZeros) {
  DomainSigns signs(square());
  const DomainSign change = signs.sign(x() - y());
  EXPECT_EQ(change.kind, Kind::not_strict);
  const auto value = [](const Polynomial& f, const std::vector<Rational>& at) {
    return f.evaluate<Rational>(at);
  };
  for (const Polynomial& f : {x() - y(), x() * x() + y() * y() - Polynomial(Rational(1, 1000)),
                              x() * y() - Polynomial(Rational(1, 3))}) {
    const DomainSign found = signs.sign(f);
    ASSERT_EQ(found.kind, Kind::not_strict);
    ASSERT_FALSE(found.witnesses.empty());
    if (found.witnesses.size() == 1) {
      EXPECT_EQ(value(f, found.witnesses[0]), Rational(0));
    } else {
      EXPECT_EQ(value(f, found.witnesses[0]).sign() * value(f, found.witnesses[1]).sign(), -1);
    }
    for (const auto& point : found.witnesses) EXPECT_TRUE(signs.domain().contains(point[0], point[1]));
  }
  // Zero at one point alone; a square of a factor that changes sign; a pole.
  const Polynomial half(Rational(1, 2));
  EXPECT_EQ(signs.sign((x() - half) * (x() - half) + (y() - half) * (y() - half)).kind, Kind::not_strict);
  EXPECT_EQ(signs.sign((x() - y()) * (x() - y())).kind, Kind::not_strict);
  EXPECT_EQ(signs.sign(RationalFunction(1) / RationalFunction(x() - half)).kind, Kind::not_strict);
}

TEST(SignOnDomain, NeverCallsATouchedZeroStrict) {
  // Zero at (1/sqrt 2, 1/3) alone: no halving finds that point.
  const Polynomial a = x() * x() - Polynomial(Rational(1, 2));
  const Polynomial b = y() - Polynomial(Rational(1, 3));
  const DomainSign found = DomainSigns(square(), 2000).sign(a * a + b * b);
  EXPECT_EQ(found.kind, Kind::undecided);
  EXPECT_NE(found.status, Status::closed);
  // Without a zero there it is positive, however close.
  EXPECT_EQ(sign_of(a * a + b * b + Polynomial(Rational(1, 1000000)), square()), Kind::positive);
}

TEST(SignOnDomain, BudgetEndsUndecided) {
  const Polynomial f = x() * x() - x() * y() + y() * y() + Polynomial(Rational(1, 1000000));
  const DomainSign found = DomainSigns(square(), 1).sign(f);
  EXPECT_EQ(found.kind, Kind::undecided);
  EXPECT_EQ(found.status, Status::out_of_time);
  EXPECT_EQ(DomainSigns(square(), 1000, 1).sign(f).status, Status::out_of_depth);
  // The depth is that of both directions: x_0 is halved first, and here x_1 has to be.
  const Polynomial b = y() - Polynomial(Rational(1, 2));
  EXPECT_EQ(DomainSigns(square(), 1000, 1).sign(b * b + Polynomial(Rational(1, 8))).kind, Kind::positive);
  // So it is for a point of the domain: here the first is the middle of a quarter.
  const Polynomial quarter(Rational(1, 4));
  const Polynomial near =
      Polynomial(Rational(1, 16)) - (x() - quarter) * (x() - quarter) - (y() - quarter) * (y() - quarter);
  EXPECT_EQ(DomainSigns(square({near}), 1000, 1).sign(x() + y()).kind, Kind::positive);
}

TEST(SignOnDomain, RefusesWhatItCannotAnswer) {
  DomainSigns signs(square());
  EXPECT_THROW((void)signs.sign(Polynomial(0)), std::invalid_argument);
  EXPECT_THROW((void)signs.sign(Polynomial::variable(2)), std::invalid_argument);
  EXPECT_THROW(DomainSigns(PlaneDomain{{{Rational(0)}, {Rational(1)}}, {}}), std::invalid_argument);
  // No point: nothing is known, nothing is claimed.
  EXPECT_EQ(DomainSigns(square({Polynomial(-1) - x()})).sign(x() + Polynomial(1)).kind, Kind::undecided);
}

TEST(SignOnDomain, AgreesWithSamples) {
  // Polynomials with many signs: a proved sign is that of every sample.
  const PlaneDomain domain = disc();
  DomainSigns signs(domain, 500);
  int proved = 0;
  for (int k = 0; k < 60; ++k) {
    const auto c = [&](int i) {
      return Polynomial(Rational((k * k * 7 + i * i * 13 + i * k * 5) % 19 - 9, 4));
    };
    const Polynomial f = c(0) + c(0) + c(0) + c(1) * x() + c(2) * y() + c(3) * x() * y() + c(4) * x() * x() +
                         c(5) * x() * y() * y();
    if (f.is_zero()) continue;
    const DomainSign found = signs.sign(f);
    for (int i = -10; i <= 10; ++i) {
      for (int j = -10; j <= 10; ++j) {
        const std::array<Rational, 2> at{Rational(i, 10), Rational(j, 10)};
        if (!domain.contains(at[0], at[1])) continue;
        const int sign = f.evaluate<Rational>(at).sign();
        EXPECT_TRUE(found.kind != Kind::positive || sign == 1) << k;
        EXPECT_TRUE(found.kind != Kind::negative || sign == -1) << k;
      }
    }
    proved += found.kind == Kind::positive || found.kind == Kind::negative ? 1 : 0;
  }
  EXPECT_GT(proved, 5);
}

}  // namespace
}  // namespace subdiv
