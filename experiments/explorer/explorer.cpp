#include "experiments/explorer/explorer.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>

#include "experiments/explorer/curve.h"
#include "experiments/explorer/facts.h"

namespace subdiv::explorer {
namespace {

/// What lives from call to call.
struct State {
  std::string reply;
  Facts facts;
  Curve curve;
};

State& state() {
  static State value;
  return value;
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return result + "\"";
}

std::string json(double x) {
  constexpr std::size_t room = 40;
  std::array<char, room> text{};
  if (!std::isfinite(x)) return "null";
  return {text.data(), static_cast<std::size_t>(std::snprintf(text.data(), text.size(), "%.17g", x))};
}
std::string json(const std::optional<double>& x) { return x ? json(*x) : "null"; }

std::string polygon_json(const Polyline& polygon) {
  std::string result = "[";
  for (std::size_t i = 0; i < polygon.coordinates[0].size(); ++i) {
    result += (i > 0 ? "," : "") + json(polygon.coordinates[0][i]) + "," + json(polygon.coordinates[1][i]);
  }
  return result + "]";
}

std::string curve_json(const Curve& curve) {
  return "{\"points\":" + std::to_string(curve.curve.topology.points) + ",\"length\":" + json(curve.length) +
         ",\"area\":" + json(curve.area) + ",\"polygonArea\":" + json(curve.polygon_area) +
         ",\"limitArea\":" + json(curve.limit_area) +
         ",\"largestJerk\":" + json(curve.jerk_of_level.largest) +
         ",\"meanJerk\":" + json(curve.jerk_of_level.mean) + ",\"polygon\":" + polygon_json(curve.polygon) +
         "}";
}

std::string smoothness_json(const Continuity& known, const ExponentBounds& bounds) {
  constexpr int decimals = 9;
  std::string claims;
  for (const std::string& claim : known.claims) claims += (claims.empty() ? "" : ",") + quoted(claim);
  const auto end = [](const std::optional<Rational>& x, int direction) {
    return x ? quoted(decimal_text(*x, decimals, direction)) : std::string("null");
  };
  const bool exact = bounds.lower && bounds.upper && *bounds.lower == *bounds.upper;
  return "{\"proved\":" + std::to_string(known.proved) + ",\"refuted\":" + std::to_string(known.refuted) +
         ",\"reason\":" + quoted(known.reason) + ",\"claims\":[" + claims +
         "],\"exponent\":{\"lower\":" + end(bounds.lower, -1) + ",\"upper\":" + end(bounds.upper, 1) +
         ",\"formula\":" + quoted(bounds.formula) + ",\"reason\":" + quoted(bounds.reason) +
         ",\"exact\":" + (exact ? "true" : "false") + "}}";
}

/// The reply of a call; an exception becomes {"error": ".."}.
template <class Call>
const char* reply(Call call) {
  std::string& text = state().reply;
  try {
    text = call();
  } catch (const std::exception& error) {
    text = "{\"error\":" + quoted(error.what()) + "}";
  }
  return text.c_str();
}

const std::vector<double>& array(int which) {
  const Curve& curve = state().curve;
  static const std::vector<double> none;
  constexpr int curvature = 2;
  constexpr int jerk = 3;
  if (which == curvature) return curve.curvature;
  if (which == jerk) return curve.jerk;
  const auto coordinate = static_cast<std::size_t>(which);
  return which >= 0 && coordinate < curve.curve.coordinates.size() ? curve.curve.coordinates[coordinate]
                                                                   : none;
}

}  // namespace
}  // namespace subdiv::explorer

using namespace subdiv::explorer;

const char* explorer_set_facts(const char* text) {
  return reply([&] {
    state().facts = parse_facts(text);
    return std::string("{}");
  });
}

const char* explorer_evaluate(const char* request, int with_limit_area) {
  return reply([&] {
    state().curve = evaluate(parse_request(request), with_limit_area != 0);
    return curve_json(state().curve);
  });
}

const double* explorer_array(int which) { return array(which).data(); }
int explorer_size(int which) { return static_cast<int>(array(which).size()); }

const char* explorer_smoothness(const char* a, const char* b) {
  return reply([&] {
    const subdiv::Rational first = subdiv::Rational::parse(a);
    const subdiv::Rational second = subdiv::Rational::parse(b);
    const Facts& facts = state().facts;
    return smoothness_json(continuity(facts, first, second), exponent_bounds(facts, first, second));
  });
}

const char* explorer_number(const char* text) {
  return reply([&] {
    const subdiv::Rational x = subdiv::Rational::parse(text);
    return "{\"value\":" + quoted(x.to_string()) + ",\"double\":" + json(x.to_double()) + "}";
  });
}
