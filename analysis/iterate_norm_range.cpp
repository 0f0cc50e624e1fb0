#include "analysis/iterate_norm_range.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "analysis/critical_root.h"
#include "analysis/norm_box.h"

namespace subdiv {
namespace {

// Only upper ends are looked for: a lower end is the upper end of the family of -s.

/// norm_k < 1 is proved on [interior, inside]; norm_k >= 1 at outside, unless the search ended there.
struct End {
  Rational inside;
  Rational outside;
  std::optional<Algebraic> exact;
  bool sharp = false;  // proved also on [inside, outside) up to the one point where norm_k reaches 1
  Status status = Status::closed;
  std::string method;
};

struct Search {
  const DifferenceFamily& family;
  double limit;
  double tolerance;
};

struct Bracket {
  double inside;   // the norm is below 1, by a computed value or by a proof
  double outside;  // norm >= 1, proved
};

/// The largest class of level k at s, and whether its norm is at least 1 in exact arithmetic.
struct Sample {
  ClassValue largest;
  bool reaches_one;
};

Sample sample(const DifferenceFamily& family, int k, double s) {
  NormBox point = norm_box(family, s, s);
  Sample result{largest_class(point, k), false};
  constexpr double doubtful = 1e-9;
  if (result.largest.norm < 1 - doubtful) return result;
  const auto reaches = [&](const ClassWord& word) {
    return class_norm(family, word, Rational::from_double(s)) >= Rational(1);
  };
  constexpr std::size_t most_classes = 256;
  const auto others = critical_classes(point, k, most_classes);
  result.reaches_one =
      reaches(result.largest.word) || (others && std::any_of(others->begin(), others->end(), reaches));
  return result;
}

/// A point beyond `inside` with norm_k >= 1, in growing steps; nothing when there is none up to the limit.
std::optional<Bracket> find_outside(const Search& search, int k, double inside) {
  for (double step = 1.0 / 64; inside < search.limit; step *= 2) {
    const double s = std::min(inside + step, search.limit);
    if (sample(search.family, k, s).reaches_one) return Bracket{inside, s};
    if (s == search.limit) break;
  }
  return std::nullopt;
}

/// Newton's method on the largest class, kept within the bracket, until the bracket is narrower than the
/// tolerance.
Bracket narrow(const Search& search, int k, Bracket bracket) {
  const double nudge = search.tolerance / 4;
  double s = bracket.outside;
  for (int i = 1; bracket.outside - bracket.inside > search.tolerance; ++i) {
    const Sample at = sample(search.family, k, s);
    (at.reaches_one ? bracket.outside : bracket.inside) = s;
    double next = s - (at.largest.norm - 1) / at.largest.slope;
    if (std::abs(next - s) < nudge) next += at.reaches_one ? -nudge : nudge;
    const bool leaves = !(bracket.inside < next && next < bracket.outside);
    if (leaves || i % 4 == 0) next = bracket.inside + (bracket.outside - bracket.inside) / 2;
    if (next == bracket.inside || next == bracket.outside) break;  // neighbouring doubles
    s = next;
  }
  return bracket;
}

/// Proves norm_k < 1 on [from, to] box by box; returns how far it came. Close to a zero of 1 - norm_k at
/// distance x a box of width about sqrt(x) can be proved, so boxes are first tried that leave a gap of the
/// square of what they cover.
double prove_up_to(const Search& search, int k, double from, double to) {
  std::vector<double> targets{to};
  const double least = search.tolerance / 64;
  while (!targets.empty()) {
    const double target = targets.back();
    NormBox box = norm_box(search.family, from, target);
    if (proves_contraction(box, k)) {
      from = target;
      targets.pop_back();
      continue;
    }
    const double width = target - from;
    if (width < least) return from;
    const double share = targets.size() == 1 ? std::clamp(width, 1e-6, 0.5) : 0.5;
    const double nearer = target - share * width;
    if (nearer <= from || nearer >= target) return from;  // neighbouring doubles
    targets.push_back(nearer);
  }
  return from;
}

/// Follows the interval from `inside` (proved) to its end.
End march(const Search& search, int k, double inside) {
  const auto ended = [&](double reached, double outside, Status status) {
    return End{Rational::from_double(reached),
               Rational::from_double(outside),
               std::nullopt,
               false,
               status,
               "boxes of the parameter, class tree in double with error bounds"};
  };
  double reached = inside;
  std::optional<Bracket> bracket = find_outside(search, k, inside);
  constexpr int most_gaps = 32;
  for (int gap = 0; gap < most_gaps; ++gap) {
    if (bracket) bracket = narrow(search, k, *bracket);
    const double target = bracket ? bracket->inside : search.limit;
    reached = prove_up_to(search, k, reached, target);
    if (reached == target) {
      return bracket ? ended(reached, bracket->outside, Status::closed)
                     : ended(reached, reached, Status::out_of_depth);
    }
    // The norm rises to 1 in between and falls again: the interval ends at the first such place.
    const double next = std::min(reached + search.tolerance / 16, search.limit);
    if (!sample(search.family, k, next).reaches_one) break;
    bracket = Bracket{reached, next};
  }
  return ended(reached, bracket ? bracket->outside : search.limit, Status::out_of_precision);
}

/// Replaces a bracket by the root of the critical classes' polynomials, where that can be proved: a simple
/// root, or the simplest fraction in the bracket.
void sharpen(const Search& search, int k, End& end) {
  if (end.status == Status::out_of_depth) return;
  constexpr std::size_t most_classes = 1024;
  NormBox box = norm_box(search.family, end.inside.to_double(), end.outside.to_double());
  const auto classes = critical_classes(box, k, most_classes);
  if (!classes) return;
  const Rational simple = simplest_between(end.inside, end.outside);
  if (const auto root = first_critical_root(search.family, *classes, end.inside, end.outside)) {
    end = {root->lower,    root->upper,
           root->exact,    true,
           Status::closed, "root of a class polynomial of degree " + std::to_string(root->degree)};
  } else if (end.inside < simple && reaches_one_first_at(search.family, *classes, end.inside, simple)) {
    end = {simple, simple, Algebraic(simple), true, Status::closed, "zero of the class polynomials"};
  }
}

bool is_rational(const End& end) { return end.sharp && end.exact && end.exact->is_rational(); }

/// How far submultiplicativity carries: norm_k <= norm_i norm_{k-i} < 1 where both are below 1. ends[i]
/// belongs to power i + 1. A rational sharp end counts as itself: the proof holds up to it, not at it.
/// Nothing when no two powers are known.
struct Start {
  Rational inside;
  bool open = false;
};

std::optional<Start> start_of(const std::vector<std::optional<End>>& ends, int k) {
  std::optional<Start> best;
  for (int i = 1; 2 * i <= k; ++i) {
    const auto& a = ends[static_cast<std::size_t>(i - 1)];
    const auto& b = ends[static_cast<std::size_t>(k - i - 1)];
    if (!a || !b) continue;
    const auto reach = [](const End& end) {
      return is_rational(end) ? Start{end.exact->to_rational(), true} : Start{end.inside, false};
    };
    const Start first = reach(*a);
    const Start second = reach(*b);
    const Start both = first.inside < second.inside   ? first
                       : second.inside < first.inside ? second
                                                      : Start{first.inside, first.open || second.open};
    if (!best || best->inside < both.inside || (best->inside == both.inside && best->open)) best = both;
  }
  return best;
}

/// The largest double not above q.
double round_down(const Rational& q) {
  double x = q.to_double();
  while (Rational::from_double(x) > q) x = std::nextafter(x, -HUGE_VAL);
  return x;
}

/// norm_k >= 1 at a rational point, by the class that is largest near it.
bool reaches_one(const DifferenceFamily& family, int k, const Rational& s) {
  const double near = s.to_double();
  NormBox point = norm_box(family, near, near);
  return class_norm(family, largest_class(point, k).word, s) >= Rational(1);
}

/// The upper ends for k = 1 .. max_power, nothing where the norm at the interior point is not below 1.
std::vector<std::optional<End>> upper_ends(const Search& search, const Rational& interior, int max_power) {
  std::vector<std::optional<End>> ends;
  const double middle = interior.to_double();
  for (int k = 1; k <= max_power; ++k) {
    ends.emplace_back();
    const std::optional<Start> inherited = start_of(ends, k);
    if (!inherited) {
      NormBox point = norm_box(search.family, round_down(interior), std::nextafter(middle, HUGE_VAL));
      if (!proves_contraction(point, k)) continue;
    }
    const Start start = inherited.value_or(Start{interior, false});
    if (start.open && reaches_one(search.family, k, start.inside)) {
      ends.back() = End{start.inside, start.inside,   Algebraic(start.inside),
                        true,         Status::closed, "submultiplicativity of the norms"};
      continue;
    }
    // A point at which the proof is open lies in a box of its own further on.
    End end = march(search, k, start.open ? middle : round_down(start.inside));
    sharpen(search, k, end);
    ends.back() = std::move(end);
  }
  return ends;
}

RangeEnd range_end(const End& end) {
  RangeEnd result;
  result.sharp = end.sharp;
  result.value =
      end.exact ? exact(*end.exact, end.method)
                : certified(std::min(end.inside, end.outside), std::max(end.inside, end.outside), end.method);
  result.value.status = end.status;
  return result;
}

/// The end of the family of -s as an end of the family.
End mirrored(End end) {
  end.inside = -end.inside;
  end.outside = -end.outside;
  if (end.exact) end.exact = -*end.exact;
  return end;
}

}  // namespace

bool NormRange::contains(const Rational& s) const {
  const bool above = lower.sharp ? lower.value.upper < s : lower.value.upper <= s;
  const bool below = upper.sharp ? s < upper.value.lower : s <= upper.value.lower;
  return above && below;
}

std::vector<NormRange> iterate_norm_ranges(const DifferenceFamily& family, const NormRangeOptions& options) {
  if (!(options.search_lower < options.interior && options.interior < options.search_upper)) {
    throw std::domain_error("the interior point must lie inside the searched interval");
  }
  const DifferenceFamily mirror = reflected(family);
  const double tolerance = options.tolerance.to_double();
  const auto upper =
      upper_ends({family, round_down(options.search_upper), tolerance}, options.interior, options.max_power);
  const auto lower = upper_ends({mirror, round_down(-options.search_lower), tolerance}, -options.interior,
                                options.max_power);
  std::vector<NormRange> ranges;
  for (std::size_t i = 0; i < upper.size(); ++i) {
    if (!upper[i] || !lower[i]) continue;
    RangeEnd low = range_end(mirrored(*lower[i]));
    ranges.push_back({static_cast<int>(i) + 1, std::move(low), range_end(*upper[i])});
  }
  return ranges;
}

std::optional<int> first_power_containing(const std::vector<NormRange>& ranges, const Rational& s) {
  for (const NormRange& range : ranges) {
    if (range.contains(s)) return range.power;
  }
  return std::nullopt;
}

}  // namespace subdiv
