#include "optimize/common_zero.h"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>

#include "optimize/krawczyk.h"
#include "optimize/taylor_form.h"

namespace subdiv {
namespace {

/// The `count` parameters that the functions depend on best at a point: columns of a pivoted QR
/// factorisation.
std::vector<Eigen::Index> best_parameters(const std::vector<TaylorFunction>& functions,
                                          std::span<const Interval> near, Eigen::Index count) {
  Eigen::MatrixXd gradients(static_cast<Eigen::Index>(functions.size()),
                            static_cast<Eigen::Index>(near.size()));
  for (Eigen::Index i = 0; i < gradients.rows(); ++i) {
    const SecondOrder local = functions[static_cast<std::size_t>(i)].over(near);
    for (Eigen::Index j = 0; j < gradients.cols(); ++j) gradients(i, j) = local.gradient(j).to_double();
  }
  if (!gradients.allFinite()) return {};
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(gradients);
  std::vector<Eigen::Index> result;
  for (Eigen::Index i = 0; i < count; ++i) result.push_back(qr.colsPermutation().indices()(i));
  return result;
}

}  // namespace

bool all_vanish(std::span<const double> residuals) {
  constexpr double small = 1e-7;
  return std::ranges::all_of(residuals, [](double r) { return std::abs(r) < small; });
}

std::optional<std::vector<Interval>> zero_on_a_family(const CommonForm& form, const std::vector<Range>& box,
                                                      const std::vector<double>& near, long precision) {
  const std::vector<int> basis = spanning_numerators(form);
  if (basis.empty() || basis.size() >= near.size()) return std::nullopt;
  std::vector<TaylorFunction> functions;
  for (const int k : basis)
    functions.emplace_back(form.residual(k), static_cast<int>(near.size()), precision);
  std::vector<Interval> point;
  for (const double x : near) {
    // A short number close by: the zero that is found should be readable where it can be.
    const Rational close(1, 1000000);
    const Rational at = Rational::from_double(x);
    point.emplace_back(simplest_between(at - close, at + close), precision);
  }
  const auto count = static_cast<Eigen::Index>(basis.size());
  const std::vector<Eigen::Index> free = best_parameters(functions, point, count);
  if (free.empty()) return std::nullopt;
  const auto completed = [&](const Vector<Interval>& x) {
    std::vector<Interval> full = point;
    for (Eigen::Index i = 0; i < count; ++i) {
      full[static_cast<std::size_t>(free[static_cast<std::size_t>(i)])] = x(i);
    }
    return full;
  };
  SquareSystem system;
  system.value = [&](const Vector<Interval>& x) {
    Vector<Interval> result(count);
    for (Eigen::Index i = 0; i < count; ++i)
      result(i) = functions[static_cast<std::size_t>(i)].over(completed(x)).value;
    return result;
  };
  system.jacobian = [&](const Vector<Interval>& x) {
    Matrix<Interval> result(count, count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const SecondOrder local = functions[static_cast<std::size_t>(i)].over(completed(x));
      for (Eigen::Index j = 0; j < count; ++j)
        result(i, j) = local.gradient(free[static_cast<std::size_t>(j)]);
    }
    return result;
  };
  Vector<Interval> start(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    start(i) = point[static_cast<std::size_t>(free[static_cast<std::size_t>(i)])];
  }
  const auto zero = isolate_zero(system, start);
  if (!zero) return std::nullopt;
  std::vector<Interval> result = completed(zero->enclosure);
  for (std::size_t j = 0; j < result.size(); ++j) {
    if (result[j].lower() < box[j].lower || box[j].upper < result[j].upper()) return std::nullopt;
  }
  return result;
}

}  // namespace subdiv
