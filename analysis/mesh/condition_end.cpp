#include "analysis/mesh/condition_end.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

#include "analysis/mesh/plane_number.h"

namespace subdiv {
namespace {

constexpr long precision = ModeTable::precision;

using Complex = PlaneNumber<Interval>;

Complex quotient(const Complex& a, const Complex& b) {
  const Complex above = a * conjugate(b);
  const Interval below = b.x * b.x + b.y * b.y;
  return {above.x / below, above.y / below};
}

Complex centre(const Complex& z) { return {z.x.center(), z.y.center()}; }

Interval square(const Complex& z) { return z.x * z.x + z.y * z.y; }

/// P, P_x and P_s at a complex x and a real s.
struct Jet {
  Complex value;
  Complex by_x;
  Complex by_s;
};

Jet evaluate(const ParameterPolynomial& p, const Complex& x, const Interval& s) {
  Jet result;
  for (std::size_t i = p.size(); i-- > 0;) {
    Interval value(0);
    Interval slope(0);
    for (std::size_t j = p[i].size(); j-- > 0;) {
      slope = slope * s + value;
      value = value * s + p[i][j];
    }
    result.by_x = result.by_x * x + result.value;
    result.value = result.value * x + Complex{value, Interval(0)};
    result.by_s = result.by_s * x + Complex{slope, Interval(0)};
  }
  return result;
}

Complex newton(const ParameterPolynomial& p, Complex x, const Interval& s) {
  constexpr int steps = 7;  // from the digits of a double, which double each time
  for (int i = 0; i < steps; ++i) {
    const Jet at = evaluate(p, x, s);
    x = centre(x - quotient(at.value, at.by_x));
  }
  return x;
}

/// Contains zero, and its radius is at least the factor times |x|.
Interval widened(const Interval& x, const Interval& factor) {
  const Interval reach = abs(x) * factor + Interval(Rational::power_of_two(8 - precision), precision);
  return Interval::hull(-reach, reach);
}

/// An eigenvalue as a function of s, near x at the middle of the cell.
class Branch {
 public:
  Branch(ParameterPolynomial p, Complex near) : p_(std::move(p)), near_(std::move(near)) {}

  /// A box with exactly one root for every s of the cell; a real start gives a real root.
  [[nodiscard]] std::optional<Complex> over(const Interval& cell) const {
    const Interval middle = cell.center();
    const Complex x = newton(p_, near_, middle);
    const Jet at = evaluate(p_, x, middle);
    const Jet along = evaluate(p_, x, cell);
    const Complex c = centre(quotient({Interval(1), Interval(0)}, at.by_x));
    // P(x, s) by the mean value theorem in s, times -c.
    const Complex shift = Complex{Interval(0), Interval(0)} - c * (at.value + (cell - middle) * along.by_s);
    if (!shift.x.is_finite() || !shift.y.is_finite()) return std::nullopt;
    const bool real = x.y.is_exactly_zero();
    constexpr int growths = 6;
    for (int factor = 2, i = 0; i < growths; ++i, factor *= 2) {
      const Interval reach = abs(shift.x) + abs(shift.y);
      const Complex offset{widened(reach, Interval(factor)),
                           real ? Interval(0) : widened(reach, Interval(factor))};
      const Complex box = x + offset;
      const Complex rest = Complex{Interval(1), Interval(0)} - c * evaluate(p_, box, cell).by_x;
      Complex image = x + shift + rest * offset;
      if (box.x.contains_strictly(image.x) && (real || box.y.contains_strictly(image.y))) return image;
    }
    return std::nullopt;
  }

  /// dz/ds for all s of the cell, z there known to lie in the box.
  [[nodiscard]] Complex slope(const Interval& cell, const Complex& box) const {
    const Jet at = evaluate(p_, box, cell);
    return Complex{Interval(0), Interval(0)} - quotient(at.by_s, at.by_x);
  }

 private:
  ParameterPolynomial p_;
  Complex near_;
};

/// Lambda and its rival at the middle of a cell, and the radius that separates them from all others.
struct Leaders {
  std::optional<Branch> lambda;
  std::optional<Branch> rival;
  Rival found;
  double radius = 0;
};

Leaders leaders(const SpectralCondition& condition, const Rational& s) {
  struct Root {
    int mode;
    std::complex<double> value;
    ParameterPolynomial p;
  };
  std::vector<Root> roots;
  const Interval at(s, precision);
  for (int mode = 0; mode <= condition.valence() / 2; ++mode) {
    for (const ParameterPolynomial& p : condition.factors(mode)) {
      IntervalPolynomial here;
      for (const IntervalPolynomial& c : p) here.push_back(value_at(c, at));
      for (const std::complex<double>& z : approximate_roots(here)) {
        if (z.imag() >= 0) roots.push_back({mode, z, p});
      }
    }
  }
  const auto branch = [](const Root& root) {
    return Branch(root.p, {Interval(root.value.real()), Interval(root.value.imag())});
  };
  std::sort(roots.begin(), roots.end(),
            [](const Root& a, const Root& b) { return std::abs(a.value) > std::abs(b.value); });
  Leaders result;
  const auto first = std::find_if(roots.begin(), roots.end(), [](const Root& root) {
    return root.mode == 1 && root.value.imag() == 0 && root.value.real() > 0;
  });
  if (first == roots.end() || roots.size() < 3) return result;
  result.lambda = branch(*first);
  result.found.subdominant = first->value.real();
  roots.erase(first);
  result.rival = branch(roots[0]);
  result.found.mode = roots[0].mode;
  result.found.value = roots[0].value;
  const double least = std::min(result.found.subdominant, std::abs(roots[0].value));
  result.radius = std::sqrt(least * std::abs(roots[1].value));
  return result;
}

/// |rival|^2 - lambda^2 on a cell, and its derivative; nothing when a root is not isolated.
struct Gap {
  Complex lambda;
  Complex rival;
  Interval value;
  Interval slope;
};

std::optional<Gap> gap_over(const Leaders& two, const Interval& cell) {
  const auto lambda = two.lambda->over(cell);
  const auto rival = two.rival->over(cell);
  if (!lambda || !rival) return std::nullopt;
  const Complex rival_slope = two.rival->slope(cell, *rival);
  const Complex product = conjugate(*rival) * rival_slope;
  const Interval slope = Interval(2) * (product.x - lambda->x * two.lambda->slope(cell, *lambda).x);
  return Gap{*lambda, *rival, square(*rival) - square(*lambda), slope};
}

/// The roots enclosed for a part of the cell are those of the whole: its boxes hold one root each.
bool is_branch_of(const Gap& part, const Gap& whole) {
  return whole.lambda.x.contains(part.lambda.x) && whole.rival.x.contains(part.rival.x) &&
         whole.rival.y.contains(part.rival.y);
}

/// The circle holds all but lambda and the rival, or the pair, throughout the cell.
bool are_alone(const SpectralCondition& condition, const Rational& lower, const Rational& upper,
               const Leaders& two, const Gap& over) {
  const bool real = over.rival.y.is_exactly_zero();
  if (!real && over.rival.y.contains_zero()) return false;
  const auto beyond = condition.beyond(lower, upper, Interval(two.radius));
  if (!beyond) return false;
  for (int mode = 0; mode < static_cast<int>(beyond->size()); ++mode) {
    const int expected = (mode == 1 ? 1 : 0) + (mode == two.found.mode ? (real ? 1 : 2) : 0);
    if ((*beyond)[static_cast<std::size_t>(mode)] != expected) return false;
  }
  const Interval outside = Interval(two.radius) * Interval(two.radius);
  const bool apart = two.found.mode != 1 || !real || certainly_less(over.rival.x, over.lambda.x);
  return apart && certainly_less(outside, square(over.rival)) &&
         certainly_less(outside, square(over.lambda)) && certainly_positive(over.lambda.x) &&
         certainly_less(over.lambda.x, Interval(1));
}

}  // namespace

std::optional<ConditionEnd> condition_end(const SpectralCondition& condition, const Rational& lower,
                                          const Rational& upper) {
  const Leaders two = leaders(condition, (lower + upper) / Rational(2));
  if (!two.lambda) return std::nullopt;
  Interval cell = Interval::hull(lower, upper, precision);
  const auto over = gap_over(two, cell);
  if (!over || over->slope.contains_zero() || !are_alone(condition, lower, upper, two, *over)) {
    return std::nullopt;
  }
  // Roots at single s belong to the same branch: they lie in its box over the cell, which has one root each.
  const auto gap_at = [&](const Rational& s) -> std::optional<Interval> {
    const auto at = gap_over(two, Interval(s, precision));
    return at && is_branch_of(*at, *over) ? std::optional<Interval>(at->value) : std::nullopt;
  };
  const auto below = gap_at(lower);
  const auto above = gap_at(upper);
  if (!below || !above || below->contains_zero() || above->contains_zero()) return std::nullopt;
  if (certainly_negative(*below) == certainly_negative(*above)) return std::nullopt;
  Interval slope = over->slope;
  constexpr int steps = 12;
  for (int i = 0; i < steps; ++i) {
    const Interval middle = cell.center();
    const auto value = gap_at(middle.midpoint());
    if (!value) break;
    const Interval next = middle - *value / slope;
    if (!next.is_finite() || !cell.contains_strictly(next)) break;
    cell = next;
    const auto finer = gap_over(two, cell);
    if (finer && is_branch_of(*finer, *over) && !finer->slope.contains_zero()) slope = finer->slope;
  }
  return ConditionEnd{cell, certainly_negative(*below), two.found};
}

}  // namespace subdiv
