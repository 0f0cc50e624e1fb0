#include "optimize/local_minimum.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "optimize/common_zero.h"
#include "optimize/residual_functions.h"

namespace subdiv {
namespace {

/// What is assumed about the minimum before it is proved.
struct Guess {
  LocalModel model;
  std::vector<int> active;
  bool is_zero = false;
};

class Verifier {
 public:
  Verifier(const Problem& problem, const CommonForm& form, std::vector<double> near, long precision)
      : problem_(problem), form_(form), near_(std::move(near)), precision_(precision) {
    const double below = value(form.denominator);
    for (const Polynomial& p : form.numerators) values_.push_back(value(p) / below);
    order_.resize(values_.size());
    std::iota(order_.begin(), order_.end(), 0);
    const bool descending = problem.norm == Norm::linf;
    std::ranges::stable_sort(
        order_, [&](int a, int b) { return descending ? size(a) > size(b) : size(a) < size(b); });
    add_bounds();
  }

  std::optional<VerifiedMinimum> run() {
    if (problem_.norm != Norm::l2) {
      if (const auto guess = common_zero()) {
        if (auto minimum = verify(*guess)) return minimum;
      }
    }
    const std::size_t available = problem_.norm == Norm::l2     ? 0
                                  : problem_.norm == Norm::linf ? values_.size() - 1
                                                                : values_.size();
    const std::size_t most = std::min(available, near_.size() - bounds_.size());
    for (std::size_t kinks = 0; kinks <= most; ++kinks) {
      if (auto minimum = verify(guess(kinks))) return minimum;
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] int variables() const { return static_cast<int>(problem_.box.size()); }
  [[nodiscard]] double size(int k) const { return std::abs(values_[static_cast<std::size_t>(k)]); }
  [[nodiscard]] double value(const Polynomial& p) const { return p.evaluate<double>(near_); }
  [[nodiscard]] RationalFunction signed_residual(int k) const {
    const RationalFunction r = form_.residual(k);
    return values_[static_cast<std::size_t>(k)] < 0 ? -r : r;
  }

  /// Parameters that stand at an end of their range, as constraints u <= 0.
  void add_bounds() {
    is_bound_.assign(near_.size(), false);
    constexpr double close = 1e-9;
    for (std::size_t j = 0; j < near_.size(); ++j) {
      const Range& range = problem_.box[j];
      const double width = (range.upper - range.lower).to_double();
      const RationalFunction x = RationalFunction::variable(static_cast<int>(j));
      if (near_[j] - range.lower.to_double() <= close * width) {
        bounds_.push_back({RationalFunction(range.lower) - x, KinkKind::bound});
        is_bound_[j] = true;
      } else if (range.upper.to_double() - near_[j] <= close * width) {
        bounds_.push_back({x - RationalFunction(range.upper), KinkKind::bound});
        is_bound_[j] = true;
      }
    }
  }

  /// linf: one residual is the base, the next `kinks` largest attain the maximum with it. l1: the `kinks`
  /// smallest vanish.
  [[nodiscard]] Guess guess(std::size_t kinks) const {
    Guess result;
    result.model.variables = variables();
    result.model.kinks = bounds_;
    if (problem_.norm == Norm::linf) {
      result.model.base = signed_residual(order_[0]);
      result.active.push_back(order_[0]);
      for (std::size_t i = 1; i <= kinks; ++i) {
        result.model.kinks.push_back({signed_residual(order_[i]) - result.model.base, KinkKind::maximum});
        result.active.push_back(order_[i]);
      }
      return result;
    }
    Polynomial smooth;
    for (std::size_t i = 0; i < order_.size(); ++i) {
      const auto k = static_cast<std::size_t>(order_[i]);
      if (problem_.norm == Norm::l1 && i < kinks) {
        result.model.kinks.push_back({form_.residual(order_[i]), KinkKind::absolute});
        result.active.push_back(order_[i]);
      } else {
        smooth += Polynomial(values_[k] < 0 ? -1 : 1) * form_.numerators[k];
      }
    }
    result.model.base = RationalFunction(smooth) / RationalFunction(form_.denominator);
    return result;
  }

  /// All residuals vanish together: as many of them as there are parameters determine the point and span the
  /// others.
  [[nodiscard]] std::optional<Guess> common_zero() const {
    if (!all_vanish(values_)) return std::nullopt;
    const std::vector<int> basis = spanning_numerators(form_);
    if (basis.size() != near_.size()) return std::nullopt;
    Guess result;
    result.is_zero = true;
    result.model.variables = variables();
    for (const int k : basis) result.model.kinks.push_back({form_.residual(k), KinkKind::absolute});
    result.active.resize(form_.numerators.size());
    std::iota(result.active.begin(), result.active.end(), 0);
    return result;
  }

  /// Is the guess's critical point inside the box, and are its active residuals the ones that count there?
  [[nodiscard]] bool is_consistent(const Guess& guess, const CriticalPoint& point,
                                   const Interval& base) const {
    for (std::size_t j = 0; j < point.x.size(); ++j) {
      const Interval low(problem_.box[j].lower, precision_);
      const Interval high(problem_.box[j].upper, precision_);
      if (!is_bound_[j] && !(certainly_less(low, point.x[j]) && certainly_less(point.x[j], high)))
        return false;
    }
    if (guess.is_zero) return true;
    // A minimum near a point is not worse than that point: else the guess led elsewhere.
    constexpr double rounding = 1e-9;
    const double here = objective(problem_.norm == Norm::l2 ? Norm::l1 : problem_.norm, values_);
    if (base.to_double() > here + rounding * (here + rounding)) return false;
    if (problem_.norm == Norm::l2) return true;
    const Interval below = at(form_.denominator, point.x);
    for (std::size_t k = 0; k < form_.numerators.size(); ++k) {
      if (std::ranges::count(guess.active, static_cast<int>(k)) > 0) continue;
      const Interval r = at(form_.numerators[k], point.x) / below;
      const bool settled = problem_.norm == Norm::linf ? certainly_less(abs(r), base)
                           : values_[k] < 0            ? certainly_negative(r)
                                                       : certainly_positive(r);
      if (!settled) return false;
    }
    return problem_.norm == Norm::l1 || certainly_positive(base);
  }

  [[nodiscard]] Interval at(const Polynomial& p, const std::vector<Interval>& x) const {
    return TaylorForm(p, variables(), precision_).shifted(centre_of(x)).range(radius_of(x));
  }

  [[nodiscard]] std::optional<VerifiedMinimum> verify(const Guess& guess) const {
    const CompiledModel model(guess.model, precision_);
    const auto point = model.critical_point(near_);
    if (!point) return std::nullopt;
    const Interval base = model.base_value(point->x);
    if (!is_consistent(guess, *point, base)) return std::nullopt;
    const auto neighbourhood = largest_neighbourhood(model, *point);
    if (!neighbourhood) return std::nullopt;
    return VerifiedMinimum{*point, guess.is_zero ? Interval(0) : base, guess.active, *neighbourhood,
                           !bounds_.empty()};
  }

  /// The largest neighbourhood of a few shapes on which the proof succeeds: a box like the problem's, halved
  /// as often as needed, then each side doubled as far as it goes.
  [[nodiscard]] std::optional<Box> largest_neighbourhood(const CompiledModel& model,
                                                         const CriticalPoint& point) const {
    const auto neighbourhood = [&](const std::vector<int>& halvings) {
      Box box;
      for (std::size_t j = 0; j < halvings.size(); ++j) {
        const Rational centre = point.x[j].midpoint();
        const Range& range = problem_.box[j];
        const Rational radius = (range.upper - range.lower) * Rational::power_of_two(-halvings[j]);
        box.sides.push_back({centre - radius, centre + radius});
      }
      return box;
    };
    const auto proved = [&](const std::vector<int>& halvings) {
      return model.is_minimum_over(point, neighbourhood(halvings));
    };
    constexpr int most_halvings = 60;
    std::vector<int> halvings(problem_.box.size(), most_halvings);
    if (!proved(halvings)) return std::nullopt;
    int fails = 0;
    while (halvings[0] - fails > 1) {
      const std::vector<int> middle(halvings.size(), (halvings[0] + fails) / 2);
      if (proved(middle)) {
        halvings = middle;
      } else {
        fails = middle[0];
      }
    }
    for (int& exponent : halvings) {
      while (exponent > 0) {
        --exponent;
        if (proved(halvings)) continue;
        ++exponent;
        break;
      }
    }
    return neighbourhood(halvings);
  }

  const Problem& problem_;
  const CommonForm& form_;
  std::vector<double> near_;
  long precision_;
  std::vector<double> values_;  // of the residuals near the point
  std::vector<int> order_;      // linf: largest first; l1: smallest first
  std::vector<Kink> bounds_;
  std::vector<bool> is_bound_;
};

}  // namespace

std::optional<VerifiedMinimum> verify_minimum(const Problem& problem, const CommonForm& form,
                                              const std::vector<double>& near, long precision) {
  if (form.numerators.empty()) return std::nullopt;
  return Verifier(problem, form, near, precision).run();
}

}  // namespace subdiv
