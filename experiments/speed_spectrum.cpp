#include "experiments/speed_spectrum.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "analysis/adjustable_speed/ring_theorem.h"
#include "analysis/adjustable_speed/speed_matrix.h"
#include "analysis/adjustable_speed/speed_spectrum.h"
#include "analysis/mesh/spectral_condition.h"
#include "experiments/report/figure_style.h"
#include "schemes/algebra/turn.h"
#include "schemes/mesh/catmull_clark.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

const std::string speeds =
    "Adjustable speed with the vertex weights (1), q = 1 - sigma, lambda and mu the largest moduli after 1 "
    "and "
    "after lambda and its copy in mode n - 1. ";

const std::array table{
    ClaimHead{
        "speed.eq6", "speed", "III",
        "1, σ̄^3, σ̄^4, σ̄^5, σ̄^6 and the roots of λ^2 + (β+γ-2+2σ(σ̄^2+1))λ + "
        "σ̄^2(σ̄^2-(β+γ)σ̄+γσ) = 0",
        ClaimKind::exact,
        "The characteristic polynomial of mode 0 of the step on two rings around the vertex, over Q(sigma, "
        "beta, gamma)."},
    ClaimHead{
        "speed.eq7", "speed", "III",
        "0, σ̄^3, σ̄^4, σ̄^5, σ̄^6 and the roots of λ^2 - σ̄(σ^2(1+c_{n,k})+2σ̄)λ + σ̄^4 = 0", ClaimKind::exact,
        "The characteristic polynomial of all modes k != 0 over Q(sigma, c). The eigenvalue 0 comes from "
        "n copies of the vertex, all refined alike: their row in the block is the sum of the powers of "
        "w^k, 0. With the vertex itself the blocks have 6 rows."},
    ClaimHead{
        "speed.eq8", "speed", "III", "λ = σ̄/2 ((1+c)σ^2 + 2σ̄ + σ sqrt((1+c)((1+c)σ^2+4σ̄)))", ClaimKind::exact,
        "The larger root of the quadratic factor of mode 1: sum and product of the two with sqrt(..) and "
        "-sqrt(..) over Q(sigma, c)."},
    ClaimHead{
        "speed.subdominant", "speed", "III", "the subdominant eigenvalue is the root λ", ClaimKind::exact,
        speeds + "1 > lambda > |all other eigenvalues| but its copy, for every valence n >= 3 and every "
                 "sigma in (0, 1): identities over Q(sigma, D, c), D = 9 + (n-4)(1+q)^2, and signs of "
                 "polynomials on (0, 1), decided by Sturm's theorem."},
    ClaimHead{"speed.c1", "speed", "abstract", "verify C1 continuity of the limit surface", ClaimKind::exact,
              speeds +
                  "Every valence n >= 3 and every sigma in (0, 1): lambda sub-dominant, of mode 1 and simple "
                  "there, its characteristic ring regular and injective, rings C2 (Reif 1995): limits of "
                  "generic nets are C1 at the extraordinary point. The ring over Q(sigma, v), lambda = q (q "
                  "+ sigma v): signs of polynomials on the set of all (sigma, v)."},
    ClaimHead{"speed.mu", "speed", "III",
              "The subsubdominant eigenvalue µ is also a root of (7) but for k = 2", ClaimKind::exact,
              speeds + "Every valence n >= 3 and every sigma in (0, 1)."},
    finding("speed.mu.5.end", "speed III",
            speeds +
                "Valence 5: the sigma at which the larger root of (6) overtakes that of (7) for k = 2; a "
                "resultant over Q(cos(4 pi/5))."),
    finding("speed.mu.from-6", "speed III",
            speeds + "mu is the larger root of (7) for k = 2 at every valence n >= 6, all sigma in (0, 1)."),
    ClaimHead{"speed.mu.square", "speed", "III", "µ > λ^2", ClaimKind::exact,
              speeds + "Every valence n >= 3 and every sigma in (0, 1)."},
    finding("speed.mu.square.from-5", "speed III",
            speeds + "mu > lambda^2 for every valence n >= 5 and every sigma in (0, 1)."),
    finding("speed.mu.square.4", "speed III",
            "Adjustable speed at the regular vertex, n = 4: the larger root of (7) for k = 2 minus lambda^2, "
            "over "
            "Q(sigma)."),
    finding("speed.mu.square.3.lower", "speed III",
            speeds +
                "Valence 3: the lower end of the sigma with mu < lambda^2; resultants of (6) at lambda^2 and "
                "(7) at lambda."),
    finding("speed.mu.square.3.upper", "speed III",
            speeds + "Valence 3: the upper end of the sigma with mu < lambda^2; as for the lower end."),
    ClaimHead{"speed.unbounded", "speed", "III",
              "As with Catmull-Clark, the limit curvature is generically unbounded", ClaimKind::exact,
              speeds + "Curvatures of generic limit surfaces grow like (mu/lambda^2)^m at the m-th ring: "
                       "unbounded exactly for mu > lambda^2. Every valence n != 4."},
    ClaimHead{"speed.hyperbolic", "speed", "III",
              "the limit surface is generically hyperbolic at the extraordinary point", ClaimKind::exact,
              speeds +
                  "Second-order parts of generic limit surfaces are those of mu's modes: saddles where these "
                  "are 2 and n - 2 alone, mu > lambda^2 given. Every valence n != 4."},
    finding("speed.catmull-clark.eigenvalues", "speed III",
            "At sigma = 1/2 the quadratic factors of mode 0 (every valence 3 .. 30) and of the modes k != 0 "
            "(over "
            "Q(c)) are those of Catmull-Clark's matrix, made from its own rules."),
    ClaimHead{"figure.speed.lambda", "subdivlab", "speed III", std::nullopt, ClaimKind::exact,
              "lambda against sigma at the valences 3, 5, 6, 8, 12 and 30 from (8), and lambda^2 and mu at "
              "valence 3. Second route: at every tenth sigma, enclosures of lambda from the matrix."},
};

const ClaimHead& claim(const std::string& id) { return head(table, id); }

const Function s = Function::variable(0);
const Function q = Function(1) - s;
const Function x = Function::variable(eigenvalue_variable);

constexpr int far = 11;  // a valence at which no sector is read from both sides

bool same_up_to_constant(const Polynomial& a, const Polynomial& b) {
  Polynomial quotient;
  return divides(a, b, quotient) && quotient.is_constant();
}

/// (x - q^3)(x - q^4)(x - q^5)(x - q^6)
Function powers_part() {
  Function power = q * q;
  Function product(1);
  for (int k = 3; k <= 6; ++k) {
    power *= q;
    product *= x - power;
  }
  return product;
}

void require(bool proved, const std::string& what) {
  if (!proved) throw std::logic_error("not proved: " + what);
}

void add_equations(Results& results) {
  const Function beta = Function::variable(1);
  const Function gamma = Function::variable(2);
  const Function turn = Function::variable(turn_variable);
  const FanMatrix<Function> fan = speed_matrix(s, far, VertexWeights<Function>{beta, gamma});
  const Function both = beta + gamma;
  const Function six = x * x + (both - Function(2) + Function(2) * s * (q * q + Function(1))) * x +
                       q * q * (q * q - both * q + gamma * s);
  const Polynomial invariant = ((x - Function(1)) * powers_part() * six).numerator();
  results.claims.push_back(settle_statement(
      claim("speed.eq6"), same_up_to_constant(invariant, invariant_mode(fan).product()), "true"));

  const Function trace = q * (s * s * (Function(1) + turn) + Function(2) * q);
  const Function fourth = q * q * q * q;
  const Polynomial turning = (powers_part() * (x * x - trace * x + fourth)).numerator();
  results.claims.push_back(settle_statement(
      claim("speed.eq7"), same_up_to_constant(turning, turning_modes(fan).product()), "true"));

  // lambda = (first + q s root)/2, root^2 = radicand.
  const Function first = q * ((Function(1) + turn) * s * s + Function(2) * q);
  const Function radicand = (Function(1) + turn) * ((Function(1) + turn) * s * s + Function(4) * q);
  const Function product = (first * first - q * q * s * s * radicand) / Function(4);
  results.claims.push_back(settle_statement(claim("speed.eq8"), first == trace && product == fourth, "true",
                                            "The radicand is not negative, so that both roots are real."));
}

enum class Rounded { down = -1, up = 1 };

std::string digits(const Algebraic& number, Rounded direction) {
  constexpr int count = 9;
  return to_significant(number.to_interval().midpoint(), count, static_cast<int>(direction));
}

/// The one interval that a set consists of.
const RealInterval& only_part(const RealSet& set, const std::string& what) {
  require(set.parts.size() == 1 && set.parts[0].lower && set.parts[0].upper, what);
  return set.parts[0];
}

void add_subdominant(Results& results) {
  require(lambda_is_subdominant(), "lambda is sub-dominant");
  results.claims.push_back(settle_statement(
      claim("speed.subdominant"), true, "every n >= 3, every σ in (0, 1)",
      "Jury's conditions keep the roots of (6) below lambda, since 9 + (n-4)(1+q)^2 times 1 - cos(2 pi/n) is "
      "below 18; the modes k != 0 are ordered by cos(2 pi k/n). The paper says \"by inspection\"."));
  require(prove_ring_theorem().holds == Decision::yes, "the characteristic ring is regular and injective");
  results.claims.push_back(settle_statement(
      claim("speed.c1"), true, "every n >= 3, every σ in (0, 1)",
      "The paper checks the ring at samples of sigma in [1/10, 9/10] up to valence 20 (speed.ring.*)."));
}

void add_mu(Results& results) {
  require(mode_2_exceeds_square(), "mode 2 exceeds lambda^2");
  require(mode_2_is_next_from(6), "mode 2 is next from valence 6 on");
  const RealSet next_at_5 = speeds_with_mode_2_next(5);
  const RealInterval& at_5 = only_part(next_at_5, "one interval at valence 5");
  require(*at_5.lower == Algebraic(0) && *at_5.upper < Algebraic(1), "mode 2 is next from 0 on at valence 5");
  const RealSet below_at_3 = speeds_with_next_below_square_at_3();
  const RealInterval& at_3 = only_part(below_at_3, "one interval at valence 3");
  // Rounded so that what is said holds: mu < lambda^2 inside, mu > lambda^2 outside of the wider interval.
  const std::string inside_at_3 =
      fmt::format("({}, {})", digits(*at_3.lower, Rounded::up), digits(*at_3.upper, Rounded::down));
  const std::string outside_at_3 =
      fmt::format("n >= 5, and n = 3 for σ outside [{}, {}]", digits(*at_3.lower, Rounded::down),
                  digits(*at_3.upper, Rounded::up));
  const std::string up_to_end_at_5 =
      fmt::format("n >= 6, and n = 5 for σ < {}", digits(*at_5.upper, Rounded::down));
  const std::string from_end_at_5 = digits(*at_5.upper, Rounded::up);

  results.claims.push_back(settle_statement(
      claim("speed.mu"), false, up_to_end_at_5,
      fmt::format(
          "At valence 3 mode 2 is mode 1 again, n - 1, and its roots are lambda and q^4/lambda: mu is "
          "never the larger one. At valence 5 the larger root of (6) exceeds that of (7) for k = 2 from "
          "sigma = {} on. It is true for all sigma at every valence n >= 6, and at n = 4, where the "
          "root q^2 belongs to mode 0, too.",
          from_end_at_5)));
  results.claims.push_back(settle(claim("speed.mu.5.end"), exact(*at_5.upper)));
  results.claims.push_back(settle_statement(
      claim("speed.mu.from-6"), true, "true",
      "With E = (9 + (n-4)(1+q)^2)(1 - cos(4 pi/n)): E < 18 from n = 18 on; up to 17, (E - 18)^2 < 9 (1 + "
      "cos(4 pi/n))(1+q)(9 q (1+q) + sigma (18 - E)) where E >= 18."));
  results.claims.push_back(settle_statement(
      claim("speed.mu.square"), false, outside_at_3,
      fmt::format("At valence 3 all moduli after lambda are below lambda^2 for sigma in {}, an interval that "
                  "contains Catmull-Clark's 1/2 (mu = 1/6 there); at valence 4 mu = lambda^2. It is true for "
                  "every n >= 5 and every sigma.",
                  inside_at_3)));
  results.claims.push_back(settle_statement(claim("speed.mu.square.from-5"), true, "true",
                                            "With lambda = q W, W = q + sigma v, 1 + cos(2 pi/n) = v^2/W, "
                                            "the polynomial (7) for k = 2 has the value "
                                            "-sigma^2 q^3 (1+q^2) (v-1)^2 (sigma (v-1)^2 + v^2 + 2v - 1) at "
                                            "lambda^2: negative, so that lambda^2 lies "
                                            "between its roots."));
  const Polynomial seven = speed_quadratics().turning;
  // lambda = q at c = 0, the double root of (7) there at c = -1.
  const std::array<Function, max_parameters> lambda_at{s,           Function(0), Function(0), Function(0),
                                                       Function(0), Function(0), Function(0), q};
  const std::array<Function, max_parameters> mode_2{s,           Function(0),  Function(0), Function(0),
                                                    Function(0), Function(-1), Function(0), x};
  const Function root = q * q;
  const bool equal = seven.evaluate<Function>(lambda_at).is_zero() &&
                     seven.evaluate<Function>(mode_2) == (x - root) * (x - root);
  require(equal, "mu = lambda^2 at valence 4");
  results.claims.push_back(settle_statement(claim("speed.mu.square.4"), true, "0",
                                            "lambda = q, and q^2 is the double root of (7) for k = 2."));
  results.claims.push_back(settle(claim("speed.mu.square.3.lower"), exact(*at_3.lower),
                                  "The larger root of (6) is lambda^2 there, below it mu > lambda^2."));
  results.claims.push_back(settle(claim("speed.mu.square.3.upper"), exact(*at_3.upper),
                                  "The smaller root of (6) is -lambda^2 there, above it mu > lambda^2."));
  results.claims.push_back(settle_statement(
      claim("speed.unbounded"), false, outside_at_3,
      fmt::format("mu < lambda^2 at valence 3 for sigma in {}: curvatures tend to 0 there, with "
                  "Catmull-Clark, sigma = 1/2, too. Unbounded for every n >= 5.",
                  inside_at_3)));
  results.claims.push_back(settle_statement(
      claim("speed.hyperbolic"), false, up_to_end_at_5,
      fmt::format(
          "At valence 3 modes 2 and n - 2 are those of lambda, and the second-order part is that of "
          "other eigenvalues (or vanishes, for sigma in {}); at valence 5 mu belongs to mode 0, which is "
          "invariant under rotation, from sigma = {} on. True for all sigma at every n >= 6.",
          inside_at_3, from_end_at_5)));
}

void add_catmull_clark(Results& results) {
  const Function half = fraction<Function>(1, 2);
  const MeshScheme<Function> known = catmull_clark<Function>();
  bool same =
      same_up_to_constant(turning_modes(speed_matrix(half, far)).product(), turning_modes(known).product());
  constexpr int most = 30;
  for (int n = 3; n <= most; ++n) {
    same = same && same_up_to_constant(invariant_mode(speed_matrix(half, n)).product(),
                                       invariant_mode(known, n).product());
  }
  require(same, "Catmull-Clark's eigenvalues at sigma = 1/2");
  results.claims.push_back(settle_statement(claim("speed.catmull-clark.eigenvalues"), true, "true"));
}

/// (8), and mu at valence 3: the larger modulus of the roots of (6), q^3 and q^4/lambda.
Interval lambda_at(const Interval& sigma, const Interval& turn) {
  const Interval rest = Interval(1) - sigma;
  const Interval d = Interval(1) + turn;
  const Interval square = d * sigma * sigma;
  return rest / Interval(2) * (square + Interval(2) * rest + sigma * sqrt(d * (square + Interval(4) * rest)));
}

void add_figure(Results& results) {
  constexpr std::array valences{3, 5, 6, 8, 12, 30};
  constexpr int steps = 100;
  constexpr int shown = 12;
  Series series{"speed-lambda", {"sigma"}, {}};
  for (const int n : valences) series.columns.push_back(fmt::format("lambda, n = {}", n));
  series.columns.emplace_back("lambda^2, n = 3");
  series.columns.emplace_back("mu, n = 3");
  const ModeEquation turning = turning_modes(speed_matrix(s, far));
  std::vector<SpectralCondition> conditions;
  for (const int n : valences) conditions.emplace_back(turning, invariant_mode(speed_matrix(s, n)), n);
  const auto text = [&](const Interval& value) { return to_significant(value.midpoint(), shown); };
  int compared = 0;
  for (int i = 1; i < steps; ++i) {
    const Rational sigma(i, steps);
    std::vector<std::string> row{to_significant(sigma, shown)};
    for (std::size_t k = 0; k < valences.size(); ++k) {
      const Interval lambda = lambda_at(Interval(sigma), cosine_of_turn<Interval>(1, valences[k]));
      row.push_back(text(lambda));
      if (i % 10 != 0) continue;
      const auto leading = conditions[k].leading(sigma);
      require(leading && leading->subdominant.overlaps(lambda), "the matrix has the eigenvalue of (8)");
      ++compared;
    }
    const Interval lambda = lambda_at(Interval(sigma), Interval(Rational(-1, 2)));
    const auto leading = conditions[0].leading(sigma);
    require(leading.has_value(), "the spectrum at valence 3");
    row.push_back(text(lambda * lambda));
    row.push_back(text(leading->next));
    series.rows.push_back(std::move(row));
  }
  Figure figure{"speed-lambda",
                "Sub-dominant eigenvalue λ and the next, μ, of adjustable speed",
                "speed σ",
                "eigenvalue",
                {},
                "set xrange [0:1]; set yrange [0:1]; set xtics 0.2",
                {"figure.speed.lambda", "speed.subdominant", "speed.mu.square.", "speed.mu."}};
  constexpr std::array greek{std::pair{"lambda", "λ"}, std::pair{"mu", "μ"}};
  for (std::size_t k = 1; k < series.columns.size(); ++k) {
    std::string label = series.columns[k];
    for (const auto& [name, letter] : greek) {
      if (label.starts_with(name)) label.replace(0, std::string_view(name).size(), letter);
    }
    figure.curves.push_back({"speed-lambda", "sigma", series.columns[k], label,
                             k == valences.size() + 1 ? style::in_colour(style::black, 1.2)
                                                      : style::curve(std::min<std::size_t>(k - 1, 6))});
  }
  results.series.push_back(std::move(series));
  results.figures.push_back(std::move(figure));
  results.claims.push_back(settle_statement(
      claim("figure.speed.lambda"), true, "as (8)",
      fmt::format("{} values of (8) lie in the enclosures of the sub-dominant eigenvalue.", compared),
      Rigour::certified));
}

}  // namespace

std::span<const ClaimHead> speed_spectrum_heads() { return table; }

Results run_speed_spectrum() {
  Results results;
  add_equations(results);
  add_subdominant(results);
  add_mu(results);
  add_catmull_clark(results);
  add_figure(results);
  return results;
}

}  // namespace subdiv
