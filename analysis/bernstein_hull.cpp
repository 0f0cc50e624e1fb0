#include "analysis/bernstein_hull.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace subdiv {
namespace {

Rational binomial(std::size_t n, std::size_t k) {
  Rational result(1);
  for (std::size_t i = 1; i <= k; ++i) result *= Rational(static_cast<long>(n - k + i), static_cast<long>(i));
  return result;
}

/// The least common multiple of the denominators.
Polynomial common_denominator(const std::vector<Matrix<RationalFunction>>& family) {
  Polynomial result(1);
  for (const Matrix<RationalFunction>& matrix : family) {
    for (Eigen::Index i = 0; i < matrix.size(); ++i) {
      const Polynomial below = matrix.data()[i].denominator();
      Polynomial factor;
      if (!divides(gcd(result, below), below, factor)) throw std::logic_error("a gcd does not divide");
      result *= factor;
    }
  }
  return result;
}

Polynomial as_polynomial(const RationalFunction& f) {
  return f.numerator() * Polynomial(Rational(1) / f.denominator().constant());
}

/// c_{ij}, 0 <= i, j <= n: the i-th Bernstein coefficient of x^j as a polynomial of degree n on [a, b], by
/// polar forms: the mean of the products of j out of i copies of b and n - i copies of a.
std::vector<std::vector<Rational>> bernstein_coefficients(std::size_t n, const Rational& a,
                                                          const Rational& b) {
  std::vector<std::vector<Rational>> result(n + 1, std::vector<Rational>(n + 1, Rational(0)));
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t j = 0; j <= n; ++j) {
      for (std::size_t k = j - std::min(j, n - i); k <= std::min(i, j); ++k) {
        result[i][j] += binomial(n - i, j - k) * binomial(i, k) * pow(a, static_cast<long>(j - k)) *
                        pow(b, static_cast<long>(k));
      }
      result[i][j] /= binomial(n, j);
    }
  }
  return result;
}

}  // namespace

BernsteinHull::BernsteinHull(const std::vector<Matrix<RationalFunction>>& family, std::size_t dimension)
    : letters_(family.size()), rows_(family.at(0).rows()), degrees_(dimension, 0) {
  const Polynomial denominator = common_denominator(family);
  std::vector<Polynomial> all{denominator};
  for (const Matrix<RationalFunction>& matrix : family) {
    for (Eigen::Index i = 0; i < matrix.size(); ++i) {
      all.push_back(as_polynomial(matrix.data()[i] * RationalFunction(denominator)));
    }
  }
  for (const Polynomial& p : all) {
    for (int k = 0; k < max_parameters; ++k) {
      if (static_cast<std::size_t>(k) < dimension) {
        std::size_t& degree = degrees_[static_cast<std::size_t>(k)];
        degree = std::max(degree, static_cast<std::size_t>(std::max(0L, p.degree(k))));
      } else if (p.uses(k)) {
        throw std::domain_error("an entry uses a parameter that has no range");
      }
    }
  }
  std::size_t count = 1;
  for (const std::size_t degree : degrees_) count *= degree + 1;
  coefficients_.assign(count, std::vector<Rational>(all.size(), Rational(0)));
  for (std::size_t e = 0; e < all.size(); ++e) {
    for (const Polynomial::Term& term : all[e].terms()) {
      std::size_t index = 0;
      for (std::size_t k = 0; k < dimension; ++k)
        index = index * (degrees_[k] + 1) + static_cast<std::size_t>(term.exponents[k]);
      coefficients_[index][e] = term.coefficient;
    }
  }
}

std::optional<std::vector<std::vector<Matrix<Rational>>>> BernsteinHull::families(
    const ParameterBox& box) const {
  std::vector<std::vector<Rational>> values = coefficients_;
  std::size_t stride = 1;
  for (std::size_t k = degrees_.size(); k-- > 0;) {
    const std::size_t n = degrees_[k];
    const auto weights = bernstein_coefficients(n, box.lower.at(k), box.upper.at(k));
    std::vector<std::vector<Rational>> next(values.size(),
                                            std::vector<Rational>(values[0].size(), Rational(0)));
    for (std::size_t index = 0; index < values.size(); ++index) {
      const std::size_t i = index / stride % (n + 1);
      for (std::size_t j = 0; j <= n; ++j) {
        const std::vector<Rational>& power = values[index + j * stride - i * stride];
        for (std::size_t e = 0; e < power.size(); ++e) {
          if (power[e].sign() != 0) next[index][e] += weights[i][j] * power[e];
        }
      }
    }
    values = std::move(next);
    stride *= n + 1;
  }
  const int sign = values[0][0].sign();
  std::vector<std::vector<Matrix<Rational>>> result;
  for (const std::vector<Rational>& value : values) {
    if (sign == 0 || value[0].sign() != sign) return std::nullopt;
    std::vector<Matrix<Rational>> family;
    std::size_t e = 1;
    for (std::size_t r = 0; r < letters_; ++r) {
      Matrix<Rational> matrix(rows_, rows_);
      for (Eigen::Index i = 0; i < matrix.size(); ++i) matrix.data()[i] = value[e++] / value[0];
      family.push_back(std::move(matrix));
    }
    result.push_back(std::move(family));
  }
  return result;
}

}  // namespace subdiv
