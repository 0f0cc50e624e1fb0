#include "experiments/ringing.h"

#include <array>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "experiments/printed_ringing.h"
#include "schemes/algebra/rational_function.h"
#include "schemes/evaluate/level_by_level.h"
#include "schemes/evaluate/ringing.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

const std::string generic =
    "Over Q(a, b, s), for {J_{a,b}, *J_s} on a closed loop of 6 control points that stand for themselves "
    "(so for all points), 3 refinements. ";
const std::string traced = "The rings that the printed code pushes, traced call by call with 2 refinements. ";

const std::array table{
    ClaimHead{
        "ringing.footprint", "js-report", "12, 14 and abstract", "5", ClaimKind::exact,
        "Points that a ring keeps, counted: the least window of consecutive points around a vertex that "
        "{J_{a,b}, *J_s} maps into itself, for indeterminate a, b, s."},
    finding("ringing.footprint.moving", "js-report 12",
            "Points of a ring that its child reads while both move: the rules' reach at all positions of the "
            "child, for indeterminate a, b, s. The others only serve to begin anywhere on the curve."),
    ClaimHead{"ringing.no-redundancy", "js-report", "abstract, 12",
              "without having to perform any redundant computation", ClaimKind::exact,
              "Points loaded or computed at each level, counted, against the points that the level has, for "
              "closed loops of 3, 5 and 8 points refined 1 to 7 times."},
    finding(
        "ringing.repeated.inner", "js-report 12",
        "Points that a closed loop computes at each level above the last beyond those that the level has."),
    finding("ringing.repeated.last", "js-report 12",
            "Points that a closed loop computes at the last level beyond those that the curve has."),
    finding(
        "ringing.once", "js-report 12",
        "On a part of the curve without its wrap, 8 times as long as another, every level computes exactly "
        "the additional points of that level and no others."),
    ClaimHead{"ringing.same-curve", "js-report", "12",
              "producing one-by-one the series of consecutive points on the final curve", ClaimKind::exact,
              generic + "The same points as level-by-level refinement, at all depths 0 .. 3."},
    ClaimHead{"ringing.minimum-input", "js-report", "14",
              "A closed-loop (circle-like) curve may be defined by 3 control points", ClaimKind::exact,
              "3 points refined by *J_1, *J_{3/2}: the area of the triangle of limit points at the vertices "
              "is not zero; with 2 points every refined polygon lies on a line, and with 1 at a point."},
    ClaimHead{"ringing.appendix", "js-report", "appendix 1",
              "Then, we advance R[L] along the curve be repeating P.next()", ClaimKind::exact,
              generic +
                  "The points that the printed code returns, with a Stepper made for that depth, are the "
                  "refined points in their order."},
    finding("ringing.appendix.first-point", "js-report appendix 1",
            generic +
                "By how many points the first one that the printed next() returns is behind the point at "
                "which the rings are derived. Where it is not 0, an open curve loses its first point; a "
                "closed one has it last."),
    ClaimHead{
        "ringing.appendix.reset", "js-report", "appendix 1",
        "void reset() {for(int i=0; i<d; i++) B[i]=true; d=rec;}", ClaimKind::exact,
        "After a curve has been drawn with 1 refinement and the number is changed to 3, the printed code "
        "returns the refined points of *J_s, over Q(s)."},
    finding(
        "ringing.appendix.depth", "js-report appendix 1",
        "The largest number of refinements for which the printed arrays suffice: ring [7], boolean [10]."),
    ClaimHead{"ringing.appendix.stepper-comment", "js-report", "appendix 1",
              "returns ID of ring that should do a b3 step", ClaimKind::exact,
              traced + "The number that Stepper.next() returns names the ring that is pushed with b3."},
    ClaimHead{"ringing.appendix.stepper-text", "js-report", "appendix 1",
              "returns the highest index of the rings must be advanced at each step", ClaimKind::exact,
              traced + "The number that Stepper.next() returns is the highest index of the rings pushed."},
    ClaimHead{"ringing.appendix.f23-comment", "js-report", "appendix 1", "f23: f for fourth mid-edge",
              ClaimKind::exact,
              "The place of f23's point on the ring A, .., E at the abscissae 1, .., 5: the mid-edge point "
              "between vertices k and k+1 counts as the k-th."},
    ClaimHead{"ringing.appendix.b3-comment", "js-report", "appendix 1", "b3: b for fifth vertex",
              ClaimKind::exact, "The place of b3's point on the ring A, .., E at the abscissae 1, .., 5."},
    ClaimHead{
        "ringing.figure-14", "js-report", "12, figure 14",
        "(d) advance r0 by computing its new vertex from the last 4 vertices of r1; (e) advance r0 again",
        ClaimKind::exact, traced + "Steps (d), (e), (g) and the last advance r0."},
};

using Function = RationalFunction;
/// A point as a combination of control points: the coefficient of z^j belongs to P_j.
using Combination = Laurent<Function>;

constexpr int loop_size = 6;
constexpr int generic_depth = 3;

const ClaimHead& claim(const std::string& id) { return head(table, id); }
Function a() { return Function::variable(0); }
Function b() { return Function::variable(1); }
Function s() { return Function::variable(2); }

Scheme<Function> generic_scheme() {
  return mixed(stationary("J", jspline(a(), b())), stationary("J", jspline(s())));
}

std::vector<Combination> own_points() {
  std::vector<Combination> points;
  for (int j = 0; j < loop_size; ++j) points.push_back(Combination::monomial(j));
  return points;
}

std::vector<Combination> refined(const Scheme<Function>& scheme, int depth) {
  return curve_points(refine_level_by_level(scheme, closed_polygon(own_points()), depth));
}

Claim same_curve() {
  const ControlPolygon<Combination> controls = closed_polygon(own_points());
  const Scheme<Function> scheme = generic_scheme();
  bool same = true;
  for (int depth = 0; depth <= generic_depth; ++depth) {
    std::vector<Combination> points;
    Ringing<Function, Combination> rings(scheme, controls, depth);
    for (const Combination& p : rings) points.push_back(p);
    same = same && points == refined(scheme, depth);
  }
  return settle_statement(claim("ringing.same-curve"), same, same ? "true" : "false");
}

/// The offsets from the parent's centre that the child's next point reads, over all positions of the child.
int points_read(const Mask<Function>& mask, const IndexWindow& ring) {
  const auto rules = refinement_rules(mask);
  const int m = mask.arity;
  IndexWindow read{0, 0};
  for (int t = 0; t < m; ++t) {
    const int index = ring.last - t;  // the parent stands at 0, the child's centre moves to -t
    const auto& rule = rules[static_cast<std::size_t>(residue(index, m))];
    const int at = floor_divide(index, m);
    read = {std::min(read.first, at + rule.first), std::max(read.last, at + rule.last())};
  }
  return read.size();
}

void add_footprint(Results& results) {
  const Scheme<Function> scheme = generic_scheme();
  const IndexWindow ring = ring_window(scheme);
  results.claims.push_back(settle(claim("ringing.footprint"), exact(Rational(ring.size()), "counted")));
  const int read = std::max(points_read(scheme.step(0), ring), points_read(scheme.last(), ring));
  results.claims.push_back(settle(claim("ringing.footprint.moving"), exact(Rational(read), "counted"),
                                  "The trailing point of a ring is read only when rings are derived."));
}

/// The points that each level has computed when the first `spans` spans of a loop have been evaluated. Only
/// the counters matter: all points are 1.
std::vector<std::size_t> work(int points, int spans, int depth) {
  const ControlPolygon<Rational> controls =
      closed_polygon(std::vector<Rational>(static_cast<std::size_t>(points), Rational(1)));
  Ringing<Rational, Rational> rings(stationary("J", jspline(Rational(1, 2))), controls, depth);
  const auto end = static_cast<long long>(refined_spacing(2, depth)) * spans;
  while (rings.index() < end) rings.advance();
  std::vector<std::size_t> counts;
  for (std::size_t k = 0; k < rings.levels(); ++k) counts.push_back(rings.computed(k));
  return counts;
}

/// A number that all counted loops share.
struct Shared {
  std::optional<long> value;
  void require(long count) {
    if (value && *value != count) throw std::logic_error("the excess of ringing depends on the loop");
    value = count;
  }
};

void add_work(Results& results) {
  constexpr int most_refinements = 7;
  Shared inner;
  Shared last;
  for (const int n : {3, 5, 8}) {
    for (int depth = 1; depth <= most_refinements; ++depth) {
      const std::vector<std::size_t> counts = work(n, n, depth);
      for (int k = 0; k <= depth; ++k) {
        const long points = static_cast<long>(n) << k;
        (k < depth ? inner : last).require(static_cast<long>(counts[static_cast<std::size_t>(k)]) - points);
      }
    }
  }
  const bool none = *inner.value == 0 && *last.value == 0;
  results.claims.push_back(settle_statement(
      claim("ringing.no-redundancy"), none, none ? "true" : "false",
      fmt::format(
          "A closed loop computes {} points a level, and {} at the last, a second time where it wraps, "
          "however long it is; elsewhere each point is computed once. Surfaces by two display rings "
          "compute every transversal curve twice (ringing.no-redundancy.surface).",
          *inner.value, *last.value)));
  results.claims.push_back(settle(claim("ringing.repeated.inner"), exact(Rational(*inner.value), "counted")));
  results.claims.push_back(settle(claim("ringing.repeated.last"), exact(Rational(*last.value), "counted")));
  constexpr int spans = 2;
  constexpr int factor = 8;
  constexpr int depth = 5;
  const std::vector<std::size_t> part = work(2 * spans, spans, depth);
  const std::vector<std::size_t> longer = work(2 * factor * spans, factor * spans, depth);
  bool once = true;
  for (int k = 0; k <= depth; ++k) {
    const auto level = static_cast<std::size_t>(k);
    once = once && longer[level] - part[level] == static_cast<std::size_t>((factor - 1) * spans) << level;
  }
  results.claims.push_back(settle_statement(claim("ringing.once"), once, "true"));
}

/// Twice the signed area of a triangle.
Rational doubled_area(const std::array<std::array<Rational, 2>, 3>& p) {
  const auto side = [&](std::size_t i, std::size_t c) { return p[i][c] - p[0][c]; };
  return side(1, 0) * side(2, 1) - side(1, 1) * side(2, 0);
}

Claim minimum_input() {
  constexpr int depth = 3;
  bool holds = true;
  for (const Rational& at : {Rational(1), Rational(3, 2)}) {
    const Scheme<Rational> scheme = stationary("J", jspline(at));
    const auto curve = [&](const std::vector<Rational>& coordinate) {
      std::vector<Rational> points;
      const ControlPolygon<Rational> controls = closed_polygon(coordinate);
      Ringing<Rational, Rational> rings(scheme, controls, depth);
      for (const Rational& p : rings) points.push_back(p);
      return points;
    };
    const std::vector<Rational> x = curve({0, 1, 0});
    const std::vector<Rational> y = curve({0, 0, 1});
    const std::size_t third = x.size() / 3;
    holds = holds &&
            doubled_area({{{x[0], y[0]}, {x[third], y[third]}, {x[2 * third], y[2 * third]}}}).sign() != 0;
    const std::vector<Rational> on_line = curve({0, 1});
    const std::vector<Rational> on_same_line = curve({0, 2});  // (0, 0) and (1, 2): y = 2 x throughout
    for (std::size_t i = 0; i < on_line.size(); ++i)
      holds = holds && on_same_line[i] == Rational(2) * on_line[i];
    for (const Rational& p : curve({Rational(5)})) holds = holds && p == Rational(5);
  }
  return settle_statement(claim("ringing.minimum-input"), holds, holds ? "true" : "false",
                          "One and two points are evaluated too; their curves are a point and a segment that "
                          "is run through twice.");
}

using Code = printed::Polyloop<Function, Combination>;

/// By how many points the printed code's sequence is ahead of the refined curve; nothing when it is not the
/// curve from any of its points.
std::optional<std::size_t> lead(const std::vector<Combination>& returned,
                                const std::vector<Combination>& curve) {
  for (std::size_t shift = 0; shift < curve.size(); ++shift) {
    bool same = true;
    for (std::size_t i = 0; same && i < curve.size(); ++i)
      same = returned[i] == curve[(i + shift) % curve.size()];
    if (same) return shift;
  }
  return std::nullopt;
}

std::vector<Combination> returned_points(Code& code, std::size_t count) {
  std::vector<Combination> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back(code.next());
  return points;
}

void add_code(Results& results) {
  const std::vector<Combination> curve = refined(generic_scheme(), generic_depth);
  Code code(own_points(), a(), b(), s());
  code.make_stepper(generic_depth);
  code.load(generic_depth);
  const std::optional<std::size_t> ahead = lead(returned_points(code, curve.size()), curve);
  results.claims.push_back(
      settle_statement(claim("ringing.appendix"), ahead.has_value(), ahead ? "true" : "false"));
  // The rings are derived around C, the third control point: refined point 2 * 2^depth.
  const long derived = 2L << static_cast<unsigned>(generic_depth);
  const long first = ahead ? static_cast<long>(*ahead) - derived : 0;
  results.claims.push_back(
      settle(claim("ringing.appendix.first-point"), exact(Rational(first), "the printed code run"),
             "next() moves first and returns then; returning the point before the move mends it."));

  const std::vector<Combination> expected = refined(stationary("J", jspline(s())), generic_depth);
  Code reused(own_points(), s(), s(), s());
  reused.make_stepper(1);
  reused.load(1);
  (void)returned_points(reused, refined(stationary("J", jspline(s())), 1).size());
  reused.load(generic_depth);
  const bool works = lead(returned_points(reused, expected.size()), expected).has_value();
  results.claims.push_back(settle_statement(
      claim("ringing.appendix.reset"), works, works ? "true" : "false",
      "The method sets the flags of the old depth and then takes the new one, so that a changed number of "
      "refinements gives wrong points. With d=rec before the loop it is right."));

  std::size_t most = 0;
  for (;; ++most) {
    try {
      Code deeper(own_points(), s(), s(), s());
      deeper.make_stepper(most + 1);
      deeper.load(most + 1);
    } catch (const std::out_of_range&) {
      break;
    }
  }
  results.claims.push_back(settle(claim("ringing.appendix.depth"),
                                  exact(Rational(static_cast<long>(most)), "the printed code run")));
}

void add_trace(Results& results) {
  constexpr std::size_t depth = 2;
  constexpr std::size_t calls = 16;
  Code code(own_points(), s(), s(), s());
  code.make_stepper(depth);
  code.load(depth);
  std::vector<printed::Step> steps(calls);
  for (printed::Step& step : steps) (void)code.next(&step);
  bool names_b3 = true;
  bool highest = true;
  for (const printed::Step& step : steps) {
    for (const auto& [ring, function] : step.pushed)
      names_b3 = names_b3 && (function != 'b' || ring == step.answer);
    highest = highest && step.pushed.back().first == step.answer;
  }
  const auto settle_trace = [&](const std::string& id, bool holds, const std::string& note) {
    results.claims.push_back(settle_statement(claim(id), holds, holds ? "true" : "false", note));
  };
  settle_trace("ringing.appendix.stepper-comment", names_b3,
               "The number that is returned counts from the last ring: the ring pushed with b3 is rec minus "
               "the number, and a number of "
               "rec stands for a control point.");
  settle_trace("ringing.appendix.stepper-text", highest,
               "The highest index that is advanced is always that of the last ring, r_L; rec minus the "
               "number returned is the lowest one.");
  // After (a), the captions' steps: (b) r0 loads, (c) r1 by f23, (d) by f23, (e) by b3, (f) r1 by b3,
  // (g) by f23 and the last by b3: three calls, then the next begins.
  std::vector<std::pair<std::size_t, char>> order;
  for (std::size_t i = 0; i < 4; ++i)
    order.insert(order.end(), steps[i].pushed.begin(), steps[i].pushed.end());
  const std::vector<std::pair<std::size_t, char>> captions{{0, '0'}, {1, 'f'}, {0, 'f'}, {0, 'b'},
                                                           {1, 'b'}, {0, 'f'}, {0, 'b'}};
  settle_trace("ringing.figure-14", order == captions,
               "Steps (d), (e), (g) and the last advance r2, the last ring, from r1; r0 is loaded with "
               "control points alone. The letter "
               "(e) stands twice in the caption.");
}

/// Where the functions of a ring put their point when A, .., E stand at the abscissae 1, .., 5: J_s keeps
/// linear data, so that the k-th vertex is found at k and the mid-edge point behind it at k + 1/2.
void add_places(Results& results) {
  printed::Ring<Rational, Rational> ring;
  for (std::size_t i = 0; i < ring.points.size(); ++i) ring.points[i] = Rational(static_cast<int>(i) + 1);
  const Rational weight(1, 3);
  const Rational f23 = ring.f23(weight) - Rational(1, 2);
  const Rational b3 = ring.b3(weight);
  const auto settle_place = [&](const std::string& id, const Rational& found, int said,
                                fmt::format_string<std::string> what) {
    const bool holds = found == Rational(said);
    results.claims.push_back(
        settle_statement(claim(id), holds, holds ? "true" : "false", fmt::format(what, found.to_string())));
  };
  settle_place("ringing.appendix.f23-comment", f23, 4,
               "The function returns the mid-edge point of edge {}, not of the fourth.");
  settle_place("ringing.appendix.b3-comment", b3, 5,
               "The function returns the point of vertex {}, not of the fifth.");
}

}  // namespace

std::span<const ClaimHead> ringing_heads() { return table; }

Results run_ringing() {
  Results results;
  add_footprint(results);
  add_work(results);
  results.claims.push_back(same_curve());
  results.claims.push_back(minimum_input());
  add_code(results);
  add_trace(results);
  add_places(results);
  return results;
}

}  // namespace subdiv
