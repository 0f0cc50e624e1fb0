#pragma once

#include <utility>
#include <vector>

#include "analysis/mesh/interval_polynomial.h"
#include "analysis/mesh/mode_equation.h"

namespace subdiv {

/// The factors of a mode's characteristic polynomial for given parameters and turn, with multiplicities.
using ModeFactors = std::vector<std::pair<PolynomialFamily, int>>;

/// A polynomial in x whose coefficients are polynomials in s: [i][j] belongs to x^i s^j.
using ParameterPolynomial = std::vector<IntervalPolynomial>;

/// A mode equation prepared for evaluation at many intervals of its one parameter s = x_0 and many turns c.
class ModeTable {
 public:
  static constexpr long precision = 192;  ///< of the intervals, in bits

  /// Throws std::domain_error when the equation uses other variables than x_7, x_5 and x_0.
  explicit ModeTable(const ModeEquation& equation);

  /// All s of an interval: the middle's coefficients of x^i c^j of each factor, and all slopes (mean value
  /// theorem).
  struct AtParameter {
    /// A factor on the interval.
    struct Factor {
      std::vector<IntervalPolynomial> middle;  ///< for s at the middle
      std::vector<IntervalPolynomial> slope;   ///< an enclosure for all s
      int multiplicity = 1;                    ///< in the mode equation
      bool turns = false;                      ///< depends on c
    };
    std::vector<Factor> factors;        ///< irreducible ones
    Interval half_width = Interval(0);  ///< of the interval of s

    /// All factors at one turn c = cos(2 pi k/n).
    [[nodiscard]] ModeFactors at_turn(const Interval& c) const;
    /// Only the factors that depend on c: the others are the same in all modes k != 0.
    [[nodiscard]] ModeFactors turning_at(const Interval& c) const;
    /// The factors that do not depend on c.
    [[nodiscard]] ModeFactors common() const;

   private:
    static void append(const Factor& factor, const Interval& c, const Interval& half_width,
                       ModeFactors& result);
  };

  /// The factors for all s of [lower, upper].
  [[nodiscard]] AtParameter at(const Rational& lower, const Rational& upper) const;

  /// The factors as polynomials in x and s at one turn, each once.
  [[nodiscard]] std::vector<ParameterPolynomial> factors(const Interval& c) const;

 private:
  struct Factor {
    std::vector<std::vector<IntervalPolynomial>> coefficients;  // of x^i c^j: polynomials in s
    int multiplicity = 1;
    bool turns = false;
  };
  std::vector<Factor> factors_;
};

}  // namespace subdiv
