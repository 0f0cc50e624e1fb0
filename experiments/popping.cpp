#include "experiments/popping.h"

#include <array>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "experiments/report/figure_style.h"
#include "optimize/objectives.h"
#include "optimize/popping_schedule.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

constexpr int levels = 25;
constexpr int digits = 18;

const std::array<std::string, 9> printed_schedule{"0.2",   "0.366", "0.421", "0.449", "0.465",
                                                  "0.475", "0.482", "0.487", "0.491"};

const std::string greedy =
    "Greedy: s_k minimises the largest coefficient of (L(z) - S_s(z)) P_{k-1}(z^2), L linear subdivision, "
    "over all s; P_k = S_{s_k}(z) P_{k-1}(z^2), P_0 = 1. ";

std::vector<ClaimHead> make_heads() {
  std::vector<ClaimHead> heads;
  for (int k = 1; k <= levels; ++k) {
    const auto i = static_cast<std::size_t>(k - 1);
    const bool printed = i < printed_schedule.size();
    heads.push_back({fmt::format("popping.schedule.{}", k), printed ? "jsplines" : "subdivlab",
                     printed ? "11" : "jsplines 11",
                     printed ? std::optional(printed_schedule[i]) : std::nullopt, ClaimKind::rounded,
                     greedy + fmt::format("Level k = {}.", k)});
  }
  heads.push_back({"popping.limit", "subdivlab", "jsplines 11", std::nullopt, ClaimKind::exact,
                   greedy + "Limit of s_k as k grows."});
  heads.push_back(
      {"popping.order", "jsplines", "11", "Repeating this process for further subdivision levels",
       ClaimKind::exact,
       "Is the printed second value that of level 2 optimised after level 1 (P_1 = S_{1/5}), or that of both "
       "levels with one s, minimising the largest coefficient of (L(z) - S_s(z)) S_s(z^2)?"});
  heads.push_back({"popping.one-s", "subdivlab", "jsplines 11", std::nullopt, ClaimKind::rounded,
                   "The s in [0, 1] that minimises the largest coefficient of (L(z) - S_s(z)) S_s(z^2)."});
  heads.push_back({"popping.change", "jsplines", "11",
                   "the optimal value will change with the level of refinement", ClaimKind::exact,
                   "Does s_k rise strictly from each level to the next, for all k?"});
  heads.push_back({"popping.range", "jsplines", "11",
                   "all values of s fall within the C2 range of the stationary subdivision scheme",
                   ClaimKind::exact, "Is 0 < s_k < 4 for all k?"});
  heads.push_back(
      {"popping.recursion", "subdivlab", "jsplines 11", std::nullopt, ClaimKind::exact,
       "The document has no closed form for s_k: the recursion that gives it, and by it the levels "
       "1 .. 4 of the exact minimax over all coefficients."});
  return heads;
}

const std::vector<ClaimHead>& table() {
  static const std::vector<ClaimHead> heads = make_heads();
  return heads;
}

/// The second value if both levels used one s: the other reading of the paper's text.
Enclosure one_parameter_for_two_levels(const Range& range) {
  const Mask<RationalFunction> step = jspline(RationalFunction::variable(0));
  Problem problem;
  problem.residuals = popping_difference(step, step.symbol).coefficients();
  problem.box = {range};
  const Summary best = minimise(problem);
  if (best.termination != Termination::proved)
    throw std::runtime_error("one s for two levels: " + best.message);
  return best.minimiser[0];
}

/// In which order the levels are optimised.
void add_order(Results& results, const Enclosure& sequential) {
  const Enclosure between = one_parameter_for_two_levels({Rational(0), Rational(1)});
  const Enclosure anywhere = one_parameter_for_two_levels({Rational(-17, 10), Rational(58, 10)});
  const Rational printed = printed_value(printed_schedule[1]);
  const Rational tolerance = printed_tolerance(printed_schedule[1]);
  const auto prints = [&](const Enclosure& s) { return abs(s.midpoint() - printed) <= tolerance; };
  const bool is_sequential = prints(sequential) && !prints(between) && !prints(anywhere);
  const std::string elsewhere = to_significant(anywhere.midpoint(), 10);
  const std::string note = fmt::format(
      "One s for both levels would be {} between 0 and 1, and {} over [-1.7, 5.8], instead of the "
      "printed {}.",
      to_significant(between.midpoint(), 10), elsewhere, printed_schedule[1]);
  results.claims.push_back(settle_statement(head(table(), "popping.order"), is_sequential,
                                            "each level after the ones before it", note));
  results.claims.push_back(settle(head(table(), "popping.one-s"), between,
                                  fmt::format("Over [-1.7, 5.8] the best s is {}.", elsewhere)));
}

/// What holds for all levels, by the recursion.
void add_recursion(Results& results, const std::vector<PoppingLevel>& schedule) {
  const Enclosure limit = popping_limit();
  bool rises = true;
  for (std::size_t k = 0; k + 1 < schedule.size(); ++k) {
    rises = rises && schedule[k].parameter.upper < schedule[k + 1].parameter.lower;
  }
  const bool below_limit = schedule.back().parameter.upper < limit.lower;
  results.claims.push_back(
      settle(head(table(), "popping.limit"), limit, "s_k rises to it, and 1/2 - s_k <= (3/10) (3/4)^(k-1)."));
  results.claims.push_back(settle_statement(head(table(), "popping.change"), rises && below_limit, "true",
                                            "x_k falls strictly to 0, as (6 - x)/8 lies between 0 and 3/4 on "
                                            "(0, 3/2], and s_k = (2 - x_{k-1})/(4 - "
                                            "x_{k-1}) falls with x."));
  results.claims.push_back(settle_statement(head(table(), "popping.range"),
                                            rises && below_limit && schedule[0].parameter.lower > Rational(0),
                                            "1/5 <= s_k < 1/2"));
  constexpr int checked = 4;
  bool agrees = true;
  for (int k = 1; k <= checked; ++k) {
    const Objective objective = parse_objective(fmt::format("popping:level={}", k));
    const Summary best = minimise(stationary<RationalFunction>("*J", jspline(RationalFunction::variable(0))),
                                  objective, Norm::linf, {{Rational(-17, 10), Rational(58, 10)}}, {"s"});
    const Enclosure& by_recursion = schedule[static_cast<std::size_t>(k - 1)].parameter;
    agrees =
        agrees && best.termination == Termination::proved && best.minimiser[0].exact == by_recursion.exact;
  }
  results.claims.push_back(
      settle_statement(head(table(), "popping.recursion"), agrees,
                       "x_0 = 3/2, x_k = x_{k-1} (6 - x_{k-1})/8, s_k = (2 - x_{k-1})/(4 - x_{k-1})",
                       "At every level the coefficients 0 and +-1 are the largest: with y = x/6 this is the "
                       "logistic map with factor "
                       "3/4."));
}

void add_figures(Results& results, const std::vector<PoppingLevel>& schedule, const Enclosure& limit) {
  Series series{"popping-schedule", {"level", "s", "disparity", "limit"}, {}};
  for (std::size_t k = 0; k < schedule.size(); ++k) {
    series.rows.push_back({std::to_string(k + 1), to_significant(schedule[k].parameter.midpoint(), digits),
                           to_significant(schedule[k].disparity.midpoint(), digits),
                           to_significant(limit.midpoint(), digits)});
  }
  results.series.push_back(std::move(series));
  results.figures.push_back({"popping-schedule",
                             "Parameter s_k that hides the change to level k best",
                             "level k",
                             "parameter s_k",
                             {{"popping-schedule", "level", "s", "s_k", style::marked(0)},
                              {"popping-schedule", "level", "limit", "limit", style::guide}},
                             "set yrange [0.15:0.55]",
                             {"popping.schedule.", "popping.limit", "popping.order"}});
  results.figures.push_back(
      {"popping-disparity",
       "How far the change to level k moves points when one control point is moved by 1",
       "level k",
       "distance (moves of the point)",
       {{"popping-schedule", "level", "disparity", "", style::marked(0)}},
       style::log_y,
       {"popping.schedule.", "popping.change"}});
}

}  // namespace

std::span<const ClaimHead> popping_heads() { return table(); }

Results run_popping() {
  Results results;
  const std::vector<PoppingLevel> schedule = popping_schedule(levels);
  for (int k = 1; k <= levels; ++k) {
    results.claims.push_back(settle(head(table(), fmt::format("popping.schedule.{}", k)),
                                    schedule[static_cast<std::size_t>(k - 1)].parameter));
  }
  add_order(results, schedule[1].parameter);
  add_recursion(results, schedule);
  add_figures(results, schedule, popping_limit());
  return results;
}

}  // namespace subdiv
