#include "analysis/mesh/mode_table.h"

#include "analysis/eigenvalues.h"

namespace subdiv {
namespace {

IntervalPolynomial intervals(const UnivariatePolynomial& p) {
  IntervalPolynomial result;
  for (long i = 0; i <= p.degree(); ++i) result.emplace_back(p.coefficient(i), ModeTable::precision);
  return result;
}

/// p(m + t) as a polynomial in t.
IntervalPolynomial around(IntervalPolynomial p, const Interval& m) {
  for (std::size_t done = 0; done + 1 < p.size(); ++done) {
    for (std::size_t i = p.size() - 1; i-- > done;) add_product(p[i], m, p[i + 1]);
  }
  return p;
}

}  // namespace

ModeTable::ModeTable(const ModeEquation& equation) {
  for (const auto& [base, multiplicity] : equation.factors) {
    Factor factor{{}, multiplicity, base.uses(turn_variable)};
    for (const Polynomial& in_turn : base.coefficients_in(eigenvalue_variable)) {
      factor.coefficients.emplace_back();
      for (const Polynomial& in_parameter : in_turn.coefficients_in(turn_variable)) {
        factor.coefficients.back().push_back(intervals(UnivariatePolynomial(in_parameter, 0)));
      }
    }
    factors_.push_back(std::move(factor));
  }
}

ModeTable::AtParameter ModeTable::at(const Rational& lower, const Rational& upper) const {
  const Interval range = Interval::hull(lower, upper, precision);
  const Interval middle = range.center();
  AtParameter result{{}, lower == upper ? Interval(0) : abs(range - middle)};
  // A single rational number may be no dyadic one: its ball is evaluated as it is.
  for (const Factor& factor : factors_) {
    AtParameter::Factor here{{}, {}, factor.multiplicity, factor.turns};
    for (const std::vector<IntervalPolynomial>& row : factor.coefficients) {
      here.middle.emplace_back();
      here.slope.emplace_back();
      for (const IntervalPolynomial& c : row) {
        if (lower == upper) {
          here.middle.back().push_back(value_at(c, range));
          continue;
        }
        IntervalPolynomial shifted = around(c, middle);
        here.middle.back().push_back(shifted.empty() ? Interval(0) : shifted.front());
        if (!shifted.empty()) shifted.erase(shifted.begin());
        here.slope.back().push_back(value_at(shifted, range - middle));
      }
    }
    result.factors.push_back(std::move(here));
  }
  return result;
}

std::vector<ParameterPolynomial> ModeTable::factors(const Interval& c) const {
  std::vector<ParameterPolynomial> result;
  for (const Factor& factor : factors_) {
    ParameterPolynomial p;
    for (const std::vector<IntervalPolynomial>& row : factor.coefficients) {
      p.emplace_back();
      Interval power(1);
      for (const IntervalPolynomial& in_parameter : row) {
        if (p.back().size() < in_parameter.size()) p.back().resize(in_parameter.size(), Interval(0));
        for (std::size_t j = 0; j < in_parameter.size(); ++j) {
          add_product(p.back()[j], in_parameter[j], power);
        }
        power *= c;
      }
    }
    result.push_back(std::move(p));
  }
  return result;
}

void ModeTable::AtParameter::append(const Factor& factor, const Interval& c, const Interval& half_width,
                                    ModeFactors& result) {
  PolynomialFamily p{{}, {}, half_width};
  for (const IntervalPolynomial& in_turn : factor.middle) p.middle.push_back(value_at(in_turn, c));
  for (const IntervalPolynomial& in_turn : factor.slope) p.slope.push_back(value_at(in_turn, c));
  // Exactly zero leading coefficients: a rule that is shorter at this value.
  while (p.middle.size() > 1 && half_width.is_exactly_zero() && p.middle.back().is_exactly_zero()) {
    p.middle.pop_back();
  }
  result.emplace_back(std::move(p), factor.multiplicity);
}

ModeFactors ModeTable::AtParameter::at_turn(const Interval& c) const {
  ModeFactors result;
  for (const Factor& factor : factors) append(factor, c, half_width, result);
  return result;
}

ModeFactors ModeTable::AtParameter::common() const {
  ModeFactors result;
  for (const Factor& factor : factors) {
    if (!factor.turns) append(factor, Interval(0), half_width, result);
  }
  return result;
}

ModeFactors ModeTable::AtParameter::turning_at(const Interval& c) const {
  ModeFactors result;
  for (const Factor& factor : factors) {
    if (factor.turns) append(factor, c, half_width, result);
  }
  return result;
}

}  // namespace subdiv
