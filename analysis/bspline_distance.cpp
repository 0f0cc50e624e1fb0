#include "analysis/bspline_distance.h"

#include <algorithm>
#include <stdexcept>

#include "schemes/bspline.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

constexpr int jspline_radius = 3;  // the mask's support is [-3, 3]

LocalBasis<Interval> local_basis(const Rational& s, long precision) {
  const auto enclose = [&](const Rational& q) { return Interval(q, precision); };
  return {map_coefficients(basis_tables(jspline(s)), enclose), -jspline_radius, jspline_radius};
}

Interval kappa(const Rational& s, long precision) {
  if (s <= Rational(0) || s > Rational(3)) throw std::domain_error("the distance of *J_s needs 0 < s <= 3");
  return Interval(s < Rational(1) ? (Rational(1) - s) / (Rational(2) * s) : Rational(0), precision);
}

/// Is phi_s the B-spline itself?
bool is_bspline(const Rational& s, int degree) {
  return degree % 2 == 1 && jspline(s) == bspline<Rational>(degree);
}

/// Half the width of the smallest symmetric interval of integers that holds the supports of phi_s and B_d.
int radius(const UniformBspline& b) { return std::max(jspline_radius, (b.degree() + 2) / 2); }

/// A node of a maximisation: an attained value at its ends and an upper bound.
template <class Node>
struct Candidate {
  Node node;
  Rational upper;
  friend bool operator<(const Candidate& a, const Candidate& b) { return a.upper < b.upper; }
};

/// The largest value of a function by best-first branch and bound: bound(node) returns (lower bound that is
/// attained, upper bound), halves(node) two nodes that cover it.
template <class Node, class Bound, class Halves>
Enclosure maximise(const std::vector<Node>& roots, Bound bound, Halves halves,
                   const DistanceOptions& options) {
  std::vector<Candidate<Node>> heap;
  Rational attained(0);
  const auto push = [&](const Node& node) {
    const auto [lower, upper] = bound(node);
    attained = std::max(attained, lower);
    heap.push_back({node, upper});
    std::push_heap(heap.begin(), heap.end());
  };
  for (const Node& root : roots) push(root);
  int pieces = static_cast<int>(roots.size());
  while (heap.front().upper > attained + options.tolerance && pieces < options.max_pieces) {
    std::pop_heap(heap.begin(), heap.end());
    const auto [left, right] = halves(heap.back().node);
    heap.pop_back();
    push(left);
    push(right);
    pieces += 2;
  }
  const Rational upper = std::max(attained, heap.front().upper);
  Enclosure result = certified(attained, upper, "branch and bound with exact curvature bounds");
  if (upper > attained + options.tolerance) result.status = Status::out_of_depth;
  return result;
}

}  // namespace

BsplineDifference::BsplineDifference(const Rational& s, int degree, long precision)
    : basis_(local_basis(s, precision)),
      bspline_(degree),
      kappa_(kappa(s, precision)),
      precision_(precision) {
  if (degree < 1) throw std::domain_error("the distance needs a continuous B-spline, of degree at least 1");
}

BsplineDifference::Piece BsplineDifference::describe(BasisPiece<Interval> basis) const {
  const Rational left = basis.left;
  const Rational right = basis.right();
  const UnivariatePolynomial& b = bspline_.piece(left, right);
  const Interval left_value = basis_.left_value(basis) - Interval(b.evaluate(left), precision_);
  const Interval right_value = basis_.right_value(basis) - Interval(b.evaluate(right), precision_);
  const std::vector<Interval>& p = basis.coefficients;
  const Interval scale(Rational::power_of_two(2 * basis.level), precision_);
  std::vector<Interval> w;
  for (std::size_t j = 1; j + 1 < p.size(); ++j)
    w.push_back((p[j - 1] - Interval(2) * p[j] + p[j + 1]) * scale);
  Interval lowest = w[0];
  Interval highest = w[0];
  for (const Interval& value : w) {
    lowest = min(lowest, value);
    highest = max(highest, value);
  }
  Interval q(0);
  for (std::size_t j = 1; j + 1 < w.size(); ++j) q = max(q, abs(w[j - 1] - Interval(2) * w[j] + w[j + 1]));
  const Interval margin = kappa_ * q;
  const UnivariatePolynomial second = b.derivative().derivative();
  const Interval curvature = Interval::hull(lowest - margin, highest + margin) -
                             second.evaluate(Interval::hull(left, right, precision_));
  return {std::move(basis), left_value, right_value, curvature};
}

std::vector<BsplineDifference::Piece> BsplineDifference::pieces(int lower, int upper) const {
  std::vector<Piece> result;
  for (int i = lower; i < upper; ++i) {
    auto [left, right] = basis_.halves(basis_.unit(i));
    result.push_back(describe(std::move(left)));
    result.push_back(describe(std::move(right)));
  }
  return result;
}

std::pair<BsplineDifference::Piece, BsplineDifference::Piece> BsplineDifference::halves(
    const Piece& piece) const {
  auto [left, right] = basis_.halves(piece.basis);
  return {describe(std::move(left)), describe(std::move(right))};
}

Interval BsplineDifference::integral(const Piece& piece) const {
  const Rational of_bspline = bspline_.integral(piece.basis.right()) - bspline_.integral(piece.basis.left);
  return basis_.integral(piece.basis) * Interval(piece.basis.width(), precision_) -
         Interval(of_bspline, precision_);
}

Interval BsplineDifference::bow(const Piece& piece) {
  const Rational factor = Rational::power_of_two(-2 * piece.basis.level - 3);
  return abs(piece.curvature) * Interval(factor, piece.curvature.precision());
}

Enclosure bspline_distance_l1(const Rational& s, int degree, const DistanceOptions& options) {
  if (is_bspline(s, degree)) return exact(Rational(0), "the same mask");
  const BsplineDifference e(s, degree, options.precision);
  Interval settled(0);
  Rational unsettled(0);
  int pieces = 0;
  bool exhausted = false;
  std::vector<BsplineDifference::Piece> stack = e.pieces(0, radius(e.bspline()));
  while (!stack.empty()) {
    const BsplineDifference::Piece piece = std::move(stack.back());
    stack.pop_back();
    ++pieces;
    const Interval deviation = BsplineDifference::bow(piece);
    const bool positive =
        certainly_at_most(deviation, piece.left) && certainly_at_most(deviation, piece.right);
    const bool negative =
        certainly_at_most(piece.left, -deviation) && certainly_at_most(piece.right, -deviation);
    if (positive || negative) {
      settled += positive ? e.integral(piece) : -e.integral(piece);
      continue;
    }
    const Interval largest = max(abs(piece.left), abs(piece.right)) + deviation;
    const Rational at_most = largest.upper() * piece.basis.width();
    exhausted = exhausted || pieces >= options.max_pieces;
    if (at_most <= options.tolerance || exhausted) {
      unsettled += at_most;
      continue;
    }
    auto [left, right] = e.halves(piece);
    stack.push_back(std::move(left));
    stack.push_back(std::move(right));
  }
  // e is even.
  Enclosure result = certified(Rational(2) * settled.lower(), Rational(2) * (settled.upper() + unsettled),
                               "signs by exact curvature bounds, exact integrals");
  if (exhausted) result.status = Status::out_of_depth;
  return result;
}

Enclosure bspline_distance_linf(const Rational& s, int degree, const DistanceOptions& options) {
  if (is_bspline(s, degree)) return exact(Rational(0), "the same mask");
  using Piece = BsplineDifference::Piece;
  const BsplineDifference e(s, degree, options.precision);
  const auto bound = [](const Piece& piece) {
    const Interval ends = max(abs(piece.left), abs(piece.right));
    return std::pair(ends.lower(), (ends + BsplineDifference::bow(piece)).upper());
  };
  return maximise(
      e.pieces(0, radius(e.bspline())), bound, [&](const Piece& p) { return e.halves(p); }, options);
}

Enclosure bspline_edge_bound(const Rational& s, int degree, const DistanceOptions& options) {
  if (is_bspline(s, degree)) return exact(Rational(0), "the same mask");
  // A node: the pieces of e at t + m, for one dyadic interval of t in [0, 1] and all m, ascending.
  using Node = std::vector<BsplineDifference::Piece>;
  const BsplineDifference e(s, degree, options.precision);
  const int reach = radius(e.bspline());
  Node first_half;
  Node second_half;
  const std::vector<BsplineDifference::Piece> all = e.pieces(-reach, reach);
  for (std::size_t i = 0; i < all.size(); ++i) (i % 2 == 0 ? first_half : second_half).push_back(all[i]);
  const auto bound = [](const Node& node) {
    // sum of |H_k| is convex where the H_k are linear, so it is largest at an end but for the sum of their
    // bows.
    BsplineDifference::Piece h{node[0].basis, Interval(0), Interval(0), Interval(0)};
    Interval left(0);
    Interval right(0);
    Interval deviation(0);
    for (std::size_t m = node.size(); m-- > 0;) {
      h.left += node[m].left;
      h.right += node[m].right;
      h.curvature += node[m].curvature;
      left += abs(h.left);
      right += abs(h.right);
      deviation += BsplineDifference::bow(h);
    }
    const Interval ends = max(left, right);
    return std::pair(ends.lower(), (ends + deviation).upper());
  };
  const auto halves = [&](const Node& node) {
    std::pair<Node, Node> result;
    for (const auto& piece : node) {
      auto [left, right] = e.halves(piece);
      result.first.push_back(std::move(left));
      result.second.push_back(std::move(right));
    }
    return result;
  };
  return maximise(std::vector<Node>{first_half, second_half}, bound, halves, options);
}

}  // namespace subdiv
