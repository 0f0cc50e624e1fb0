#include "optimize/popping_schedule.h"

#include <stdexcept>
#include <utility>

#include "schemes/algebra/interval.h"
#include "schemes/algebra/univariate.h"
#include "schemes/bspline.h"

namespace subdiv {
namespace {

/// x_k and M_k of the recursion, over rationals or intervals.
template <class R>
struct State {
  R x;
  R largest;  // M

  [[nodiscard]] R parameter() const { return (R(2) - x) / (R(4) - x); }
  [[nodiscard]] R disparity() const { return parameter() * largest / R(8); }
  [[nodiscard]] State next() const { return {x * (R(6) - x) / R(8), largest / (R(4) - x)}; }
};

}  // namespace

Laurent<RationalFunction> popping_difference(const Mask<RationalFunction>& step,
                                             const Laurent<RationalFunction>& before) {
  return (bspline<RationalFunction>(1).symbol - step.symbol) * upsample(before, 2);
}

std::vector<PoppingLevel> popping_schedule(int levels) {
  constexpr int exact_levels = 6;  // up to 77 digits
  constexpr long precision = 256;
  const char* const method = "closed recursion of the greedy minimax";
  std::vector<PoppingLevel> result;
  State<Rational> rational{Rational(3, 2), Rational(2)};
  int k = 1;
  for (; k <= levels && k <= exact_levels; ++k, rational = rational.next()) {
    result.push_back({exact(rational.parameter(), method), exact(rational.disparity(), method)});
  }
  State<Interval> enclosed{Interval(rational.x, precision), Interval(rational.largest, precision)};
  for (; k <= levels; ++k, enclosed = enclosed.next()) {
    result.push_back({certified(enclosed.parameter(), method), certified(enclosed.disparity(), method)});
  }
  return result;
}

Enclosure popping_limit() {
  const Rational start(3, 2);
  const UnivariatePolynomial x({Rational(0), Rational(1)});
  const UnivariatePolynomial factor = (UnivariatePolynomial(6) - x) * UnivariatePolynomial(Rational(1, 8));
  // On (0, start] the factor falls, so these two values bound it.
  const Rational least = factor.evaluate(start);
  const Rational greatest = factor.evaluate(Rational(0));
  const std::vector<RealRoot> fixed_points = real_roots(x * factor - x);
  const bool contracts = least > Rational(0) && greatest < Rational(1);
  for (const RealRoot& root : fixed_points) {
    if (!contracts || root.value < Algebraic(0) || root.value > Algebraic(start)) continue;
    return exact(State<Rational>{root.value.to_rational(), Rational(0)}.parameter(),
                 "the recursion contracts to its only fixed point");
  }
  throw std::logic_error("the popping recursion has no attracting fixed point");
}

}  // namespace subdiv
