#include "analysis/mesh/interval_polynomial.h"

#include <algorithm>

#include <Eigen/Eigenvalues>
#include <acb_poly.h>

namespace subdiv {
namespace {

IntervalPolynomial product(const IntervalPolynomial& a, const IntervalPolynomial& b) {
  IntervalPolynomial result(a.size() + b.size() - 1, Interval(0));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) add_product(result[i + j], a[i], b[j]);
  }
  return result;
}

/// Real roots, and one of each pair of complex ones, as exact numbers.
struct Root {
  Interval real;
  Interval imaginary;
};

std::vector<Root> roots_of(const IntervalPolynomial& p, bool fine) {
  std::vector<Root> result;
  if (fine) {
    IntervalPolynomial centre;
    for (const Interval& c : p) centre.push_back(c.center());
    if (const auto enclosed = enclosed_roots(centre)) {
      for (const ComplexRoot& z : *enclosed) {
        if (!certainly_negative(z.imaginary)) result.push_back({z.real.center(), z.imaginary.center()});
      }
      return result;
    }
  }
  for (const std::complex<double>& z : approximate_roots(p)) {
    if (z.imag() >= 0) result.push_back({Interval(z.real()), Interval(z.imag())});
  }
  return result;
}

/// A bound of |p(a + b i)|
Interval modulus_at(const IntervalPolynomial& p, const Interval& a, const Interval& b) {
  Interval real(0);
  Interval imaginary(0);
  for (std::size_t i = p.size(); i-- > 0;) {
    Interval next = real * a - imaginary * b + p[i];
    imaginary = real * b + imaginary * a;
    real = std::move(next);
  }
  return abs(real) + abs(imaginary);
}

}  // namespace

Interval value_at(const IntervalPolynomial& p, const Interval& x) {
  Interval sum(0);
  for (std::size_t i = p.size(); i-- > 0;) sum = sum * x + p[i];
  return sum;
}

Interval PolynomialFamily::value(const Interval& x) const {
  Interval centre = value_at(middle, x);
  if (half_width.is_exactly_zero()) return centre;
  return centre + Interval::hull(-half_width, half_width) * value_at(slope, x);
}

std::vector<std::complex<double>> approximate_roots(const IntervalPolynomial& p) {
  std::vector<double> c;
  for (const Interval& x : p) c.push_back(x.to_double());
  while (!c.empty() && c.back() == 0) c.pop_back();
  if (c.size() <= 1) return {};
  const auto n = static_cast<Eigen::Index>(c.size()) - 1;
  if (n == 1) return {{-c[0] / c[1], 0}};
  Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    companion(i, n - 1) = -c[static_cast<std::size_t>(i)] / c.back();
    if (i > 0) companion(i, i - 1) = 1;
  }
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(companion, false);
  return {solver.eigenvalues().data(), solver.eigenvalues().data() + n};
}

namespace {

/// Of a x^2 + b x + c by the formula: the larger real root first, the other from the product, so that roots
/// of very different size keep their digits. Nothing when the discriminant's sign or a's is open.
std::optional<std::vector<ComplexRoot>> quadratic_roots(const IntervalPolynomial& p) {
  const Interval& a = p[2];
  const Interval& b = p[1];
  const Interval& c = p[0];
  const Interval discriminant = b * b - Interval(4) * a * c;
  if (a.contains_zero()) return std::nullopt;
  const Interval half = -b / (Interval(2) * a);
  if (certainly_negative(discriminant)) {
    const Interval imaginary = abs(sqrt(-discriminant) / (Interval(2) * a));
    return {{{half, imaginary, 1}, {half, -imaginary, 1}}};
  }
  if (!certainly_positive(discriminant)) return std::nullopt;
  const Interval root = sqrt(discriminant);
  if (b.contains_zero()) {
    const Interval off = root / (Interval(2) * a);
    return {{{half + off, Interval(0), 1}, {half - off, Interval(0), 1}}};
  }
  const Interval sum = certainly_positive(b) ? -b - root : -b + root;  // no cancellation
  return {{{sum / (Interval(2) * a), Interval(0), 1}, {Interval(2) * c / sum, Interval(0), 1}}};
}

}  // namespace

std::optional<std::vector<ComplexRoot>> enclosed_roots(const IntervalPolynomial& p) {
  if (p.size() == 3) {
    if (auto roots = quadratic_roots(p)) return roots;
  }
  const auto n = static_cast<long>(p.size()) - 1;
  acb_poly_t poly;
  acb_poly_init(poly);
  long precision = Interval::default_precision;
  for (long i = 0; i <= n; ++i) {
    const Interval& c = p[static_cast<std::size_t>(i)];
    precision = std::max(precision, c.working_precision());
    acb_t value;
    acb_init(value);
    acb_set_arb(value, c.raw());
    acb_poly_set_coeff_acb(poly, i, value);
    acb_clear(value);
  }
  acb_ptr roots = _acb_vec_init(n);
  std::optional<std::vector<ComplexRoot>> result;
  if (acb_poly_degree(poly) == n &&
      (n == 0 || (acb_poly_find_roots(roots, poly, nullptr, 0, precision) == n &&
                  acb_poly_validate_real_roots(roots, poly, precision) != 0))) {
    result.emplace();
    for (long i = 0; i < n; ++i) {
      ComplexRoot root{Interval(0).with_precision(precision), Interval(0).with_precision(precision), 1};
      arb_set(root.real.raw(), acb_realref(roots + i));
      if (arb_contains_zero(acb_imagref(roots + i)) == 0) {
        arb_set(root.imaginary.raw(), acb_imagref(roots + i));
      }
      result->push_back(std::move(root));
    }
  }
  _acb_vec_clear(roots, n);
  acb_poly_clear(poly);
  return result;
}

RootCounter::RootCounter(PolynomialFamily family, bool fine) : p_(std::move(family)) {
  lead_ = p_.middle.back();
  if (lead_.contains_zero()) return;  // within() then proves nothing
  IntervalPolynomial q{lead_};
  for (const Root& z : roots_of(p_.middle, fine)) {
    if (z.imaginary.is_exactly_zero()) {
      q = product(q, {-z.real, Interval(1)});
      roots_.push_back({z.real, Interval(0), abs(z.real), Interval(0)});
    } else {
      const Interval square = z.real * z.real + z.imaginary * z.imaginary;
      q = product(q, {square, Interval(-2) * z.real, Interval(1)});
      roots_.push_back({z.real, z.imaginary, sqrt(square), Interval(0)});
      roots_.push_back({z.real, -z.imaginary, sqrt(square), Interval(0)});
    }
  }
  std::sort(roots_.begin(), roots_.end(),
            [](const Point& a, const Point& b) { return certainly_less(b.modulus, a.modulus); });
  for (const Point& z : roots_) moduli_.push_back(z.modulus);
  const bool point = p_.half_width.is_exactly_zero();
  // A member's leading coefficient may move by less than its size: then each can be scaled to the middle's.
  // (c + t d)/(1 + t d_n/c_n) - c = t (d - c d_n/c_n)/(1 + t d_n/c_n)
  const Interval lead_share = point ? Interval(0) : p_.slope.back() / lead_;
  const Interval smallest = Interval(1) - abs(lead_share) * p_.half_width;
  if (static_cast<int>(roots_.size()) != p_.degree() || !certainly_positive(smallest)) {
    lead_ = Interval(0);
    return;
  }
  width_ = p_.half_width / smallest;
  for (std::size_t i = 0; i < p_.middle.size(); ++i) {
    Interval bound = abs(p_.middle[i] - q[i]);
    if (!point) {
      offset_.push_back(p_.slope[i] - p_.middle[i] * lead_share);
      bound += abs(offset_.back()) * width_;
    }
    deviation_.push_back(std::move(bound));
  }
  find_discs();
}

void RootCounter::find_discs() {
  for (Point& z : roots_) {
    const Interval value =
        modulus_at(p_.middle, z.real, z.imaginary) + width_ * modulus_at(offset_, z.real, z.imaginary);
    Interval slope = abs(lead_);
    for (const Point& other : roots_) {
      if (&other == &z) continue;
      const Interval across = z.real - other.real;
      const Interval up = z.imaginary - other.imaginary;
      slope *= sqrt(across * across + up * up);
    }
    z.reach = Interval(p_.degree()) * value / slope;
  }
}

std::optional<int> RootCounter::within_discs(const Interval& radius) const {
  int inside = 0;
  for (const Point& z : roots_) {
    if (certainly_less(z.modulus + z.reach, radius)) {
      ++inside;
    } else if (!certainly_less(radius, z.modulus - z.reach)) {
      return std::nullopt;
    }
  }
  return inside;
}

std::optional<int> RootCounter::within_by_distance(const Interval& radius) const {
  Interval least = abs(lead_);
  int inside = 0;
  for (const Interval& modulus : moduli_) {
    if (certainly_less(modulus, radius)) {
      ++inside;
    } else if (!certainly_less(radius, modulus)) {
      return std::nullopt;
    }
    least *= abs(radius - modulus);
  }
  if (!certainly_less(value_at(deviation_, radius), least)) return std::nullopt;
  return inside;
}

int RootCounter::relative_sign(const Interval& x) const {
  if (lead_.contains_zero()) return 0;
  const Interval value = p_.value(x) * lead_;
  return certainly_positive(value) ? 1 : (certainly_negative(value) ? -1 : 0);
}

bool RootCounter::complex_beyond(const Interval& radius) const {
  if (lead_.contains_zero()) return false;
  return std::all_of(roots_.begin(), roots_.end(), [&](const Point& z) {
    return certainly_less(z.modulus + z.reach, radius) || certainly_less(z.reach, abs(z.imaginary));
  });
}

std::optional<int> RootCounter::within_a_gap(const Interval& radius) const {
  const std::optional<int> count = within_discs(radius);
  return count ? count : within_by_distance(radius);
}

std::optional<int> RootCounter::within(const Interval& radius) const {
  if (lead_.contains_zero()) return std::nullopt;
  if (const std::optional<int> count = within_a_gap(radius)) return count;
  const int n = p_.degree();
  const Interval inner =
      (n > 1 ? sqrt(moduli_[0] * moduli_[1]) : moduli_[0] * Interval(Rational(1, 2))).center();
  if (!certainly_less(inner, radius) || within_a_gap(inner) != n - 1) return std::nullopt;
  const int right = relative_sign(radius);
  const int left = relative_sign(-radius) * (n % 2 == 0 ? 1 : -1);
  if (right < 0 || left < 0) return n - 1;
  return right > 0 && left > 0 ? std::optional<int>(n) : std::nullopt;
}

}  // namespace subdiv
