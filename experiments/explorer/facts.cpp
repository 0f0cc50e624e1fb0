#include "experiments/explorer/facts.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "analysis/iterate_norm.h"
#include "schemes/jspline.h"

namespace subdiv::explorer {
namespace {

/// The words of one line.
class Words {
 public:
  explicit Words(const std::string& line) : line_(line), stream_(line) {}

  std::string text() {
    std::string word;
    if (!(stream_ >> word)) throw std::invalid_argument("'" + line_ + "' is no fact");
    return word;
  }
  Rational number() { return Rational::parse(text()); }
  int order() {
    const std::string word = text();
    constexpr int highest = 9;
    if (word.size() != 1 || word[0] < '0' || word[0] > '0' + highest)
      throw std::invalid_argument("'" + line_ + "': an order of continuity is a digit");
    return word[0] - '0';
  }

 private:
  std::string line_;
  std::istringstream stream_;
};

void add_fact(Facts& facts, const std::string& line) {
  Words words(line);
  const std::string kind = words.text();
  if (kind == "range") {
    Facts::Range range{words.order(), words.number(), words.number(), words.text()};
    facts.ranges.push_back(std::move(range));
  } else if (kind == "line") {
    Facts::Line on{words.order(),
                   {words.number(), words.number(), words.number()},
                   words.number(),
                   words.number(),
                   words.text()};
    facts.lines.push_back(std::move(on));
  } else if (kind == "cell") {
    Facts::Cell cell{words.order(),
                     words.text() == "in",
                     {words.number(), words.number()},
                     {words.number(), words.number()}};
    facts.cells.push_back(std::move(cell));
  } else if (kind == "c2-decided") {
    facts.c2_is_decided = true;
  } else {
    throw std::invalid_argument("'" + line + "' is no fact");
  }
}

std::string interval_text(const std::string& name, const Rational& lower, const Rational& upper) {
  return lower == upper ? name + " = " + lower.to_string()
                        : lower.to_string() + " < " + name + " < " + upper.to_string();
}

void prove(Continuity& result, int order, const std::string& why, const std::string& claim) {
  if (order <= result.proved) return;
  result.proved = order;
  result.reason = why;
  if (!claim.empty()) result.claims.push_back(claim);
}

void refute(Continuity& result, int order, const std::string& claim) {
  if (result.refuted >= 0 && order >= result.refuted) return;
  result.refuted = order;
  if (!claim.empty()) result.claims.push_back(claim);
}

Continuity on_diagonal(const Facts& facts, const Rational& s) {
  Continuity result;
  for (const Facts::Range& range : facts.ranges) {
    const bool inside = range.lower == range.upper ? s == range.lower : range.lower < s && s < range.upper;
    if (inside) {
      prove(
          result, range.order,
          "C" + std::to_string(range.order) + " exactly for " + interval_text("s", range.lower, range.upper),
          range.claim);
    } else {
      refute(result, range.order, range.claim);
    }
  }
  int highest = -1;
  for (const Facts::Range& range : facts.ranges) highest = std::max(highest, range.order);
  // C4 at one point only, the quintic B-spline, whose exponent is 5 and which is no C5 curve.
  if (highest >= 0 && result.proved == highest) refute(result, highest + 1, "");
  return result;
}

bool on_line(const Facts& facts, const Rational& a, const Rational& b) {
  return std::any_of(facts.lines.begin(), facts.lines.end(), [&](const auto& l) { return l.contains(a, b); });
}

Continuity elsewhere(const Facts& facts, const Rational& a, const Rational& b) {
  Continuity result;
  bool c2_on_a_line = false;
  for (const Facts::Line& line : facts.lines) {
    if (!line.contains(a, b)) continue;
    if (line.lower < b && b < line.upper) {
      prove(result, line.order,
            "on this line C" + std::to_string(line.order) + " exactly for " +
                interval_text("b", line.lower, line.upper),
            line.claim);
      c2_on_a_line = c2_on_a_line || line.order == 2;
    } else {
      refute(result, line.order, line.claim);
    }
  }
  for (const Facts::Cell& cell : facts.cells) {
    const bool inside = cell.a[0] <= a && a <= cell.a[1] && cell.b[0] <= b && b <= cell.b[1];
    if (!inside) continue;
    const std::string claim = "smooth.map.c" + std::to_string(cell.order) + (cell.smooth ? ".in" : ".out");
    if (cell.smooth) {
      prove(result, cell.order,
            "C" + std::to_string(cell.order) + " throughout " + interval_text("a", cell.a[0], cell.a[1]) +
                ", " + interval_text("b", cell.b[0], cell.b[1]),
            claim);
    } else if (!on_line(facts, a,
                        b)) {  // where shifts are independent, the limits are no smoother than the scheme
      refute(result, cell.order, claim);
    }
  }
  if (facts.c2_is_decided && !c2_on_a_line) refute(result, 2, "smooth.ab.c2");
  return result;
}

/// From the norm of six steps of the second differences, or of the fourth ones on the diagonal: rho is at
/// most its sixth root.
std::optional<Rational> lower_by_norms(const Mask<Rational>& mask) {
  constexpr int steps = 6;
  const auto symbol = difference_symbol(mask, 1);
  if (!symbol || symbol->is_zero()) return std::nullopt;
  const Rational norm = iterate_norms(*symbol, 2, steps).back();
  if (norm.sign() <= 0) return std::nullopt;
  Rational bound = Rational(1) - log2_bracket(norm).upper / Rational(steps);
  if (bound.sign() <= 0) return std::nullopt;
  return bound;
}

}  // namespace

Facts parse_facts(std::string_view text) {
  Facts facts;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty()) add_fact(facts, line);
  }
  return facts;
}

Continuity continuity(const Facts& facts, const Rational& a, const Rational& b) {
  return a == b ? on_diagonal(facts, a) : elsewhere(facts, a, b);
}

ExponentBounds exponent_bounds(const Facts& facts, const Rational& a, const Rational& b) {
  if (a == b) {
    const auto exponent = jspline_exponent(a);
    if (!exponent) return {{}, {}, "", "no limit"};
    return {exponent->value.lower, exponent->value.upper, exponent->formula, "closed form"};
  }
  ExponentBounds bounds;
  if (const auto lower = lower_by_norms(jspline(a, b))) {
    bounds.lower = lower;
    bounds.reason = "norm of six steps";
  }
  const Continuity known = elsewhere(facts, a, b);
  if (known.proved >= 0 && (!bounds.lower || *bounds.lower < Rational(known.proved)))
    bounds.lower = Rational(known.proved);
  if (known.refuted >= 0) bounds.upper = Rational(known.refuted);
  return bounds;
}

}  // namespace subdiv::explorer
