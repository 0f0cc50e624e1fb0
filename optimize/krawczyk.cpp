#include "optimize/krawczyk.h"

#include <algorithm>
#include <cmath>

#include "optimize/residual_functions.h"
#include "schemes/algebra/elimination.h"

namespace subdiv {
namespace {

Vector<Interval> centres(const Vector<Interval>& box) {
  Vector<Interval> result(box.size());
  for (Eigen::Index i = 0; i < box.size(); ++i) result(i) = box(i).center();
  return result;
}

bool all_finite(const Vector<Interval>& x) {
  return std::all_of(x.data(), x.data() + x.size(), [](const Interval& v) { return v.is_finite(); });
}

Vector<Interval> product(const Matrix<Interval>& a, const Vector<Interval>& x) {
  Vector<Interval> result(a.rows());
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    for (Eigen::Index j = 0; j < a.cols(); ++j) result(i) += a(i, j) * x(j);
  }
  return result;
}

/// A ball about 0 whose radius is an upper bound of |x| times the factor, and at least `least`.
Interval symmetric(const Interval& x, double factor, const Interval& least) {
  const Interval largest = max(abs(x) * Interval(factor), least);
  return Interval::hull(largest, -largest);
}

/// The end of Newton's iteration in centres; nothing when the steps do not become small.
std::optional<Vector<Interval>> newton(const SquareSystem& system, Vector<Interval> x) {
  constexpr int most_steps = 100;
  constexpr double small_step = 1e-12;
  double last = INFINITY;
  for (int k = 0; k < most_steps; ++k) {
    const auto inverse = approximate_inverse(system.jacobian(x));
    if (!inverse) return std::nullopt;
    const Vector<Interval> step = product(*inverse, system.value(x));
    if (!all_finite(step)) return std::nullopt;
    double length = 0;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      length = std::max(length, std::abs(step(i).to_double()) / (1 + std::abs(x(i).to_double())));
      x(i) = (x(i) - step(i)).center();
    }
    if (length == 0) return x;
    // Converged when the steps have become small and stop shrinking: then only rounding is left.
    if (length < small_step && length > last / 2) return x;
    last = length;
  }
  return std::nullopt;
}

}  // namespace

SquareSystem square_system(std::span<const RationalFunction> f, long precision) {
  std::vector<CompiledResidual> compiled;
  for (const RationalFunction& component : f) {
    compiled.push_back(compile(component, static_cast<int>(f.size()), precision));
  }
  const auto n = static_cast<Eigen::Index>(f.size());
  SquareSystem system;
  system.value = [compiled, n](const Vector<Interval>& x) {
    Vector<Interval> result(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      result(i) = compiled[static_cast<std::size_t>(i)].value.evaluate(std::span(x.data(), compiled.size()));
    }
    return result;
  };
  system.jacobian = [compiled, n](const Vector<Interval>& x) {
    Matrix<Interval> result(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
      for (Eigen::Index j = 0; j < n; ++j) {
        result(i, j) = compiled[static_cast<std::size_t>(i)].gradient[static_cast<std::size_t>(j)].evaluate(
            std::span(x.data(), compiled.size()));
      }
    }
    return result;
  };
  return system;
}

std::optional<Matrix<Interval>> approximate_inverse(const Matrix<Interval>& a) {
  const Eigen::Index n = a.rows();
  Matrix<Interval> centre(n, n);
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    if (!a.data()[i].is_finite()) return std::nullopt;
    centre.data()[i] = a.data()[i].center();
  }
  Matrix<Interval> inverse(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    Vector<Interval> unit = Vector<Interval>::Constant(n, Interval(0));
    unit(j) = Interval(1);
    const auto column = solve_linear(centre, unit);
    if (!column || !all_finite(*column)) return std::nullopt;
    inverse.col(j) = centres(*column);
  }
  return inverse;
}

std::optional<Vector<Interval>> krawczyk(const SquareSystem& system, const Vector<Interval>& box) {
  const Vector<Interval> m = centres(box);
  const auto c = approximate_inverse(system.jacobian(m));
  if (!c) return std::nullopt;
  const Eigen::Index n = box.size();
  const Matrix<Interval> slopes = system.jacobian(box);
  Vector<Interval> result = m - product(*c, system.value(m));
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      Interval entry(i == j ? 1 : 0);
      for (Eigen::Index k = 0; k < n; ++k) entry -= (*c)(i, k) * slopes(k, j);
      result(i) += entry * (box(j) - m(j));
    }
  }
  return result;
}

std::optional<IsolatedZero> isolate_zero(const SquareSystem& system, const Vector<Interval>& near) {
  const auto end = newton(system, centres(near));
  if (!end) return std::nullopt;
  const auto inverse = approximate_inverse(system.jacobian(*end));
  if (!inverse) return std::nullopt;
  const Vector<Interval> step = product(*inverse, system.value(*end));
  const auto inside = [](const Vector<Interval>& outer, const Vector<Interval>& inner) {
    for (Eigen::Index i = 0; i < outer.size(); ++i) {
      if (!inner(i).is_finite() || !outer(i).contains_strictly(inner(i))) return false;
    }
    return true;
  };
  constexpr int growths = 12;
  double factor = 4;
  for (int k = 0; k < growths; ++k, factor *= 8) {
    Vector<Interval> region(end->size());
    for (Eigen::Index i = 0; i < region.size(); ++i) {
      const Interval& x = (*end)(i);
      const Interval least =
          Interval(Rational::power_of_two(-x.working_precision() + 4), x.working_precision()) *
          (Interval(1) + abs(x)) * Interval(factor);
      region(i) = x + symmetric(step(i), factor, least);
    }
    auto contracted = krawczyk(system, region);
    if (!contracted || !inside(region, *contracted)) continue;
    IsolatedZero zero{*contracted, region};
    constexpr int contractions = 8;  // each squares the width, until rounding stops it
    for (int c = 0; c < contractions; ++c) {
      const auto next = krawczyk(system, zero.enclosure);
      if (!next || !inside(zero.enclosure, *next)) break;
      zero.enclosure = *next;
    }
    return zero;
  }
  return std::nullopt;
}

std::optional<Vector<Interval>> inverse_bounds(const SquareSystem& system, const Vector<Interval>& box) {
  // f(x) - f(x') = J (x - x') with J in f'(X), row by row. d = C (f(x) - f(x')) + (I - C J) d.
  const Eigen::Index n = box.size();
  const Matrix<Interval> slopes = system.jacobian(box);
  const auto c = approximate_inverse(slopes);
  if (!c) return std::nullopt;
  Vector<Interval> direct(n);
  Vector<Interval> remainder(n);
  Interval largest_direct(0);
  Interval largest_remainder(0);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      Interval entry(i == j ? 1 : 0);
      for (Eigen::Index k = 0; k < n; ++k) entry -= (*c)(i, k) * slopes(k, j);
      remainder(i) += abs(entry);
      direct(i) += abs((*c)(i, j));
    }
    largest_direct = max(largest_direct, direct(i));
    largest_remainder = max(largest_remainder, remainder(i));
  }
  if (!largest_remainder.is_finite() || !certainly_less(largest_remainder, Interval(1))) return std::nullopt;
  const Interval largest = largest_direct / (Interval(1) - largest_remainder);
  Vector<Interval> result(n);
  for (Eigen::Index i = 0; i < n; ++i) result(i) = direct(i) + remainder(i) * largest;
  return result;
}

Rational largest_width(const Vector<Interval>& box) {
  Rational width;
  for (Eigen::Index i = 0; i < box.size(); ++i) width = std::max(width, box(i).upper() - box(i).lower());
  return width;
}

}  // namespace subdiv
