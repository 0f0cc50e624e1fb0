#include "analysis/radius_map.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include <Eigen/Dense>

#include "analysis/corner_polytope.h"
#include "analysis/expanding_condition.h"
#include "analysis/transition_matrices.h"

namespace subdiv {
namespace {

/// T(x) = sum over subsets S of the parameters of coefficient_S prod_{i in S} x_i; S as a bit set.
using MultiAffine = std::vector<Matrix<Rational>>;

MultiAffine multi_affine(const Matrix<RationalFunction>& matrix, std::size_t dimension) {
  const auto refuse = [](const std::string& what) {
    throw std::domain_error("maps need entries of degree at most 1 in each parameter of the box; " + what);
  };
  MultiAffine result(std::size_t{1} << dimension, zero_matrix<Rational>(matrix.rows(), matrix.cols()));
  for (Eigen::Index i = 0; i < matrix.size(); ++i) {
    const RationalFunction& entry = matrix.data()[i];
    if (!entry.denominator().is_constant()) refuse("an entry has a denominator");
    const Rational scale = Rational(1) / entry.denominator().constant();
    for (const Polynomial::Term& term : entry.numerator().terms()) {
      std::size_t subset = 0;
      for (std::size_t k = 0; k < term.exponents.size(); ++k) {
        if (term.exponents[k] > 1) refuse("an entry is not linear");
        if (term.exponents[k] == 1 && k >= dimension) refuse("an entry uses another parameter");
        if (term.exponents[k] == 1) subset |= std::size_t{1} << k;
      }
      result[subset].data()[i] = term.coefficient * scale;
    }
  }
  return result;
}

Matrix<Rational> value_at(const MultiAffine& matrix, const std::vector<Rational>& x) {
  Matrix<Rational> sum = matrix[0];
  for (std::size_t subset = 1; subset < matrix.size(); ++subset) {
    Rational monomial(1);
    for (std::size_t k = 0; k < x.size(); ++k) {
      if ((subset >> k & 1) != 0) monomial *= x[k];
    }
    for (Eigen::Index i = 0; i < sum.size(); ++i) {
      if (matrix[subset].data()[i].sign() != 0) sum.data()[i] += monomial * matrix[subset].data()[i];
    }
  }
  return sum;
}

std::vector<Rational> corner(const ParameterBox& box, std::size_t index) {
  std::vector<Rational> x;
  for (std::size_t k = 0; k < box.lower.size(); ++k) {
    x.push_back((index >> k & 1) != 0 ? box.upper[k] : box.lower[k]);
  }
  return x;
}

/// All values of the family at the corners, corner by corner.
std::vector<Matrix<Rational>> corner_values(const std::vector<MultiAffine>& family, const ParameterBox& box) {
  std::vector<Matrix<Rational>> result;
  for (std::size_t c = 0; c < std::size_t{1} << box.lower.size(); ++c) {
    for (const MultiAffine& matrix : family) result.push_back(value_at(matrix, corner(box, c)));
  }
  return result;
}

/// The largest spectral radius^(1/length) of short words at one of the corners, in floating point: where it
/// reaches 1 a polytope would be sought in vain.
double largest_radius(const std::vector<Matrix<Rational>>& corners, std::size_t letters, int longest) {
  double largest = 0;
  for (std::size_t i = 0; i < corners.size(); i += letters) {
    std::vector<Eigen::MatrixXd> family;
    for (std::size_t k = 0; k < letters; ++k) {
      family.push_back(corners[i + k].unaryExpr([](const Rational& q) { return q.to_double(); }));
    }
    for (Word word = next_lyndon_word({}, static_cast<int>(letters), longest); !word.empty();
         word = next_lyndon_word(word, static_cast<int>(letters), longest)) {
      const Eigen::EigenSolver<Eigen::MatrixXd> solver(product(family, word), false);
      const double radius = solver.eigenvalues().cwiseAbs().maxCoeff();
      largest = std::max(largest, std::pow(radius, 1.0 / static_cast<double>(word.size())));
    }
  }
  return largest;
}

/// The cell halved in all directions.
std::vector<ParameterBox> children(const ParameterBox& box) {
  std::vector<ParameterBox> result;
  for (std::size_t c = 0; c < std::size_t{1} << box.lower.size(); ++c) {
    ParameterBox child = box;
    for (std::size_t k = 0; k < box.lower.size(); ++k) {
      const Rational middle = (box.lower[k] + box.upper[k]) / Rational(2);
      ((c >> k & 1) != 0 ? child.lower : child.upper)[k] = middle;
    }
    result.push_back(std::move(child));
  }
  return result;
}

/// What is known of a family before any cell is looked at.
struct Prepared {
  std::vector<MultiAffine> family;
  std::vector<std::pair<Word, RangedPolynomial>> conditions;
};

/// A word whose condition is proved on all of the box.
std::optional<Word> expanding_word(const Prepared& prepared, const ParameterBox& box) {
  std::vector<Interval> intervals;
  std::vector<double> centre;
  for (std::size_t k = 0; k < box.lower.size(); ++k) {
    intervals.push_back(Interval::hull(box.lower[k], box.upper[k]));
    centre.push_back(intervals.back().to_double());
  }
  for (const auto& [word, g] : prepared.conditions) {
    if (g.value(centre) < 0 && certainly_at_most(g.range(intervals), Interval(0))) {
      return word;
    }
  }
  return std::nullopt;
}

MapCell decide(const Prepared& prepared, const ParameterBox& box, const RadiusMapOptions& options) {
  MapCell cell{box, Decision::undecided, 0, {}};
  if (const auto word = expanding_word(prepared, box)) {
    cell.below = Decision::no;
    cell.word = *word;
    return cell;
  }
  const std::vector<Matrix<Rational>> corners = corner_values(prepared.family, box);
  if (largest_radius(corners, prepared.family.size(), options.longest_word) >= 1) return cell;
  if (const auto vertices = contracting_polytope(corners, options.vertices)) {
    cell.below = Decision::yes;
    cell.vertices = *vertices;
  }
  return cell;
}

}  // namespace

Rational ParameterBox::volume() const {
  Rational product(1);
  for (std::size_t k = 0; k < lower.size(); ++k) product *= upper[k] - lower[k];
  return product;
}

Rational RadiusMap::volume(Decision below) const {
  Rational sum(0);
  for (const MapCell& cell : cells) {
    if (cell.below == below) sum += cell.box.volume();
  }
  return sum;
}

RadiusMap radius_map(const std::vector<Matrix<RationalFunction>>& family, const Rational& bound,
                     const ParameterBox& box, const RadiusMapOptions& options) {
  const std::size_t dimension = box.lower.size();
  if (dimension == 0 || dimension > static_cast<std::size_t>(max_free_parameters) ||
      box.upper.size() != dimension) {
    throw std::domain_error("a map needs a box of 1 to " + std::to_string(max_free_parameters) +
                            " parameters");
  }
  std::vector<Matrix<RationalFunction>> scaled;
  Prepared prepared;
  for (const Matrix<RationalFunction>& t : family) {
    scaled.push_back(t.unaryExpr([&](const RationalFunction& f) { return f / RationalFunction(bound); }));
    prepared.family.push_back(multi_affine(scaled.back(), dimension));
  }
  for (const ExpandingCondition& c : expanding_conditions(scaled, options.longest_word)) {
    prepared.conditions.emplace_back(c.word, RangedPolynomial(c.g, dimension));
  }
  RadiusMap map;
  const std::function<void(const ParameterBox&, int)> visit = [&](const ParameterBox& cell_box, int depth) {
    MapCell cell = decide(prepared, cell_box, options);
    if (cell.below != Decision::undecided || depth == 0) {
      map.cells.push_back(std::move(cell));
    } else {
      for (const ParameterBox& child : children(cell_box)) visit(child, depth - 1);
    }
  };
  visit(box, options.depth);
  return map;
}

RadiusMap continuity_map(const Mask<RationalFunction>& mask, int continuity, const ParameterBox& box,
                         const RadiusMapOptions& options) {
  const NormalForm<RationalFunction> form = normal_form(mask);
  if (continuity < 0 || continuity > form.factors - 1) {
    throw std::domain_error("the symbol has " + std::to_string(form.factors) +
                            " smoothing factors for all parameters, so C^" + std::to_string(continuity) +
                            " has no map");
  }
  const Rational bound = pow(Rational(form.arity), form.factors - 1 - continuity);
  return radius_map(transition_matrices(form), bound, box, options);
}

}  // namespace subdiv
