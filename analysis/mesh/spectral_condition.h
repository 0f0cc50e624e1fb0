#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "analysis/decision.h"
#include "analysis/mesh/mode_table.h"

namespace subdiv {

/// Reif's condition on the eigenvalues at a vertex of valence n (Reif: A unified approach to subdivision
/// algorithms near extraordinary vertices, 1995; Peters & Reif: Subdivision surfaces, 2008): 1 is simple and
/// of mode 0; the next is lambda, real and positive, simple in mode 1 and so in its mirror image n - 1;
/// all others are strictly smaller in modulus: 1 > lambda > |others|. (Necessary for limits that are C1 and
/// injective for generic control points; with a regular and injective characteristic map, sufficient.)

/// A closed interval of the parameter throughout which the condition holds, or fails, or is not decided.
struct ConditionCell {
  Rational lower;                        ///< the left end
  Rational upper;                        ///< the right end
  Decision holds = Decision::undecided;  ///< for all parameters of the cell
};

/// The largest eigenvalue besides 1 and lambda, in double precision: not proved.
struct Rival {
  int mode = 0;                ///< the Fourier mode that it belongs to
  std::complex<double> value;  ///< the eigenvalue
  double subdominant = 0;      ///< the modulus of mode 1's largest
};

/// What is known of the spectrum where the condition holds.
struct LeadingEigenvalues {
  Interval subdominant;  ///< lambda
  Interval next;         ///< the largest modulus of the others, 1 left out
};

/// The condition for one scheme, valence by valence, on intervals of its parameter.
class SpectralCondition {
 public:
  /// The equations of the modes k != 0 and of mode 0, with no other parameter than x_0, at one valence. (Mode
  /// 0 may use cos(2 pi/n), as x_5.) Throws std::domain_error when 1 is no eigenvalue of mode 0.
  SpectralCondition(const ModeEquation& turning, const ModeEquation& invariant, int valence);

  [[nodiscard]] int valence() const { return valence_; }

  /// Proved for every s of [lower, upper], or refuted for every one, or neither. All roots are counted
  /// inside circles whose radius lies between lambda and the others (roots_within), in interval arithmetic.
  [[nodiscard]] Decision decide(const Rational& lower, const Rational& upper) const;
  [[nodiscard]] Decision decide(const Rational& s) const { return decide(s, s); }

  /// [lower, upper] as cells, ascending, neighbours of different decisions: halved until decided or narrower
  /// than `width`. An undecided cell lies around a point where the condition begins or ends.
  [[nodiscard]] std::vector<ConditionCell> cells(const Rational& lower, const Rational& upper,
                                                 const Rational& width) const;

  /// Certified at a single s where the condition holds; nothing otherwise.
  [[nodiscard]] std::optional<LeadingEigenvalues> leading(const Rational& s) const;

  /// The other eigenvalue of the largest modulus, whether or not the condition holds.
  [[nodiscard]] Rival rival(const Rational& s) const;

  /// The numbers of eigenvalues of the modes 0 .. n/2, the 1 of mode 0 left out, outside the circle, the same
  /// for all s of [lower, upper], none of them on it; nothing when that is not proved.
  [[nodiscard]] std::optional<std::vector<int>> beyond(const Rational& lower, const Rational& upper,
                                                       const Interval& radius) const;

  /// The factors of a mode's characteristic polynomial, that of the 1 of mode 0 left out, as polynomials in x
  /// and s.
  [[nodiscard]] std::vector<ParameterPolynomial> factors(int mode) const;

 private:
  class Cell;
  [[nodiscard]] const Interval& turn(int mode) const { return turns_[static_cast<std::size_t>(mode)]; }
  [[nodiscard]] int last_mode() const { return valence_ / 2; }
  void split(const Rational& lower, const Rational& upper, const Rational& width,
             std::vector<Interval> bounds, std::vector<ConditionCell>& result) const;

  int valence_;
  ModeTable turning_;
  ModeTable invariant_;  // without the eigenvalue 1
  std::vector<Interval> turns_;
};

}  // namespace subdiv
