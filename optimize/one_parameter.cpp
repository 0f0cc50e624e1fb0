#include "optimize/one_parameter.h"

#include <algorithm>
#include <deque>
#include <memory>
#include <optional>

#include "optimize/residual_functions.h"
#include "schemes/algebra/univariate.h"

namespace subdiv {
namespace {

/// A sum of residuals whose signs are settled on a whole subtree, and those still free there.
struct Group {
  RationalFunction settled;  // l1: sum of sign_i r_i, added to the objective as it stands
  CompiledResidual compiled_settled;
  bool has_settled = false;
  std::vector<int> free;  // indices of the other residuals that matter
};

struct Node {
  Rational lower;
  Rational upper;
  std::shared_ptr<const Group> group;
};

/// The objective on one box: a lower bound, the value at the centre, and what can be settled for subboxes.
struct Bound {
  Interval at_centre;
  Interval below;  // only its lower end means anything
  std::vector<int> still_free;
  std::vector<std::pair<int, int>> newly_settled;  // residual, sign
};

/// Residuals that are equal, or each other's negatives, count once with a weight (l1, l2) or once (linf).
struct Distinct {
  std::vector<RationalFunction> functions;
  std::vector<int> weights;
  std::vector<int> representative;  // of each original residual
};

Distinct merge_duplicates(const std::vector<RationalFunction>& residuals) {
  Distinct result;
  for (const RationalFunction& r : residuals) {
    std::size_t i = 0;
    const RationalFunction negative = -r;
    // Masks are symmetric, so a residual's twin is usually among the few most recent or at the mirrored
    // place.
    for (; i < result.functions.size(); ++i) {
      if (result.functions[i] == r || result.functions[i] == negative) break;
    }
    if (i == result.functions.size()) {
      result.functions.push_back(r);
      result.weights.push_back(0);
    }
    ++result.weights[i];
    result.representative.push_back(static_cast<int>(i));
  }
  return result;
}

class Search {
 public:
  Search(const Problem& problem, const Options& options)
      : problem_(problem), options_(options), distinct_(merge_duplicates(problem.residuals)) {
    if (problem.norm == Norm::l2) combine_squares();
    if (problem.norm == Norm::l1) apply_weights();
    for (const RationalFunction& f : distinct_.functions)
      compiled_.push_back(compile(f, 1, options.precision));
  }

  Summary run(const std::vector<double>& candidates);

 private:
  void combine_squares() {
    RationalFunction total;
    for (std::size_t i = 0; i < distinct_.functions.size(); ++i) {
      total += RationalFunction(distinct_.weights[i]) * distinct_.functions[i] * distinct_.functions[i];
    }
    distinct_.functions = {total};
  }
  void apply_weights() {
    for (std::size_t i = 0; i < distinct_.functions.size(); ++i) {
      distinct_.functions[i] *= RationalFunction(distinct_.weights[i]);
    }
  }

  [[nodiscard]] Interval ball(const Rational& lower, const Rational& upper) const {
    return Interval::hull(lower, upper, options_.precision);
  }
  [[nodiscard]] Interval objective_at(const Interval& x) const;
  [[nodiscard]] Bound bound(const Node& node) const;
  [[nodiscard]] std::shared_ptr<const Group> narrow(const std::shared_ptr<const Group>& group,
                                                    const Bound& bound) const;
  [[nodiscard]] bool has_pole() const;
  [[nodiscard]] int slope_sign(const Interval& x) const;
  [[nodiscard]] UnivariatePolynomial common_factor() const;
  [[nodiscard]] std::optional<RationalFunction> defining_function(const Interval& x,
                                                                  std::vector<int>& active) const;
  [[nodiscard]] std::optional<RationalFunction> kink_of_maximum(const Interval& x,
                                                                std::vector<int>& active) const;
  [[nodiscard]] std::optional<RationalFunction> critical_point_of_sum(const Interval& x,
                                                                      std::vector<int>& active) const;
  void describe_minimiser(const Rational& lower, const Rational& upper, Summary& summary) const;

  const Problem& problem_;
  const Options& options_;
  Distinct distinct_;
  std::vector<CompiledResidual> compiled_;
};

Interval value(const CompiledFunction& f, const Interval& x) { return f.evaluate(std::span(&x, 1)); }

Interval Search::objective_at(const Interval& x) const {
  Interval total(0);
  for (const CompiledResidual& r : compiled_) {
    const Interval v = value(r.value, x);
    if (problem_.norm == Norm::linf) {
      total = max(total, abs(v));
    } else {
      total += problem_.norm == Norm::l1 ? abs(v) : v;
    }
  }
  return total;
}

bool Search::has_pole() const {
  // Denominators are checked exactly: no root in the closed range.
  for (const RationalFunction& f : distinct_.functions) {
    const Polynomial below = f.denominator();
    if (below.is_constant()) continue;
    if (count_roots(UnivariatePolynomial(below, 0), problem_.box[0].lower, problem_.box[0].upper) > 0)
      return true;
  }
  return false;
}

Bound Search::bound(const Node& node) const {
  const Interval box = ball(node.lower, node.upper);
  const Interval centre = Interval((node.lower + node.upper) / Rational(2), options_.precision);
  const Interval offset = box - centre;
  Bound result;
  Interval constant(0);  // sum of the settled parts at the centre, and their slope over the box
  Interval slope(0);
  if (node.group->has_settled) {
    constant = value(node.group->compiled_settled.value, centre);
    slope = value(node.group->compiled_settled.gradient[0], box);
    result.at_centre = constant;
  }
  std::vector<std::pair<int, Interval>> upper_bounds;
  for (const int i : node.group->free) {
    const CompiledResidual& r = compiled_[static_cast<std::size_t>(i)];
    const Interval at_centre = value(r.value, centre);
    const Interval derivative = value(r.gradient[0], box);
    const Interval range = at_centre + derivative * offset;
    if (problem_.norm == Norm::linf) {
      result.at_centre = max(result.at_centre, abs(at_centre));
      const Interval magnitude = abs(range);
      result.below = max(result.below, Interval(magnitude.is_finite() ? magnitude.lower() : Rational(0),
                                                options_.precision));
      upper_bounds.emplace_back(i, magnitude);
      continue;
    }
    const int sign = problem_.norm == Norm::l2 || certainly_positive(range) ? 1
                     : certainly_negative(range)                            ? -1
                                                                            : 0;
    result.at_centre += problem_.norm == Norm::l2 ? at_centre : abs(at_centre);
    if (sign == 0) {
      result.still_free.push_back(i);
    } else {
      constant += Interval(sign) * at_centre;
      slope += Interval(sign) * derivative;
      result.newly_settled.emplace_back(i, sign);
    }
  }
  if (problem_.norm == Norm::linf) {
    for (const auto& [i, magnitude] : upper_bounds) {
      if (!certainly_less(magnitude, result.below)) result.still_free.push_back(i);
    }
  } else {
    result.below = constant + slope * offset;
  }
  return result;
}

std::shared_ptr<const Group> Search::narrow(const std::shared_ptr<const Group>& group,
                                            const Bound& bound) const {
  // Re-grouping costs exact additions: worth it when it at least halves the list.
  if (problem_.norm == Norm::l2 || 2 * bound.still_free.size() > group->free.size()) return group;
  auto next = std::make_shared<Group>();
  next->free = bound.still_free;
  if (problem_.norm == Norm::l1) {
    next->settled = group->settled;
    for (const auto& [i, sign] : bound.newly_settled) {
      next->settled += RationalFunction(sign) * distinct_.functions[static_cast<std::size_t>(i)];
    }
    next->compiled_settled = compile(next->settled, 1, options_.precision);
    next->has_settled = true;
  }
  return next;
}

/// 1 or -1 when the objective strictly rises or falls on the whole of x, 0 when that is not known.
int Search::slope_sign(const Interval& x) const {
  const bool is_maximum = problem_.norm == Norm::linf;
  Interval largest(0);
  if (is_maximum) {
    for (const CompiledResidual& r : compiled_) {
      largest = max(largest, Interval(abs(value(r.value, x)).lower(), options_.precision));
    }
  }
  Interval total(0);
  bool rising = true;
  bool falling = true;
  for (const CompiledResidual& r : compiled_) {
    const Interval v = value(r.value, x);
    if (is_maximum && certainly_less(abs(v), largest)) continue;
    const Interval derivative = value(r.gradient[0], x);
    Interval slope = derivative;
    if (problem_.norm != Norm::l2 && !certainly_positive(v)) {
      slope = certainly_negative(v) ? -derivative : Interval::hull(derivative, -derivative);
    }
    total += slope;
    rising = rising && certainly_positive(slope);
    falling = falling && certainly_negative(slope);
  }
  if (!is_maximum) {
    rising = certainly_positive(total);
    falling = certainly_negative(total);
  }
  return rising ? 1 : falling ? -1 : 0;
}

/// On x: is the maximum attained by an increasing and a decreasing function only, or by one convex function?
/// Then the minimiser is the zero of the function returned.
std::optional<RationalFunction> Search::kink_of_maximum(const Interval& x, std::vector<int>& active) const {
  Interval largest(0);
  std::vector<Interval> magnitudes;
  for (const CompiledResidual& r : compiled_) {
    magnitudes.push_back(abs(value(r.value, x)));
    largest = max(largest, Interval(magnitudes.back().lower(), options_.precision));
  }
  std::vector<RationalFunction> rising;
  std::vector<RationalFunction> falling;
  std::vector<RationalFunction> flat;
  for (std::size_t i = 0; i < compiled_.size(); ++i) {
    if (certainly_less(magnitudes[i], largest)) continue;
    active.push_back(static_cast<int>(i));
    const Interval v = value(compiled_[i].value, x);
    if (v.contains_zero()) return std::nullopt;
    const RationalFunction f = certainly_positive(v) ? distinct_.functions[i] : -distinct_.functions[i];
    const Interval slope = value(compiled_[i].gradient[0], x) * Interval(certainly_positive(v) ? 1 : -1);
    (certainly_positive(slope) ? rising : certainly_negative(slope) ? falling : flat).push_back(f);
  }
  if (flat.empty() && rising.size() == 1 && falling.size() == 1) return rising[0] - falling[0];
  if (flat.size() == 1 && rising.empty() && falling.empty()) {
    RationalFunction derivative = flat[0].derivative(0);
    const CompiledFunction second(derivative.derivative(0), 1, options_.precision);
    if (certainly_positive(value(second, x))) return derivative;
  }
  return std::nullopt;
}

/// l1 and l2 on x: a smooth strictly convex sum, or one vanishing residual whose slope outweighs the rest.
std::optional<RationalFunction> Search::critical_point_of_sum(const Interval& x,
                                                              std::vector<int>& active) const {
  RationalFunction smooth;
  std::vector<std::size_t> kinks;
  for (std::size_t i = 0; i < compiled_.size(); ++i) {
    const Interval v = value(compiled_[i].value, x);
    if (problem_.norm == Norm::l2 || certainly_positive(v)) {
      smooth += distinct_.functions[i];
    } else if (certainly_negative(v)) {
      smooth -= distinct_.functions[i];
    } else if (!distinct_.functions[i].is_zero()) {
      kinks.push_back(i);
    }
  }
  RationalFunction derivative = smooth.derivative(0);
  if (kinks.empty()) {
    const CompiledFunction second(derivative.derivative(0), 1, options_.precision);
    return certainly_positive(value(second, x)) ? std::optional(derivative) : std::nullopt;
  }
  if (kinks.size() > 1) return std::nullopt;
  active.push_back(static_cast<int>(kinks[0]));
  const Interval slope = value(CompiledFunction(derivative, 1, options_.precision), x);
  if (!certainly_less(abs(slope), abs(value(compiled_[kinks[0]].gradient[0], x)))) return std::nullopt;
  return distinct_.functions[kinks[0]];
}

/// The greatest common divisor of all residuals, whose roots make the objective 0.
UnivariatePolynomial Search::common_factor() const {
  UnivariatePolynomial common;
  for (const RationalFunction& f : distinct_.functions) {
    common = gcd(common, UnivariatePolynomial(f.numerator(), 0));
    if (common.degree() == 0) break;
  }
  return common;
}

std::optional<RationalFunction> Search::defining_function(const Interval& x, std::vector<int>& active) const {
  if (const UnivariatePolynomial common = common_factor();
      common.degree() > 0 && count_roots(common, x.lower(), x.upper()) == 1) {
    // Every residual vanishes there: nothing can be better.
    for (std::size_t i = 0; i < distinct_.functions.size(); ++i) active.push_back(static_cast<int>(i));
    RationalFunction result;
    for (long i = common.degree(); i >= 0; --i) {
      result = result * RationalFunction::variable(0) + RationalFunction(common.coefficient(i));
    }
    return result;
  }
  return problem_.norm == Norm::linf ? kink_of_maximum(x, active) : critical_point_of_sum(x, active);
}

/// The exact root in [lower, upper] of the polynomial that defines the minimiser, when it is unique there.
void Search::describe_minimiser(const Rational& lower, const Rational& upper, Summary& summary) const {
  constexpr long largest_degree = 32;
  constexpr std::size_t longest_text = 160;
  const Interval x = ball(lower, upper);
  std::vector<int> active;
  const auto function = defining_function(x, active);
  if (!function || function->is_zero()) return;
  summary.termination = Termination::proved;
  summary.message = "the minimiser is unique and nothing better lies in the range";
  for (std::size_t i = 0; i < distinct_.representative.size(); ++i) {
    if (problem_.norm != Norm::l2 && std::ranges::count(active, distinct_.representative[i]) > 0) {
      summary.active.push_back(static_cast<int>(i));
    }
  }
  for (const auto& [factor, multiplicity] : factor(UnivariatePolynomial(function->numerator(), 0))) {
    if (count_roots(factor, lower, upper) != 1) continue;
    if (factor.degree() > largest_degree) return;
    for (const RealRoot& root : real_roots(factor)) {
      if (root.value < Algebraic(lower) || root.value > Algebraic(upper)) continue;
      Enclosure& minimiser = summary.minimiser[0];
      const Enclosure found = exact(root.value, "root of a polynomial over Q that the active residuals give");
      if (root.value.is_rational()) {
        minimiser = found;
        const Rational at = root.value.to_rational();
        Rational total;
        const std::vector<Rational> point{at};
        for (const RationalFunction& f : distinct_.functions) {
          const Rational v = abs(f.evaluate<Rational>(point));
          total = problem_.norm == Norm::linf ? std::max(total, v) : total + v;
        }
        summary.minimum = exact(total, "exact value at the minimiser");
      } else {
        minimiser.lower = std::max(minimiser.lower, found.lower);
        minimiser.upper = std::min(minimiser.upper, found.upper);
        if (found.exact.size() <= longest_text) {
          minimiser.exact = found.exact;
          minimiser.rigour = Rigour::exact;
        }
        const Interval value_there = objective_at(root.value.to_interval(options_.precision));
        summary.minimum = certified(value_there, summary.method);
      }
      return;
    }
  }
}

Summary Search::run(const std::vector<double>& candidates) {
  Summary summary;
  summary.method = "branch and bound with mean-value forms";
  const Range& range = problem_.box[0];
  if (has_pole()) {
    summary.termination = Termination::pole_in_box;
    summary.message = "a residual has a pole in the range";
    return summary;
  }
  auto root = std::make_shared<Group>();
  for (std::size_t i = 0; i < compiled_.size(); ++i) root->free.push_back(static_cast<int>(i));
  Interval best = objective_at(Interval(range.lower, options_.precision));
  best = min(best, objective_at(Interval(range.upper, options_.precision)));
  for (const double candidate : candidates) {
    const Rational at = std::clamp(Rational::from_double(candidate), range.lower, range.upper);
    best = min(best, objective_at(Interval(at, options_.precision)));
  }
  std::deque<Node> queue{{range.lower, range.upper, root}};
  const Rational leaf_width = options_.width / Rational(64);
  std::vector<Node> leaves;
  while (!queue.empty()) {
    const Node node = std::move(queue.front());
    queue.pop_front();
    const Bound b = bound(node);
    ++summary.boxes;
    best = min(best, b.at_centre);
    // Strictly worse than a value that is attained: the box holds no minimiser.
    if (certainly_less(best, b.below)) continue;
    if (node.upper - node.lower <= leaf_width) {
      leaves.push_back(node);
      continue;
    }
    if (summary.boxes >= options_.max_boxes) {
      leaves.push_back(node);
      for (Node& rest : queue) leaves.push_back(std::move(rest));
      queue.clear();
      summary.termination = Termination::out_of_boxes;
      break;
    }
    const auto group = narrow(node.group, b);
    const Rational middle = (node.lower + node.upper) / Rational(2);
    queue.push_back({node.lower, middle, group});
    queue.push_back({middle, node.upper, group});
  }
  std::erase_if(leaves, [&](const Node& leaf) { return certainly_less(best, bound(leaf).below); });
  Rational lower = leaves.front().lower;
  Rational upper = leaves.front().upper;
  for (const Node& leaf : leaves) {
    lower = std::min(lower, leaf.lower);
    upper = std::max(upper, leaf.upper);
  }
  summary.minimiser = {certified(lower, upper, summary.method)};
  // Boxes left out are strictly worse, so the least lower bound of the leaves holds for the whole range.
  Rational least = best.upper();
  for (const Node& leaf : leaves) {
    const Interval below = bound(leaf).below;
    least = std::min(least, below.is_finite() ? below.lower() : Rational(0));
  }
  summary.minimum = certified(std::max(least, Rational(0)), best.upper(), summary.method);
  if (summary.termination == Termination::out_of_boxes) {
    summary.minimiser[0].status = Status::out_of_depth;
    summary.minimum.status = Status::out_of_depth;
    summary.message = "branch and bound ran out of boxes";
    return summary;
  }
  summary.termination = Termination::not_isolated;
  summary.message = "the minimiser is enclosed, its uniqueness is not proved";
  if (upper - lower > options_.width) {
    summary.termination = Termination::not_unique;
    summary.message = "several minimisers, or a minimum too flat to separate at this width";
  } else if (const int slope = slope_sign(ball(lower, upper));
             (slope > 0 && lower == range.lower) || (slope < 0 && upper == range.upper)) {
    const Rational end = slope > 0 ? lower : upper;
    summary.termination = Termination::proved;
    summary.minimiser = {exact(end, "end of the range, by monotonicity")};
    summary.minimum = certified(objective_at(Interval(end, options_.precision)), summary.method);
    summary.message = "the objective is monotone at that end of the range: widen it to look further";
  } else {
    describe_minimiser(lower, upper, summary);
  }
  return summary;
}

}  // namespace

Summary minimise_one_parameter(const Problem& problem, const Options& options,
                               const std::vector<double>& candidates) {
  return Search(problem, options).run(candidates);
}

}  // namespace subdiv
