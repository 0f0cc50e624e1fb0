#include "experiments/speed_characteristic_ring.h"

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "analysis/adjustable_speed/characteristic_ring_joins.h"
#include "analysis/adjustable_speed/characteristic_ring_map.h"
#include "analysis/adjustable_speed/contraction.h"
#include "analysis/adjustable_speed/ring_conditions.h"
#include "analysis/adjustable_speed/ring_theorem.h"
#include "schemes/algebra/rational_function.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

const std::string shapes =
    "Over Q(sigma, v), where lambda = q W, q = 1 - sigma, W = q + sigma v and 1 + c = v^2/W, which holds all "
    "speeds and valences: ";
const std::string differences =
    "The 97 conditions of analysis/adjustable_speed/ring_conditions.h: coordinates of the differences of "
    "Bezier "
    "coefficients of two patches have strict signs. ";

std::vector<ClaimHead> make_heads() {
  std::vector<ClaimHead> heads = ring_formula_heads();
  const auto add = [&](const char* id, const char* section, const char* printed, const std::string& text) {
    heads.push_back({id, "speed", section, printed, ClaimKind::exact, text});
  };
  add("speed.ring.c2", "III",
      "The characteristic ring is a normalized bi-3 symmetric scalable C2 map for any speed σ",
      shapes +
          "derivatives up to the second of neighbouring patches across all their borders, the spokes, and "
          "between the ring and lambda times its outer part; mirror images.");
  add("speed.ring.two-patches", "III", "two of the three BB patches of a sector",
      shapes +
          "the patch at the next spoke is the mirror image in the bisectrix of the one at the first "
          "spoke, the corner patch its own.");
  add("speed.ring.signs", "III",
      "Regularity and injectivity of characteristic ring have been checked numerically for n = 3, 5, 6, . . "
      ". "
      ", 20 and σ ∈ [1/10, 9/10]",
      differences +
          "For these valences and all speeds of the interval, by outward-rounded Taylor expansions "
          "on parts of it.");
  heads.push_back(finding(
      "speed.ring.theorem", "speed III",
      differences + "For all valences n >= 3 and all 0 < sigma < 1 at once: signs of rational functions "
                    "of two variables on a plane domain, by factors and Bernstein coefficients over Q."));
  add("speed.ring.injective", "III",
      "Injectivity follows by monotonicity of the boundary coefficients of the patch",
      "The outer border of half a sector runs from the bisectrix to the spoke with falling x > 0, for all "
      "speeds and valences: it winds once around the centre, and a regular map whose copies join is then "
      "injective (analysis/adjustable_speed/ring_conditions.h).");
  add("speed.ring.free", "III", "the characteristic ring is independent of β and γ",
      shapes +
          "beta and gamma occur in the vertex's rule alone, as factors of means over all sectors: of w, T w, "
          ".., T^(n-1) w with the turn T by 2 pi/n, which vanish for all w as T - 1 is regular.");
  add("speed.contraction", "abstract",
      "Other speeds are useful to vary the contraction near extraordinary points",
      "lambda as a function of sigma at a fixed valence: its derivative over Q(sigma, v) by implicit "
      "differentiation of v^2 = (1 + c)(q + sigma v), its sign on the domain of speed.ring.theorem, which "
      "contains all speeds and valences n >= 3; the roots of (7) at sigma = 0 and sigma = 1.");
  heads.push_back(
      finding("figure.speed.7", "speed figure 7",
              "The construction of one sector, n = 5, sigma = 2/3: coefficients of the tensor border "
              "that the net defines, and those of the ring's sector that are lambda times "
              "one of the border."));
  heads.push_back(
      finding("figure.speed.8", "speed figure 8",
              "Characteristic rings, n = 5, sigma = 1/4, 1/2, 3/4, 9/10: the area of a sector by the "
              "integral of the Jacobian over its patches, over what the outer border encloses; it "
              "is 1 - lambda^2. Enclosed; largest difference."));
  return heads;
}

const std::vector<ClaimHead>& table() {
  static const std::vector<ClaimHead> heads = make_heads();
  return heads;
}
const ClaimHead& claim(const std::string& id) { return head(table(), id); }

void add_joins(Results& results) {
  const RingShape<Function> shape{Function::variable(0), Function::variable(1)};
  std::size_t joins = 0;
  std::size_t mirrors = 0;
  bool smooth = true;
  bool symmetric = true;
  for (const auto& [name, difference] : ring_joins(characteristic_ring(shape), shape)) {
    const bool zero = difference[0].is_zero() && difference[1].is_zero();
    const bool mirror = name.find("mirror") != std::string::npos;
    (mirror ? mirrors : joins) += 1;
    (mirror ? symmetric : smooth) = (mirror ? symmetric : smooth) && zero;
  }
  results.claims.push_back(settle_statement(claim("speed.ring.c2"), smooth && symmetric,
                                            smooth && symmetric ? "true" : "false",
                                            fmt::format("{} joins and {} mirror images.", joins, mirrors)));
  results.claims.push_back(settle_statement(claim("speed.ring.two-patches"), symmetric,
                                            symmetric ? "true" : "false",
                                            "So is half of the corner patch of the other half."));
}

void add_signs(Results& results) {
  const Interval speeds = Interval::hull(Rational(1, 10), Rational(9, 10), 256);
  bool hold = true;
  int cells = 0;
  for (int n = 3; n <= 20; ++n) {
    if (n == 4) continue;
    const RingRange range = ring_conditions_on(speeds, n);
    hold = hold && range.hold == Decision::yes;
    cells += range.cells;
  }
  if (hold) {
    results.claims.push_back(
        settle_statement(claim("speed.ring.signs"), true, "17 valences, regular and injective",
                         fmt::format("{} parts of the interval over all valences; the paper samples.", cells),
                         Rigour::certified));
  } else {
    Enclosure open = exact(Rational(0));
    open.status = Status::out_of_depth;
    results.claims.push_back(settle_as(claim("speed.ring.signs"), Verdict::undecided, open, "Budget ended."));
  }
}

void add_theorem(Results& results) {
  const RingTheorem theorem = prove_ring_theorem();
  if (theorem.holds != Decision::yes) throw std::logic_error("the ring's theorem is not proved");
  results.claims.push_back(settle_statement(
      claim("speed.ring.theorem"), true, "regular and injective for all n >= 3 and 0 < sigma < 1",
      fmt::format("{} signs on {} cells, {} identities; n = 4 and shapes between valences included.",
                  theorem.conditions, theorem.cells, theorem.identities)));
  results.claims.push_back(settle_statement(
      claim("speed.ring.injective"), true, "true",
      "For one patch, monotone coefficients make its border a simple curve; that neighbouring patches do not "
      "overlap takes the winding number too."));

  // T - 1 for the turn T = [c, -2 sin^2; 2 cos^2, c] in these coordinates: its determinant is 2 - 2 c.
  const RingShape<Function> shape = ring_coordinates();
  const Function d = shape.one_plus_cosine();
  const Function c_less_one = d - Function(2);
  DomainSigns signs(ring_shapes());
  const bool regular =
      signs.sign(c_less_one * c_less_one + d * (Function(2) - d)).kind == DomainSign::Kind::positive;
  results.claims.push_back(settle_statement(claim("speed.ring.free"), regular, regular ? "true" : "false",
                                            "det(T - 1) = 2 - 2 cos(2 pi/n) > 0."));
}

void add_contraction(Results& results) {
  // v(sigma) at fixed d = 1 + c, from F(sigma, v) = v^2 - d (q + sigma v) = 0.
  const RingShape<Function> shape{Function::variable(0), Function::variable(1)};
  const Function d = Function::variable(2);
  const Function condition = shape.v * shape.v - d * shape.width();
  const Function slope = -(condition.derivative(0) / condition.derivative(1));
  const Function rate = shape.eigenvalue().derivative(0) + shape.eigenvalue().derivative(1) * slope;
  const std::array<Function, 3> at_shape{shape.sigma, shape.v, shape.one_plus_cosine()};
  const bool derived = rate.evaluate<Function>(at_shape) == contraction_rate(shape);
  DomainSigns signs(ring_shapes());
  const bool falls = signs.sign(contraction_rate(ring_coordinates())).kind == DomainSign::Kind::negative;
  // (7) in lambda, x_3: (lambda - 1)^2 at sigma = 0, lambda^2 at sigma = 1, whatever c is.
  const Function lambda = Function::variable(3);
  const auto quadratic = [&](const Function& sigma) {
    const Function q = Function(1) - sigma;
    return lambda * lambda - q * (sigma * sigma * d + Function(2) * q) * lambda + q * q * q * q;
  };
  const bool ends = quadratic(Function(0)) == (lambda - Function(1)) * (lambda - Function(1)) &&
                    quadratic(Function(1)) == lambda * lambda;
  const bool holds = derived && falls && ends;
  results.claims.push_back(settle_statement(
      claim("speed.contraction"), holds,
      holds ? "lambda falls strictly from 1 to 0 with sigma, for every n >= 3" : "false",
      "dlambda/dsigma = -(2 q^2 (2 - v) + q sigma v (5 - 2 v) + sigma^2 v^2)/(2 q + sigma v) with v < 2. So "
      "every contraction in (0, 1) is that of one speed, at every valence. What a contraction is useful for "
      "is the paper's opinion."));
}

}  // namespace

std::span<const ClaimHead> speed_characteristic_ring_heads() { return table(); }

Results run_speed_characteristic_ring() {
  Results results;
  add_ring_formulas(results, table());
  add_joins(results);
  add_signs(results);
  add_theorem(results);
  add_contraction(results);
  add_ring_construction_figure(results, claim("figure.speed.7"));
  add_ring_speeds_figure(results, claim("figure.speed.8"));
  return results;
}

}  // namespace subdiv
