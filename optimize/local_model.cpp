#include "optimize/local_model.h"

#include <Eigen/QR>

#include "schemes/algebra/elimination.h"

namespace subdiv {
namespace {

std::vector<Interval> to_box(const Vector<Interval>& x, Eigen::Index size) {
  return {x.data(), x.data() + size};
}

}  // namespace

/// Enclosures of everything over one box.
struct CompiledModel::Local {
  SecondOrder base;
  std::vector<SecondOrder> kinks;
};

CompiledModel::CompiledModel(const LocalModel& model, long precision)
    : precision_(precision), variables_(model.variables), base_(model.base, model.variables, precision) {
  for (const Kink& kink : model.kinks) {
    kinks_.emplace_back(kink.function, model.variables, precision);
    kinds_.push_back(kink.kind);
  }
}

CompiledModel::Local CompiledModel::over(std::span<const Interval> box) const {
  Local local{base_.over(box), {}};
  for (const TaylorFunction& kink : kinks_) local.kinks.push_back(kink.over(box));
  return local;
}

SquareSystem CompiledModel::critical_system() const {
  const auto n = static_cast<Eigen::Index>(variables_);
  const auto k = static_cast<Eigen::Index>(kinks_.size());
  SquareSystem system;
  system.value = [*this, n, k](const Vector<Interval>& at) {
    const Local local = over(to_box(at, n));
    Vector<Interval> result(n + k);
    result.head(n) = local.base.gradient;
    for (Eigen::Index i = 0; i < k; ++i) {
      const SecondOrder& u = local.kinks[static_cast<std::size_t>(i)];
      result(n + i) = u.value;
      for (Eigen::Index j = 0; j < n; ++j) result(j) += at(n + i) * u.gradient(j);
    }
    return result;
  };
  system.jacobian = [*this, n, k](const Vector<Interval>& at) {
    const Local local = over(to_box(at, n));
    Matrix<Interval> result = zero_matrix<Interval>(n + k, n + k);
    result.topLeftCorner(n, n) = local.base.hessian;
    for (Eigen::Index i = 0; i < k; ++i) {
      const SecondOrder& u = local.kinks[static_cast<std::size_t>(i)];
      for (Eigen::Index j = 0; j < n; ++j) {
        result(j, n + i) = result(n + i, j) = u.gradient(j);
        for (Eigen::Index l = 0; l < n; ++l) result(j, l) += at(n + i) * u.hessian(j, l);
      }
    }
    return result;
  };
  return system;
}

bool CompiledModel::conditions_hold(const Vector<Interval>& multipliers) const {
  Interval sum(0);
  bool has_maximum = false;
  for (std::size_t i = 0; i < kinds_.size(); ++i) {
    const Interval& m = multipliers(static_cast<Eigen::Index>(i));
    if (kinds_[i] == KinkKind::absolute) {
      if (!certainly_less(abs(m), Interval(1))) return false;
      continue;
    }
    if (!certainly_positive(m)) return false;
    if (kinds_[i] == KinkKind::maximum) {
      sum += m;
      has_maximum = true;
    }
  }
  return !has_maximum || certainly_less(sum, Interval(1));
}

std::optional<CriticalPoint> CompiledModel::critical_point(const std::vector<double>& near) const {
  const auto n = static_cast<Eigen::Index>(variables_);
  const auto k = static_cast<Eigen::Index>(kinks_.size());
  if (k > n) return std::nullopt;
  Vector<Interval> start(n + k);
  for (Eigen::Index j = 0; j < n; ++j) {
    start(j) = Interval(Rational::from_double(near[static_cast<std::size_t>(j)]), precision_);
  }
  // Multipliers by least squares, which Newton then improves.
  const Local local = over(to_box(start, n));
  Eigen::MatrixXd gradients(n, k);
  Eigen::VectorXd right(n);
  for (Eigen::Index j = 0; j < n; ++j) {
    right(j) = -local.base.gradient(j).to_double();
    for (Eigen::Index i = 0; i < k; ++i) {
      gradients(j, i) = local.kinks[static_cast<std::size_t>(i)].gradient(j).to_double();
    }
  }
  if (!gradients.allFinite() || !right.allFinite()) return std::nullopt;
  if (k > 0) {
    const Eigen::VectorXd multipliers = gradients.colPivHouseholderQr().solve(right);
    for (Eigen::Index i = 0; i < k; ++i) start(n + i) = Interval(multipliers(i)).with_precision(precision_);
  }
  const auto zero = isolate_zero(critical_system(), start);
  if (!zero || !conditions_hold(zero->enclosure.tail(k))) return std::nullopt;
  return CriticalPoint{
      to_box(zero->enclosure, n), {zero->enclosure.data() + n, zero->enclosure.data() + n + k}, zero->region};
}

bool CompiledModel::is_minimum_over(const CriticalPoint& point, const Box& neighbourhood) const {
  const auto k = static_cast<Eigen::Index>(kinks_.size());
  const auto contracted = krawczyk(critical_system(), point.region);
  if (!contracted) return false;
  for (Eigen::Index i = 0; i < point.region.size(); ++i) {
    const bool in_x = i < variables_;
    const Interval& claimed = in_x ? point.x[static_cast<std::size_t>(i)]
                                   : point.multipliers[static_cast<std::size_t>(i - variables_)];
    if (!(*contracted)(i).is_finite() || !point.region(i).contains_strictly((*contracted)(i))) return false;
    if (!claimed.overlaps((*contracted)(i)) || !point.region(i).contains(claimed)) return false;
  }
  for (std::size_t j = 0; j < point.x.size(); ++j) {
    const Range& side = neighbourhood.sides[j];
    if (!(side.lower <= point.x[j].lower() && point.x[j].upper() <= side.upper)) return false;
  }
  if (!conditions_hold(point.region.tail(k))) return false;
  if (kinks_.size() == static_cast<std::size_t>(variables_) && is_vertex_over(neighbourhood)) return true;
  const std::vector<Interval> natural = natural_penalties(point);
  for (const int strength : {4, 1, 16, 64}) {
    std::vector<Interval> penalties;
    for (const Interval& penalty : natural) penalties.push_back(Interval(strength) * penalty);
    if (is_convex_over(point, penalties, neighbourhood)) return true;
    if (natural.empty()) break;
  }
  return false;
}

bool CompiledModel::is_vertex_over(const Box& neighbourhood) const {
  const auto n = static_cast<Eigen::Index>(variables_);
  const Local local = over(neighbourhood.balls(precision_));
  Matrix<Interval> transposed(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      transposed(j, i) = local.kinks[static_cast<std::size_t>(i)].gradient(j);
      if (!transposed(j, i).is_finite()) return false;
    }
  }
  const auto inverse = approximate_inverse(transposed);
  if (!inverse) return false;
  // Preconditioned: (C A') m = -C grad g has a matrix near the identity.
  Matrix<Interval> matrix = zero_matrix<Interval>(n, n);
  Vector<Interval> right = Vector<Interval>::Constant(n, Interval(0));
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index l = 0; l < n; ++l) {
      right(i) -= (*inverse)(i, l) * local.base.gradient(l);
      for (Eigen::Index j = 0; j < n; ++j) matrix(i, j) += (*inverse)(i, l) * transposed(l, j);
    }
  }
  const auto multipliers = solve_linear(matrix, right);
  return multipliers && conditions_hold(*multipliers);
}

/// rho_i that give the penalty's curvature across a kink the size of the Lagrangian's Hessian at the point.
std::vector<Interval> CompiledModel::natural_penalties(const CriticalPoint& point) const {
  const Local local = over(point.x);
  Interval curvature(0);
  for (Eigen::Index e = 0; e < local.base.hessian.size(); ++e) {
    Interval entry = local.base.hessian.data()[e];
    for (std::size_t i = 0; i < kinks_.size(); ++i)
      entry += point.multipliers[i] * local.kinks[i].hessian.data()[e];
    curvature += abs(entry.center());
  }
  if (!certainly_positive(curvature)) curvature = Interval(1);
  std::vector<Interval> result;
  for (const SecondOrder& u : local.kinks) {
    Interval length(0);
    for (Eigen::Index j = 0; j < variables_; ++j) length += pow(u.gradient(j).center(), 2);
    result.push_back((curvature / length).center());
  }
  return result;
}

/// F >= G on a box: each slack outweighs its penalty there. With D_i = max(0, u) - u_i, u_0 = 0, for a
/// maximum: sum of m_i D_i >= 1/2 sum of rho_i u_i^2 since u_i^2 <= D_0^2 + D_i^2.
bool CompiledModel::majorises(const Local& local, const CriticalPoint& point,
                              const std::vector<Interval>& penalties) const {
  Interval highest(0);
  Interval rest(1);  // m_0
  Interval total(0);
  for (std::size_t i = 0; i < kinds_.size(); ++i) {
    if (kinds_[i] != KinkKind::maximum) continue;
    highest = max(highest, local.kinks[i].value);
    rest -= point.multipliers[i];
    total += penalties[i];
  }
  if (!certainly_at_most(highest * total, Interval(2) * rest)) return false;
  for (std::size_t i = 0; i < kinds_.size(); ++i) {
    const Interval& u = local.kinks[i].value;
    const Interval& m = point.multipliers[i];
    const Interval distance = kinds_[i] == KinkKind::absolute  ? abs(u)
                              : kinds_[i] == KinkKind::maximum ? highest - u
                                                               : -u;
    const Interval slack = kinds_[i] == KinkKind::absolute ? Interval(1) - abs(m) : m;
    if (!certainly_at_most(distance * penalties[i], Interval(2) * slack)) return false;
  }
  return true;
}

bool CompiledModel::is_convex_over(const CriticalPoint& point, const std::vector<Interval>& penalties,
                                   const Box& neighbourhood) const {
  constexpr int most_boxes = 64;
  const auto n = static_cast<Eigen::Index>(variables_);
  std::vector<Box> open{neighbourhood};
  for (int examined = 0; !open.empty(); ++examined) {
    if (examined == most_boxes) return false;
    const Box box = std::move(open.back());
    open.pop_back();
    const Local local = over(box.balls(precision_));
    Matrix<Interval> hessian = local.base.hessian;
    for (std::size_t i = 0; i < kinks_.size(); ++i) {
      const SecondOrder& u = local.kinks[i];
      const Interval weight = point.multipliers[i] + penalties[i] * u.value;
      for (Eigen::Index j = 0; j < n; ++j) {
        for (Eigen::Index l = 0; l < n; ++l) {
          hessian(j, l) += weight * u.hessian(j, l) + penalties[i] * u.gradient(j) * u.gradient(l);
        }
      }
    }
    if (majorises(local, point, penalties) && is_positive_definite(hessian)) continue;
    std::size_t widest = 0;
    for (std::size_t j = 1; j < box.sides.size(); ++j) {
      const auto share = [&](std::size_t side) {
        return (box.sides[side].upper - box.sides[side].lower) /
               (neighbourhood.sides[side].upper - neighbourhood.sides[side].lower);
      };
      if (share(j) > share(widest)) widest = j;
    }
    for (Box& half : box.halves(widest)) open.push_back(std::move(half));
  }
  return true;
}

bool is_positive_definite(Matrix<Interval> a) {
  const Eigen::Index n = a.rows();
  for (Eigen::Index p = 0; p < n; ++p) {
    if (!a(p, p).is_finite() || !certainly_positive(a(p, p))) return false;
    for (Eigen::Index i = p + 1; i < n; ++i) {
      const Interval factor = a(i, p) / a(p, p);
      for (Eigen::Index j = p + 1; j < n; ++j) a(i, j) -= factor * a(p, j);
    }
  }
  return true;
}

}  // namespace subdiv
