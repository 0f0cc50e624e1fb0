#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "analysis/adjustable_speed/characteristic_ring_joins.h"
#include "analysis/adjustable_speed/characteristic_ring_map.h"
#include "analysis/adjustable_speed/ring_theorem.h"
#include "experiments/printed_border.h"
#include "experiments/speed_arrays.h"
#include "experiments/speed_characteristic_ring.h"
#include "schemes/algebra/rational_function.h"
#include "schemes/algebra/turn.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

const std::string shapes =
    "Over Q(sigma, v), where lambda = q W, q = 1 - sigma, W = q + sigma v and 1 + c = v^2/W, which holds all "
    "speeds and valences: ";
/// h_0 .. h_4 of a border, from t_30, t_20, t_10, t_31, t_11.
template <class R>
std::array<R, 5> border_scalars(const BezierPatch<RingPoint<R>>& border, const R& one_plus_cosine) {
  const R unit = R(1) / border[0][0];
  const auto at = [&](std::size_t i, std::size_t j, std::size_t k) { return border[4 * i + j][k] * unit; };
  const R across = at(2, 0, 0) - at(2, 0, 1);
  const R half = fraction<R>(1, 2);
  return {R(2) * at(3, 0, 0), across, R(2) * (at(1, 0, 0) - across * (R(2) - one_plus_cosine)),
          R(2) * at(3, 1, 0), half * at(1, 1, 0)};
}

struct GeneralRing {
  RingShape<Function> shape{Function::variable(0), Function::variable(1)};
  CharacteristicRing<Function> ring = characteristic_ring(shape);
  std::array<Function, 5> quotients =
      array_quotients(shape.sigma, shape.one_plus_cosine() - Function(1), shape.eigenvalue());
};

// ---- (9) -------------------------------------------------------------------------------------------------

/// Identities that say that the points (9) and their mirror images in the spoke have equal derivatives up to
/// the second; those that fail.
std::size_t broken_joins(const std::array<RingPoint<Function>, border_places.size()>& points,
                         const Function& one_plus_cosine) {
  const auto at = [&](std::size_t i, std::size_t j) {  // along the first spoke: t_(j, i)
    for (std::size_t k = 0; k < border_places.size(); ++k) {
      if (border_places.at(k).i == j && border_places.at(k).j == i)
        return RingPoint<Function>{points.at(k)[0], -points.at(k)[1]};
      if (border_places.at(k).i == i && border_places.at(k).j == j) return points.at(k);
    }
    throw std::logic_error("not a coefficient of the border");
  };
  const auto is_own_image = [&](const RingPoint<Function>& p) {
    const RingPoint<Function> image = reflected(p, one_plus_cosine);
    return (image[0] - p[0]).is_zero() && (image[1] - p[1]).is_zero();
  };
  const auto difference = [](const RingPoint<Function>& a, const RingPoint<Function>& b) {
    return RingPoint<Function>{a[0] - b[0], a[1] - b[1]};
  };
  std::size_t broken = 0;
  for (const std::size_t i : {0U, 1U, 2U}) {
    const RingPoint<Function> first = difference(at(i, 3), at(i, 2));  // odd across the spoke
    const RingPoint<Function> turned = reflected(first, one_plus_cosine);
    const bool odd = (first[0] + turned[0]).is_zero() && (first[1] + turned[1]).is_zero();
    const RingPoint<Function> second = difference(first, difference(at(i, 2), at(i, 1)));
    broken += (is_own_image(at(i, 3)) ? 0U : 1U) + (odd ? 0U : 1U) + (is_own_image(second) ? 0U : 1U);
  }
  return broken;
}

void add_border_formulas(Results& results, std::span<const ClaimHead> heads, const GeneralRing& general) {
  const Function d = general.shape.one_plus_cosine();
  const auto formulas = border_formulas(general.quotients, d, Function(1));
  const auto& border = general.ring.border;
  for (std::size_t k = 0; k < border_places.size(); ++k) {
    const BorderPlace& place = border_places.at(k);
    const RingPoint<Function>& own = border[4 * place.i + place.j];
    const bool holds = (formulas.at(k)[0] * border[0][0] - own[0]).is_zero() &&
                       (formulas.at(k)[1] * border[0][0] - own[1]).is_zero();
    const ClaimHead& own_head = head(heads, fmt::format("speed.eq9.t{}{}", place.i, place.j));
    if (place.i != 2 || place.j != 2) {
      results.claims.push_back(settle_statement(own_head, holds, holds ? "true" : "false"));
      continue;
    }
    // As printed it is the same only where z3 (cos - sin) vanishes: z3 > 0 in the ring, as t31 shows.
    DomainSigns signs(ring_shapes());
    const std::array<Function, 2> in_box{Function(1) - Function::variable(0) * Function::variable(1),
                                         Function(2) - Function::variable(0)};
    const bool z3_positive = signs.sign((border[12 + 1][0] / border[0][0]).evaluate<Function>(in_box)).kind ==
                             DomainSign::Kind::positive;
    if (!holds || !z3_positive) throw std::logic_error("the corrected t22 is the ring's");
    results.claims.push_back(settle_statement(
        own_head, false, "(z3 c̄ - z4 c/(2 s̄), 0)",
        "z3 has the factor c̄ = cos(pi/n), not s̄; then the formula holds, and with it the "
        "printed t32 is C2. As z3 > 0 at all speeds, the printed t22 is right for n = 4 alone."));
  }

  std::array<Function, 5> h;
  for (std::size_t k = 0; k < h.size(); ++k) h[k] = Function::variable(static_cast<int>(k));
  const Function cosine = Function::variable(5);
  const std::size_t printed = broken_joins(border_formulas(h, cosine, Function::variable(6)), cosine);
  const std::size_t corrected = broken_joins(border_formulas(h, cosine, Function(1)), cosine);
  results.claims.push_back(settle_statement(
      head(heads, "speed.eq9.c2"), printed == 0, fmt::format("{} of 9 identities fail", printed),
      fmt::format("As printed, {} of the nine identities of C2 joins fail. With z3 c̄ in place of z3 s̄ in t22 "
                  "(see speed.eq9.t22) {} of them fail, whatever z0 .. z4 and n are.",
                  printed, corrected)));
  if (corrected != 0) throw std::logic_error("the corrected border joins C2");
}

// ---- (12) ------------------------------------------------------------------------------------------------

void add_quotients(Results& results, std::span<const ClaimHead> heads, const GeneralRing& general) {
  const RingShape<Function>& shape = general.shape;
  const std::array<Function, 5> own = border_scalars(general.ring.border, shape.one_plus_cosine());
  const std::array<Function, 5> printed =
      array_quotients(Function(1), shape.one_plus_cosine() - Function(1), shape.eigenvalue());
  const bool as_printed = printed == own;
  // What the printed sums are: functions of c alone.
  const Function d = shape.one_plus_cosine();
  const Function third(Rational(1, 3));
  const std::array<Function, 5> of_cosine{third * (d + Function(2)), third,
                                          third * (Function(2) * d + Function(1)), third * (d + Function(1)),
                                          third};
  if (!(printed == of_cosine)) throw std::logic_error("the sums without sigma are functions of c");
  const std::array<Function, 2> at_one{Function(1), Function::variable(1)};
  for (std::size_t k = 0; k < own.size(); ++k) {
    if (!(own.at(k).evaluate<Function>(at_one) == of_cosine.at(k).evaluate<Function>(at_one)))
      throw std::logic_error("the sums without sigma are the limits for sigma -> 1");
  }
  results.claims.push_back(settle_statement(
      head(heads, "speed.eq12"), as_printed, "h = ((3+c)/3, 1/3, (3+2c)/3, (2+c)/3, 1/3) at every speed",
      "The factor σ^(i-1) is missing from all four sums. Without it the quotients do not depend on the "
      "speed: they are the values for σ -> 1. With it they are the ring's (speed.eq12.corrected)."));
  results.claims.push_back(settle_statement(
      head(heads, "speed.eq12.corrected"), general.quotients == own,
      "hr = (Σ σ^(i-1) NUM[r][i][1][j] c^(j-1) + λ Σ σ^(i-1) NUM[r][i][2][j] c^(j-1)) / (the same with DEN)",
      "Five identities of rational functions of sigma and v."));
}

constexpr std::array<int, 5> digit_valences{3, 5, 6, 9, 20};
constexpr std::array<const char*, 5> digit_speeds{"1/10", "1/2", "3/4", "9/10", "999/1000"};

void add_digits(Results& results, std::span<const ClaimHead> heads) {
  constexpr long precision = 1024;
  Interval largest(0);
  for (const int n : digit_valences) {
    for (const char* speed : digit_speeds) {
      const Interval sigma(Rational::parse(speed), precision);
      const Interval q = Interval(1) - sigma;
      const Interval c = cos(Interval(2) * pi(precision) / Interval(n));
      const Interval d = Interval(1) + c;
      const Interval inner = d * sigma * sigma;
      const Interval lambda =
          q / Interval(2) * (inner + Interval(2) * q + sigma * sqrt(d * (inner + Interval(4) * q)));  // (8)
      const std::array<Interval, 5> by_arrays = array_quotients(sigma, c, lambda);
      const std::array<Interval, 5> by_vector =
          border_scalars(characteristic_ring(ring_shape(sigma, n)).border, d);
      for (std::size_t k = 0; k < by_arrays.size(); ++k)
        largest = max(largest, abs(by_arrays[k] - by_vector[k]));
    }
  }
  const Interval bound(Rational(1) / pow(Rational(10), 30));
  if (!certainly_less(largest, bound)) throw std::logic_error("(12) and the eigenvector differ");
  results.claims.push_back(settle_statement(
      head(heads, "speed.eq12.digits"), true, "at most 1e-30",
      fmt::format("25 pairs of n and sigma; proved to be at most {}.", to_significant(largest.upper(), 2, 1)),
      Rigour::certified));
}

constexpr std::array<const char*, 8> loss_speeds{"1/1000", "1/10",     "1/2",        "9/10",
                                                 "99/100", "999/1000", "9999/10000", "99999/100000"};

/// The largest relative errors of the two routes in double precision, enclosed.
struct Losses {
  Interval by_arrays{0};
  Interval by_vector{0};
};

Losses losses_at(const Rational& speed) {
  constexpr long precision = 512;
  Losses worst;
  for (int n = 3; n <= 20; ++n) {
    if (n == 4) continue;
    const Interval sigma(speed, precision);
    const std::array<Interval, 5> truth = border_scalars(characteristic_ring(ring_shape(sigma, n)).border,
                                                         ring_shape(sigma, n).one_plus_cosine());
    const double s = speed.to_double();
    const RingShape<double> shape = ring_shape(s, n);
    const double c = cosine_of_turn<double>(1, n);
    const std::array<double, 5> arrays = array_quotients(s, c, shape.eigenvalue());
    const std::array<double, 5> vector = border_scalars(characteristic_ring(shape).border, 1 + c);
    for (std::size_t k = 0; k < truth.size(); ++k) {
      const auto error = [&](double value) { return abs((Interval(value) - truth[k]) / truth[k]); };
      worst.by_arrays = max(worst.by_arrays, error(arrays[k]));
      worst.by_vector = max(worst.by_vector, error(vector[k]));
    }
  }
  return worst;
}

/// Numerators and denominator of the corrected (12) vanish for sigma = 0 and for sigma = 1.
bool vanish_at_ends(const RingShape<Function>& shape) {
  const Polynomial ends = Polynomial::variable(0) * (Polynomial(1) - Polynomial::variable(0));
  const auto vanishes = [&](const PrintedArray& rows) {
    const Function sum =
        array_sum(rows, shape.sigma, shape.one_plus_cosine() - Function(1), shape.eigenvalue());
    Polynomial quotient;
    return divides(ends, sum.numerator(), quotient);
  };
  return vanishes(printed_denominator()) && std::ranges::all_of(printed_numerators(), vanishes);
}

void add_loss(Results& results, std::span<const ClaimHead> heads, const RingShape<Function>& shape) {
  Series series{"speed-ring-digits", {"speed", "by (12)", "by the eigenvector"}, {}};
  const auto shown = [](const Interval& x) { return to_significant(x.midpoint(), 2); };
  std::vector<Losses> losses;
  for (const char* text : loss_speeds) {
    const Rational speed = Rational::parse(text);
    losses.push_back(losses_at(speed));
    series.rows.push_back(
        {to_significant(speed, 5), shown(losses.back().by_arrays), shown(losses.back().by_vector)});
  }
  const Interval accurate(Rational(1) / pow(Rational(10), 14));
  const Interval lost(Rational(1) / pow(Rational(10), 6));
  const bool keeps =
      std::ranges::all_of(losses, [&](const Losses& at) { return certainly_less(at.by_vector, accurate); });
  if (!keeps || !certainly_less(lost, losses.back().by_arrays) || !vanish_at_ends(shape))
    throw std::logic_error("the digits that (12) loses, and the eigenvector keeps");
  results.claims.push_back(settle_statement(
      head(heads, "speed.eq12.loss"), true,
      "above 1e-6 by (12) at sigma = 0.99999, below 1e-14 by the eigenvector",
      "Numerators and denominator of (12) have the common factor σ(1-σ), but coefficients up to 241515.",
      Rigour::certified));
  results.series.push_back(std::move(series));
}

}  // namespace

std::vector<ClaimHead> ring_formula_heads() {
  std::vector<ClaimHead> heads;
  const auto add = [&](const char* id, const char* section, const char* printed, const std::string& text) {
    heads.push_back({id, "speed", section, printed, ClaimKind::exact, text});
  };
  for (const BorderPlace& place : border_places) {
    heads.push_back({fmt::format("speed.eq9.t{}{}", place.i, place.j), "speed", "III, (9)", place.printed,
                     ClaimKind::exact,
                     shapes +
                         "the Bezier coefficient of the eigenvector's tensor border over t00, with z0 .. "
                         "z4 by (12) and its missing factor."});
  }
  add("speed.eq9.c2", "III", "tensor-borders from adjacent sectors are C2 connected if (9)",
      "Derivatives up to the second across the spoke, of coefficients (9) with free z0 .. z4 and c, against "
      "those of the mirror image.");
  add("speed.eq12", "V-B, (12)",
      "hr := (Σ NUM[r][i][1][j] c^(j-1) + λ Σ NUM[r][i][2][j] c^(j-1)) / (Σ DEN[i][1][j] c^(j-1) + λ Σ "
      "DEN[i][2][j] c^(j-1))",
      shapes +
          "h0 .. h4 of the eigenvector's tensor border, t00 = (1, 0), against the formula with the arrays "
          "as printed.");
  heads.push_back(finding("speed.eq12.corrected", "speed V-B, (12)",
                          shapes +
                              "the same with the factor sigma^(i-1) in all four sums. All 612 entries of "
                              "the arrays enter."));
  heads.push_back(
      finding("speed.eq12.digits", "speed V-B, (12)",
              "The corrected (12) with lambda by (8) and the eigenvector's tensor border, enclosed "
              "in 1024 bits for n = 3, 5, 6, 9, 20 and sigma = 1/10, 1/2, 3/4, 9/10, 999/1000: "
              "the largest difference of h0 .. h4."));
  heads.push_back(
      finding("speed.eq12.loss", "speed V-B, (12)",
              "In double precision, Horner's rule: the largest relative error of h0 .. h4 over n = "
              "3, 5, 6, .., 20 by the corrected (12) and by the eigenvector in closed form, at each of "
              "sigma = " +
                  fmt::format("{}", fmt::join(loss_speeds, ", ")) +
                  " (rounded to double; the true values are enclosed in 512 bits at the fraction itself). "
                  "Series speed-ring-digits."));
  return heads;
}

void add_ring_formulas(Results& results, std::span<const ClaimHead> heads) {
  const GeneralRing general;
  add_border_formulas(results, heads, general);
  add_quotients(results, heads, general);
  add_digits(results, heads);
  add_loss(results, heads, general.shape);
}

}  // namespace subdiv
