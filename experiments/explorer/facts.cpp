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

/// Facts gathered one after the other; those that are implied by stronger ones fall away.
class Gathering {
 public:
  void prove(int order, const std::string& why, const std::string& claim) {
    if (order > proved_.order) proved_ = {order, why, claim};
  }
  void refute(int order, const std::string& why, const std::string& claim) {
    if (refuted_.order < 0 || order < refuted_.order) refuted_ = {order, why, claim};
  }
  [[nodiscard]] int proved() const { return proved_.order; }

  [[nodiscard]] Continuity result() const {
    Continuity result{proved_.order, refuted_.order, "", {}};
    for (const Fact* fact : {&proved_, &refuted_}) {
      const auto add = [](std::string& text, const std::string& more) {
        if (!more.empty() && text.find(more) == std::string::npos) text += (text.empty() ? "" : "; ") + more;
      };
      add(result.reason, fact->why);
      if (!fact->claim.empty() && (result.claims.empty() || result.claims[0] != fact->claim))
        result.claims.push_back(fact->claim);
    }
    return result;
  }

 private:
  struct Fact {
    int order = -1;
    std::string why;
    std::string claim;
  };
  Fact proved_;
  Fact refuted_;
};

std::string exactly(int order, const std::string& name, const Rational& lower, const Rational& upper) {
  return "C" + std::to_string(order) + " exactly for " + interval_text(name, lower, upper);
}

Continuity on_diagonal(const Facts& facts, const Rational& s) {
  Gathering known;
  int highest = -1;
  for (const Facts::Range& range : facts.ranges) {
    highest = std::max(highest, range.order);
    const bool inside = range.lower == range.upper ? s == range.lower : range.lower < s && s < range.upper;
    const std::string why = exactly(range.order, "s", range.lower, range.upper);
    if (inside) {
      known.prove(range.order, why, range.claim);
    } else {
      known.refute(range.order, why, range.claim);
    }
  }
  // The last range is the quintic B-spline alone, a piecewise polynomial whose fifth derivative jumps.
  constexpr int quintic = 4;
  if (highest == quintic && known.proved() == quintic)
    known.refute(quintic + 1, "a quintic B-spline curve", "");
  return known.result();
}

bool on_line(const Facts& facts, const Rational& a, const Rational& b) {
  return std::any_of(facts.lines.begin(), facts.lines.end(), [&](const auto& l) { return l.contains(a, b); });
}

Continuity elsewhere(const Facts& facts, const Rational& a, const Rational& b) {
  Gathering known;
  bool c2_on_a_line = false;
  for (const Facts::Line& line : facts.lines) {
    if (!line.contains(a, b)) continue;
    const std::string why = "on this line " + exactly(line.order, "b", line.lower, line.upper);
    if (line.lower < b && b < line.upper) {
      known.prove(line.order, why, line.claim);
      c2_on_a_line = c2_on_a_line || line.order == 2;
    } else {
      known.refute(line.order, why, line.claim);
    }
  }
  const bool dependent = on_line(facts, a, b);  // limits may be smoother than the scheme
  for (const Facts::Cell& cell : facts.cells) {
    const bool inside = cell.a[0] <= a && a <= cell.a[1] && cell.b[0] <= b && b <= cell.b[1];
    if (!inside || (!cell.smooth && dependent)) continue;
    const std::string where = "C" + std::to_string(cell.order) +
                              (cell.smooth ? " throughout " : " nowhere in ") +
                              "a = " + cell.a[0].to_string() + " .. " + cell.a[1].to_string() +
                              ", b = " + cell.b[0].to_string() + " .. " + cell.b[1].to_string();
    const std::string claim = "smooth.map.c" + std::to_string(cell.order) + (cell.smooth ? ".in" : ".out");
    if (cell.smooth) {
      known.prove(cell.order, where, claim);
    } else {
      known.refute(cell.order, where, claim);
    }
  }
  const bool c2_is_known = facts.c2_is_decided && !c2_on_a_line;
  if (c2_is_known) known.refute(2, "C2 for a = b and on a part of a = 2 only", "smooth.ab.c2");
  return known.result();
}

/// Differences of divided differences grow at most like the sixth root of the norm of six steps (Warren &
/// Weimer, p. 77): the exponent is at least 1 minus its logarithm.
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
