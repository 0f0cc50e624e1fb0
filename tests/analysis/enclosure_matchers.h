#pragma once

#include <string>

#include <gtest/gtest.h>

#include "analysis/enclosure.h"

namespace subdiv::testing {

/// The enclosure is certified or exact, lies within one unit of the last digit of a decimal, and is no wider
/// than that.
inline ::testing::AssertionResult agrees(const Enclosure& value, const std::string& decimal) {
  const std::size_t point = decimal.find('.');
  const long digits = point == std::string::npos ? 0 : static_cast<long>(decimal.size() - point - 1);
  const Rational unit = pow(Rational(10), -digits);
  const Rational printed = Rational::parse(decimal);
  const bool inside = value.lower <= value.upper && printed - unit <= value.lower &&
                      value.upper <= printed + unit && value.width() <= unit;
  if (inside && value.rigour != Rigour::approximate) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << "[" << to_significant(value.lower, 25, -1) << ", " << to_significant(value.upper, 25, 1) << "] ("
         << to_string(value.rigour) << ") is not " << decimal;
}

}  // namespace subdiv::testing
