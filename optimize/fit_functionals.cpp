#include "optimize/fit_functionals.h"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <utility>

#include "schemes/jspline.h"

namespace subdiv {
namespace {

constexpr int radius = 3;      // of the support of phi_s, which holds that of B_d
constexpr int grid_level = 6;  // pieces of width 2^-6 on which a sign change is looked for

template <class R>
LocalBasis<R> basis_at(const FitFamily& family, const R& s) {
  const auto at = [&](const RationalFunction& f) { return f.evaluate(std::span<const R>(&s, 1)); };
  return {map_coefficients(family.tables, at), -radius, radius};
}

/// Follows the binary digits of t from the unit piece that holds it down to the piece that begins at t;
/// visit(piece) is called for every piece that is passed on the way.
template <class R, class Visit>
BasisPiece<R> descend(const LocalBasis<R>& basis, const Rational& t, Visit visit) {
  const Rational whole = floor(t);
  BasisPiece<R> piece = basis.unit(static_cast<int>(whole.to_integer()));
  while (piece.left != t) {
    auto [left, right] = basis.halves(piece);
    if (right.left <= t) {
      visit(left);
      piece = std::move(right);
    } else {
      piece = std::move(left);
    }
  }
  return piece;
}

template <class R>
R value_at(const LocalBasis<R>& basis, const Rational& t) {
  return basis.left_value(descend(basis, t, [](const BasisPiece<R>&) {}));
}

/// The integral of phi over [0, t].
template <class R>
R integral_to(const LocalBasis<R>& basis, const Rational& t) {
  R sum(0);
  for (int i = 0; i < radius && Rational(i + 1) <= t; ++i) sum += basis.integral(basis.unit(i));
  if (t >= Rational(radius)) return sum;
  descend(basis, t, [&](const BasisPiece<R>& passed) {
    sum += basis.integral(passed) * from_rational<R>(passed.width());
  });
  return sum;
}

/// e at a fixed s, in multiprecision without regard to rounding: for guesses.
class Scout {
 public:
  Scout(const FitFamily& family, const Rational& s)
      : family_(family), basis_(basis_at(family, Interval(s, family.precision))) {}

  [[nodiscard]] std::vector<BasisPiece<Interval>> grid(int level) const {
    std::vector<BasisPiece<Interval>> pieces;
    for (int i = 0; i < radius; ++i) pieces.push_back(basis_.unit(i));
    for (int k = 0; k < level; ++k) {
      std::vector<BasisPiece<Interval>> finer;
      for (const auto& piece : pieces) {
        auto [left, right] = basis_.halves(piece);
        finer.push_back(std::move(left));
        finer.push_back(std::move(right));
      }
      pieces = std::move(finer);
    }
    return pieces;
  }
  [[nodiscard]] Rational value(const Rational& t) const {
    return value_at(basis_, t).midpoint() - family_.bspline.value(t);
  }
  [[nodiscard]] Interval left_value(const BasisPiece<Interval>& p) const {
    return (basis_.left_value(p) - Interval(family_.bspline.value(p.left), family_.precision)).center();
  }
  [[nodiscard]] Interval right_value(const BasisPiece<Interval>& p) const {
    return (basis_.right_value(p) - Interval(family_.bspline.value(p.right()), family_.precision)).center();
  }
  [[nodiscard]] Interval left_slope(const BasisPiece<Interval>& p) const {
    return slope(p, basis_.left_slope(p), p.left);
  }
  [[nodiscard]] Interval right_slope(const BasisPiece<Interval>& p) const {
    return slope(p, basis_.right_slope(p), p.right());
  }
  /// The point of p, to 2^-depth, where a function that is negative at one end and positive at the other
  /// changes sign.
  template <class F>
  [[nodiscard]] Rational sign_change(BasisPiece<Interval> p, int depth, F at_left) const {
    const bool negative = certainly_negative(at_left(p));
    while (p.level < depth) {
      auto [left, right] = basis_.halves(p);
      p = certainly_negative(at_left(right)) == negative ? std::move(right) : std::move(left);
    }
    return p.left;
  }

 private:
  [[nodiscard]] Interval slope(const BasisPiece<Interval>& p, const Interval& of_basis,
                               const Rational& t) const {
    const Rational of_bspline = family_.bspline.piece(p.left, p.right()).derivative().evaluate(t);
    const Interval scale(Rational::power_of_two(p.level), family_.precision);
    return (of_basis * scale - Interval(of_bspline, family_.precision)).center();
  }

  const FitFamily& family_;
  LocalBasis<Interval> basis_;
};

bool opposite(const Interval& a, const Interval& b) {
  return (certainly_positive(a) && certainly_negative(b)) || (certainly_negative(a) && certainly_positive(b));
}

FitFunctional signs_of_difference(const FitFamily& family, const Rational& s, int depth) {
  const Scout scout(family, s);
  const bool repeats = family.bspline.half_width() <= Rational(2);
  const Rational end = repeats ? Rational(5, 2) : Rational(radius);
  FitFunctional g{Norm::l1, {Rational(0)}, {scout.value(Rational(0)).sign() < 0 ? -1 : 1}, 0};
  const auto left_value = [&](const auto& p) { return scout.left_value(p); };
  for (const auto& piece : scout.grid(grid_level)) {
    if (piece.left >= end) break;
    if (piece.left == Rational(2)) {  // a point without a change: what follows repeats
      g.points.push_back(piece.left);
      g.signs.push_back(g.signs.back());
    }
    if (!opposite(scout.left_value(piece), scout.right_value(piece))) continue;
    g.points.push_back(scout.sign_change(piece, depth, left_value));
    g.signs.push_back(-g.signs.back());
  }
  g.points.push_back(end);
  if (repeats) g.repeats = s < Rational(1) ? -1 : 1;  // the sign of c_3
  return g;
}

std::vector<FitFunctional> extrema_of_difference(const FitFamily& family, const Rational& s, int depth) {
  using Piece = BasisPiece<Interval>;
  const Scout scout(family, s);
  const auto by_size = [](const auto& a, const auto& b) { return a.first > b.first; };
  std::vector<std::pair<Rational, Piece>> turning;  // |e| at the left end, where the slope changes sign
  for (Piece& piece : scout.grid(grid_level)) {
    if (!opposite(scout.left_slope(piece), scout.right_slope(piece))) continue;
    turning.emplace_back(abs(scout.left_value(piece).midpoint()), std::move(piece));
  }
  std::stable_sort(turning.begin(), turning.end(), by_size);
  constexpr std::size_t most = 3;
  turning.resize(std::min(turning.size(), most));
  // e is even, so t = 0 is an extremum too; against the hat there is a kink at 1.
  std::vector<Rational> places{Rational(0)};
  if (family.bspline.degree() == 1) places.emplace_back(1);
  const auto left_slope = [&](const auto& p) { return scout.left_slope(p); };
  for (auto& [size, piece] : turning)
    places.push_back(scout.sign_change(std::move(piece), depth, left_slope));
  std::vector<std::pair<Rational, FitFunctional>> found;
  for (const Rational& t : places) {
    const Rational value = scout.value(t);
    found.emplace_back(abs(value), FitFunctional{Norm::linf, {t}, {value.sign() < 0 ? -1 : 1}, 0});
  }
  std::stable_sort(found.begin(), found.end(), by_size);
  std::vector<FitFunctional> result;
  for (auto& [size, g] : found) result.push_back(std::move(g));
  return result;
}

}  // namespace

FitFamily fit_family(int degree, long precision) {
  if (degree < 1 || degree > 5)
    throw std::domain_error("the target's support must lie in that of *J_s: degrees 1 to 5");
  return {basis_tables(jspline(RationalFunction::variable(0))), UniformBspline(degree), precision};
}

template <std::size_t N>
Taylor<Interval, N> evaluate(const FitFamily& family, const FitFunctional& g, const Interval& s) {
  using Jet = Taylor<Interval, N>;
  const auto constant = [&](const Rational& q) { return Jet::constant(Interval(q, family.precision)); };
  const LocalBasis<Jet> basis = basis_at(family, Jet::variable(s));
  if (g.norm == Norm::linf) {
    return Jet(g.signs[0]) * (value_at(basis, g.points[0]) - constant(family.bspline.value(g.points[0])));
  }
  Jet total(0);
  Jet repeating(0);  // the part in [2, 5/2]
  Jet previous(0);
  for (std::size_t j = 0; j + 1 < g.points.size(); ++j) {
    const Rational of_bspline = family.bspline.integral(g.points[j + 1]) - Rational(1, 2);
    const Jet here = integral_to(basis, g.points[j + 1]) - constant(of_bspline);
    const Jet part = Jet(2 * g.signs[j]) * (here - previous);
    const bool is_repeated = g.repeats != 0 && g.points[j] >= Rational(2);
    (is_repeated ? repeating : total) += part;
    previous = here;
  }
  // X = A + repeats (c_3 / 2) X for the integral X over [2, 3] and A over [2, 5/2].
  const Jet ratio = constant(Rational(g.repeats, 2)) * basis.tables().mask[radius];
  return total + repeating / (Jet(1) - ratio);
}

template Taylor<Interval, 2> evaluate<2>(const FitFamily&, const FitFunctional&, const Interval&);
template Taylor<Interval, 3> evaluate<3>(const FitFamily&, const FitFunctional&, const Interval&);

std::vector<FitFunctional> touching_functionals(const FitFamily& family, Norm norm, const Rational& s,
                                                int depth) {
  if (norm == Norm::l1) return {signs_of_difference(family, s, depth)};
  return extrema_of_difference(family, s, depth);
}

}  // namespace subdiv
