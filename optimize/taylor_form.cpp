#include "optimize/taylor_form.h"

#include <cmath>
#include <stdexcept>

namespace subdiv {
namespace {

/// [-r, r] for a ball r, and [0, r] where the power is even.
Interval power_range(const Interval& radius, std::size_t power) {
  if (power == 0) return Interval(1);
  const Interval largest = pow(radius, static_cast<long>(power));
  return power % 2 == 0 ? Interval::hull(Interval(0), largest) : Interval::hull(-largest, largest);
}

Interval symmetric_hull(const Interval& x) { return Interval::hull(x, -x); }

}  // namespace

TaylorForm::TaylorForm(const Polynomial& p, int variables, long precision) {
  std::size_t size = 1;
  for (int j = 0; j < max_parameters; ++j) {
    const auto extent = static_cast<std::size_t>(std::max(p.degree(j), 0L) + 1);
    if (j < variables) {
      extents_.push_back(extent);
      size *= extent;
    } else if (extent > 1) {
      throw std::domain_error("a residual depends on a parameter that has no range");
    }
  }
  coefficients_.resize(size);
  for (const Polynomial::Term& term : p.terms()) {
    std::size_t index = 0;
    for (std::size_t j = 0; j < extents_.size(); ++j) {
      index = index * extents_[j] + static_cast<std::size_t>(term.exponents[j]);
    }
    coefficients_[index] = Interval(term.coefficient, precision);
  }
}

std::size_t TaylorForm::stride(std::size_t variable) const {
  std::size_t result = 1;
  for (std::size_t j = variable + 1; j < extents_.size(); ++j) result *= extents_[j];
  return result;
}

/// visit(index, powers) for every coefficient.
template <class Visit>
void TaylorForm::for_each(Visit visit) const {
  std::vector<std::size_t> powers(extents_.size(), 0);
  for (std::size_t index = 0; index < coefficients_.size(); ++index) {
    visit(index, powers);
    for (std::size_t j = extents_.size(); j-- > 0;) {
      if (++powers[j] < extents_[j]) break;
      powers[j] = 0;
    }
  }
}

TaylorForm TaylorForm::shifted(std::span<const Interval> offset) const {
  TaylorForm result(*this);
  std::vector<Interval>& t = result.coefficients_;
  for (std::size_t j = 0; j < extents_.size(); ++j) {
    const std::size_t step = stride(j);
    const std::size_t block = step * extents_[j];
    for (std::size_t start = 0; start < t.size(); ++start) {
      if (start % block >= step) continue;
      // Horner's scheme along parameter j, repeated: the Taylor shift.
      for (std::size_t low = 0; low + 1 < extents_[j]; ++low) {
        for (std::size_t i = extents_[j] - 1; i-- > low;) {
          t[start + i * step] += offset[j] * t[start + (i + 1) * step];
        }
      }
    }
  }
  return result;
}

TaylorForm TaylorForm::scaled(std::span<const Interval> radius) const {
  TaylorForm result(*this);
  for_each([&](std::size_t index, const std::vector<std::size_t>& powers) {
    for (std::size_t j = 0; j < powers.size(); ++j) {
      if (powers[j] > 0) result.coefficients_[index] *= pow(radius[j], static_cast<long>(powers[j]));
    }
  });
  return result;
}

TaylorForm TaylorForm::derivative(int variable) const {
  const auto j = static_cast<std::size_t>(variable);
  const std::size_t step = stride(j);
  TaylorForm result;
  result.extents_ = extents_;
  if (extents_[j] > 1) --result.extents_[j];
  for_each([&](std::size_t index, const std::vector<std::size_t>& powers) {
    if (powers[j] >= result.extents_[j]) return;
    const bool is_constant = extents_[j] == 1;
    result.coefficients_.push_back(
        is_constant ? Interval(0) : Interval(static_cast<long>(powers[j] + 1)) * coefficients_[index + step]);
  });
  return result;
}

Interval TaylorForm::range(std::span<const Interval> radius) const {
  std::vector<std::vector<Interval>> powers_of_radius(extents_.size());
  for (std::size_t j = 0; j < extents_.size(); ++j) {
    for (std::size_t k = 0; k < extents_[j]; ++k) powers_of_radius[j].push_back(power_range(radius[j], k));
  }
  Interval total(0);
  for_each([&](std::size_t index, const std::vector<std::size_t>& powers) {
    Interval term = coefficients_[index];
    for (std::size_t j = 0; j < powers.size(); ++j) {
      if (powers[j] > 0) term *= powers_of_radius[j][powers[j]];
    }
    total += term;
  });
  return total;
}

Interval TaylorForm::slope(int variable) const {
  const auto j = static_cast<std::size_t>(variable);
  return extents_[j] > 1 ? coefficients_[stride(j)] : Interval(0);
}

TaylorForm TaylorForm::padded(const std::vector<std::size_t>& extents) const {
  if (extents == extents_) return *this;
  TaylorForm result;
  result.extents_ = extents;
  std::size_t size = 1;
  for (const std::size_t extent : extents) size *= extent;
  result.coefficients_.resize(size);
  for_each([&](std::size_t index, const std::vector<std::size_t>& powers) {
    std::size_t target = 0;
    for (std::size_t j = 0; j < powers.size(); ++j) target = target * extents[j] + powers[j];
    result.coefficients_[target] = coefficients_[index];
  });
  return result;
}

TaylorForm& TaylorForm::operator+=(const TaylorForm& o) {
  if (extents_ != o.extents_) throw std::logic_error("Taylor forms of different extents");
  for (std::size_t i = 0; i < coefficients_.size(); ++i) coefficients_[i] += o.coefficients_[i];
  return *this;
}

TaylorForm& TaylorForm::operator*=(const Interval& factor) {
  for (Interval& t : coefficients_) t *= factor;
  return *this;
}

Interval TaylorForm::least_on_cube() const {
  Interval result = coefficients_.front();
  for_each([&](std::size_t index, const std::vector<std::size_t>& powers) {
    if (index == 0) return;
    bool all_even = true;
    for (const std::size_t power : powers) all_even = all_even && power % 2 == 0;
    if (!all_even) {
      result -= abs(coefficients_[index]);
    } else if (!certainly_positive(coefficients_[index])) {
      result += min(coefficients_[index], Interval(0));
    }
  });
  return result;
}

double TaylorForm::influence(int variable) const {
  double total = 0;
  for_each([&](std::size_t index, const std::vector<std::size_t>& powers) {
    if (powers[static_cast<std::size_t>(variable)] > 0) total += std::abs(coefficients_[index].to_double());
  });
  return total;
}

TaylorFunction::TaylorFunction(const Polynomial& numerator, const Polynomial& denominator, int variables,
                               long precision)
    : numerator_(numerator, variables, precision),
      denominator_(denominator, variables, precision),
      has_denominator_(!denominator.is_constant() || !(denominator.constant() == Rational(1))) {}

namespace {

/// Ranges of a polynomial and its first two derivatives.
SecondOrder ranges(const TaylorForm& about_centre, std::span<const Interval> radius) {
  const auto n = static_cast<Eigen::Index>(radius.size());
  SecondOrder result{about_centre.range(radius), Vector<Interval>(n), Matrix<Interval>(n, n)};
  for (int j = 0; j < n; ++j) {
    const TaylorForm first = about_centre.derivative(j);
    result.gradient(j) = first.range(radius);
    for (int k = j; k < n; ++k)
      result.hessian(k, j) = result.hessian(j, k) = first.derivative(k).range(radius);
  }
  return result;
}

}  // namespace

SecondOrder TaylorFunction::over(std::span<const Interval> box) const {
  const std::vector<Interval> centre = centre_of(box);
  const std::vector<Interval> radius = radius_of(box);
  const TaylorForm above_form = numerator_.shifted(centre);
  SecondOrder above = ranges(above_form, radius);
  if (!has_denominator_) return above;
  const TaylorForm below_form = denominator_.shifted(centre);
  const SecondOrder below = ranges(below_form, radius);
  // f = p/q: grad f = (grad p - f grad q)/q, Hess f = (Hess p - grad f grad q' - grad q grad f' - f Hess
  // q)/q.
  SecondOrder f = above;
  f.value = above.value / below.value;
  const auto n = f.gradient.size();
  for (Eigen::Index j = 0; j < n; ++j) {
    f.gradient(j) = (above.gradient(j) - f.value * below.gradient(j)) / below.value;
  }
  // The mean-value form is sharper on small boxes.
  Interval by_slopes = above_form.constant() / below_form.constant();
  for (Eigen::Index j = 0; j < n; ++j) {
    by_slopes += f.gradient(j) * symmetric_hull(radius[static_cast<std::size_t>(j)]);
  }
  if (by_slopes.radius() < f.value.radius()) f.value = by_slopes;
  for (Eigen::Index j = 0; j < n; ++j) {
    for (Eigen::Index k = j; k < n; ++k) {
      f.hessian(j, k) = (above.hessian(j, k) - f.gradient(j) * below.gradient(k) -
                         below.gradient(j) * f.gradient(k) - f.value * below.hessian(j, k)) /
                        below.value;
      f.hessian(k, j) = f.hessian(j, k);
    }
  }
  return f;
}

std::vector<Interval> centre_of(std::span<const Interval> box) {
  std::vector<Interval> result;
  result.reserve(box.size());
  for (const Interval& x : box) result.push_back(x.center());
  return result;
}

std::vector<Interval> radius_of(std::span<const Interval> box) {
  std::vector<Interval> result;
  result.reserve(box.size());
  for (const Interval& x : box) {
    Interval radius;
    arb_get_rad_arb(radius.raw(), x.raw());
    result.push_back(radius.with_precision(x.precision()));
  }
  return result;
}

}  // namespace subdiv
