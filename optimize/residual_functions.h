#pragma once

#include <span>
#include <vector>

#include "optimize/problem.h"
#include "schemes/algebra/interval.h"

namespace subdiv {

/// A rational function prepared for repeated evaluation at points and boxes: terms in a flat array.
class CompiledFunction {
 public:
  CompiledFunction() = default;
  /// Coefficients enclosed at the given precision; parameters beyond `variables` must not occur
  /// (std::domain_error).
  CompiledFunction(const RationalFunction& f, int variables, long precision);

  /// The value at a point, in floating point.
  [[nodiscard]] double evaluate(std::span<const double> x) const;
  /// The range over a box, outward-rounded; not finite where the denominator may vanish.
  [[nodiscard]] Interval evaluate(std::span<const Interval> x) const;
  /// Can the denominator vanish somewhere in the box?
  [[nodiscard]] bool may_have_pole(std::span<const Interval> x) const;

 private:
  struct Part {
    std::vector<Interval> coefficients;
    std::vector<double> rounded;
    std::vector<int> exponents;  // `variables` a term
  };
  static Part compile(const Polynomial& p, int variables, long precision);
  template <class T>
  static T evaluate_part(const Part& part, const std::vector<T>& coefficients, std::span<const T> x);

  Part numerator_;
  Part denominator_;
  bool has_denominator_ = false;
};

/// A residual with its gradient.
struct CompiledResidual {
  CompiledFunction value;                  ///< the residual
  std::vector<CompiledFunction> gradient;  ///< its partial derivatives
};

/// Of one residual in x_0 .. x_{variables-1}; enclosures are at the precision in bits.
[[nodiscard]] CompiledResidual compile(const RationalFunction& residual, int variables, long precision);
/// Of all residuals of a problem.
[[nodiscard]] std::vector<CompiledResidual> compile(const Problem& problem, long precision);

/// The norm's objective from residual values: max |r_i|, sum of |r_i|, or sum of squares.
[[nodiscard]] double objective(Norm norm, std::span<const double> residuals);
/// The norm of values known as intervals: an enclosure.
[[nodiscard]] Interval objective(Norm norm, std::span<const Interval> residuals);

}  // namespace subdiv
