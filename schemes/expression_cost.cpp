#include "schemes/expression_cost.h"

#include <flint/fmpz.h>

namespace subdiv {

long ExpressionCost<Rational>::size(const Rational& x) {
  constexpr long word = 64;
  return 1 + static_cast<long>(fmpz_bits(fmpq_numref(x.raw())) + fmpz_bits(fmpq_denref(x.raw()))) / word;
}

long ExpressionCost<RationalFunction>::size(const RationalFunction& f) {
  using Terms = ExpressionCost<Polynomial>;
  return Terms::size(f.numerator()) + Terms::size(f.denominator()) - 1;
}

}  // namespace subdiv
