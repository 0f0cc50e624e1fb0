#include "analysis/map_cell.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Dense>

#include "analysis/corner_polytope.h"

namespace subdiv {
namespace {

using Families = std::vector<std::vector<Matrix<Rational>>>;

/// The largest spectral radius^(1/length) of short words of one of the families, in floating point: where it
/// reaches 1 a polytope would be sought in vain.
double largest_radius(const Families& families, int longest) {
  double largest = 0;
  for (const std::vector<Matrix<Rational>>& exact : families) {
    std::vector<Eigen::MatrixXd> family;
    for (const Matrix<Rational>& matrix : exact) {
      family.emplace_back(matrix.unaryExpr([](const Rational& q) { return q.to_double(); }));
      if (!family.back().allFinite()) return std::numeric_limits<double>::infinity();
    }
    const int letters = static_cast<int>(family.size());
    for (Word word = next_lyndon_word({}, letters, longest); !word.empty();
         word = next_lyndon_word(word, letters, longest)) {
      const Eigen::MatrixXd p = product(family, word);
      if (!p.allFinite()) return std::numeric_limits<double>::infinity();
      const Eigen::EigenSolver<Eigen::MatrixXd> solver(p, false);
      const double radius = solver.eigenvalues().cwiseAbs().maxCoeff();
      largest = std::max(largest, std::pow(radius, 1.0 / static_cast<double>(word.size())));
    }
  }
  return largest;
}

/// A word whose condition is proved on all of the box.
std::optional<Word> expanding_word(const std::vector<std::pair<Word, RangedPolynomial>>& conditions,
                                   const ParameterBox& box) {
  std::vector<Interval> intervals;
  std::vector<double> centre;
  for (std::size_t k = 0; k < box.lower.size(); ++k) {
    intervals.push_back(Interval::hull(box.lower[k], box.upper[k]));
    centre.push_back(intervals.back().to_double());
  }
  for (const auto& [word, g] : conditions) {
    if (g.value(centre) < 0 && certainly_at_most(g.range(intervals), Interval(0))) return word;
  }
  return std::nullopt;
}

}  // namespace

CellDecider::CellDecider(const std::vector<Matrix<RationalFunction>>& family, std::size_t dimension,
                         const CellOptions& options)
    : CellDecider(family, dimension, expanding_conditions(family, options.longest_word), options) {}

CellDecider::CellDecider(const std::vector<Matrix<RationalFunction>>& family, std::size_t dimension,
                         const std::vector<ExpandingCondition>& conditions, const CellOptions& options)
    : options_(options), hull_(family, dimension) {
  for (const ExpandingCondition& c : conditions) {
    conditions_.emplace_back(c.word, RangedPolynomial(c.g, dimension));
  }
}

MapCell CellDecider::decide(const ParameterBox& box) const {
  MapCell cell{box, Decision::undecided, 0, {}};
  const auto families = hull_.families(box);
  if (!families) return cell;
  if (const auto word = expanding_word(conditions_, box)) {
    cell.below = Decision::no;
    cell.word = *word;
    return cell;
  }
  const double radius = largest_radius(*families, options_.longest_word);
  if (!(radius < 1)) return cell;
  std::vector<Matrix<Rational>> all;
  for (const auto& family : *families) all.insert(all.end(), family.begin(), family.end());
  constexpr double part = 1.0 / 8;  // of the distance from 1 that is left for a polytope
  const double margin = std::min(options_.margin, (1 - radius) * part);
  if (const auto vertices = contracting_polytope(all, options_.vertices, margin)) {
    cell.below = Decision::yes;
    cell.vertices = *vertices;
  }
  return cell;
}

std::vector<Matrix<RationalFunction>> continuity_family(const NormalForm<RationalFunction>& form,
                                                        int continuity) {
  return divided(transition_matrices(form), pow(Rational(form.arity), form.factors - 1 - continuity));
}

std::vector<Matrix<RationalFunction>> divided(std::vector<Matrix<RationalFunction>> family,
                                              const Rational& bound) {
  const RationalFunction scale(Rational(1) / bound);
  for (Matrix<RationalFunction>& t : family) {
    for (Eigen::Index i = 0; i < t.size(); ++i) t.data()[i] *= scale;
  }
  return family;
}

}  // namespace subdiv
