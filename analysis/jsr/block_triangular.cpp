#include "analysis/jsr/block_triangular.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>

#include "schemes/algebra/univariate.h"

namespace subdiv {
namespace {

template <class R>
using Family = std::vector<Matrix<R>>;
using Indices = std::vector<Eigen::Index>;

/// Beyond this size exact elimination costs too much; only zero patterns are used.
constexpr Eigen::Index largest_exact = 20;

template <class R>
Family<R> submatrices(const Family<R>& family, const Indices& rows) {
  Family<R> result;
  for (const Matrix<R>& t : family) result.emplace_back(t(rows, rows));
  return result;
}

/// Strongly connected components of the graph with an edge j -> i where some matrix has an entry (i, j) that
/// is not zero: the diagonal blocks of the best permutation (Tarjan 1972).
template <class R>
class Components {
 public:
  explicit Components(const Family<R>& family)
      : family_(family), n_(static_cast<std::size_t>(family[0].rows())) {
    order_.assign(n_, 0);
    low_.assign(n_, 0);
    on_stack_.assign(n_, false);
    for (std::size_t j = 0; j < n_; ++j) {
      if (order_[j] == 0) visit(j);
    }
  }
  std::vector<Indices> components;

 private:
  [[nodiscard]] bool edge(std::size_t j, std::size_t i) const {
    return std::any_of(family_.begin(), family_.end(), [&](const Matrix<R>& t) {
      return !is_zero(t(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
    });
  }
  void visit(std::size_t j) {
    order_[j] = low_[j] = ++count_;
    stack_.push_back(j);
    on_stack_[j] = true;
    for (std::size_t i = 0; i < n_; ++i) {
      if (!edge(j, i)) continue;
      if (order_[i] == 0) {
        visit(i);
        low_[j] = std::min(low_[j], low_[i]);
      } else if (on_stack_[i]) {
        low_[j] = std::min(low_[j], order_[i]);
      }
    }
    if (low_[j] != order_[j]) return;
    Indices component;
    for (std::size_t i = n_; i != j;) {
      i = stack_.back();
      stack_.pop_back();
      on_stack_[i] = false;
      component.push_back(static_cast<Eigen::Index>(i));
    }
    std::sort(component.begin(), component.end());
    components.push_back(std::move(component));
  }

  const Family<R>& family_;
  std::size_t n_;
  std::size_t count_ = 0;
  std::vector<std::size_t> order_, low_, stack_;
  std::vector<bool> on_stack_;
};

/// A subspace in echelon form: each vector is 1 at its pivot, where all others are 0.
class Subspace {
 public:
  explicit Subspace(Eigen::Index n) : n_(n) {}

  /// Adds x unless it lies in the subspace already.
  bool add(Vector<Rational> x) {
    for (std::size_t k = 0; k < basis_.size(); ++k) subtract(x, basis_[k], pivots_[k]);
    Eigen::Index pivot = 0;
    while (pivot < n_ && is_zero(x(pivot))) ++pivot;
    if (pivot == n_) return false;
    const Rational scale = x(pivot);
    for (Eigen::Index i = 0; i < n_; ++i) x(i) = x(i) / scale;
    for (Vector<Rational>& b : basis_) subtract(b, x, pivot);
    basis_.push_back(std::move(x));
    pivots_.push_back(pivot);
    return true;
  }
  [[nodiscard]] Eigen::Index dimension() const { return static_cast<Eigen::Index>(basis_.size()); }
  [[nodiscard]] const std::vector<Vector<Rational>>& basis() const { return basis_; }
  [[nodiscard]] const Indices& pivots() const { return pivots_; }

 private:
  static void subtract(Vector<Rational>& x, const Vector<Rational>& b, Eigen::Index pivot) {
    if (is_zero(x(pivot))) return;
    const Rational factor = x(pivot);
    for (Eigen::Index i = 0; i < x.size(); ++i) x(i) = x(i) - factor * b(i);
  }

  Eigen::Index n_;
  std::vector<Vector<Rational>> basis_;
  Indices pivots_;
};

/// The smallest subspace that contains v and is invariant under the family.
Subspace spin(const Family<Rational>& family, const Vector<Rational>& v) {
  const Eigen::Index n = v.size();
  Subspace space(n);
  std::vector<Vector<Rational>> fresh;
  if (space.add(v)) fresh.push_back(v);
  while (!fresh.empty() && space.dimension() < n) {
    const Vector<Rational> x = std::move(fresh.back());
    fresh.pop_back();
    for (const Matrix<Rational>& t : family) {
      Vector<Rational> image = t * x;
      if (space.add(image)) fresh.push_back(std::move(image));
    }
  }
  return space;
}

Matrix<Rational> evaluate(const UnivariatePolynomial& p, const Matrix<Rational>& a) {
  Matrix<Rational> value = zero_matrix<Rational>(a.rows(), a.cols());
  for (long i = p.degree(); i >= 0; --i) {
    value = (value * a).eval();
    for (Eigen::Index k = 0; k < a.rows(); ++k) value(k, k) += p.coefficient(i);
  }
  return value;
}

Family<Rational> transposed(const Family<Rational>& family) {
  Family<Rational> result;
  for (const Matrix<Rational>& t : family) result.emplace_back(t.transpose());
  return result;
}

/// The annihilator { x : <y, x> = 0 for all y in the space }.
Subspace annihilator(const Subspace& space, Eigen::Index n) {
  Matrix<Rational> equations(space.dimension(), n);
  for (Eigen::Index i = 0; i < space.dimension(); ++i) {
    equations.row(i) = space.basis()[static_cast<std::size_t>(i)].transpose();
  }
  Subspace result(n);
  for (const Vector<Rational>& x : null_space(equations)) result.add(x);
  return result;
}

/// A few elements of the algebra that the family generates.
std::vector<Matrix<Rational>> samples(const Family<Rational>& family) {
  std::vector<Matrix<Rational>> result = family;
  if (family.size() == 1) return result;
  Matrix<Rational> sum = family[0];
  Matrix<Rational> weighted = family[0];
  Matrix<Rational> whole = family[0];
  for (std::size_t i = 1; i < family.size(); ++i) {
    sum = (sum + family[i]).eval();
    weighted = (weighted + Rational(static_cast<std::int64_t>(2 * i + 1)) * family[i]).eval();
    whole = (family[i] * whole).eval();
  }
  result.push_back(sum);
  result.push_back(weighted);
  result.push_back(whole);
  result.emplace_back(weighted * whole - sum);
  return result;
}

/// A proper common invariant subspace; nothing when none was found.
std::optional<Subspace> invariant_subspace(const Family<Rational>& family) {
  const Eigen::Index n = family[0].rows();
  const Family<Rational> dual = transposed(family);
  const auto proper = [&](const Subspace& s) { return s.dimension() > 0 && s.dimension() < n; };
  for (const Matrix<Rational>& a : samples(family)) {
    for (const auto& [p, multiplicity] : factor(UnivariatePolynomial(characteristic_polynomial(a)))) {
      const Matrix<Rational> value = evaluate(p, a);
      std::vector<Vector<Rational>> right = null_space(value);
      std::vector<Vector<Rational>> left = null_space(Matrix<Rational>(value.transpose()));
      // Norton: then all null vectors generate the same subspace, and when this and that of the transposes
      // are the whole space, there is no other.
      const bool decides = static_cast<long>(right.size()) == p.degree();
      if (decides) right.resize(1), left.resize(1);
      for (const Vector<Rational>& v : right) {
        if (Subspace s = spin(family, v); proper(s)) return s;
      }
      for (const Vector<Rational>& w : left) {
        if (const Subspace s = spin(dual, w); proper(s)) return annihilator(s, n);
      }
      if (decides) return std::nullopt;
    }
  }
  return std::nullopt;
}

/// The family on the subspace and on the quotient by it, in the basis of the subspace and the unit vectors
/// off its pivots.
std::pair<Family<Rational>, Family<Rational>> split(const Family<Rational>& family, const Subspace& space) {
  const Eigen::Index n = family[0].rows();
  Indices others;
  for (Eigen::Index i = 0; i < n; ++i) {
    if (std::find(space.pivots().begin(), space.pivots().end(), i) == space.pivots().end())
      others.push_back(i);
  }
  std::pair<Family<Rational>, Family<Rational>> result;
  for (const Matrix<Rational>& t : family) {
    Matrix<Rational> inner(space.dimension(), space.dimension());
    for (Eigen::Index j = 0; j < inner.cols(); ++j) {
      // Coordinates in the subspace stand at the pivots.
      const Vector<Rational> image = t * space.basis()[static_cast<std::size_t>(j)];
      for (Eigen::Index i = 0; i < inner.rows(); ++i) {
        inner(i, j) = image(space.pivots()[static_cast<std::size_t>(i)]);
      }
    }
    const auto size = static_cast<Eigen::Index>(others.size());
    Matrix<Rational> outer(size, size);
    for (Eigen::Index j = 0; j < size; ++j) {
      Vector<Rational> image = t.col(others[static_cast<std::size_t>(j)]);
      for (Eigen::Index k = 0; k < space.dimension(); ++k) {
        const Rational c = image(space.pivots()[static_cast<std::size_t>(k)]);
        for (Eigen::Index i = 0; i < n; ++i)
          image(i) = image(i) - c * space.basis()[static_cast<std::size_t>(k)](i);
      }
      for (Eigen::Index i = 0; i < size; ++i) outer(i, j) = image(others[static_cast<std::size_t>(i)]);
    }
    result.first.push_back(std::move(inner));
    result.second.push_back(std::move(outer));
  }
  return result;
}

void divide_further(const Family<Rational>& family, std::vector<Family<Rational>>& blocks) {
  const Eigen::Index n = family[0].rows();
  std::optional<Subspace> space;
  if (n > 1 && n <= largest_exact) space = invariant_subspace(family);
  if (!space) {
    blocks.push_back(family);
    return;
  }
  const auto [inner, outer] = split(family, *space);
  divide_further(inner, blocks);
  divide_further(outer, blocks);
}

template <class R>
std::vector<Family<R>> permuted_blocks(const Family<R>& family) {
  std::vector<Family<R>> result;
  for (const Indices& component : Components(family).components)
    result.push_back(submatrices(family, component));
  return result;
}

}  // namespace

std::vector<Family<Rational>> diagonal_blocks(const Family<Rational>& family) {
  std::vector<Family<Rational>> result;
  for (const Family<Rational>& block : permuted_blocks(family)) divide_further(block, result);
  return result;
}

std::vector<Family<Interval>> diagonal_blocks(const Family<Interval>& family) {
  return permuted_blocks(family);
}
std::vector<Family<Algebraic>> diagonal_blocks(const Family<Algebraic>& family) {
  return permuted_blocks(family);
}

}  // namespace subdiv
