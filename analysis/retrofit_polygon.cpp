#include "analysis/retrofit_polygon.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include "schemes/input_error.h"

namespace subdiv {
namespace {

using Arrays = std::vector<std::vector<double>>;

struct Complex {
  Interval real;
  Interval imaginary;
};

/// p(e^{iw}) by Horner's rule, up to a factor of modulus 1.
Complex on_unit_circle(const Laurent<Interval>& p, const Complex& z) {
  Complex value{Interval(0), Interval(0)};
  for (int j = p.last(); j >= p.first(); --j) {
    Interval real = value.real * z.real - value.imaginary * z.imaginary + p[j];
    value = {std::move(real), value.real * z.imaginary + value.imaginary * z.real};
  }
  return value;
}

/// A square that is known not to be negative.
Interval modulus(const Complex& z) {
  const Interval square = z.real * z.real + z.imaginary * z.imaginary;
  Interval result = square;
  arb_sqrtpos(result.raw(), square.raw(), square.working_precision());
  return result;
}

std::string shown(const Interval& x) {
  constexpr int digits = 6;
  return to_significant(x.midpoint(), digits);
}

void require_target(const Polyline& target) {
  if (!target.topology.closed) {
    throw InputError("retrofitting needs a closed polygon, this one is open; close it");
  }
  if (target.topology.points == 0 || target.coordinates.empty()) {
    throw InputError("retrofitting needs a polygon of at least 1 point, this one has none");
  }
  for (const std::vector<double>& c : target.coordinates) {
    const auto bad = std::ranges::find_if(c, [](double x) { return !std::isfinite(x); });
    if (bad != c.end()) {
      throw InputError("retrofitting needs finite coordinates: point " + std::to_string(bad - c.begin()) +
                       " has none");
    }
  }
}

std::string points_text(std::size_t n) {
  return "closed loops of " + std::to_string(n) + (n == 1 ? " point" : " points");
}

Laurent<double> rounded(const Laurent<Interval>& mask) {
  return map_coefficients(mask, [](const Interval& x) { return x.to_double(); });
}

/// C - L P for one coordinate.
std::vector<double> misses(const Laurent<double>& mask, const std::vector<double>& current,
                           const std::vector<double>& target) {
  const auto n = static_cast<long long>(current.size());
  std::vector<double> result(target);
  for (int j = mask.first(); j <= mask.last(); ++j) {
    const double weight = mask[j];
    auto from = static_cast<std::size_t>(((j % n) + n) % n);
    for (std::size_t i = 0; i < result.size(); ++i) {
      result[i] -= weight * current[from];
      if (++from == current.size()) from = 0;
    }
  }
  return result;
}

Arrays misses(const Laurent<double>& mask, const Arrays& current, const Arrays& target) {
  Arrays result;
  for (std::size_t c = 0; c < target.size(); ++c) result.push_back(misses(mask, current[c], target[c]));
  return result;
}

double largest_length(const Arrays& vectors) {
  double largest = 0;
  for (std::size_t i = 0; i < vectors.front().size(); ++i) {
    double length = 0;
    for (const std::vector<double>& c : vectors) length = std::hypot(length, c[i]);
    largest = std::max(largest, length);
  }
  return largest;
}

void require_convergence(const LoopSpectrum& spectrum, std::size_t n) {
  if (spectrum.converges()) return;
  throw InputError("retrofitting by iteration does not converge on " + points_text(n) +
                   ": a step multiplies errors by " + shown(spectrum.rate) + ", which is not below 1; " +
                   (spectrum.solvable() ? "solve directly, that works here"
                                        : "the direct system is singular, too; choose another scheme"));
}

/// How many steps exact arithmetic needs at most.
double step_bound(double first_residual, std::size_t n, const RetrofitOptions& options, double rate) {
  if (first_residual <= options.tolerance) return 0;
  if (rate <= 0) return 1;
  return std::ceil(std::log(options.tolerance / (std::sqrt(static_cast<double>(n)) * first_residual)) /
                   std::log(rate));
}

}  // namespace

LoopSpectrum loop_spectrum(const Laurent<Interval>& limit_mask, std::size_t n) {
  if (n == 0) throw std::domain_error("a closed loop has at least one point");
  const Laurent<Interval> error = Laurent<Interval>(1) - limit_mask;
  LoopSpectrum result{};
  for (std::size_t k = 0; k <= n / 2; ++k) {  // w and -w give the same moduli
    const Interval w =
        pi() * Interval(Rational(2 * static_cast<std::int64_t>(k), static_cast<std::int64_t>(n)));
    const Complex z = k == 0 ? Complex{Interval(1), Interval(0)} : Complex{cos(w), sin(w)};
    const Interval gain = modulus(on_unit_circle(limit_mask, z));
    const Interval rate = modulus(on_unit_circle(error, z));
    result.rate = k == 0 ? rate : max(result.rate, rate);
    result.smallest = k == 0 ? gain : min(result.smallest, gain);
    result.largest = k == 0 ? gain : max(result.largest, gain);
  }
  return result;
}

Retrofit retrofit_by_iteration(const Laurent<Interval>& limit_mask, const Polyline& target,
                               const RetrofitOptions& options) {
  require_target(target);
  if (!(options.tolerance > 0)) throw InputError("retrofitting needs a tolerance above 0");
  const std::size_t n = target.topology.points;
  Retrofit result{target, 0, 0, loop_spectrum(limit_mask, n)};
  require_convergence(result.spectrum, n);
  const Laurent<double> mask = rounded(limit_mask);
  Arrays& current = result.polygon.coordinates;
  Arrays miss = misses(mask, current, target.coordinates);
  result.residual = largest_length(miss);
  const double bound = step_bound(result.residual, n, options, result.spectrum.rate.to_double());
  while (result.residual > options.tolerance) {
    if (result.iterations >= options.max_iterations) {
      throw InputError("retrofitting: " + std::to_string(result.iterations) +
                       " iterations are not enough, each multiplies errors by " +
                       shown(result.spectrum.rate) + " at worst; solve directly or allow more");
    }
    if (static_cast<double>(result.iterations) > bound + 1) {
      throw InputError(fmt::format(
          "retrofitting: rounding keeps the limit points {:g} away; choose a larger tolerance than {:g}",
          result.residual, options.tolerance));
    }
    for (std::size_t c = 0; c < current.size(); ++c) {
      for (std::size_t i = 0; i < n; ++i) current[c][i] += miss[c][i];
    }
    miss = misses(mask, current, target.coordinates);
    result.residual = largest_length(miss);
    ++result.iterations;
  }
  return result;
}

Retrofit retrofit_directly(const Laurent<Interval>& limit_mask, const Polyline& target) {
  require_target(target);
  const std::size_t n = target.topology.points;
  Retrofit result{target, 0, 0, loop_spectrum(limit_mask, n)};
  if (!result.spectrum.solvable()) {
    throw InputError("retrofitting: the limit points of " + points_text(n) +
                     " do not determine their control points, the direct system is singular; choose another "
                     "scheme or number of points");
  }
  const Laurent<double> mask = rounded(limit_mask);
  const auto size = static_cast<Eigen::Index>(n);
  std::vector<Eigen::Triplet<double, Eigen::Index>> entries;
  for (Eigen::Index i = 0; i < size; ++i) {
    for (int j = mask.first(); j <= mask.last(); ++j)
      entries.emplace_back(i, (((i + j) % size) + size) % size, mask[j]);
  }
  Eigen::SparseMatrix<double> system(size, size);
  system.setFromTriplets(entries.begin(), entries.end());  // adds up entries at the same place
  const Eigen::SparseLU<Eigen::SparseMatrix<double>> factors(system);
  if (factors.info() != Eigen::Success) throw InputError("retrofitting: " + factors.lastErrorMessage());
  for (std::vector<double>& c : result.polygon.coordinates) {
    const Eigen::VectorXd solution = factors.solve(Eigen::Map<const Eigen::VectorXd>(c.data(), size));
    c.assign(solution.begin(), solution.end());
  }
  result.residual = largest_length(misses(mask, result.polygon.coordinates, target.coordinates));
  return result;
}

}  // namespace subdiv
