#include "experiments/popping.h"

#include <array>

#include <fmt/format.h>

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
    "over all s; "
    "P_k = S_{s_k}(z) P_{k-1}(z^2), P_0 = 1. ";

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
  return heads;
}

const std::vector<ClaimHead>& table() {
  static const std::vector<ClaimHead> heads = make_heads();
  return heads;
}

/// The second value if both levels used one s: the other reading of the paper's text.
Summary one_parameter_for_two_levels() {
  const Mask<RationalFunction> step = jspline(RationalFunction::variable(0));
  Problem problem;
  problem.residuals = popping_difference(step, step.symbol).coefficients();
  problem.box = {{Rational(-17, 10), Rational(58, 10)}};
  return minimise(problem);
}

Claim order_claim(const Enclosure& sequential) {
  const ClaimHead& claim = head(table(), "popping.order");
  const Summary together = one_parameter_for_two_levels();
  const Rational printed = Rational::parse(printed_schedule[1]);
  const Rational tolerance = printed_tolerance(printed_schedule[1], ClaimKind::rounded);
  const bool is_sequential = abs(sequential.midpoint() - printed) <= tolerance;
  const bool is_together = abs(together.minimiser[0].midpoint() - printed) <= tolerance;
  const std::string other = to_significant(together.minimiser[0].midpoint(), 10);
  return settle_statement(claim, is_sequential && !is_together, "sequential",
                          "One s for both levels would give " + other + " instead of the printed 0.366.");
}

}  // namespace

std::span<const ClaimHead> popping_heads() { return table(); }

Results run_popping() {
  Results results;
  const std::vector<PoppingLevel> schedule = popping_schedule(levels);
  Series series{"popping-schedule", {"level", "s", "disparity", "limit"}, {}};
  for (int k = 1; k <= levels; ++k) {
    const PoppingLevel& level = schedule[static_cast<std::size_t>(k - 1)];
    results.claims.push_back(settle(head(table(), fmt::format("popping.schedule.{}", k)), level.parameter));
    series.rows.push_back({std::to_string(k), to_significant(level.parameter.midpoint(), digits),
                           to_significant(level.disparity.midpoint(), digits), "0.5"});
  }
  results.claims.push_back(
      settle(head(table(), "popping.limit"), popping_limit(),
             "s_k increases to 1/2, and 1/2 - s_k <= (3/10) (3/4)^(k-1): with x_0 = 3/2, "
             "x_k = x_{k-1} (6 - x_{k-1})/8, s_k = (2 - x_{k-1})/(4 - x_{k-1})."));
  results.claims.push_back(order_claim(schedule[1].parameter));
  results.series.push_back(std::move(series));
  results.figures.push_back({"popping-schedule",
                             "Parameter that hides each level best",
                             "level k",
                             "s_k",
                             {{"popping-schedule", "level", "s", "s_k", "linespoints pt 7 ps 0.6"},
                              {"popping-schedule", "level", "limit", "limit 1/2", "lines dt 2"}},
                             "set yrange [0.15:0.55]; set key bottom"});
  return results;
}

}  // namespace subdiv
