#include "optimize/continuum_fit.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "analysis/bspline_distance.h"
#include "analysis/inner_products.h"
#include "optimize/fit_functionals.h"
#include "optimize/one_parameter.h"
#include "schemes/algebra/univariate.h"
#include "schemes/bspline.h"
#include "schemes/input_error.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

const Rational near_radius =
    Rational(1, 16);           // part 2 of the proof covers it on both sides of s0, part 3 the rest
constexpr int cell_level = 6;  // part 3: cells of width 2^-6

Scheme<RationalFunction> jspline_family() {
  return stationary<RationalFunction>("jspline", jspline(RationalFunction::variable(0)));
}

/// The largest power of two not above x > 0.
int floor_log2(const Rational& x) {
  int exponent = 0;
  while (Rational::power_of_two(exponent) > x) --exponent;
  while (Rational::power_of_two(exponent + 1) <= x) ++exponent;
  return exponent;
}

class Fit {
 public:
  Fit(int degree, Norm norm, const Range& range, const Options& options)
      : degree_(degree),
        norm_(norm),
        range_(range),
        log_half_width_(floor_log2(options.width) - 1),
        options_(options),
        family_(fit_family(degree, precision())) {}

  Summary run();

 private:
  /// Bits for functionals, whose excess over the minimum is of the order of the square of the enclosure's
  /// width.
  [[nodiscard]] long precision() const {
    return std::max(options_.precision, 96 - 2 * long{log_half_width_});
  }
  /// Spacing 2^-depth of the functionals' points.
  [[nodiscard]] int depth() const { return 8 - log_half_width_; }
  [[nodiscard]] Rational half_width() const { return Rational::power_of_two(log_half_width_); }

  [[nodiscard]] Rational scout() const;
  [[nodiscard]] int slope_sign(const Rational& s, int fineness) const;
  [[nodiscard]] Enclosure distance(const Rational& s) const;
  [[nodiscard]] Rational lower_bound(const Rational& s, const Rational& radius) const;
  [[nodiscard]] Rational provable_step(const FitFunctional& g, const Rational& s, int direction,
                                       const Rational& limit, const Rational& above) const;
  [[nodiscard]] bool excludes_near(const Rational& s, int direction, const Rational& above) const;
  [[nodiscard]] bool excludes_far(const Rational& lower, const Rational& upper, const Rational& above,
                                  int& boxes) const;

  int degree_;
  Norm norm_;
  Range range_;
  int log_half_width_;
  Options options_;
  FitFamily family_;
};

/// The sign of the objective's slope at s, as far as the guessed functional that touches it there tells.
int Fit::slope_sign(const Rational& s, int fineness) const {
  const FitFunctional g = touching_functionals(family_, norm_, s, fineness).front();
  return evaluate<2>(family_, g, Interval(s, family_.precision)).c[1].midpoint().sign();
}

/// A local minimum, by bisection on the sign of the slope where bspline_distance works: 0 < s <= 3.
Rational Fit::scout() const {
  Rational lower = std::max(range_.lower, Rational(1, 16));
  Rational upper = std::min(range_.upper, Rational(3));
  const Rational resolution = half_width() * Rational::power_of_two(-6);
  // Dyadic ends keep the points short.
  const Rational unit = Rational::power_of_two(log_half_width_);
  lower = floor(lower / unit) * unit;
  while (upper - lower > resolution) {
    const Rational middle = (lower + upper) / Rational(2);
    // Points a little finer than the bracket do.
    const int fine = std::min(depth(), 16 - floor_log2(upper - lower));
    (slope_sign(middle, fine) < 0 ? lower : upper) = middle;
  }
  return floor(upper / resolution) * resolution;
}

Enclosure Fit::distance(const Rational& s) const {
  DistanceOptions options;
  // The finest pieces are about as wide as the enclosure; differences of order 2 lose twice that many bits.
  options.precision = family_.precision - 2 * long{log_half_width_};
  options.tolerance = half_width() * half_width() * Rational::power_of_two(-12);
  return norm_ == Norm::l1 ? bspline_distance_l1(s, degree_, options)
                           : bspline_distance_linf(s, degree_, options);
}

/// A lower bound of the objective on [s - radius, s + radius].
Rational Fit::lower_bound(const Rational& s, const Rational& radius) const {
  Rational best(0);
  const Interval box = Interval::hull(s - radius, s + radius, family_.precision);
  const Interval offset = Interval::hull(-radius, radius, family_.precision);
  for (const FitFunctional& g : touching_functionals(family_, norm_, s, depth())) {
    const Taylor<Interval, 3> centre = evaluate<3>(family_, g, Interval(s, family_.precision));
    const Taylor<Interval, 3> whole = evaluate<3>(family_, g, box);
    const Interval value = centre.c[0] + centre.c[1] * offset + whole.c[2] * pow(offset, 2);
    best = std::max(best, value.lower());
  }
  return best;
}

/// How far from s, up to limit, g proves that the objective exceeds `above`; 0 when not even at s.
Rational Fit::provable_step(const FitFunctional& g, const Rational& s, int direction, const Rational& limit,
                            const Rational& above) const {
  const auto interval = [&](const Rational& q) { return Interval(q, family_.precision); };
  const Taylor<Interval, 3> at = evaluate<3>(family_, g, interval(s));
  const Interval excess = at.c[0] - interval(above);
  if (!certainly_positive(excess)) return 0;
  // excess + slope u - |curvature| u^2 is concave in u: positive at both ends of [0, step], it is positive
  // between.
  const auto proves = [&](const Rational& step, const Interval& curvature) {
    const Interval u = interval(step);
    return certainly_positive(excess + Interval(direction) * at.c[1] * u - abs(curvature) * u * u);
  };
  Rational step = limit;
  constexpr int most_halvings = 80;
  for (int i = 0; i < most_halvings; ++i, step /= Rational(2)) {
    if (!proves(step, Interval(2) * at.c[2])) continue;
    const Rational end = s + Rational(direction) * step;
    const Interval box = Interval::hull(std::min(s, end), std::max(s, end), family_.precision);
    if (proves(step, evaluate<3>(family_, g, box).c[2])) return step;
  }
  return 0;
}

/// Part 2: the objective exceeds `above` from half_width() to near_radius away from s, on one side and in the
/// range.
bool Fit::excludes_near(const Rational& s, int direction, const Rational& above) const {
  const Rational to_end = direction < 0 ? s - range_.lower : range_.upper - s;
  const Rational goal = std::min(near_radius, to_end);
  constexpr int most_steps = 200;
  Rational reached = half_width();
  for (int i = 0; i < most_steps && reached < goal; ++i) {
    const Rational from = s + Rational(direction) * reached;
    Rational step(0);
    for (const FitFunctional& g : touching_functionals(family_, norm_, from, depth())) {
      step = std::max(step, provable_step(g, from, direction, goal - reached, above));
      if (step == goal - reached) break;
    }
    if (step.sign() == 0) return false;
    reached += step;
  }
  return reached >= goal;
}

/// Part 3: the objective exceeds `above` on [lower, upper].
bool Fit::excludes_far(const Rational& lower, const Rational& upper, const Rational& above,
                       int& boxes) const {
  if (lower >= upper) return true;
  Problem minorant;
  minorant.norm = norm_;
  minorant.box = {{lower, upper}};
  const Rational width = Rational::power_of_two(-cell_level);
  const Rational last(3);
  if (norm_ == Norm::l1) {
    const auto integral = basis_integral(jspline(RationalFunction::variable(0)), cell_level);
    int i = 0;
    for (Rational t(0); t < last; t += width, ++i) {
      const Rational of_bspline = family_.bspline.integral(t + width) - family_.bspline.integral(t);
      // Twice, for the cell at -t.
      minorant.residuals.push_back(RationalFunction(2) *
                                   (integral.at(i + 1) - integral.at(i) - RationalFunction(of_bspline)));
    }
  } else {
    const auto values = basis_values(jspline_family(), cell_level);
    int i = 0;
    for (Rational t(0); t < last; t += width, ++i) {
      minorant.residuals.push_back(values[i] - RationalFunction(family_.bspline.value(t)));
    }
  }
  Options options = options_;
  options.width = Rational(1, 1024);
  const Summary summary = minimise_one_parameter(minorant, options);
  boxes += summary.boxes;
  return summary.termination != Termination::pole_in_box && summary.minimum.lower > above;
}

Summary Fit::run() {
  Summary summary;
  summary.method = "touching functionals with Taylor remainders; branch and bound on cells";
  const Rational s = scout();
  const Rational half = half_width();
  summary.termination = Termination::not_isolated;
  summary.message = "the distance has no minimum that can be proved inside the range and below s = 3";
  if (s - half <= range_.lower || s + half >= range_.upper || s + half >= Rational(3)) return summary;
  const Enclosure at_s = distance(s);
  summary.minimiser = {certified(s - half, s + half, summary.method)};
  summary.minimum = certified(std::min(lower_bound(s, half), at_s.upper), at_s.upper, summary.method);
  const Rational above = at_s.upper;
  const bool proved = excludes_near(s, -1, above) && excludes_near(s, 1, above) &&
                      excludes_far(range_.lower, s - near_radius, above, summary.boxes) &&
                      excludes_far(s + near_radius, range_.upper, above, summary.boxes);
  if (!proved) {
    summary.minimiser[0].status = Status::ambiguous;
    summary.minimiser[0].rigour = Rigour::approximate;
    summary.minimum.rigour = Rigour::approximate;
    summary.message = "a local minimum was found; that nothing better lies in the range is not proved";
    return summary;
  }
  summary.termination = Termination::proved;
  summary.message = "every minimiser of the range lies in the enclosure";
  return summary;
}

}  // namespace

Scheme<RationalFunction> bspline_at(int degree, const Rational& centre) {
  const Mask<RationalFunction> mask = bspline<RationalFunction>(degree);
  const Rational own_centre = degree % 2 == 0 ? Rational(1, 2) : Rational(0);
  const Rational twice = Rational(2) * (centre - own_centre);
  if (!twice.is_integer())
    throw std::domain_error("a B-spline scheme's centre is an integer or half an integer");
  // B(t - x) = sum of a_i B(2 (t - x) - i): one step, moved by 2x, of B's own scheme.
  Mask<RationalFunction> first = mask;
  first.symbol = shift(mask.symbol, static_cast<int>(twice.to_integer()));
  return {"bspline", {first, mask}};
}

RationalFunction squared_distance(const Scheme<RationalFunction>& scheme, int degree,
                                  const Rational& centre) {
  const Scheme<RationalFunction> target = bspline_at(degree, centre);
  return inner_products(scheme, scheme)[0] - RationalFunction(2) * inner_products(scheme, target)[0] +
         inner_products(target, target)[0];
}

std::optional<Summary> only_zero(const RationalFunction& distance, const Range& range) {
  const UnivariatePolynomial numerator(distance.numerator(), 0);
  if (numerator.is_zero() || count_roots(numerator, range.lower, range.upper) != 1) return std::nullopt;
  for (const RealRoot& root : real_roots(numerator)) {
    if (root.value < Algebraic(range.lower) || root.value > Algebraic(range.upper)) continue;
    Summary summary;
    summary.termination = Termination::proved;
    summary.method = "zero of the squared distance";
    summary.minimiser = {exact(root.value, summary.method)};
    summary.minimum = exact(Rational(0), summary.method);
    summary.message = "the basis function is the target there, and nowhere else in the range";
    return summary;
  }
  return std::nullopt;
}

Range jspline_fit_range() { return {Rational(-17, 10), Rational(29, 5)}; }

Summary minimise_continuum_fit(int degree, Norm norm, const Range& range, const Options& options) {
  const Range allowed = jspline_fit_range();
  if (degree < 1 || degree > 5) {
    throw InputError(fmt::format(
        "degree={}: the continuum fit knows degrees 1 to 5, whose support lies in that of *J_s", degree));
  }
  if (range.lower < allowed.lower || range.upper > allowed.upper || range.lower >= range.upper) {
    throw InputError(fmt::format("{}..{}: the continuum fit needs a range within {}..{}, where *J_s is C^1",
                                 range.lower.to_string(), range.upper.to_string(), allowed.lower.to_string(),
                                 allowed.upper.to_string()));
  }
  if (norm == Norm::l2) throw InputError("the continuum fit in l2 is a rational function: minimise that");
  const RationalFunction squared = squared_distance(jspline_family(), degree, 0);
  if (auto summary = only_zero(squared, range)) return *summary;
  return Fit(degree, norm, range, options).run();
}

}  // namespace subdiv
