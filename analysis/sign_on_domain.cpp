#include "analysis/sign_on_domain.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <stdexcept>
#include <utility>

#include "analysis/bernstein_form.h"

namespace subdiv {
namespace {

using Point = std::vector<Rational>;

Rational value_at(const Polynomial& f, const Point& x) { return f.evaluate<Rational>(x); }

/// A part of the box, with the forms of the domain's polynomials and of the function.
struct Cell {
  ParameterBox box;
  std::vector<BernsteinForm> positive;
  std::vector<BernsteinForm> function;  // one, or none
  std::array<int, 2> depth{};

  [[nodiscard]] Point middle() const {
    return {(box.lower[0] + box.upper[0]) / Rational(2), (box.lower[1] + box.upper[1]) / Rational(2)};
  }
  /// The middle and the corners.
  [[nodiscard]] std::array<Point, 5> samples() const {
    return {middle(), Point{box.lower[0], box.lower[1]}, Point{box.lower[0], box.upper[1]},
            Point{box.upper[0], box.lower[1]}, Point{box.upper[0], box.upper[1]}};
  }
  [[nodiscard]] bool is_outside() const {
    return std::ranges::any_of(positive, [](const BernsteinForm& form) {
      return std::ranges::all_of(form.coefficients(), [](const Rational& c) { return c.sign() <= 0; });
    });
  }
  [[nodiscard]] std::array<Cell, 2> halves() const {
    const bool first = depth[0] <= depth[1];
    const std::size_t k = first ? 0 : 1;
    std::array<Cell, 2> result{Cell{box, {}, {}, depth}, Cell{box, {}, {}, depth}};
    result[0].box.upper[k] = result[1].box.lower[k] = middle()[k];
    for (Cell& half : result) ++half.depth.at(k);
    const auto add = [&](const BernsteinForm& form, std::vector<BernsteinForm> Cell::* member) {
      std::array<BernsteinForm, 2> parts = form.halves(first);
      for (std::size_t i = 0; i < 2; ++i) (result.at(i).*member).push_back(std::move(parts.at(i)));
    };
    for (const BernsteinForm& form : positive) add(form, &Cell::positive);
    for (const BernsteinForm& form : function) add(form, &Cell::function);
    return result;
  }
};

/// All coefficients have this sign, but for values 0 at corners outside the domain. For an irreducible
/// polynomial that has a value of this sign in the domain: where all cells with points of the domain do, so
/// has every point of it (sign_on_domain.h).
bool has_sign(const Cell& cell, const PlaneDomain& domain, int sign) {
  std::array<bool, 4> outside{};
  for (std::size_t k = 0; k < outside.size(); ++k)
    outside.at(k) = !domain.contains((k >= 2 ? cell.box.upper : cell.box.lower)[0],
                                     (k % 2 != 0 ? cell.box.upper : cell.box.lower)[1]);
  return cell.function.front().has_sign(sign, outside);
}

Cell whole(const PlaneDomain& domain) {
  Cell cell{domain.box, {}, {}, {}};
  for (const Polynomial& g : domain.positive) cell.positive.emplace_back(g, domain.box);
  return cell;
}

Point point_inside(const PlaneDomain& domain, long cells, int depth) {
  std::deque<Cell> waiting{whole(domain)};
  for (long count = 0; !waiting.empty() && count < cells; ++count) {
    const Cell cell = std::move(waiting.front());
    waiting.pop_front();
    if (cell.is_outside()) continue;
    const Point middle = cell.middle();
    if (domain.contains(middle[0], middle[1])) return middle;
    if (std::min(cell.depth[0], cell.depth[1]) >= depth) continue;
    for (Cell& half : cell.halves()) waiting.push_back(std::move(half));
  }
  return {};
}

DomainSign of_sign(int sign) {
  return {sign > 0 ? DomainSign::Kind::positive : DomainSign::Kind::negative, Status::closed, 0, {}};
}

/// Proves the sign that an irreducible f has at a point of the domain on all of it, or finds a point with
/// another one.
DomainSign prove(const Polynomial& f, const PlaneDomain& domain, const Point& inside, long cells, int depth) {
  const int sign = value_at(f, inside).sign();
  if (sign == 0) return {DomainSign::Kind::not_strict, Status::closed, 0, {inside}};
  DomainSign result = of_sign(sign);
  Cell start = whole(domain);
  start.function.emplace_back(f, domain.box);
  std::vector<Cell> waiting{std::move(start)};
  while (!waiting.empty()) {
    const Cell cell = std::move(waiting.back());
    waiting.pop_back();
    ++result.cells;
    if (has_sign(cell, domain, sign) || cell.is_outside()) continue;
    for (const Point& x : cell.samples()) {
      const int there = value_at(f, x).sign();
      if (there == sign || !domain.contains(x[0], x[1])) continue;
      result.kind = DomainSign::Kind::not_strict;
      result.witnesses = there == 0 ? std::vector<Point>{x} : std::vector<Point>{inside, x};
      return result;
    }
    const bool deep = std::min(cell.depth[0], cell.depth[1]) >= depth;
    if (deep || result.cells >= cells) {
      result.kind = DomainSign::Kind::undecided;
      result.status = deep ? Status::out_of_depth : Status::out_of_time;
      return result;
    }
    for (Cell& half : cell.halves()) waiting.push_back(std::move(half));
  }
  return result;
}

/// +1 or -1 when f is a multiple of g by a number, whose sign that is; else 0.
int common_sign(const Polynomial& f, const Polynomial& g) {
  Polynomial quotient;
  if (!divides(g, f, quotient) || !quotient.is_constant()) return 0;
  return quotient.constant().sign();
}

}  // namespace

std::string to_string(DomainSign::Kind kind) {
  switch (kind) {
    case DomainSign::Kind::positive:
      return "positive";
    case DomainSign::Kind::negative:
      return "negative";
    case DomainSign::Kind::not_strict:
      return "not strict";
    default:
      return "undecided";
  }
}

bool PlaneDomain::contains(const Rational& x0, const Rational& x1) const {
  const Point x{x0, x1};
  for (std::size_t k = 0; k < 2; ++k) {
    if (!(box.lower[k] < x[k] && x[k] < box.upper[k])) return false;
  }
  return std::ranges::all_of(positive, [&](const Polynomial& g) { return value_at(g, x).sign() > 0; });
}

DomainSigns::DomainSigns(PlaneDomain domain, long cells, int depth)
    : domain_(std::move(domain)), cells_(cells), depth_(depth) {
  const ParameterBox& box = domain_.box;
  if (box.lower.size() != 2 || box.upper.size() != 2)
    throw std::invalid_argument("the sign on a plane domain: the box has two dimensions");
  inside_ = point_inside(domain_, cells_, depth_);
}

DomainSign DomainSigns::factor_sign(const Polynomial& factor) {
  if (inside_.empty()) return {DomainSign::Kind::undecided, Status::out_of_depth, 0, {}};
  for (int k = 0; k < 2; ++k) {
    const auto slot = static_cast<std::size_t>(k);
    const Polynomial x = Polynomial::variable(k);
    if (const int sign = common_sign(factor, x - Polynomial(domain_.box.lower[slot])); sign != 0)
      return of_sign(sign);
    if (const int sign = common_sign(factor, Polynomial(domain_.box.upper[slot]) - x); sign != 0)
      return of_sign(sign);
  }
  for (const Polynomial& g : domain_.positive) {
    if (const int sign = common_sign(factor, g); sign != 0) return of_sign(sign);
  }
  const std::string name = factor.to_string();
  const auto found = known_.find(name);
  if (found != known_.end()) return found->second;
  DomainSign result = prove(factor, domain_, inside_, cells_, depth_);
  known_[name] = result;
  return result;
}

DomainSign DomainSigns::sign(const Polynomial& f) {
  for (int k = 2; k < max_parameters; ++k) {
    if (f.uses(k)) throw std::invalid_argument("the sign on a plane domain: of functions of x_0, x_1 alone");
  }
  if (f.is_zero()) throw std::invalid_argument("the sign on a plane domain: of functions that are not 0");
  const Factorization parts = factor(f);
  int sign = parts.constant.sign();
  DomainSign result;
  DomainSign open;
  bool is_open = false;
  for (const auto& [factor, power] : parts.factors) {
    DomainSign own = factor_sign(factor);
    result.cells += own.cells;
    if (own.kind == DomainSign::Kind::not_strict) {
      own.cells = result.cells;
      return own;
    }
    if (own.kind == DomainSign::Kind::undecided) {
      is_open = true;
      open = own;
    }
    if (own.kind == DomainSign::Kind::negative && power % 2 != 0) sign = -sign;
  }
  const long cells = result.cells;
  result = is_open ? open : of_sign(sign);
  result.cells = cells;
  return result;
}

DomainSign DomainSigns::sign(const RationalFunction& f) {
  // f and numerator times denominator have the same signs, and the same points where they have none.
  return sign(f.numerator() * f.denominator());
}

}  // namespace subdiv
