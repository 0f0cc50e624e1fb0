#include "analysis/contraction_end.h"

#include <algorithm>
#include <array>
#include <utility>

#include "analysis/contraction_range.h"
#include "analysis/eigenvalues.h"
#include "analysis/symmetric_gauge.h"
#include "schemes/algebra/specialize.h"
#include "schemes/algebra/univariate.h"

namespace subdiv {
namespace {

using Function = RationalFunction;
using Family = std::vector<Matrix<Function>>;

Eigen::VectorXd approximate(const Vector<Rational>& v) {
  return v.unaryExpr([](const Rational& q) { return q.to_double(); });
}

/// The unit vectors and their images that are not inside, as far as an orbit of few vertices closes.
std::optional<Matrix<Function>> standing_vertices(const Family& matrices, const Rational& at) {
  constexpr std::size_t most = 32;
  constexpr double rounding = 1e-10;
  std::vector<Matrix<Rational>> family;
  for (const Matrix<Function>& t : matrices) {
    family.emplace_back(t.unaryExpr([&](const Function& f) { return specialize(f, 0, at); }));
  }
  const Eigen::Index n = family[0].rows();
  std::vector<Vector<Rational>> vertices;
  for (Eigen::Index i = 0; i < n; ++i) vertices.emplace_back(identity_matrix<Rational>(n).col(i));
  auto gauge = SymmetricGauge::of(Eigen::MatrixXd::Identity(n, n));
  for (std::size_t j = 0; j < vertices.size(); ++j) {
    for (const Matrix<Rational>& t : family) {
      const Vector<Rational> image = t * vertices[j];
      const Eigen::VectorXd point = approximate(image);
      if (!point.allFinite()) return std::nullopt;
      if (gauge->gauge(point) <= 1 + rounding) continue;
      if (vertices.size() >= most) return std::nullopt;
      vertices.push_back(image);
      gauge->add_vertex(point);
    }
  }
  Matrix<Function> result(n, static_cast<Eigen::Index>(vertices.size()));
  for (std::size_t j = 0; j < vertices.size(); ++j) {
    result.col(static_cast<Eigen::Index>(j)) =
        vertices[j].unaryExpr([](const Rational& q) { return Function(q); });
  }
  return result;
}

/// A product with the eigenvalue 1 at the end, its beginnings, and the symmetry of the family that it uses.
struct Leading {
  Matrix<Function> matrix;
  Family beginnings;
  std::optional<Matrix<Function>> mirror;
};

bool vanishes_at(const Function& f, const Algebraic& p) {
  const UnivariatePolynomial numerator(f.numerator(), 0);
  return divide(numerator, UnivariatePolynomial(p.minimal_polynomial())).second.is_zero();
}

bool is_mirrored(const Family& matrices, const Matrix<Function>& mirror) {
  for (std::size_t r = 0; r < matrices.size(); ++r) {
    const Matrix<Function>& other = matrices[matrices.size() - 1 - r];
    if (!(Matrix<Function>(mirror * matrices[r] * mirror) == other)) return false;
  }
  return true;
}

/// The word's first half when the second is its mirror image, also after a rotation.
std::optional<Word> mirrored_half(Word word, int letters) {
  if (word.size() % 2 != 0) return std::nullopt;
  const std::size_t half = word.size() / 2;
  for (std::size_t i = 0; i < half; ++i) {
    if (word[i] + word[i + half] != letters - 1) return std::nullopt;
  }
  word.resize(half);
  return word;
}

/// +matrix or -matrix, whichever has the eigenvalue 1 at the end, simple in the sense that it is a factor's.
std::optional<Leading> with_sign(const Family& matrices, const Word& word, const Algebraic& end,
                                 const std::optional<Matrix<Function>>& mirror, bool flipped) {
  Leading result{identity_matrix<Function>(matrices[0].rows()), {}, mirror};
  for (const int letter : word) {
    result.matrix = (matrices[static_cast<std::size_t>(letter)] * result.matrix).eval();
    result.beginnings.push_back(result.matrix);
  }
  result.beginnings.pop_back();
  if (flipped) result.matrix = (*mirror * result.matrix).eval();
  const Matrix<Function> unit = identity_matrix<Function>(result.matrix.rows());
  for (const int sign : {1, -1}) {
    const Matrix<Function> rest = unit - Function(sign) * result.matrix;
    if (!vanishes_at(characteristic_polynomial(rest)[0], end)) continue;
    if (sign < 0) result.matrix = (Function(-1) * result.matrix).eval();
    return result;
  }
  return std::nullopt;
}

std::vector<Leading> leading_products(const Family& matrices, const Word& word, const Algebraic& end) {
  std::vector<Leading> result;
  const Matrix<Function> flip = reversal(matrices[0].rows());
  std::optional<Matrix<Function>> mirror;
  if (is_mirrored(matrices, flip)) mirror = flip;
  if (const auto half = mirrored_half(word, static_cast<int>(matrices.size())); half && mirror) {
    if (auto leading = with_sign(matrices, *half, end, mirror, true)) result.push_back(std::move(*leading));
  }
  if (auto leading = with_sign(matrices, word, end, mirror, false)) result.push_back(std::move(*leading));
  return result;
}

/// The point a part of the way from the end to `inside`, with a small denominator.
Rational part_of_way(const Algebraic& end, const Rational& inside, const Rational& part) {
  const Rational from = end.to_interval().midpoint();
  const Rational step = (inside - from) * part;
  const Rational slack = abs(step) / Rational(8);
  return simplest_between(from + step - slack, from + step + slack);
}

std::optional<ContractionEnd> prove_near(const Family& matrices, int length, const Matrix<Function>& vertices,
                                         const Algebraic& end, const Rational& inside) {
  constexpr std::array parts{32, 1024, 32768};
  const Family products = all_products(matrices, length);
  for (const int part : parts) {
    const Rational cut = part_of_way(end, inside, Rational(1, part));
    const bool upwards = end > Algebraic(cut);
    const RealInterval near = upwards ? RealInterval{Algebraic(cut), end, true, false}
                                      : RealInterval{end, Algebraic(cut), false, true};
    constexpr int most_ranges = 8;
    auto polytopes =
        prove_containment(products, vertices, Function(1), near, Containment::interior, most_ranges);
    if (polytopes) return ContractionEnd{end, cut, length, std::move(*polytopes)};
  }
  return std::nullopt;
}

}  // namespace

std::optional<ContractionEnd> prove_contraction_at_end(const Family& matrices, const Word& word,
                                                       const Algebraic& end, const Rational& inside) {
  if (end.is_rational()) {
    if (const auto vertices = standing_vertices(matrices, end.to_rational())) {
      if (auto proof = prove_near(matrices, 1, *vertices, end, inside)) return proof;
    }
  }
  const Matrix<Function> unit = identity_matrix<Function>(matrices[0].rows());
  for (const int length : {2, 3}) {
    if (auto proof = prove_near(matrices, length, unit, end, inside)) return proof;
  }
  constexpr int closeness = 1000;
  const Rational at = part_of_way(end, inside, Rational(1, closeness));
  for (const Leading& leading : leading_products(matrices, word, end)) {
    const auto vertices = critical_vertices(matrices, leading.matrix, leading.mirror, at, leading.beginnings);
    if (!vertices) continue;
    if (auto proof = prove_near(matrices, 1, *vertices, end, inside)) return proof;
  }
  return std::nullopt;
}

}  // namespace subdiv
