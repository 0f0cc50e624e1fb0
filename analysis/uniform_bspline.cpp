#include "analysis/uniform_bspline.h"

#include <algorithm>
#include <stdexcept>

namespace subdiv {
namespace {

UnivariatePolynomial antiderivative(const UnivariatePolynomial& p) {
  std::vector<Rational> coefficients{0};
  for (long i = 0; i <= p.degree(); ++i) coefficients.push_back(p.coefficient(i) / Rational(i + 1));
  return UnivariatePolynomial(coefficients);
}

}  // namespace

UniformBspline::UniformBspline(int degree) : degree_(degree) {
  if (degree < 0) throw std::domain_error("a B-spline's degree is at least 0");
  Piece current;
  pieces_.push_back(current);
  Rational weight(1);  // (-1)^j binomial(d+1, j) / d!
  for (int j = 2; j <= degree; ++j) weight /= Rational(j);
  for (int j = 0; j <= degree + 1; ++j) {
    const UnivariatePolynomial offset({half_width() - Rational(j), Rational(1)});
    UnivariatePolynomial power(weight);
    for (int k = 0; k < degree; ++k) power *= offset;
    current.value += power;
    const Rational knot = Rational(j) - half_width();
    const UnivariatePolynomial primitive = antiderivative(current.value);
    const Rational before = current.integral.evaluate(knot);
    current.integral = primitive + UnivariatePolynomial(before - primitive.evaluate(knot));
    pieces_.push_back(current);
    weight *= Rational(j - degree - 1, j + 1);
  }
}

std::size_t UniformBspline::piece_from(const Rational& t) const {
  const Rational place = floor(t + half_width());
  const Rational last(degree_ + 1);
  return static_cast<std::size_t>((std::clamp(place, Rational(-1), last) + Rational(1)).to_integer());
}

const UnivariatePolynomial& UniformBspline::piece(const Rational& lower, const Rational& upper) const {
  const std::size_t i = piece_from(lower);
  const Rational next_knot = Rational(static_cast<std::int64_t>(i)) - half_width();
  if (i + 1 < pieces_.size() && upper > next_knot) throw std::domain_error("a knot lies inside the interval");
  return pieces_[i].value;
}

Rational UniformBspline::value(const Rational& t) const { return pieces_[piece_from(t)].value.evaluate(t); }

Rational UniformBspline::integral(const Rational& t) const {
  return pieces_[piece_from(t)].integral.evaluate(t);
}

}  // namespace subdiv
