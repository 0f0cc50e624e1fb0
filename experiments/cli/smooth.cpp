#include <algorithm>
#include <cmath>
#include <iostream>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analysis/curve_measures.h"
#include "analysis/polyloop/transfer_function.h"
#include "experiments/cli/control_points.h"
#include "experiments/cli/verbs.h"
#include "experiments/polygon_file.h"
#include "experiments/report/curve_writer.h"
#include "schemes/bspline.h"
#include "schemes/input_error.h"
#include "schemes/polyloop/apply_operator.h"
#include "schemes/polyloop/operator_sequence.h"
#include "schemes/text.h"

namespace subdiv::cli {
namespace {

using Json = nlohmann::ordered_json;
using Chains = std::vector<VertexChain<double>>;  // one a coordinate

/// Polygons are kept in memory.
constexpr std::size_t most_vertices = std::size_t{1} << 24U;

Polyline polyline_of(const Chains& chains) {
  std::vector<std::vector<double>> coordinates;
  for (const VertexChain<double>& chain : chains) coordinates.push_back(chain.vertices);
  return make_polyline(std::move(coordinates), chains.front().closed);
}

Chains read_chains(const SmoothOptions& options) {
  const PointList<double> points = read_points<double>(options.input);
  const bool closed = options.open.empty();
  if (points.closed.has_value() && *points.closed != closed) {
    throw InputError(options.input + (*points.closed
                                          ? ": its line element is closed; leave --open out"
                                          : ": its line element is open; say --open drop or --open keep"));
  }
  Chains chains;
  for (const std::vector<double>& coordinate : points.coordinates) chains.push_back({coordinate, closed, 0});
  require_measurable(polyline_of(chains), options.input);
  return chains;
}

/// Applies the sequence `repeat` times. InputError names the operator and the repetition where vertices leave
/// the range of doubles, become too many, or none is left.
Chains smoothed(Chains chains, const SmoothOptions& options, const OperatorSequence& sequence) {
  const std::vector<PolyloopOperator<double>> operators = operators_in_double(sequence);
  const OpenRule rule = options.open == "keep" ? OpenRule::keep : OpenRule::drop;
  for (long k = 1; k <= options.repeat; ++k) {
    for (const std::size_t i : sequence.order) {
      const auto where = [&] {
        return fmt::format("--operators, {} in repetition {}", in_quotes(sequence.calls[i].text), k);
      };
      const auto grows = static_cast<std::size_t>(operators[i].outputs() / operators[i].period);
      if (chains.front().vertices.size() > most_vertices / std::max<std::size_t>(1, grows)) {
        throw InputError(fmt::format("{}: more than {} vertices; refine less often", where(), most_vertices));
      }
      for (VertexChain<double>& chain : chains) {
        try {
          chain = apply(operators[i], chain, rule);
        } catch (const InputError& error) {
          throw InputError(where() + ": " + error.what());
        }
      }
      if (chains.front().vertices.empty()) {
        throw InputError(where() +
                         ": no vertex is left of the open polygon, whose ends the rules reach; "
                         "--open keep holds vertices in their places, or repeat less often");
      }
      require_measurable(polyline_of(chains), where());
    }
  }
  return chains;
}

/// The largest gain of one sequence, where it is a filter: it treats all vertices alike and keeps their
/// number.
std::optional<LargestGain> gain_of(const OperatorSequence& sequence) {
  const std::vector<PolyloopOperator<Rational>> operators = operators_of<Rational>(sequence);
  std::vector<FilterPart> parts;
  for (std::size_t i = 0; i < operators.size(); ++i) {
    const auto weights = weights_of(operators[i]);
    if (!weights) return std::nullopt;
    parts.push_back({*weights, std::ranges::count(sequence.order, i)});
  }
  return largest_gain(parts);
}

/// Roots may cancel in the whole sequence, as those of {tuck(sqrt(1/2)); tuck(-sqrt(1/2))} do: tried for
/// short sequences of quadratic numbers, where that is fast.
std::optional<Laurent<Rational>> rational_weights(const OperatorSequence& sequence) {
  constexpr std::size_t longest = 4;
  if (sequence.order.size() > longest) return std::nullopt;
  std::vector<PolyloopOperator<Algebraic>> steps;
  for (const PolyloopOperator<Algebraic>& op : operators_of<Algebraic>(sequence)) {
    for (const Laurent<Algebraic>& row : op.rows) {
      if (std::ranges::any_of(row.coefficients(), [](const Algebraic& x) { return x.degree() > 2; }))
        return std::nullopt;
    }
    steps.push_back(op);
  }
  std::vector<PolyloopOperator<Algebraic>> ordered;
  for (const std::size_t i : sequence.order) ordered.push_back(steps[i]);
  const auto weights = weights_of(subdiv::sequence(ordered));
  if (!weights || !std::ranges::all_of(weights->coefficients(), &Algebraic::is_rational)) return std::nullopt;
  return map_coefficients(*weights, [](const Algebraic& x) { return x.to_rational(); });
}

/// What is known of the gain; roots make it an enclosure without a place.
struct Gain {
  Enclosure value;
  std::optional<Algebraic> cosine;
};

std::optional<Gain> interval_gain(const OperatorSequence& sequence) {
  const auto operators = operators_of<Interval>(sequence, {}, IntervalLiteral{});
  std::vector<IntervalFilterPart> parts;
  for (std::size_t i = 0; i < operators.size(); ++i) {
    const PolyloopOperator<Interval>& op = operators[i];
    if (op.period != 1 || op.outputs() != 1) return std::nullopt;
    parts.push_back({op.rows.front(), std::ranges::count(sequence.order, i)});
  }
  return Gain{largest_gain(parts), std::nullopt};
}

std::optional<Gain> find_gain(const OperatorSequence& sequence) {
  try {
    const std::optional<LargestGain> exact = gain_of(sequence);
    if (!exact) return std::nullopt;
    return Gain{exact->gain, exact->cosine};
  } catch (const OutsideRingError&) {
    try {
      if (const auto weights = rational_weights(sequence)) {
        const LargestGain exact = largest_gain(*weights);
        return Gain{exact.gain, exact.cosine};
      }
    } catch (const OutsideRingError&) {  // of too high a degree: intervals hold everything
      return interval_gain(sequence);
    }
    return interval_gain(sequence);
  }
}

/// Of closed plane polygons.
std::optional<double> area_of(const Polyline& polyline) {
  if (!polyline.topology.closed || polyline.coordinates.size() != 2) return std::nullopt;
  return signed_area(polyline);
}

/// "3/2" where that is short; an upper bound where the enclosure is wide.
std::string gain_text(const Enclosure& value) {
  constexpr std::size_t longest = 24;
  if (!value.exact.empty() && value.exact.size() <= longest) return value.exact;
  if (!std::isfinite(value.upper.to_double())) return "more than 1.7e308";
  const bool narrow = value.width() < Rational(1, 1000000000) * value.upper;
  return narrow ? fmt::format("about {:.10g}", value.midpoint().to_double())
                : fmt::format("{:.8g}", value.upper.to_double());
}

std::string frequency_text(const Algebraic& cosine) {
  if (cosine == Algebraic(-1)) return "pi";
  if (cosine == Algebraic(1)) return "0";
  return fmt::format("{:.6g} (cos {:.6g})", std::acos(cosine.to_interval().to_double()),
                     cosine.to_interval().to_double());
}

/// Before and after, where both are known.
template <class Value>
std::string kept(const Value& before, const Value& after) {
  return before != 0 ? fmt::format("{:.8g}", after / before) : "-";
}

struct Report {
  Polyline before;
  Polyline after;
  std::optional<Gain> gain;
};

void print(const Report& report, const SmoothOptions& options) {
  std::cout << fmt::format("vertices  {} -> {}\n", curve_size(report.before.topology),
                           curve_size(report.after.topology));
  const double before = length(report.before);
  const double after = length(report.after);
  std::cout << fmt::format("length    {:.10g} -> {:.10g}, kept {}\n", before, after, kept(before, after));
  const auto area = area_of(report.before);
  const auto area_after = area_of(report.after);
  if (area && area_after)
    std::cout << fmt::format("area      {:.10g} -> {:.10g}, kept {}\n", *area, *area_after,
                             kept(*area, *area_after));
  if (!report.gain) {
    std::cout << "gain      - (the sequence makes new vertices or tells them apart)\n";
    return;
  }
  std::cout << "gain      " << gain_text(report.gain->value);
  if (report.gain->cosine) std::cout << " at frequency " << frequency_text(*report.gain->cosine);
  std::cout << (options.repeat > 1 ? ", in each repetition\n" : "\n");
}

Json to_json(const Report& report, const SmoothOptions& options, const OperatorSequence& sequence) {
  const auto text = [](double x) { return fmt::format("{}", x); };
  Json json = {
      {"input", options.input},
      {"operators", sequence.text},
      {"repeat", options.repeat},
      {"closed", options.open.empty()},
      {"dimension", report.before.coordinates.size()},
      {"vertices",
       {{"before", curve_size(report.before.topology)}, {"after", curve_size(report.after.topology)}}},
      {"length", {{"before", text(length(report.before))}, {"after", text(length(report.after))}}}};
  const auto area = area_of(report.before);
  const auto area_after = area_of(report.after);
  if (area && area_after) json["area"] = {{"before", text(*area)}, {"after", text(*area_after)}};
  if (report.gain) {
    const Enclosure& value = report.gain->value;
    Json gain;
    if (!value.exact.empty()) gain["exact"] = value.exact;
    constexpr int digits = 17;
    gain["lower"] = to_significant(value.lower, digits, -1);
    gain["upper"] = to_significant(value.upper, digits, 1);
    if (report.gain->cosine) gain["cosine"] = report.gain->cosine->to_string();
    gain["amplifies"] = to_string(amplifies(value));
    json["gain"] = std::move(gain);
  }
  return json;
}

void warn(const std::optional<Gain>& gain) {
  if (!gain || amplifies(gain->value) != Decision::yes) return;
  std::cerr
      << "subdivlab: warning: the sequence amplifies the frequency "
      << (gain->cosine ? frequency_text(*gain->cosine) : "of its largest gain") << " by "
      << gain_text(gain->value)
      << "; repeated, it lets it grow. {tuck(s); tuck(-t)} is stable for 0 <= t <= s <= (1 + t)/(1 + 2t)\n";
}

void write(const Report& report, const std::string& out) {
  OutputFile file(out);
  const CurveBlocks<double> curve(stationary("", bspline<double>(1)), report.after, 0);
  write_curve(file, curve_format(out), curve, report.after.topology.closed);
  file.finish();
}

}  // namespace

int smooth(const SmoothOptions& options) {
  (void)curve_format(options.out);  // before anything is computed
  if (!options.json.empty() && have_same_target(options.json, options.out)) {
    throw InputError("--json " + options.json + ": " +
                     (is_standard_output(options.out) ? "standard output takes the polygon already"
                                                      : "-o " + options.out + " writes this file") +
                     "; the report needs another one");
  }
  const OperatorSequence sequence = parse_operators(options.operators);
  (void)operators_in_double(sequence);
  const Chains chains = read_chains(options);
  Report report{polyline_of(chains), polyline_of(smoothed(chains, options, sequence)), find_gain(sequence)};
  const bool to_output = is_standard_output(options.out);
  std::optional<OutputFile> json;
  if (!options.json.empty()) {
    json.emplace(options.json);
    json->write(to_json(report, options, sequence).dump(2) + "\n");
    json->close();
  }
  write(report, options.out);
  if (json) json->finish();
  warn(report.gain);
  if (!to_output && (options.json.empty() || !is_standard_output(options.json))) print(report, options);
  return ExitCode::done;
}

}  // namespace subdiv::cli
