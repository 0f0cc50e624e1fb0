#include "analysis/mesh/spectral_condition.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "analysis/eigenvalues.h"

namespace subdiv {
namespace {

constexpr long precision = ModeTable::precision;

ModeEquation without_one(ModeEquation equation) {
  const Polynomial one = Polynomial::variable(eigenvalue_variable) - Polynomial(1);
  for (std::size_t i = 0; i < equation.factors.size(); ++i) {
    auto& [base, multiplicity] = equation.factors[i];
    Polynomial quotient;
    if (!divides(one, base, quotient) || !quotient.is_constant()) continue;
    if (--multiplicity == 0) equation.factors.erase(equation.factors.begin() + static_cast<long>(i));
    return equation;
  }
  throw std::domain_error("1 is no eigenvalue of the invariant mode");
}

/// All factors of a mode with their root counters.
class Counters {
 public:
  Counters(ModeFactors factors, bool fine) {
    for (auto& [p, multiplicity] : factors) {
      degree_ += multiplicity * p.degree();
      counters_.emplace_back(RootCounter(std::move(p), fine), multiplicity);
      for (int i = 0; i < multiplicity; ++i) {
        const std::vector<Interval>& own = counters_.back().first.moduli();
        moduli_.insert(moduli_.end(), own.begin(), own.end());
      }
    }
    std::sort(moduli_.begin(), moduli_.end(),
              [](const Interval& a, const Interval& b) { return certainly_less(b, a); });
    constexpr std::size_t least = 3;
    moduli_.resize(std::max(moduli_.size(), least), Interval(0));
  }

  /// The i-th largest modulus; not proved; 0 past the last.
  [[nodiscard]] const Interval& modulus(std::size_t i) const { return moduli_[i]; }

  /// The number of eigenvalues beyond the radius, all of the others inside; nothing when not proved.
  [[nodiscard]] std::optional<int> beyond(const Interval& radius) const {
    int inside = 0;
    for (const auto& [counter, multiplicity] : counters_) {
      const std::optional<int> count = counter.within(radius);
      if (!count) return std::nullopt;
      inside += multiplicity * *count;
    }
    return degree_ - inside;
  }

  /// All eigenvalues from the radius on are proved to be no real numbers.
  [[nodiscard]] bool complex_beyond(const Interval& radius) const {
    return std::all_of(counters_.begin(), counters_.end(),
                       [&](const auto& c) { return c.first.complex_beyond(radius); });
  }

  /// The first factor with eigenvalues beyond the radius.
  [[nodiscard]] const RootCounter* outer_factor(const Interval& radius) const {
    for (const auto& [counter, multiplicity] : counters_) {
      const std::optional<int> count = counter.within(radius);
      if (count && *count < counter.family().degree()) return &counter;
    }
    return nullptr;
  }

 private:
  std::vector<std::pair<RootCounter, int>> counters_;
  std::vector<Interval> moduli_;
  int degree_ = 0;
};

/// A radius that separates two moduli, at equal ratios; half of the larger where the smaller is 0.
Interval between(const Interval& a, const Interval& b) {
  if (b.is_exactly_zero()) return (a * Interval(Rational(1, 2))).center();
  return sqrt(a * b).center();
}

}  // namespace

/// All modes on a cell of the parameter. bounds[k] is a radius inside which mode k is proved to lie, mode 1
/// but for one eigenvalue; not finite as long as nothing is proved.
class SpectralCondition::Cell {
 public:
  Cell(const SpectralCondition& condition, const Rational& lower, const Rational& upper,
       std::vector<Interval>& bounds)
      : condition_(condition),
        bounds_(bounds),
        turning_(condition.turning_.at(lower, upper)),
        invariant_(condition.invariant_.at(lower, upper)) {}

  Decision decide() {
    Counters first(mode(1), false);
    const std::vector<int> near = modes_near(first.modulus(0));
    std::vector<Counters> others;
    bool fine = close(first.modulus(0), first.modulus(1)) || close(first.modulus(0), Interval(1));
    for (const int k : near) {
      others.emplace_back(mode(k), false);
      fine = fine || close(first.modulus(0), others.back().modulus(0));
    }
    if (fine) first = Counters(mode(1), true);
    const Interval& lambda = first.modulus(0);
    bool proved = prove_first(first);
    for (std::size_t i = 0; i < near.size(); ++i) {
      if (close(lambda, others[i].modulus(0))) others[i] = Counters(mode(near[i]), true);
      const Interval& other = others[i].modulus(0);
      const Interval radius = between(lambda, other);
      const std::optional<int> beyond = others[i].beyond(radius);
      if (certainly_less(other, lambda) && beyond == 0) {
        bounds_[static_cast<std::size_t>(near[i])] = radius;
        continue;
      }
      // Mode k has an eigenvalue beyond the radius, mode 1 has none.
      if (beyond && *beyond > 0 && first.beyond(radius) == 0) return Decision::no;
      proved = false;
    }
    if (proved && is_positive(first)) return Decision::yes;
    return fails(first) ? Decision::no : Decision::undecided;
  }

 private:
  [[nodiscard]] ModeFactors mode(int k) const {
    if (k == 0) return invariant_.at_turn(condition_.turn(1));
    // What does not depend on the turn is common to all modes, and mode 1 answers for it.
    return k == 1 ? turning_.at_turn(condition_.turn(1)) : turning_.turning_at(condition_.turn(k));
  }

  /// An eigenvalue that all modes k != 0 share is of mode 1 alone only at valence 3.
  [[nodiscard]] bool is_shared(const Interval& radius) const {
    if (condition_.last_mode() < 2) return false;
    const Counters common(turning_.common(), false);
    return common.beyond(radius) != 0;
  }

  static bool close(const Interval& a, const Interval& b) {
    constexpr double tight = 1e-6;
    const double x = a.to_double();
    return std::abs(x - b.to_double()) < tight * x;
  }

  /// The modes not yet known to stay clear of lambda.
  [[nodiscard]] std::vector<int> modes_near(const Interval& lambda) const {
    constexpr double clear = 0.97;
    std::vector<int> result;
    for (int k = 0; k <= condition_.last_mode(); ++k) {
      const Interval& bound = bounds_[static_cast<std::size_t>(k)];
      if (k == 1 || (bound.is_finite() && bound.to_double() < clear * lambda.to_double())) continue;
      result.push_back(k);
    }
    return result;
  }

  bool prove_first(const Counters& first) {
    const Interval radius = between(first.modulus(0), first.modulus(1));
    const bool proved = first.beyond(radius) == 1;
    if (proved) bounds_[1] = radius;
    return proved;
  }

  /// The one eigenvalue of mode 1 beyond bounds[1] lies between the largest bound and 1: p changes its sign.
  [[nodiscard]] bool is_positive(const Counters& first) const {
    Interval radius = bounds_[1];
    for (const Interval& bound : bounds_) radius = certainly_less(radius, bound) ? bound : radius;
    const RootCounter* p = first.outer_factor(bounds_[1]);
    return p != nullptr && !is_shared(bounds_[1]) && p->relative_sign(radius) < 0 &&
           p->relative_sign(Interval(1)) > 0 && certainly_less(radius, Interval(1));
  }

  /// Mode 1 itself is at fault: an eigenvalue outside the unit circle; a negative one, or a pair of complex
  /// ones, as the largest.
  [[nodiscard]] static bool fails(const Counters& first) {
    const std::optional<int> outside = first.beyond(Interval(1));
    if (outside && *outside > 0) return true;
    const Interval radius = between(first.modulus(0), first.modulus(1));
    const RootCounter* p = first.outer_factor(radius);
    if (p != nullptr && first.beyond(radius) == 1 && p->relative_sign(radius) > 0) return true;
    const Interval inner = between(first.modulus(1), first.modulus(2));
    const std::optional<int> pair = first.beyond(inner);
    return pair && *pair > 0 && first.complex_beyond(inner);
  }

  const SpectralCondition& condition_;
  std::vector<Interval>& bounds_;
  ModeTable::AtParameter turning_;
  ModeTable::AtParameter invariant_;
};

namespace {

Interval unbounded() { return Interval(1) / Interval(0); }

}  // namespace

SpectralCondition::SpectralCondition(const ModeEquation& turning, const ModeEquation& invariant, int valence)
    : valence_(valence), turning_(turning), invariant_(without_one(invariant)) {
  const Interval twice = Interval(2) * pi(precision);
  for (int k = 0; k <= last_mode(); ++k) {
    turns_.push_back(cos(twice * Interval(Rational(k, valence), precision)));
  }
}

Decision SpectralCondition::decide(const Rational& lower, const Rational& upper) const {
  std::vector<Interval> bounds(turns_.size(), unbounded());
  return Cell(*this, lower, upper, bounds).decide();
}

std::optional<std::vector<int>> SpectralCondition::beyond(const Rational& lower, const Rational& upper,
                                                          const Interval& radius) const {
  const ModeTable::AtParameter turning = turning_.at(lower, upper);
  const ModeTable::AtParameter invariant = invariant_.at(lower, upper);
  std::vector<int> result;
  for (int k = 0; k <= last_mode(); ++k) {
    const Counters counters(k == 0 ? invariant.at_turn(turn(1)) : turning.at_turn(turn(k)), false);
    const std::optional<int> count = counters.beyond(radius);
    if (!count) return std::nullopt;
    result.push_back(*count);
  }
  return result;
}

std::vector<ParameterPolynomial> SpectralCondition::factors(int mode) const {
  return mode == 0 ? invariant_.factors(turn(1)) : turning_.factors(turn(mode));
}

void SpectralCondition::split(const Rational& lower, const Rational& upper, const Rational& width,
                              std::vector<Interval> bounds, std::vector<ConditionCell>& result) const {
  const Decision decision = Cell(*this, lower, upper, bounds).decide();
  if (decision == Decision::undecided && width < upper - lower) {
    const Rational middle = (lower + upper) / Rational(2);
    split(lower, middle, width, bounds, result);
    split(middle, upper, width, std::move(bounds), result);
    return;
  }
  if (!result.empty() && result.back().holds == decision) {
    result.back().upper = upper;
  } else {
    result.push_back({lower, upper, decision});
  }
}

std::vector<ConditionCell> SpectralCondition::cells(const Rational& lower, const Rational& upper,
                                                    const Rational& width) const {
  std::vector<ConditionCell> result;
  split(lower, upper, width, std::vector<Interval>(turns_.size(), unbounded()), result);
  return result;
}

Rival SpectralCondition::rival(const Rational& s) const {
  const ModeTable::AtParameter turning = turning_.at(s, s);
  const ModeTable::AtParameter invariant = invariant_.at(s, s);
  Rival result;
  std::vector<std::complex<double>> own;
  for (int k = 0; k <= last_mode(); ++k) {
    for (const auto& [p, multiplicity] : (k == 0 ? invariant : turning).at_turn(turn(std::max(k, 1)))) {
      const std::vector<std::complex<double>> roots = approximate_roots(p.middle);
      for (const std::complex<double>& z : roots) {
        for (int i = 0; k == 1 && i < multiplicity; ++i) own.push_back(z);
        if (k != 1 && std::abs(z) > std::abs(result.value)) {
          result.mode = k;
          result.value = z;
        }
      }
    }
  }
  std::sort(own.begin(), own.end(), [](const auto& a, const auto& b) { return std::abs(a) > std::abs(b); });
  if (own.empty()) return result;
  result.subdominant = std::abs(own[0]);
  if (own.size() > 1 && std::abs(own[1]) > std::abs(result.value)) {
    result.mode = 1;
    result.value = own[1];
  }
  return result;
}

std::optional<LeadingEigenvalues> SpectralCondition::leading(const Rational& s) const {
  if (decide(s) != Decision::yes) return std::nullopt;
  const ModeTable::AtParameter turning = turning_.at(s, s);
  const ModeTable::AtParameter invariant = invariant_.at(s, s);
  const Counters first(turning.at_turn(turn(1)), true);
  const auto mode = [&](int k) {
    return Counters(k == 0 ? invariant.at_turn(turn(1)) : turning.at_turn(turn(k)), true);
  };
  const Rival other = rival(s);
  std::vector<Counters> others;
  for (int k = 0; k <= last_mode(); ++k) {
    if (k != 1) others.push_back(mode(k));
  }
  Interval next = first.modulus(1);
  for (const Counters& m : others) next = certainly_less(next, m.modulus(0)) ? m.modulus(0) : next;
  const Counters rivals = mode(other.mode);
  for (int digits = 30; digits >= 5; --digits) {
    const Interval slack(pow(Rational(10), -digits), precision);
    const Interval low = first.modulus(0) * (Interval(1) - slack);
    const Interval high = first.modulus(0) * (Interval(1) + slack);
    const Interval below = next * (Interval(1) - slack);
    const Interval above = next * (Interval(1) + slack);
    const std::optional<int> reached = rivals.beyond(below);
    bool proved = first.beyond(high) == 0 && first.beyond(low) == 1 && first.beyond(above) == 1;
    proved = proved && reached && *reached > (other.mode == 1 ? 1 : 0);
    for (const Counters& m : others) proved = proved && m.beyond(above) == 0;
    if (proved) return LeadingEigenvalues{Interval::hull(low, high), Interval::hull(below, above)};
  }
  return std::nullopt;
}

}  // namespace subdiv
