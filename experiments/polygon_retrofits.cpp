#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include <fmt/format.h>

#include "analysis/limit_points.h"
#include "analysis/retrofit.h"
#include "experiments/polygon_curves.h"
#include "experiments/report/figure_style.h"
#include "experiments/simple_polygons.h"
#include "schemes/algebra/univariate.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

constexpr int digits = 12;

const ClaimHead& head_of(const std::string& id) { return head(polygon_curve_heads(), id); }

/// L of *J_s over Q(s).
Laurent<RationalFunction> limit_family() { return limit_mask(jspline(RationalFunction::variable(0))); }

/// 1 - L(-1), the factor of alternating data.
RationalFunction alternating_factor() {
  return RationalFunction(1) - symbol_at_cosine(limit_family(), RationalFunction(-1));
}

Rational at(const RationalFunction& f, const Rational& s) {
  const std::vector<Rational> point{s};
  return f.evaluate<Rational>(point);
}

/// Whether f exists and rises strictly on [lower, upper].
bool rises(const RationalFunction& f, const Rational& lower, const Rational& upper) {
  std::vector<Algebraic> critical;
  const RationalFunction slope = f.derivative(0);
  append_real_roots(slope.numerator(), 0, critical);
  append_real_roots(f.denominator(), 0, critical);
  const bool none = std::ranges::none_of(
      critical, [&](const Algebraic& x) { return Algebraic(lower) <= x && x <= Algebraic(upper); });
  return none && at(slope, (lower + upper) / Rational(2)).sign() > 0;
}

/// Whether [lower, upper] belongs to one interval of the set.
bool contains(const RealSet& set, const Rational& lower, const Rational& upper) {
  return std::ranges::any_of(set.parts, [&](const RealInterval& part) {
    return part.contains(Algebraic(lower)) && part.contains(Algebraic(upper));
  });
}

/// Where alternating data shrink most slowly. I - L has the factor s, without which s = 0 is no exception.
RealSet alternating_range() {
  using Mask = Laurent<RationalFunction>;
  const RationalFunction one_over_s = RationalFunction(1) / RationalFunction::variable(0);
  return alternation_dominates(Mask(1) - one_over_s * (Mask(1) - limit_family()));
}

void add_rates(Results& results) {
  const Rational lower(-3, 4);
  const Rational upper(3, 2);
  const RationalFunction factor = alternating_factor();
  const RealSet range = retrofit_range(limit_family());
  const RealSet alternating = alternating_range();
  const Rational slow = at(factor, upper);
  results.claims.push_back(settle_statement(
      head_of("retrofit.realtime"), contains(range, lower, upper), "true",
      fmt::format("At s = -3/4 a step multiplies errors by {} at most, at s = 3/2 by {}; realtime is a "
                  "matter of the number of steps, see retrofit.realtime.iterations.",
                  abs(at(factor, lower)).to_string(), slow.to_string())));
  // |1 - L(-1)| grows towards both ends of an interval on which 1 - L(-1) rises.
  if (!contains(alternating, lower, upper) || !rises(factor, lower, upper))
    throw std::logic_error("the rate of retrofitting is not that of alternating data");
  results.claims.push_back(
      settle(head_of("retrofit.realtime.rate"), exact(std::max(abs(at(factor, lower)), slow))));
  const std::vector<std::string> names{"s"};
  const bool slower = contains(alternating, upper, Rational(2)) && rises(factor, upper, Rational(2)) &&
                      at(factor, Rational(2)) == Rational(1);
  results.claims.push_back(settle_statement(head_of("retrofit.realtime.slower"), slower,
                                            "1 - L(-1) = " + factor.to_factored_string(names)));
}

/// The misses C - L P of one polygon, which a step of the iteration multiplies by I - L, in floating point
/// with a bound on what rounding has done to them. I - L is a normal matrix, so that errors grow in their
/// Euclidean norm by its spectral radius at most.
class Misses {
 public:
  Misses(const Laurent<Rational>& error, double rate, const PlanePolygon& polygon) : rate_(rate) {
    constexpr double unit = 0x1p-53;
    constexpr double room = 2;  // for the rounding of the bound itself
    first_ = error.first();
    double sum = 0;
    for (const Rational& weight : error.coefficients()) {
      weights_.push_back(weight.to_double());
      sum += std::abs(weights_.back());
    }
    // A sum of k products of rounded weights: k + 1 roundings each, the conversion within a unit in the last
    // place.
    unit_error_ = room * (static_cast<double>(weights_.size()) + 3) * unit * sum;
    for (const auto& [x, y] : polygon) {
      values_[0].push_back(x.to_double());  // integers: exact
      values_[1].push_back(y.to_double());
    }
    step();
  }

  void step() {
    // Every entry of the sum is at most the norm; of both coordinates and n points, sqrt(2 n) of them.
    double norm = 0;
    for (const Loop& loop : values_) {
      for (const double x : loop) norm = std::hypot(norm, x);
    }
    const double entries = std::sqrt(2 * static_cast<double>(values_[0].size()));
    bound_ = rate_ * bound_ + unit_error_ * entries * (norm + bound_);
    for (Loop& loop : values_) loop = applied(loop);
  }

  /// Whether all misses are at most 1/1000 long. Throws std::logic_error when rounding leaves that open.
  [[nodiscard]] bool are_small() const {
    constexpr double threshold = 1e-3;
    constexpr double relative = 1e-14;  // of hypot and of the threshold as a double
    const double open = bound_ + relative * threshold;
    bool all = true;
    for (std::size_t i = 0; i < values_[0].size(); ++i) {
      const double length = std::hypot(values_[0][i], values_[1][i]);
      if (std::abs(length - threshold) <= open)
        throw std::logic_error("a residual of retrofitting cannot be told from its threshold");
      all = all && length < threshold;
    }
    return all;
  }

 private:
  using Loop = std::vector<double>;

  [[nodiscard]] Loop applied(const Loop& loop) const {
    const auto n = static_cast<int>(loop.size());
    Loop result(loop.size());
    for (std::size_t i = 0; i < loop.size(); ++i) {
      auto from = static_cast<std::size_t>(residue(static_cast<int>(i) + first_, n));
      for (const double weight : weights_) {
        result[i] += weight * loop[from];
        if (++from == loop.size()) from = 0;
      }
    }
    return result;
  }

  double rate_;
  int first_ = 0;
  Loop weights_;
  double unit_error_ = 0;
  std::array<Loop, 2> values_;
  double bound_ = 0;
};

/// Steps until every limit point is at most 1/1000 from its target, for every polygon.
std::vector<int> iterations(const Rational& s) {
  const Laurent<Rational> error = Laurent<Rational>(1) - limit_mask(jspline(s));
  const double rate = abs(at(alternating_factor(), s)).to_double() * (1 + 1e-15);
  std::vector<int> result;
  for (const PlanePolygon& polygon : simple_polygons()) {
    Misses misses(error, rate, polygon);
    int count = 0;
    for (; !misses.are_small(); ++count) misses.step();
    result.push_back(count);
  }
  return result;
}

void add_iterations(Results& results) {
  constexpr int quick = 50;
  if (!contains(alternating_range(), Rational(-17, 20), Rational(39, 20)))
    throw std::logic_error("the rate of retrofitting is not that of alternating data");
  Series series{"retrofit-iterations", {"s", "largest", "mean", "rate"}, {}};
  int largest = 0;
  int quick_pairs = 0;
  int pairs = 0;
  for (int i = -17; i <= 39; ++i) {
    const Rational s(i, 20);
    const std::vector<int> counts = iterations(s);
    const int most = *std::ranges::max_element(counts);
    const auto total = static_cast<int>(counts.size());
    if (Rational(-3, 4) <= s && s <= Rational(3, 2)) largest = std::max(largest, most);
    quick_pairs += static_cast<int>(std::ranges::count_if(counts, [](int n) { return n <= quick; }));
    pairs += total;
    const Rational mean(std::accumulate(counts.begin(), counts.end(), 0), total);
    series.rows.push_back({to_significant(s, digits), std::to_string(most), to_significant(mean, digits),
                           to_significant(abs(at(alternating_factor(), s)), digits)});
  }
  results.claims.push_back(settle(head_of("retrofit.realtime.iterations"),
                                  exact(Rational(largest), "counted"),
                                  "A step for n points costs 5 n multiplications a coordinate."));
  results.claims.push_back(settle_share(head_of("retrofit.realtime.quick"), quick_pairs, pairs,
                                        "Towards both ends of the range the number of steps grows without "
                                        "bound (series retrofit-iterations)."));
  results.claims.push_back(settle_not_reproducible(
      head_of("retrofit.realtime.js-report"),
      "The test cases are lost. On simple polygons it converges throughout, but not always quickly: see "
      "retrofit.realtime.quick. The later document narrows the range to -0.75 < s < 1.5."));
  results.series.push_back(std::move(series));
  results.figures.push_back({"retrofit-iterations",
                             "Steps until retrofitting leaves 1/1000 of the error, on simple polygons",
                             "parameter s",
                             "steps",
                             {{"retrofit-iterations", "s", "largest", "largest", style::marked(0)},
                              {"retrofit-iterations", "s", "mean", "mean", style::marked(1)}},
                             "set logscale y",
                             {"retrofit.realtime.", "retrofit.realtime"}});
}

/// For each span of a loop of 12 points, from the moved vertex on, how far the retrofitted limit curve moves
/// at most at the parameters i/16 when one vertex moves by 1.
std::vector<Rational> responses(const Rational& s) {
  constexpr std::size_t n = 12;
  constexpr int level = 4;
  constexpr std::size_t spacing = std::size_t{1} << level;
  const Scheme<Rational> scheme = stationary("J", jspline(s));
  std::vector<Rational> moved(n);
  moved[0] = Rational(1);
  const ControlPolygon<Rational> controls =
      closed_polygon(retrofit_directly(vertex_limit_mask(scheme), moved));
  const std::vector<Rational> curve = limit_derivatives(scheme, controls, level, 0);
  std::vector<Rational> largest(n);
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (i % spacing == 0) continue;  // vertices belong to two spans, and all but one stay
    largest[i / spacing] = std::max(largest[i / spacing], abs(curve[i]));
  }
  return largest;
}

void add_local_effects(Results& results) {
  int nearby = 0;
  int total = 0;
  for (int i = -17; i <= 39; ++i) {
    if (i == 0) continue;  // nothing is retrofitted
    const std::vector<Rational> spans = responses(Rational(i, 20));
    const Rational far = *std::max_element(spans.begin() + 1, spans.end() - 1);
    nearby += far < std::max(spans.front(), spans.back()) ? 1 : 0;
    ++total;
  }
  results.claims.push_back(settle_share(head_of("retrofit.local.nearby"), nearby, total));
  const std::vector<Rational> spans = responses(Rational(3, 2));
  const bool everywhere = std::ranges::min_element(spans)->sign() > 0;
  constexpr std::size_t farthest = 5;
  results.claims.push_back(settle_statement(head_of("retrofit.local.whole"), everywhere,
                                            everywhere ? "true" : "false",
                                            fmt::format("On the two spans farthest from the vertex it is {} "
                                                        "at most.",
                                                        to_significant(spans[farthest], 3))));
}

}  // namespace

Results run_polygon_retrofits() {
  Results results;
  add_rates(results);
  add_iterations(results);
  add_local_effects(results);
  return results;
}

}  // namespace subdiv
