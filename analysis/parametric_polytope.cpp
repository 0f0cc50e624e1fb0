#include "analysis/parametric_polytope.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "analysis/sign_on_interval.h"
#include "analysis/symmetric_gauge.h"
#include "schemes/algebra/specialize.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

std::string image_name(std::size_t matrix, Eigen::Index vertex) {
  return "T_" + std::to_string(matrix) + " v_" + std::to_string(vertex + 1);
}

template <class Test>
bool all_entries(const Matrix<Function>& a, Test test) {
  return std::all_of(a.data(), a.data() + a.size(), test);
}

bool is_finite(const Matrix<Function>& a, const RealInterval& range) {
  return all_entries(a, [&](const Function& f) { return f.is_constant() || subdiv::is_finite(f, range); });
}

void require_shape(const ParametricPolytope& p) {
  const Eigen::Index n = p.vertices.rows();
  const Eigen::Index count = p.vertices.cols();
  bool fits = p.matrices.size() == p.combinations.size();
  for (const auto& t : p.matrices) fits = fits && t.rows() == n && t.cols() == n;
  for (const auto& c : p.combinations) fits = fits && c.rows() == count && c.cols() == count;
  if (!fits) throw std::domain_error("matrices, vertices and combinations of a polytope do not fit");
}

/// The sum of the moduli is at most (below) the factor: tried with every sign that a coefficient takes on the
/// range.
bool sum_stays_within(const ParametricPolytope& p, const Matrix<Function>& combination, Eigen::Index column,
                      const RealInterval& range, Containment containment) {
  Function room = p.factor;
  std::vector<Function> ambiguous;
  for (Eigen::Index k = 0; k < combination.rows(); ++k) {
    const Function& c = combination(k, column);
    if (c.is_zero()) continue;
    if (is_nonnegative(c, range)) {
      room -= c;
    } else if (is_nonnegative(-c, range)) {
      room += c;
    } else {
      ambiguous.push_back(c);
    }
  }
  constexpr std::size_t most_ambiguous = 12;
  if (ambiguous.size() > most_ambiguous) return false;
  for (std::size_t signs = 0; signs < (std::size_t{1} << ambiguous.size()); ++signs) {
    Function rest = room;
    for (std::size_t k = 0; k < ambiguous.size(); ++k)
      rest += (signs >> k & 1) != 0 ? ambiguous[k] : -ambiguous[k];
    const bool within =
        containment == Containment::closed ? is_nonnegative(rest, range) : is_positive(rest, range);
    if (!within) return false;
  }
  return true;
}

/// The determinant of n columns of a matrix.
Function minor(const Matrix<Function>& a, const std::vector<int>& columns) {
  Matrix<Function> square(a.rows(), a.rows());
  for (Eigen::Index k = 0; k < a.rows(); ++k) square.col(k) = a.col(columns[static_cast<std::size_t>(k)]);
  const Function constant = characteristic_polynomial(square)[0];
  return a.rows() % 2 == 0 ? constant : -constant;
}

/// The next set of columns 0 <= c_0 < c_1 < .. < count in lexicographic order; false after the last.
bool advance(std::vector<int>& columns, int count) {
  for (std::size_t i = columns.size(); i-- > 0;) {
    if (columns[i] >= count - static_cast<int>(columns.size() - i)) continue;
    std::iota(columns.begin() + static_cast<std::ptrdiff_t>(i), columns.end(), columns[i] + 1);
    return true;
  }
  return false;
}

/// The columns have full rank at every p in the range: the minors have no common root there.
bool spans(const Matrix<Function>& vertices, const RealInterval& range) {
  if (vertices.cols() < vertices.rows()) return false;
  std::vector<int> columns(static_cast<std::size_t>(vertices.rows()));
  std::iota(columns.begin(), columns.end(), 0);
  Polynomial common(0);
  do {
    common = gcd(common, minor(vertices, columns).numerator());
    if (has_no_root(common, range)) return true;
  } while (advance(columns, static_cast<int>(vertices.cols())));
  return false;
}

Eigen::MatrixXd approximate(const Matrix<Function>& a, const Rational& at) {
  return a.unaryExpr([&](const Function& f) { return specialize(f, 0, at).to_double(); });
}

/// Bisects the range; midpoints are rational.
std::pair<RealInterval, RealInterval> halves(const RealInterval& range) {
  const Interval middle = (range.lower->to_interval() + range.upper->to_interval()) / Interval(2);
  const Rational width = range.upper->to_interval().midpoint() - range.lower->to_interval().midpoint();
  const Rational off = width / Rational(32);
  const Algebraic cut(simplest_between(middle.midpoint() - off, middle.midpoint() + off));
  return {RealInterval{range.lower, cut, range.lower_closed, true},
          RealInterval{cut, range.upper, true, range.upper_closed}};
}

}  // namespace

std::optional<std::string> find_flaw(const ParametricPolytope& polytope, const RealInterval& range,
                                     Containment containment) {
  require_shape(polytope);
  const ParametricPolytope& p = polytope;
  const auto finite = [&](const Matrix<Function>& a) { return is_finite(a, range); };
  if (!finite(p.vertices) || !std::all_of(p.matrices.begin(), p.matrices.end(), finite) ||
      !std::all_of(p.combinations.begin(), p.combinations.end(), finite)) {
    return "an entry has a pole in the range";
  }
  if (!spans(p.vertices, range)) return "the vertices do not span the space everywhere";
  for (std::size_t i = 0; i < p.matrices.size(); ++i) {
    const Matrix<Function> difference = p.matrices[i] * p.vertices - p.vertices * p.combinations[i];
    for (Eigen::Index j = 0; j < p.vertices.cols(); ++j) {
      const Matrix<Function> column = difference.col(j);
      if (!all_entries(column, [](const Function& f) { return f.is_zero(); })) {
        return image_name(i, j) + " is not its combination";
      }
      if (!sum_stays_within(p, p.combinations[i], j, range, containment)) {
        return "the coefficients of " + image_name(i, j) + " may add up to more than the factor";
      }
    }
  }
  return std::nullopt;
}

std::optional<Vector<Function>> combine(const Matrix<Function>& vertices, const std::vector<int>& basis,
                                        const Vector<Function>& x) {
  const Function below = minor(vertices, basis);
  if (below.is_zero()) return std::nullopt;
  Matrix<Function> extended(vertices.rows(), vertices.cols() + 1);
  extended.leftCols(vertices.cols()) = vertices;
  extended.col(vertices.cols()) = x;
  Vector<Function> result = Vector<Function>::Constant(vertices.cols(), Function(0));
  for (std::size_t k = 0; k < basis.size(); ++k) {
    std::vector<int> columns = basis;
    columns[k] = static_cast<int>(vertices.cols());
    result(basis[k]) = minor(extended, columns) / below;
  }
  return result;
}

std::optional<ParametricPolytope> propose_combinations(std::vector<Matrix<Function>> matrices,
                                                       Matrix<Function> vertices, Function factor,
                                                       const Rational& at) {
  const std::optional<SymmetricGauge> gauge = SymmetricGauge::of(approximate(vertices, at));
  if (!gauge) return std::nullopt;
  ParametricPolytope result{std::move(matrices), std::move(vertices), {}, std::move(factor)};
  for (const Matrix<Function>& t : result.matrices) {
    const Matrix<Function> images = t * result.vertices;
    const Eigen::MatrixXd image_points = approximate(images, at);
    Matrix<Function> combination = zero_matrix<Function>(images.cols(), images.cols());
    for (Eigen::Index j = 0; j < images.cols(); ++j) {
      const auto column = combine(result.vertices, gauge->combine(image_points.col(j)).basis, images.col(j));
      if (!column) return std::nullopt;
      combination.col(j) = *column;
    }
    result.combinations.push_back(std::move(combination));
  }
  return result;
}

std::optional<std::vector<PolytopeProof>> prove_containment(const std::vector<Matrix<Function>>& matrices,
                                                            const Matrix<Function>& vertices,
                                                            const Function& factor, const RealInterval& range,
                                                            Containment containment, int most) {
  std::vector<PolytopeProof> proofs;
  std::vector<RealInterval> open{range};  // a stack; the leftmost range is on top
  while (!open.empty()) {
    if (static_cast<int>(proofs.size() + open.size()) > most) return std::nullopt;
    const RealInterval part = open.back();
    open.pop_back();
    const auto [left, right] = halves(part);
    auto polytope = propose_combinations(matrices, vertices, factor, left.upper->to_rational());
    if (polytope && !find_flaw(*polytope, part, containment)) {
      proofs.push_back({part, std::move(*polytope)});
    } else {
      open.push_back(right);
      open.push_back(left);
    }
  }
  return proofs;
}

bool is_eigenvalue(const Matrix<Function>& matrix, const Function& value) {
  const std::vector<Function> coefficients = characteristic_polynomial(matrix);
  Function sum(0);
  for (std::size_t i = coefficients.size(); i-- > 0;) sum = sum * value + coefficients[i];
  return sum.is_zero();
}

}  // namespace subdiv
