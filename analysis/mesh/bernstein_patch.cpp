#include "analysis/mesh/bernstein_patch.h"

#include <algorithm>
#include <array>

namespace subdiv {
namespace {

Interval binomial(int n, int k) {
  long result = 1;
  for (long i = 1; i <= k; ++i) result = result * (n - k + i) / i;
  return result;
}

/// n!/(i! j! (n-i-j)!)
Interval trinomial(int n, int i, int j) { return binomial(n, i) * binomial(n - i, j); }

const Interval& half() {
  static const Interval value(Rational(1, 2));
  return value;
}

/// The coefficients of f on the halves of u, or of v.
std::array<SquarePatch, 2> halves(const SquarePatch& f, bool along_u) {
  SquarePatch low(f.degree_u(), f.degree_v());
  SquarePatch high = f;
  const int n = along_u ? f.degree_u() : f.degree_v();
  const int lines = along_u ? f.degree_v() : f.degree_u();
  for (int line = 0; line <= lines; ++line) {
    const auto at = [&](SquarePatch& patch, int i) -> Interval& {
      return along_u ? patch(i, line) : patch(line, i);
    };
    for (int level = 0; level <= n; ++level) {
      at(low, level) = at(high, 0);
      for (int i = 0; i + level < n; ++i) {
        at(high, i) += at(high, i + 1);
        at(high, i) *= half();
      }
    }
  }
  return {std::move(low), std::move(high)};
}

}  // namespace

SquarePatch derivative_u(const SquarePatch& f) {
  SquarePatch result(f.degree_u() - 1, f.degree_v());
  for (int i = 0; i < f.degree_u(); ++i) {
    for (int j = 0; j <= f.degree_v(); ++j) result(i, j) = Interval(f.degree_u()) * (f(i + 1, j) - f(i, j));
  }
  return result;
}

SquarePatch derivative_v(const SquarePatch& f) {
  SquarePatch result(f.degree_u(), f.degree_v() - 1);
  for (int i = 0; i <= f.degree_u(); ++i) {
    for (int j = 0; j < f.degree_v(); ++j) result(i, j) = Interval(f.degree_v()) * (f(i, j + 1) - f(i, j));
  }
  return result;
}

SquarePatch operator*(const SquarePatch& f, const SquarePatch& g) {
  const auto weighted = [](const SquarePatch& p) {
    SquarePatch result = p;
    for (int i = 0; i <= p.degree_u(); ++i) {
      for (int j = 0; j <= p.degree_v(); ++j)
        result(i, j) *= binomial(p.degree_u(), i) * binomial(p.degree_v(), j);
    }
    return result;
  };
  const SquarePatch a = weighted(f);
  const SquarePatch b = weighted(g);
  SquarePatch result(f.degree_u() + g.degree_u(), f.degree_v() + g.degree_v());
  for (int i = 0; i <= f.degree_u(); ++i) {
    for (int j = 0; j <= f.degree_v(); ++j) {
      for (int k = 0; k <= g.degree_u(); ++k) {
        for (int l = 0; l <= g.degree_v(); ++l) add_product(result(i + k, j + l), a(i, j), b(k, l));
      }
    }
  }
  for (int i = 0; i <= result.degree_u(); ++i) {
    for (int j = 0; j <= result.degree_v(); ++j)
      result(i, j) /= binomial(result.degree_u(), i) * binomial(result.degree_v(), j);
  }
  return result;
}

SquarePatch operator-(SquarePatch f, const SquarePatch& g) {
  for (int i = 0; i <= f.degree_u(); ++i) {
    for (int j = 0; j <= f.degree_v(); ++j) f(i, j) -= g(i, j);
  }
  return f;
}

TrianglePatch derivative_u(const TrianglePatch& f) {
  TrianglePatch result(f.degree() - 1);
  for (int i = 0; i < f.degree(); ++i) {
    for (int j = 0; i + j < f.degree(); ++j) result(i, j) = Interval(f.degree()) * (f(i + 1, j) - f(i, j));
  }
  return result;
}

TrianglePatch derivative_v(const TrianglePatch& f) {
  TrianglePatch result(f.degree() - 1);
  for (int i = 0; i < f.degree(); ++i) {
    for (int j = 0; i + j < f.degree(); ++j) result(i, j) = Interval(f.degree()) * (f(i, j + 1) - f(i, j));
  }
  return result;
}

TrianglePatch operator*(const TrianglePatch& f, const TrianglePatch& g) {
  TrianglePatch result(f.degree() + g.degree());
  for (int i = 0; i <= f.degree(); ++i) {
    for (int j = 0; i + j <= f.degree(); ++j) {
      const Interval weighted = trinomial(f.degree(), i, j) * f(i, j);
      for (int k = 0; k <= g.degree(); ++k) {
        for (int l = 0; k + l <= g.degree(); ++l)
          add_product(result(i + k, j + l), weighted, trinomial(g.degree(), k, l) * g(k, l));
      }
    }
  }
  for (int i = 0; i <= result.degree(); ++i) {
    for (int j = 0; i + j <= result.degree(); ++j) result(i, j) /= trinomial(result.degree(), i, j);
  }
  return result;
}

TrianglePatch operator-(TrianglePatch f, const TrianglePatch& g) {
  for (int i = 0; i <= f.degree(); ++i) {
    for (int j = 0; i + j <= f.degree(); ++j) f(i, j) -= g(i, j);
  }
  return f;
}

SquarePatch over_square(const TrianglePatch& f) {
  // The terms with i + j = m are B^n_m(p) times a polynomial of degree m in q, raised to degree n.
  const int n = f.degree();
  SquarePatch result(n, n);
  for (int m = 0; m <= n; ++m) {
    for (int l = 0; l <= n; ++l) {
      for (int j = std::max(0, l - (n - m)); j <= std::min(m, l); ++j)
        add_product(result(m, l), binomial(m, j) * binomial(n - m, l - j), f(m - j, j));
      result(m, l) /= binomial(n, l);
    }
  }
  return result;
}

void add_signs(SignsFound& found, const SquarePatch& f, int depth, int& parts) {
  if (found.both()) return;
  const std::vector<Interval>& c = f.coefficients();
  const bool positive = std::ranges::all_of(c, certainly_positive);
  const bool negative = !positive && std::ranges::all_of(c, certainly_negative);
  for (const int i : {0, f.degree_u()}) {  // the values at the corners
    for (const int j : {0, f.degree_v()}) {
      found.positive = found.positive || certainly_positive(f(i, j));
      found.negative = found.negative || certainly_negative(f(i, j));
    }
  }
  if (found.both() || positive || negative || depth == 0 || parts <= 0) {
    for (const Interval& x : c) {
      found.smallest = std::min(found.smallest, x.to_double());
      found.largest = std::max(found.largest, x.to_double());
    }
    found.open = found.open || (!positive && !negative);
    return;
  }
  parts -= 4;
  for (const SquarePatch& part : halves(f, true)) {
    for (const SquarePatch& quarter : halves(part, false)) add_signs(found, quarter, depth - 1, parts);
  }
}

std::optional<Interval> turned_angle(const std::vector<PlaneNumber<Interval>>& curve, int depth) {
  using Number = PlaneNumber<Interval>;
  const Number& first = curve.front();
  const Number& last = curve.back();
  const Number middle = first + last;
  const Number towards{middle.x.center(), middle.y.center()};
  const bool apart = std::ranges::all_of(
      curve, [&](const Number& c) { return certainly_positive((conjugate(towards) * c).x); });
  if (apart) {
    const Number change = conjugate(first) * last;
    Interval angle;
    arb_atan2(angle.raw(), change.y.raw(), change.x.raw(), Interval::default_precision);
    return angle;
  }
  if (depth == 0) return std::nullopt;
  std::vector<Number> low;
  std::vector<Number> high = curve;
  for (std::size_t n = curve.size(); n > 0; --n) {
    low.push_back(high.front());
    for (std::size_t i = 0; i + 1 < n; ++i) high[i] = half() * (high[i] + high[i + 1]);
  }
  const std::optional<Interval> a = turned_angle(low, depth - 1);
  if (!a) return std::nullopt;
  const std::optional<Interval> b = turned_angle(high, depth - 1);
  if (!b) return std::nullopt;
  return *a + *b;
}

}  // namespace subdiv
