#include "optimize/exclusion.h"

#include <algorithm>
#include <cmath>

#include "optimize/dual_weights.h"
#include "optimize/taylor_form.h"

namespace subdiv {
namespace {

class Excluder {
 public:
  Excluder(Norm norm, const CommonForm& form, const Interval& level, const std::vector<Range>& box,
           long precision)
      : norm_(norm), level_(level), variables_(static_cast<int>(box.size())), precision_(precision) {
    for (const Range& side : box) widths_.push_back(side.upper - side.lower);
    for (const Polynomial& p : form.numerators) residuals_.emplace_back(p, variables_, precision);
    residuals_.emplace_back(form.denominator, variables_, precision);
    std::vector<std::size_t> extents(box.size(), 1);
    for (const TaylorForm& t : residuals_) {
      for (std::size_t j = 0; j < extents.size(); ++j) extents[j] = std::max(extents[j], t.extents()[j]);
    }
    for (TaylorForm& t : residuals_) t = t.padded(extents);
  }

  enum class Answer { excluded, better, split };
  struct Verdict {
    Answer answer = Answer::split;
    std::size_t side = 0;  // where to split
  };
  [[nodiscard]] Verdict examine(const Box& box) const;

 private:
  /// Residuals on a box as functions on the unit cube; the last one is the denominator.
  [[nodiscard]] std::vector<TaylorForm> on_cube(const Box& box) const {
    const std::vector<Interval> centre = box.centre(precision_);
    const std::vector<Interval> radius = box.radius(precision_);
    std::vector<TaylorForm> result;
    result.reserve(residuals_.size());
    for (const TaylorForm& t : residuals_) result.push_back(t.shifted(centre).scaled(radius));
    return result;
  }
  [[nodiscard]] AffinePiece linear_part(const TaylorForm& t) const {
    AffinePiece piece{t.constant().to_double(), {}};
    for (int j = 0; j < variables_; ++j) piece.slope.push_back(t.slope(j).to_double());
    return piece;
  }
  [[nodiscard]] bool is_below_level_at_centre(const std::vector<TaylorForm>& local) const;
  [[nodiscard]] TaylorForm bound(const std::vector<TaylorForm>& local,
                                 const std::vector<double>& weights) const;

  [[nodiscard]] std::size_t side_to_split(const Box& box, const TaylorForm& below) const;

  Norm norm_;
  Interval level_;
  int variables_;
  std::vector<Rational> widths_;
  long precision_;
  std::vector<TaylorForm> residuals_;
};

bool Excluder::is_below_level_at_centre(const std::vector<TaylorForm>& local) const {
  Interval total(0);
  for (std::size_t i = 0; i + 1 < local.size(); ++i) {
    const Interval magnitude = abs(local[i].constant());
    total = norm_ == Norm::linf ? max(total, magnitude) : total + magnitude;
  }
  return certainly_less(total, level_ * local.back().constant());
}

/// sum of w_i p_i - |w| level q: where it is positive, the norm exceeds the level.
TaylorForm Excluder::bound(const std::vector<TaylorForm>& local, const std::vector<double>& weights) const {
  Interval dual_norm(0);
  TaylorForm total = local.back();
  total *= Interval(0);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] == 0) continue;
    const Interval weight(weights[i]);
    dual_norm = norm_ == Norm::linf ? dual_norm + abs(weight) : max(dual_norm, abs(weight));
    TaylorForm term = local[i];
    term *= weight;
    total += term;
  }
  TaylorForm below = local.back();
  below *= -(dual_norm.with_precision(precision_) * level_);
  total += below;
  return total;
}

Excluder::Verdict Excluder::examine(const Box& box) const {
  const std::vector<TaylorForm> local = on_cube(box);
  std::vector<AffinePiece> pieces;
  for (const TaylorForm& t : local) pieces.push_back(linear_part(t));
  AffinePiece offset = pieces.back();
  pieces.pop_back();
  const double level = level_.to_double();
  offset.constant *= -level;
  for (double& slope : offset.slope) slope *= -level;
  const TaylorForm below = bound(local, dual_weights(norm_, pieces, offset));
  if (certainly_positive(Interval(below.least_on_cube()))) return {Answer::excluded};
  if (is_below_level_at_centre(local)) return {Answer::better};
  return {Answer::split, side_to_split(box, below)};
}

/// The side that costs the bound most, among those that are not much narrower than the others (in shares of
/// the whole box): what a side costs for these weights says nothing of the better weights that smaller boxes
/// allow.
std::size_t Excluder::side_to_split(const Box& box, const TaylorForm& below) const {
  constexpr double narrow = 0.15;
  std::vector<double> shares;
  for (std::size_t j = 0; j < widths_.size(); ++j) {
    shares.push_back(((box.sides[j].upper - box.sides[j].lower) / widths_[j]).to_double());
  }
  const double widest = *std::ranges::max_element(shares);
  std::size_t side = 0;
  double largest = -1;
  for (std::size_t j = 0; j < shares.size(); ++j) {
    const double influence = below.influence(static_cast<int>(j));
    if (shares[j] < narrow * widest || influence <= largest) continue;
    largest = influence;
    side = j;
  }
  return side;
}

}  // namespace

Exclusion exclude(Norm norm, const CommonForm& form, const Interval& level, const std::vector<Range>& box,
                  const std::vector<Box>& neighbourhoods, long precision, int max_boxes) {
  const Excluder excluder(norm, form, level, box, precision);
  Exclusion result;
  std::vector<Box> open{Box{box}};
  while (!open.empty()) {
    const Box next = std::move(open.back());
    open.pop_back();
    if (std::ranges::any_of(neighbourhoods, [&](const Box& n) { return n.contains(next); })) continue;
    if (result.boxes == max_boxes) {
      result.outcome = Exclusion::Outcome::out_of_boxes;
      return result;
    }
    ++result.boxes;
    const Excluder::Verdict verdict = excluder.examine(next);
    if (verdict.answer == Excluder::Answer::excluded) continue;
    if (verdict.answer == Excluder::Answer::better) {
      for (const Range& side : next.sides) result.point.push_back((side.lower + side.upper) / Rational(2));
      result.outcome = Exclusion::Outcome::better_point;
      return result;
    }
    for (Box& half : next.halves(verdict.side)) open.push_back(std::move(half));
  }
  return result;
}

}  // namespace subdiv
