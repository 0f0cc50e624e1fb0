#include "analysis/norm_box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "analysis/iterate_norm.h"

namespace subdiv {
namespace {

// Every bound below is a sum of at most 2^7 products of numbers that are not negative; fewer than 2^8
// roundings of relative size 2^-53 went into it, so that inflating it by 2^-44 makes it an upper bound. What
// underflows is below `tiny`.
double inflate(double x) { return x * (1.0 + 0x1p-44); }
constexpr double tiny = 1e-290;
/// The largest bound of a level is raised by this share of itself, to keep classes that tie from all being
/// visited.
constexpr double tie = 1e-10;
constexpr int most_levels = 64;
constexpr double below_one = 1.0 - 0x1p-53;

/// A double that is not below q >= 0.
double round_up(const Rational& q) {
  double x = q.to_double();
  while (Rational::from_double(x) < q) x = std::nextafter(x, std::numeric_limits<double>::infinity());
  return x;
}

/// gamma_n of n roundings, rounded up.
double rounding(std::size_t n) { return inflate(static_cast<double>(n) * 0x1p-53); }

/// d_i(center + t) = value + slope t + t^2 (..), where the last bracket is at most rest for |t| <= radius.
struct TaylorCoefficient {
  Rational value;
  Rational slope;
  Rational rest;
};

TaylorCoefficient expand(UnivariatePolynomial p, const Rational& center, const Rational& radius) {
  TaylorCoefficient result{p.evaluate(center), Rational(0), Rational(0)};
  Rational factor(1);  // radius^(i-2) / i!
  for (int i = 1; p.degree() > 0; ++i) {
    p = p.derivative();
    factor /= Rational(i);
    if (i == 1) result.slope = p.evaluate(center);
    if (i > 2) factor *= radius;
    if (i >= 2) result.rest += abs(p.evaluate(center)) * factor;
  }
  return result;
}

/// The largest sums over the columns of all A_e of: stored values and slopes, their distances to the exact
/// ones, and rests.
struct ColumnNorms {
  Rational value, slope, value_error, slope_error, rest;
};

void raise(Rational& largest, const Rational& x) {
  if (largest < x) largest = x;
}

/// Stores the matrices and measures them. Column j of A_e holds d_{e + m l - j}, l = 0 .. n - 1.
ColumnNorms fill(NormBox& box, const std::vector<TaylorCoefficient>& d) {
  ColumnNorms largest;
  const auto arity = static_cast<std::size_t>(box.arity);
  box.value.assign(arity * box.n * box.n, 0.0);
  box.slope = box.value;
  for (std::size_t e = 0; e < arity; ++e) {
    for (std::size_t j = 0; j < box.n; ++j) {
      ColumnNorms column;
      for (std::size_t l = 0; l < box.n; ++l) {
        if (e + arity * l < j || e + arity * l - j >= d.size()) continue;
        const TaylorCoefficient& c = d[e + arity * l - j];
        const std::size_t entry = (e * box.n + l) * box.n + j;
        box.value[entry] = c.value.to_double();
        box.slope[entry] = c.slope.to_double();
        const Rational value = Rational::from_double(box.value[entry]);
        const Rational slope = Rational::from_double(box.slope[entry]);
        column.value += abs(value);
        column.slope += abs(slope);
        column.value_error += abs(value - c.value);
        column.slope_error += abs(slope - c.slope);
        column.rest += c.rest;
      }
      raise(largest.value, column.value);
      raise(largest.slope, column.slope);
      raise(largest.value_error, column.value_error);
      raise(largest.slope_error, column.slope_error);
      raise(largest.rest, column.rest);
    }
  }
  return largest;
}

/// The search through the classes of one level of a box. Classes whose bound does not pass the cutoff are not
/// visited.
class Search {
 public:
  Search(const NormBox& box, int levels)
      : box_(box), levels_(static_cast<std::size_t>(levels)), word_(levels_, 0), defects_(levels_ + 1, 0.0) {
    const std::vector<double> zeros(box.n, 0.0);
    nodes_.assign(levels_ + 1,
                  std::vector<Node>(static_cast<std::size_t>(box.arity), Node{zeros, zeros, 0, 0, 0}));
  }

  /// The largest bound of a class of this level, within `tie`, and a class that has it.
  std::pair<double, ClassValue> largest() {
    raises_ = true;
    cutoff_ = 0.0;
    run();
    return {cutoff_, best_};
  }

  /// The classes whose bound passes the cutoff; nothing when there are more than `most`.
  std::optional<std::vector<ClassWord>> above(double cutoff, std::size_t most) {
    raises_ = false;
    cutoff_ = cutoff;
    most_ = most;
    run();
    if (overflow_) return std::nullopt;
    return words_;
  }

 private:
  struct Node {
    std::vector<double> v0, v1;
    double norm0, norm1;  // bounds of |v0| and |v1|
    double bound;         // of |v(s)| on the box
  };

  void run() {
    const std::vector<double> zeros(box_.n, 0.0);
    Node root{zeros, zeros, 1.0, 0.0, 1.0};
    root.v0[0] = 1.0;
    descend(root, 0);
  }

  void descend(const Node& node, std::size_t level) {
    if (level == levels_) return reach(node);
    const std::size_t left = levels_ - level - 1;
    defects_[level + 1] = inflate(box_.defect_value * node.norm0 + box_.defect_slope * node.norm1) + tiny;
    std::vector<Node>& children = nodes_[level];
    std::size_t first = 0;
    for (std::size_t e = 0; e < children.size(); ++e) {
      step(node, e, level + 1, children[e]);
      if (children[e].bound > children[first].bound) first = e;
    }
    for (std::size_t i = 0; i < children.size() && !overflow_; ++i) {
      const std::size_t e = (first + i) % children.size();
      if (inflate(children[e].bound * box_.bounds[left]) <= cutoff_) continue;
      word_[level] = static_cast<int>(e);
      descend(children[e], level + 1);
    }
  }

  void step(const Node& from, std::size_t e, std::size_t level, Node& to) const {
    const double* value = box_.value.data() + e * box_.n * box_.n;
    const double* slope = box_.slope.data() + e * box_.n * box_.n;
    double sum0 = 0, sum1 = 0, left_end = 0, right_end = 0;
    for (std::size_t l = 0; l < box_.n; ++l, value += box_.n, slope += box_.n) {
      double v0 = 0, v1 = 0;
      for (std::size_t j = 0; j < box_.n; ++j) {
        v0 += value[j] * from.v0[j];
        v1 += value[j] * from.v1[j];
        v1 += slope[j] * from.v0[j];
      }
      to.v0[l] = v0;
      to.v1[l] = v1;
      sum0 += std::abs(v0);
      sum1 += std::abs(v1);
      left_end += std::abs(v0 - box_.radius * v1);
      right_end += std::abs(v0 + box_.radius * v1);
    }
    double rest = 0;
    for (std::size_t i = 1; i <= level; ++i) rest += defects_[i] * box_.bounds[level - i];
    to.norm0 = inflate(sum0);
    to.norm1 = inflate(sum1);
    const double bound = inflate(std::max(left_end, right_end) + rest + 0x1p-52 * box_.radius * sum1 + tiny);
    to.bound = std::isnan(bound) ? std::numeric_limits<double>::infinity() : bound;
  }

  void reach(const Node& leaf) {
    if (leaf.bound <= cutoff_) return;
    if (raises_) {
      cutoff_ = leaf.bound * (1.0 + tie);
      best_.word = word_;
      best_.norm = 0;
      best_.slope = 0;
      for (std::size_t l = 0; l < box_.n; ++l) {
        best_.norm += std::abs(leaf.v0[l]);
        best_.slope += leaf.v0[l] < 0 ? -leaf.v1[l] : leaf.v1[l];
      }
    } else if (words_.size() == most_) {
      overflow_ = true;
    } else {
      words_.push_back(word_);
    }
  }

  const NormBox& box_;
  std::size_t levels_;
  ClassWord word_;
  std::vector<double> defects_;           // of the steps of the current path, from 1
  std::vector<std::vector<Node>> nodes_;  // the children at each level of the current path
  bool raises_ = false;
  double cutoff_ = 0.0;
  ClassValue best_;
  std::size_t most_ = 0;
  bool overflow_ = false;
  std::vector<ClassWord> words_;
};

}  // namespace

NormBox norm_box(const DifferenceFamily& family, double lower, double upper) {
  constexpr std::size_t largest_size = 32;
  NormBox box;
  box.arity = family.arity;
  box.n = static_cast<std::size_t>(class_size(family.symbol, family.arity));
  if (box.n > largest_size) throw std::domain_error("masks of more than 32 class entries are not supported");
  const double center = lower + (upper - lower) / 2;
  const Rational exact_center = Rational::from_double(center);
  box.radius = round_up(
      std::max(Rational::from_double(upper) - exact_center, exact_center - Rational::from_double(lower)));

  std::vector<TaylorCoefficient> d;
  for (const UnivariatePolynomial& p : family.symbol.coefficients()) {
    d.push_back(expand(p, exact_center, Rational::from_double(box.radius)));
  }
  const ColumnNorms norms = fill(box, d);
  const double h = box.radius;
  const double value_error =
      round_up(norms.value_error) + inflate(rounding(2 * box.n) * round_up(norms.value));
  const double slope_error =
      round_up(norms.slope_error) + inflate(rounding(2 * box.n) * round_up(norms.slope));
  const double rest = round_up(norms.rest);
  const double slope = round_up(norms.slope) + round_up(norms.slope_error);
  box.defect_value = inflate(value_error + h * slope_error + h * h * rest);
  box.defect_slope = inflate(h * value_error + h * h * slope + h * h * h * rest);
  return box;
}

void bound_norms(NormBox& box, int k) {
  if (k < 0 || k > most_levels) throw std::domain_error("the power of an iterate is 0 .. 64");
  while (box.bounds.size() <= static_cast<std::size_t>(k)) {
    box.bounds.push_back(Search(box, static_cast<int>(box.bounds.size())).largest().first);
  }
}

ClassValue largest_class(NormBox& box, int k) {
  bound_norms(box, k - 1);
  return Search(box, k).largest().second;
}

bool proves_contraction(NormBox& box, int k) {
  bound_norms(box, k - 1);
  return Search(box, k).above(below_one, 0).has_value();
}

std::optional<std::vector<ClassWord>> critical_classes(NormBox& box, int k, std::size_t most) {
  bound_norms(box, k - 1);
  return Search(box, k).above(below_one, most);
}

std::optional<int> contraction_power(const Laurent<Rational>& d, int arity, int max_power) {
  const auto constant = [](const Rational& c) { return UnivariatePolynomial(c); };
  NormBox point = norm_box({arity, map_coefficients(d, constant)}, 0, 0);
  for (int k = 1; k <= max_power; ++k) {
    if (proves_contraction(point, k)) return k;
  }
  return std::nullopt;
}

}  // namespace subdiv
