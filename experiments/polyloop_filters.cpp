#include <algorithm>
#include <array>
#include <stdexcept>

#include <fmt/format.h>

#include "analysis/polyloop/transfer_function.h"
#include "experiments/data.h"
#include "experiments/drawing.h"
#include "experiments/polyloop_smoothing.h"
#include "schemes/algebra/turn.h"
#include "schemes/polyloop/apply_operator.h"
#include "schemes/polyloop/operator_sequence.h"

namespace subdiv {
namespace {

const std::string noisy = "The stored noisy polyloop of 96 vertices, polyloop-noisy.csv, exact areas: ";

const std::array table{
    finding("figure.polyloops.transfer", "polyloops 2",
            "The largest |g| of {tuck(1/2); tuck(-7/10)} over all frequencies; the figure's series is "
            "made from sums of cosines instead."),
    finding("figure.polyloops.transfer.crossing", "polyloops 2",
            "cos omega at which {tuck(1/2); tuck(-7/10)} keeps a frequency as it is, omega > 0."),
    finding("figure.polyloops.noisy.tuck", "polyloops 2",
            noisy + "after 20 times tuck(1/2) over that before."),
    finding("figure.polyloops.noisy.push-pull", "polyloops 2",
            noisy + "after 20 times {tuck(1/2); tuck(-1/2)} over that before."),
    finding("figure.polyloops.noisy.balanced", "polyloops 2",
            noisy + "after 20 times {tuck(1/2); tuck(-53/100)} over that before."),
    finding("figure.polyloops.noisy.energy", "polyloops 2",
            noisy +
                "the sum of |M(B)|^2 over all vertices after 20 times {tuck(1/2); tuck(-53/100)} over that "
                "before."),
};

constexpr int repetitions = 20;

Laurent<Rational> filter(const std::string& text) {
  return weights_of(composed_operator<Rational>(parse_operators(text))).value();
}

/// Weights of 2/sqrt(6), which are rational as a pair.
Laurent<Rational> unstable_filter() {
  const auto op = composed_operator<Algebraic>(parse_operators("tuck(2/sqrt(6)); tuck(-2/sqrt(6))"));
  return map_coefficients(op.rows.front(), [](const Algebraic& x) { return x.to_rational(); });
}

void add_transfer(Results& results) {
  const std::string stronger = "{tuck(1/2); tuck(-7/10)}";  // told apart from -1/2 by eye
  struct Named {
    std::string name;
    Laurent<Rational> weights;
  };
  const std::vector<Named> filters{{"tuck(1/2)", filter("tuck(1/2)")},
                                   {"tuck(2/3)", filter("tuck(2/3)")},
                                   {"{tuck(1/2); tuck(-1/2)}", filter("tuck(1/2); tuck(-1/2)")},
                                   {stronger, filter(stronger)},
                                   {"20 times that", filter(stronger)},
                                   {"{tuck(2/√6); tuck(-2/√6)}", unstable_filter()}};
  Series series{"polyloops-transfer", {"omega/pi"}, {}};
  for (const Named& f : filters) series.columns.push_back(f.name);
  constexpr int steps = 120;
  constexpr int digits = 15;
  for (int k = 0; k <= steps; ++k) {
    std::vector<std::string> row{to_significant(Rational(k, steps), digits)};
    for (std::size_t i = 0; i < filters.size(); ++i) {
      const auto as_interval = [](const Rational& q) { return Interval(q); };
      const Laurent<Interval> weights = map_coefficients(filters[i].weights, as_interval);
      Interval value(weights[0]);  // g = w_0 + 2 sum of w_j cos j omega
      for (int j = 1; j <= weights.last(); ++j)
        value += Interval(2) * weights[j] * cosine_of_turn<Interval>(j * k, 2 * steps);
      if (filters[i].name == "20 times that") {
        Interval power(1);
        for (int n = 0; n < repetitions; ++n) power *= value;
        value = power;
      }
      row.push_back(to_significant(value.midpoint(), digits));
    }
    series.rows.push_back(std::move(row));
  }
  Figure figure{
      "polyloops-transfer",
      "What smoothing operators keep of each frequency",
      "frequency ω/π (1: every second vertex)",
      "factor g(ω)",
      {},
      "set xrange [0:1]; set yrange [-1.8:2]; set ytics 0.5\n" + style::across("1") + style::across("-1"),
      {"figure.polyloops.transfer", "figure.polyloops.transfer.crossing"}};
  for (std::size_t i = 0; i < filters.size(); ++i)
    figure.curves.push_back(
        {series.name, series.columns[0], filters[i].name, filters[i].name, style::curve(i)});
  results.series.push_back(std::move(series));
  results.figures.push_back(std::move(figure));

  const LargestGain largest = largest_gain(filter(stronger));
  const std::string at = "At cos omega = " + largest.cosine.value().to_string() + ".";
  results.claims.push_back(settle(head(table, "figure.polyloops.transfer"), largest.gain, at));
  // 1 - g = x ((s - t) + s t x) vanishes at x = (t - s)/(s t), x = 1 - cos omega.
  const Rational s(1, 2);
  const Rational t(7, 10);
  const Rational cosine = Rational(1) - (t - s) / (s * t);
  if (transfer_at_cosine(filter(stronger), cosine) != Rational(1))
    throw std::logic_error("the frequency is not kept");
  results.claims.push_back(settle(head(table, "figure.polyloops.transfer.crossing"), exact(cosine)));
}

using Loop = std::array<VertexChain<Rational>, 2>;

Loop smoothed(Loop loop, const std::string& text) {
  const OperatorSequence sequence = parse_operators(text);
  const auto operators = operators_of<Rational>(sequence);
  for (const std::size_t i : sequence.order) {
    for (VertexChain<Rational>& coordinate : loop) coordinate = apply(operators[i], coordinate);
  }
  return loop;
}

Rational area(const Loop& loop) {
  const auto& [xs, ys] = loop;
  const std::size_t n = xs.vertices.size();
  Rational twice(0);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    twice += xs.vertices[i] * ys.vertices[next] - xs.vertices[next] * ys.vertices[i];
  }
  return twice / Rational(2);
}

/// The sum of |M(B)|^2.
Rational energy(const Loop& loop) {
  const Laurent<Rational> laplace(-1, {Rational(1, 2), Rational(-1), Rational(1, 2)});
  Rational sum(0);
  for (const VertexChain<Rational>& coordinate : loop) {
    for (const Rational& x : apply_to_loop(laplace, coordinate.vertices)) sum += x * x;
  }
  return sum;
}

PlanePoints points_of(const Loop& loop) {
  PlanePoints points;
  for (std::size_t i = 0; i < loop[0].vertices.size(); ++i)
    points.emplace_back(loop[0].vertices[i], loop[1].vertices[i]);
  return points;
}

void add_noisy(Results& results) {
  Loop loop;
  for (const auto& [x, y] : polygon_from_data("polyloop-noisy.csv")) {
    loop[0].vertices.push_back(x);
    loop[1].vertices.push_back(y);
  }
  const Rational whole = area(loop);
  Drawing drawing{"polyloops-noisy",
                  "A noisy polyloop, and after 20 repetitions of smoothing operators",
                  {},
                  {"figure.polyloops.noisy."}};
  drawing.panels.push_back(
      {"96 vertices", {{"noisy polyloop", points_of(loop), true, style::in_colour(style::black, 1)}}});
  constexpr int digits = 6;
  const auto add = [&](const std::string& id, const std::string& text, std::size_t colour) {
    const Loop after = smoothed(loop, "{" + text + "}^" + std::to_string(repetitions));
    const Rational kept = area(after) / whole;
    results.claims.push_back(settle(head(table, id),
                                    certified(Interval(kept), "exact areas, rounded outwards"),
                                    "The share is " + to_significant(kept, digits) + "."));
    drawing.panels.push_back({fmt::format("area {}", to_significant(kept, 3)),
                              {{"", points_of(loop), true, style::polygon},
                               {text, points_of(after), true, style::curve(colour)}}});
    return after;
  };
  (void)add("figure.polyloops.noisy.tuck", "tuck(1/2)", 0);
  (void)add("figure.polyloops.noisy.push-pull", "tuck(1/2); tuck(-1/2)", 1);
  const Loop balanced = add("figure.polyloops.noisy.balanced", "tuck(1/2); tuck(-53/100)", 2);
  const Rational roughness = energy(balanced) / energy(loop);
  results.claims.push_back(settle(head(table, "figure.polyloops.noisy.energy"),
                                  certified(Interval(roughness), "exact sums, rounded outwards"),
                                  "The share is " + to_significant(roughness, digits) + "."));
  add_drawing(results, drawing);
}

}  // namespace

std::span<const ClaimHead> polyloop_filter_heads() { return table; }

Results run_polyloop_filters() {
  Results results;
  add_transfer(results);
  add_noisy(results);
  return results;
}

}  // namespace subdiv
