#include "optimize/several_parameters.h"

#include <algorithm>

#include "optimize/common_form.h"
#include "optimize/common_zero.h"
#include "optimize/exclusion.h"
#include "optimize/local_minimum.h"

namespace subdiv {
namespace {

const std::string method = "Krawczyk and branch and bound";

class Minimiser {
 public:
  Minimiser(const Problem& problem, const Options& options)
      : problem_(problem),
        options_(options),
        residuals_(common_form(problem)),
        form_(objective_form(problem, residuals_)) {}

  Summary run(const std::vector<LocalMinimum>& candidates);

 private:
  /// Branch and bound works on short numbers: a box near the level is split, not computed more precisely.
  static constexpr long search_precision = 128;

  void add(const std::vector<double>& near);
  void keep_best();
  [[nodiscard]] Rational level() const;
  [[nodiscard]] Summary stopped(Termination termination, std::string message) const;
  [[nodiscard]] Summary conclude() const;
  [[nodiscard]] std::optional<Summary> zero_of_many(const LocalMinimum& candidate) const;
  [[nodiscard]] std::vector<int> active_residuals(const VerifiedMinimum& minimum) const;

  const Problem& problem_;
  const Options& options_;
  CommonForm residuals_;
  CommonForm form_;
  std::vector<VerifiedMinimum> found_;  // none certainly worse than another
  int boxes_ = 0;
};

bool same_point(const VerifiedMinimum& a, const VerifiedMinimum& b) {
  for (std::size_t j = 0; j < a.point.x.size(); ++j) {
    if (!a.point.x[j].overlaps(b.point.x[j])) return false;
  }
  return true;
}

/// Verifies the minimum near a point, with more bits until it is narrow enough, and keeps it when it may be
/// the best.
void Minimiser::add(const std::vector<double>& near) {
  for (long precision = options_.precision; precision <= options_.max_precision; precision *= 2) {
    auto minimum = verify_minimum(problem_, form_, near, precision);
    if (!minimum) continue;
    const bool narrow = std::ranges::all_of(
        minimum->point.x, [&](const Interval& x) { return x.upper() - x.lower() <= options_.width; });
    if (!narrow && precision * 2 <= options_.max_precision) continue;
    const bool known =
        std::ranges::any_of(found_, [&](const VerifiedMinimum& m) { return same_point(m, *minimum); });
    if (!known) found_.push_back(std::move(*minimum));
    keep_best();
    return;
  }
}

void Minimiser::keep_best() {
  const auto best = std::ranges::min_element(found_, [](const VerifiedMinimum& a, const VerifiedMinimum& b) {
    return a.value.upper() < b.value.upper();
  });
  const Interval value = best->value;
  std::erase_if(found_, [&](const VerifiedMinimum& m) { return certainly_less(value, m.value); });
}

/// A number that the minimum does not exceed.
Rational Minimiser::level() const {
  Rational least = found_.front().value.upper();
  for (const VerifiedMinimum& m : found_) least = std::min(least, m.value.upper());
  return least;
}

std::vector<int> Minimiser::active_residuals(const VerifiedMinimum& minimum) const {
  std::vector<int> result;
  for (const int k : minimum.active) {
    for (const int i : form_.members(k)) result.push_back(i);
  }
  for (std::size_t i = 0; minimum.value.is_exactly_zero() && i < form_.representative.size(); ++i) {
    if (form_.representative[i] < 0) result.push_back(static_cast<int>(i));
  }
  std::ranges::sort(result);
  return result;
}

Summary Minimiser::stopped(Termination termination, std::string message) const {
  Summary summary;
  summary.termination = termination;
  summary.method = method;
  summary.message = std::move(message);
  summary.boxes = boxes_;
  return summary;
}

/// The summary when nothing outside the neighbourhoods can be as good as the level.
Summary Minimiser::conclude() const {
  Summary summary =
      stopped(Termination::proved, "the minimiser is unique and nothing better lies in the box");
  const VerifiedMinimum& first = found_.front();
  Rational lower = first.value.lower();
  for (const VerifiedMinimum& m : found_) lower = std::min(lower, m.value.lower());
  const bool is_zero =
      std::ranges::any_of(found_, [](const VerifiedMinimum& m) { return m.value.is_exactly_zero(); });
  summary.minimum = is_zero ? exact(Rational(0), "all residuals vanish")
                            : certified(std::max(lower, Rational(0)), level(), method);
  for (std::size_t j = 0; j < problem_.box.size(); ++j) {
    Interval x = first.point.x[j];
    for (const VerifiedMinimum& m : found_) x = Interval::hull(x, m.point.x[j]);
    const Range& range = problem_.box[j];
    summary.minimiser.push_back(
        certified(std::max(x.lower(), range.lower), std::min(x.upper(), range.upper), method));
  }
  if (problem_.norm != Norm::l2) summary.active = active_residuals(first);
  if (found_.size() > 1) {
    summary.termination = Termination::not_unique;
    summary.message = "the minimum is proved; several points attain it, as far as the precision can tell";
  } else if (first.on_boundary) {
    summary.message = "the minimiser lies on the boundary of the box: widen it to look further";
  }
  return summary;
}

/// One of a curve or surface of points where all residuals vanish: the least value that a norm can have.
std::optional<Summary> Minimiser::zero_of_many(const LocalMinimum& candidate) const {
  std::vector<double> values;
  for (const Polynomial& p : residuals_.numerators) {
    values.push_back(p.evaluate<double>(candidate.x) / residuals_.denominator.evaluate<double>(candidate.x));
  }
  if (!all_vanish(values)) return std::nullopt;
  const auto zero = zero_on_a_family(residuals_, problem_.box, candidate.x, options_.precision);
  if (!zero) return std::nullopt;
  Summary summary =
      stopped(Termination::not_unique,
              "all residuals vanish, along a curve or surface of parameters; one point of it is given");
  summary.minimum = exact(Rational(0), "all residuals vanish");
  for (const Interval& x : *zero) summary.minimiser.push_back(certified(x, "Krawczyk"));
  for (std::size_t i = 0; i < problem_.residuals.size() && problem_.norm != Norm::l2; ++i) {
    summary.active.push_back(static_cast<int>(i));
  }
  return summary;
}

Summary Minimiser::run(const std::vector<LocalMinimum>& candidates) {
  constexpr int most_improvements = 20;
  constexpr int boxes_for_poles = 20000;
  if (!is_positive_on(form_.denominator, problem_.box, search_precision, boxes_for_poles)) {
    return stopped(Termination::pole_in_box, "a residual may have a pole in the box");
  }
  if (candidates.empty())
    return stopped(Termination::no_local_minimum, "no start of the local solver converged");
  if (form_.numerators.empty()) return stopped(Termination::not_isolated, "the objective is 0 everywhere");
  if (auto summary = zero_of_many(candidates.front())) return *summary;
  for (const LocalMinimum& candidate : candidates) {
    constexpr double worse = 1e-6;
    if (!found_.empty() &&
        candidate.objective > found_.front().value.to_double() * (1 + worse) + worse * worse)
      break;
    add(candidate.x);
  }
  for (int k = 0; k < most_improvements && !found_.empty(); ++k) {
    std::vector<Box> neighbourhoods;
    for (const VerifiedMinimum& m : found_) neighbourhoods.push_back(m.neighbourhood);
    const Exclusion exclusion =
        exclude(problem_.norm, form_, Interval(level(), search_precision), problem_.box, neighbourhoods,
                search_precision, options_.max_boxes - boxes_);
    boxes_ += exclusion.boxes;
    if (exclusion.outcome == Exclusion::Outcome::proved) return conclude();
    if (exclusion.outcome == Exclusion::Outcome::out_of_boxes) {
      Summary summary = conclude();
      summary.termination = Termination::out_of_boxes;
      summary.message =
          "branch and bound ran out of boxes: the minimum is verified locally, not in the whole box";
      for (Enclosure& x : summary.minimiser) {
        x.rigour = Rigour::approximate;
        x.status = Status::out_of_depth;
      }
      summary.minimum.rigour = Rigour::approximate;
      summary.minimum.status = Status::out_of_depth;
      return summary;
    }
    std::vector<double> start;
    for (const Rational& x : exclusion.point) start.push_back(x.to_double());
    const auto improved = improve(problem_, start);
    const Rational before = level();
    if (improved) add(improved->x);
    if (level() >= before) break;
  }
  Summary summary = stopped(Termination::not_isolated, "the local minimum could not be verified");
  constexpr int believed = 6;
  for (const double x : candidates.front().x) {
    summary.minimiser.push_back(approximate(x, believed, "local search"));
    summary.minimiser.back().status = Status::ambiguous;
  }
  summary.minimum = approximate(candidates.front().objective, believed, "local search");
  summary.minimum.status = Status::ambiguous;
  return summary;
}

}  // namespace

Summary minimise_several_parameters(const Problem& problem, const Options& options,
                                    const std::vector<LocalMinimum>& candidates) {
  return Minimiser(problem, options).run(candidates);
}

}  // namespace subdiv
