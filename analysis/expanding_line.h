#pragma once

#include <vector>

#include "analysis/expanding_condition.h"
#include "analysis/real_set.h"

namespace subdiv {

/// A part of a line of parameters on which a condition holds (expanding_condition.h), with the words of the
/// conditions that show it: at each point of the part one of them at least.
struct ExpandingPart {
  RealInterval range;       ///< where a condition holds
  std::vector<Word> words;  ///< of the conditions
};

/// A maximal interval on which no condition holds. Its open ends are roots of conditions, of which the words
/// are named; its closed ends are those of the line.
struct OpenGap {
  RealInterval range;          ///< where none holds
  std::vector<Word> at_lower;  ///< of the conditions that end there; empty at the line's end
  std::vector<Word> at_upper;  ///< of those that begin there
};

/// The exact partition of a closed interval of one parameter x_0 by conditions, found one after the other.
class ExpandingLine {
 public:
  /// lower < upper (std::domain_error).
  ExpandingLine(const Rational& lower, const Rational& upper);

  /// The condition uses no other parameter than x_0 (std::domain_error).
  void add(const ExpandingCondition& condition);

  /// Ascending; parts that touch are one.
  [[nodiscard]] std::vector<ExpandingPart> parts() const;
  [[nodiscard]] const std::vector<OpenGap>& gaps() const { return gaps_; }

 private:
  std::vector<ExpandingPart> parts_;
  std::vector<OpenGap> gaps_;
};

}  // namespace subdiv
