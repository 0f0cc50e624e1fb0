#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/mesh/plane_number.h"
#include "schemes/algebra/interval.h"

namespace subdiv {

/// Polynomials in two variables in Bernstein form, coefficients over outward-rounded intervals (Farin: Curves
/// and Surfaces for CAGD, chapters 5, 16, 17).

/// On the unit square: sum of c(i, j) B^m_i(u) B^n_j(v).
class SquarePatch {
 public:
  /// 0, of degree m in u and n in v.
  SquarePatch(int m, int n)
      : m_(m), n_(n), c_(static_cast<std::size_t>(m + 1) * static_cast<std::size_t>(n + 1)) {}

  [[nodiscard]] int degree_u() const { return m_; }
  [[nodiscard]] int degree_v() const { return n_; }
  [[nodiscard]] const Interval& operator()(int i, int j) const { return c_[slot(i, j)]; }
  [[nodiscard]] Interval& operator()(int i, int j) { return c_[slot(i, j)]; }
  [[nodiscard]] const std::vector<Interval>& coefficients() const { return c_; }

 private:
  [[nodiscard]] std::size_t slot(int i, int j) const {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(n_ + 1) + static_cast<std::size_t>(j);
  }
  int m_;
  int n_;
  std::vector<Interval> c_;
};

/// The derivative with respect to u.
[[nodiscard]] SquarePatch derivative_u(const SquarePatch& f);
/// The derivative with respect to v.
[[nodiscard]] SquarePatch derivative_v(const SquarePatch& f);
[[nodiscard]] SquarePatch operator*(const SquarePatch& f, const SquarePatch& g);
/// Of equal degrees.
[[nodiscard]] SquarePatch operator-(SquarePatch f, const SquarePatch& g);

/// On the triangle u, v, 1 - u - v >= 0: sum over i + j <= n of c(i, j) n!/(i! j! (n - i - j)!) u^i v^j
/// (1 - u - v)^(n - i - j).
class TrianglePatch {
 public:
  /// 0, of degree n.
  explicit TrianglePatch(int n)
      : n_(n), c_(static_cast<std::size_t>(n + 1) * static_cast<std::size_t>(n + 1)) {}

  [[nodiscard]] int degree() const { return n_; }
  [[nodiscard]] const Interval& operator()(int i, int j) const { return c_[slot(i, j)]; }
  [[nodiscard]] Interval& operator()(int i, int j) { return c_[slot(i, j)]; }

 private:
  [[nodiscard]] std::size_t slot(int i, int j) const {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(n_ + 1) + static_cast<std::size_t>(j);
  }
  int n_;
  std::vector<Interval> c_;
};

/// The derivative with respect to u.
[[nodiscard]] TrianglePatch derivative_u(const TrianglePatch& f);
/// The derivative with respect to v.
[[nodiscard]] TrianglePatch derivative_v(const TrianglePatch& f);
[[nodiscard]] TrianglePatch operator*(const TrianglePatch& f, const TrianglePatch& g);
[[nodiscard]] TrianglePatch operator-(TrianglePatch f, const TrianglePatch& g);
/// The same polynomial at u = p (1 - q), v = p q over the unit square of (p, q), which covers the triangle.
[[nodiscard]] SquarePatch over_square(const TrianglePatch& f);

/// The strict signs that a function is known to take.
struct SignsFound {
  bool positive = false;  ///< somewhere
  bool negative = false;  ///< somewhere
  bool open = false;      ///< somewhere the budget ended
  /// Of all Bernstein coefficients looked at in the end, up to rounding.
  double smallest = std::numeric_limits<double>::infinity();
  double largest = -std::numeric_limits<double>::infinity();

  [[nodiscard]] bool both() const { return positive && negative; }
};

/// Adds the signs of f on the unit square: one sign of all coefficients proves it; else f is halved in both
/// directions (de Casteljau), at most `depth` times and into parts that `parts` counts down from. Stops when
/// both signs are known.
void add_signs(SignsFound& found, const SquarePatch& f, int depth, int& parts);

/// A plane curve sum of c_i B_i(t), 0 <= t <= 1: the change of its argument about 0, enclosed. Nothing when
/// `depth` halvings do not part all pieces' control points from 0 by lines.
[[nodiscard]] std::optional<Interval> turned_angle(const std::vector<PlaneNumber<Interval>>& curve,
                                                   int depth);

}  // namespace subdiv
