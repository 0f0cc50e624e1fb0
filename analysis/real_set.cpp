#include "analysis/real_set.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "schemes/algebra/univariate.h"

namespace subdiv {
namespace {

Rational rational_below(const Algebraic& x) { return floor(x.to_interval().lower()) - Rational(1); }
Rational rational_above(const Algebraic& x) { return floor(x.to_interval().upper()) + Rational(1); }

/// Gathers neighbouring cells and points into intervals, from left to right.
class Gatherer {
 public:
  /// The open interval between two neighbours belongs to the set or not.
  void cell(const std::optional<Algebraic>& lower, bool holds) {
    if (holds && !open_) open_ = RealInterval{lower, std::nullopt, false, false};
    if (!holds && open_) close(lower, true);
  }
  void point(const Algebraic& x, bool holds) {
    if (holds && !open_) open_ = RealInterval{x, std::nullopt, true, false};
    if (!holds && open_) close(x, false);
  }
  RealSet finish() {
    if (open_) set_.parts.push_back(std::move(*open_));
    return std::move(set_);
  }

 private:
  void close(const std::optional<Algebraic>& upper, bool closed) {
    open_->upper = upper;
    open_->upper_closed = closed;
    set_.parts.push_back(std::move(*open_));
    open_.reset();
  }

  RealSet set_;
  std::optional<RealInterval> open_;
};

}  // namespace

bool RealInterval::contains(const Algebraic& x) const {
  if (lower && (x < *lower || (x == *lower && !lower_closed))) return false;
  return !upper || x < *upper || (x == *upper && upper_closed);
}

bool RealSet::contains(const Algebraic& x) const {
  return std::any_of(parts.begin(), parts.end(), [&](const RealInterval& part) { return part.contains(x); });
}

std::string RealSet::to_string() const {
  std::string text;
  for (const RealInterval& part : parts) {
    if (!text.empty()) text += " u ";
    if (part.is_point()) {
      text += "{" + part.lower->to_string() + "}";
      continue;
    }
    text += (part.lower_closed ? "[" : "(") + (part.lower ? part.lower->to_string() : "-inf") + ", ";
    text += (part.upper ? part.upper->to_string() : "inf") + (part.upper_closed ? "]" : ")");
  }
  return text.empty() ? "empty" : text;
}

void append_real_roots(const Polynomial& p, int i, std::vector<Algebraic>& roots) {
  if (p.is_constant()) return;
  for (RealRoot& root : real_roots(UnivariatePolynomial(p, i))) roots.push_back(std::move(root.value));
}

Rational rational_between(const Algebraic& a, const Algebraic& b) {
  if (!(a < b)) throw std::domain_error("no number lies between " + a.to_string() + " and " + b.to_string());
  for (long precision = Interval::default_precision;; precision *= 2) {
    const Rational low = a.to_interval(precision).upper();
    const Rational high = b.to_interval(precision).lower();
    if (!(low < high)) continue;
    // The middle half keeps clear of both ends.
    const Rational quarter = (high - low) / Rational(4);
    return simplest_between(low + quarter, high - quarter);
  }
}

RealSet solve_by_cells(std::vector<Algebraic> critical, const std::function<bool(const Algebraic&)>& holds) {
  std::sort(critical.begin(), critical.end());
  critical.erase(std::unique(critical.begin(), critical.end()), critical.end());
  Gatherer gatherer;
  if (critical.empty()) {
    gatherer.cell(std::nullopt, holds(Algebraic(0)));
    return gatherer.finish();
  }
  gatherer.cell(std::nullopt, holds(rational_below(critical.front())));
  for (std::size_t i = 0; i < critical.size(); ++i) {
    const bool last = i + 1 == critical.size();
    gatherer.point(critical[i], holds(critical[i]));
    gatherer.cell(critical[i],
                  holds(last ? rational_above(critical[i]) : rational_between(critical[i], critical[i + 1])));
  }
  return gatherer.finish();
}

}  // namespace subdiv
