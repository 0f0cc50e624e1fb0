#include "experiments/mesh_smoothness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <thread>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "analysis/eigenvalues.h"
#include "analysis/mesh/mesh_condition.h"
#include "analysis/mesh/spectral_condition.h"
#include "schemes/algebra/thread_caches.h"
#include "schemes/jspline.h"
#include "schemes/mesh/butterfly.h"
#include "schemes/mesh/jspline_mesh.h"
#include "schemes/mesh/loop.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

const std::string condition_text =
    "Eigenvalues at a vertex of valence n: 1 simple in mode 0, lambda real, positive and simple in mode 1, "
    "all "
    "others but lambda's double in mode n - 1 smaller in modulus (Reif 1995). ";
const std::string cells_text =
    "Proved on whole intervals of s: roots counted in circles, in interval arithmetic, from the exact "
    "characteristic polynomials of the Fourier modes. ";
const std::string directional_text = "The directional extension of J_s. ";
const std::string literal_text = "(1-s) Kobbelt + s Catmull-Clark. ";
const std::string component =
    "the interval of s around [0, 1], within [-2, 6], for which the condition holds";
const std::string section = "jsplines 10";

constexpr int most_valence = 30;
/// Valences whose ends are records of their own.
constexpr std::array claimed_valences{3, 5, 8, 30};

ClaimHead end_head(const std::string& scheme, const std::string& text, int n, const std::string& side) {
  return finding(
      fmt::format("mesh.range.{}.n{}.{}", scheme, n, side), section,
      text + condition_text + cells_text + fmt::format("The {} end of {}, n = {}.", side, component, n));
}

std::vector<ClaimHead> make_table() {
  std::vector<ClaimHead> table{
      ClaimHead{
          "mesh.blend", "jsplines", "10", "(1-s)Sc + sSk, where Sc is Catmull-Clark and Sk Kobbelt",
          ClaimKind::exact,
          "A combination that is the cubic B-spline's scheme at s = 1 and the four-point scheme's at s = 0, "
          "as J_s is: the tensor products at the regular vertex, from the symbols."},
      ClaimHead{"mesh.blend.literal", "jsplines", "10",
                "reduce to the tensor-product of the corresponding curve subdivision schemes",
                ClaimKind::exact, "Symbols: J_s(z) J_s(w) against " + literal_text},
      ClaimHead{"mesh.blend.directional", "jsplines", "10",
                "reduce to the tensor-product of the corresponding curve subdivision schemes",
                ClaimKind::exact,
                directional_text + "Rules at a regular vertex and two rings around it over Q(s), against the "
                                   "products of the masks of J_s."},
      ClaimHead{"mesh.eigenvectors", "jsplines", "10",
                "sub-dominant left eigenvectors of the subdivision matrix", ClaimKind::exact,
                directional_text +
                    "At a regular vertex, over Q(s): coordinates of the lattice must be an "
                    "eigenvector for 1/2 (the characteristic map is the identity). Refined points "
                    "are the rows of the matrix times the control points."},
      finding("mesh.blend.as-printed", section,
              "The formula as printed, (1-s) Catmull-Clark + s Kobbelt: the end of the s > 0 for which the "
              "condition holds at valence 3. " +
                  condition_text),
  };
  for (const auto& [name, text] :
       {std::pair{"directional", directional_text}, std::pair{"literal", literal_text}}) {
    const std::string id = name;
    table.push_back(
        finding("mesh.conjecture." + id + ".eigenvalues", section,
                text + condition_text + cells_text +
                    "Valences 3 .. 30 but the regular 4, every s of the closed interval [-1/4, 3/2]. "
                    "(For the characteristic maps see mesh.characteristic-map.)"));
    table.push_back(ClaimHead{
        "mesh.conjecture." + id + ".failure", "jsplines", "10",
        "not always smooth, especially at high valence with values of s near -2 or 6", ClaimKind::exact,
        text + condition_text + "At s = -7/4 and 23/4, valences 3 .. 30: where it fails."});
    table.push_back(finding("mesh.range." + id + ".first-failure", section,
                            text + condition_text + cells_text +
                                "The least valence above 30 from which on, up to 60, it fails at s = 3/2."));
    for (const int n : claimed_valences) {
      table.push_back(end_head(id, text, n, "lower"));
      table.push_back(end_head(id, text, n, "upper"));
    }
  }
  for (ClaimHead& head : std::vector<ClaimHead>{
           finding("mesh.catmull-clark.eigenvalues", section,
                   "Catmull-Clark. " + condition_text + "Valences 3 .. 30, 40, 100."),
           finding("notes.loop.eigenvalues", "notes 4",
                   "Loop with the weights of the notes. " + condition_text + "Valences 3 .. 30, 40, 100."),
           finding(
               "notes.loop.exception", "notes 4",
               "Loop with 5/8 + 3/(8n) at valence 3, too, without the special weights. " + condition_text),
           finding("notes.loop.1987.eigenvalues", "notes 4",
                   "Loop with his own weights of 1987. " + condition_text + "Valences 3 .. 30, 40, 100."),
           ClaimHead{"notes.butterfly.valence-3", "notes", "5",
                     "not smooth at vertices of the control mesh that have degree 3", ClaimKind::exact,
                     "Butterfly at valence 3: multiplicities of 1/4 in the characteristic polynomial and the "
                     "dimension of its eigenspace, over Q. " +
                         condition_text},
           finding("notes.butterfly.mode-2", "notes 5",
                   "Butterfly: the valences among 4 .. 30, 40, 100 at which it fails, and the mode "
                   "of the "
                   "largest eigenvalue there. " +
                       condition_text)}) {
    table.push_back(std::move(head));
  }
  return table;
}

const std::vector<ClaimHead>& table() {
  static const std::vector<ClaimHead> all = make_table();
  return all;
}

const ClaimHead& claim(const std::string& id) { return head(table(), id); }

const Function s = Function::variable(0);

// ---- The blend -------------------------------------------------------------------------------------------

/// The symbol of J at tension t, shifted to a polynomial in x_i: z^3 J_t(z).
Polynomial symbol(const Function& t, int variable) {
  const Mask<Function> mask = jspline(t);
  Polynomial result;
  for (int i = mask.symbol.first(); i <= mask.symbol.last(); ++i) {
    const Function c = mask.symbol[i];
    result += c.numerator() * Polynomial(Rational(1) / c.denominator().constant()) *
              pow(Polynomial::variable(variable), static_cast<unsigned>(i + 3));
  }
  return result;
}

Polynomial tensor(const Function& t) { return symbol(t, 1) * symbol(t, 2); }

void add_blend(Results& results) {
  const Polynomial at_0 = tensor(Function(0));
  const Polynomial at_1 = tensor(Function(1));
  const Polynomial t = Polynomial::variable(0);
  const Polynomial printed = (Polynomial(1) - t) * at_1 + t * at_0;
  const bool reversed = printed.substitute(0, Polynomial(1)) == at_0 && !(at_0 == at_1);
  results.claims.push_back(settle_statement(claim("mesh.blend"), !reversed, "(1-s) Sk + s Sc",
                                            "The operands are interchanged: at s = 1 the printed formula is "
                                            "Kobbelt's scheme, at s = 0 Catmull-Clark; "
                                            "J_1 is the cubic B-spline and J_0 the four-point scheme."));
  const Polynomial difference = tensor(s) - ((Polynomial(1) - t) * at_0 + t * at_1);
  const std::vector<std::string> names{"s", "z", "w"};
  const std::string found = to_factored_string(difference, names);
  results.claims.push_back(
      settle_statement(claim("mesh.blend.literal"), difference.is_zero(), found,
                       "z^3 w^3 (J_s(z) J_s(w) - (1-s) J_0(z) J_0(w) - s J_1(z) J_1(w)) is this polynomial, "
                       "0 only at s = 0 and 1: "
                       "the tensor product is quadratic in s. The papers' scheme is J_s x J_s in regular "
                       "regions only if it is "
                       "extended in each direction on its own, as the directional scheme is."));
}

/// The place (sector, a, b) at valence 4 on the lattice.
std::pair<int, int> lattice(const FanPlace& place, int sector) {
  std::pair<int, int> at{place.a, place.b};
  for (int k = 0; k < sector; ++k) at = {-at.second, at.first};
  return at;
}

void add_regular(Results& results) {
  const FanMatrix<Function> fan = fan_matrix(jspline_mesh(s), 4, 3);
  const Laurent<Function> mask = jspline(s).symbol;
  const std::vector<FanPlace> places = sector_places(4, 3);
  bool tensor_product = true;
  bool right = true;
  bool left = true;
  for (Eigen::Index p = 0; p < fan.places(); ++p) {
    const FanPlace& row = places[static_cast<std::size_t>(p)];
    tensor_product = tensor_product && fan.pull(p) == mask[row.a] * mask[row.b] &&
                     fan.spread(p) == mask[-2 * row.a] * mask[-2 * row.b];
    Function forward(0);   // row p of the matrix times the first coordinate
    Function backward(0);  // column p
    for (int k = 0; k < 4; ++k) {
      for (Eigen::Index q = 0; q < fan.places(); ++q) {
        const auto [i, j] = lattice(places[static_cast<std::size_t>(q)], k);
        const Function& entry = fan.blocks[static_cast<std::size_t>(k)](p, q);
        tensor_product = tensor_product && entry == mask[row.a - 2 * i] * mask[row.b - 2 * j];
        forward += entry * Function(i);
        // Row (k', q), column (0, p): blocks[-k'](q, p).
        backward += fan.blocks[static_cast<std::size_t>((4 - k) % 4)](q, p) * Function(i);
      }
    }
    right = right && forward == Function(row.a) / Function(2);
    left = left && backward == Function(row.a) / Function(2);
  }
  results.claims.push_back(settle_statement(claim("mesh.blend.directional"),
                                            tensor_product && fan.centre == mask[0] * mask[0],
                                            "J_s x J_s for all s"));
  results.claims.push_back(settle_statement(
      claim("mesh.eigenvectors"), left || !right, right && !left ? "right eigenvectors" : "left eigenvectors",
      "The control net of the characteristic map is made of right eigenvectors; left ones give limits and "
      "tangents of given data, as in section 5."));
}

// ---- Ranges of s -----------------------------------------------------------------------------------------

struct Ends {
  Rational lower_low, lower_high;  // the lower end lies between
  Rational upper_low, upper_high;
  Rival lower_rival;
  Rival upper_rival;
};

const Rational from(-2);
const Rational to(6);

/// The component around [0, 1] in [lower, upper], its ends to five decimals.
Ends find_ends(const SpectralCondition& condition, const Rational& lower, const Rational& upper) {
  const std::vector<ConditionCell> cells = condition.cells(lower, upper, Rational(1, 1L << 18));
  const auto home = std::find_if(cells.begin(), cells.end(), [](const ConditionCell& cell) {
    return cell.holds == Decision::yes && cell.lower <= Rational(0) && Rational(1) <= cell.upper;
  });
  if (home == cells.end()) throw std::logic_error("the condition is not proved on [0, 1]");
  Ends result;
  result.lower_high = result.lower_low = home->lower;
  result.upper_low = result.upper_high = home->upper;
  if (home != cells.begin() && (home - 1)->holds == Decision::undecided) result.lower_low = (home - 1)->lower;
  if (home + 1 != cells.end() && (home + 1)->holds == Decision::undecided)
    result.upper_high = (home + 1)->upper;
  result.lower_rival = condition.rival(result.lower_low);
  result.upper_rival = condition.rival(result.upper_high);
  return result;
}

std::string rival_text(const Rival& rival) {
  const bool real = std::abs(rival.value.imag()) < 1e-9;
  const std::string mode = fmt::format("mode {}", rival.mode);
  if (!real) return fmt::format("a complex pair of {} with the same modulus as lambda", mode);
  return fmt::format("{} eigenvalue of {} with the modulus of lambda",
                     rival.value.real() < 0 ? "a negative" : "an", mode);
}

struct Family {
  std::string name;
  ModeEquation turning;
  ModeEquation invariant;  // over Q(s, 1/n)
};

Family family(const std::string& name, const MeshScheme<Function>& scheme) {
  return {name, turning_modes(scheme), invariant_modes(scheme)};
}

Enclosure end_enclosure(const Rational& low, const Rational& high) { return certified(low, high, "cells"); }

/// The figure's; 4 is regular.
const std::vector<int>& valences() {
  static const std::vector<int> all = [] {
    std::vector<int> result{3, 5, 6, 7, 8, 9, 12, 20, 30, 40};
    return result;
  }();
  return all;
}

/// All valences, on two threads.
std::map<int, Ends> all_ends(const Family& f) {
  const std::vector<int>& all = valences();
  std::vector<Ends> found(all.size());
  const auto work = [&](std::size_t begin) {
    for (std::size_t i = begin; i < all.size(); i += 2) {
      const SpectralCondition condition = spectral_condition(f.turning, f.invariant, all[i]);
      found[i] = find_ends(condition, from, to);
    }
  };
  {
    std::exception_ptr failure;
    std::jthread other([&] {
      try {
        work(1);
      } catch (...) {
        failure = std::current_exception();
      }
      release_thread_caches();
    });
    work(0);
    other.join();
    if (failure) std::rethrow_exception(failure);
  }
  std::map<int, Ends> result;
  for (std::size_t i = 0; i < all.size(); ++i) result.emplace(all[i], std::move(found[i]));
  return result;
}

void add_ends(Results& results, const Family& f, const std::map<int, Ends>& ends) {
  constexpr int digits = 12;
  Series series{"mesh-range-" + f.name, {"valence", "lower", "upper"}, {}};
  for (const auto& [n, e] : ends) {
    series.rows.push_back(
        {std::to_string(n), to_significant(e.lower_high, digits), to_significant(e.upper_low, digits)});
    const auto known = [&](const std::string& id) {
      return std::ranges::find(table(), id, &ClaimHead::id) != table().end();
    };
    const std::string id = fmt::format("mesh.range.{}.n{}.", f.name, n);
    if (!known(id + "lower")) continue;
    const std::string outside = "Beyond it the condition fails: ";
    results.claims.push_back(settle(
        claim(id + "lower"), end_enclosure(e.lower_low, e.lower_high),
        e.lower_high == from ? "The whole range looked at." : outside + rival_text(e.lower_rival) + "."));
    results.claims.push_back(settle(claim(id + "upper"), end_enclosure(e.upper_low, e.upper_high),
                                    e.upper_low == to ? "It holds up to the end 6 of the range looked at."
                                                      : outside + rival_text(e.upper_rival) + "."));
  }
  results.series.push_back(std::move(series));
}

void add_conjecture(Results& results, const Family& f, const std::map<int, Ends>& ends) {
  bool holds = true;
  for (int n = 3; n <= most_valence; ++n) {
    if (n == 4) continue;
    const std::vector<ConditionCell> cells = spectral_condition(f.turning, f.invariant, n)
                                                 .cells(Rational(-1, 4), Rational(3, 2), Rational(1, 1024));
    holds = holds && cells.size() == 1 && cells[0].holds == Decision::yes;
  }
  const Rational lower = ends.at(3).lower_high;
  const Rational upper = ends.at(most_valence).upper_low;
  // At s = 3/2 itself, valence after valence.
  constexpr int most = 60;
  int first = most;
  for (int n = most; n > most_valence; --n) {
    const Decision decision = spectral_condition(f.turning, f.invariant, n).decide(Rational(3, 2));
    if (decision != Decision::no) break;
    first = n;
  }
  if (spectral_condition(f.turning, f.invariant, first - 1).decide(Rational(3, 2)) != Decision::yes) {
    throw std::logic_error("the first failure above valence 30 is not decided");
  }
  constexpr int digits = 8;
  const std::string id = "mesh.conjecture." + f.name;
  results.claims.push_back(settle_statement(
      claim(id + ".eigenvalues"), holds, holds ? "true" : "false",
      fmt::format("The ends -1/4 and 3/2 included. Valence 3 ends first below, at {}, valence "
                  "30 above, at {}.",
                  to_significant(lower, digits), to_significant(upper, digits)),
      Rigour::certified));
  results.claims.push_back(
      settle(claim("mesh.range." + f.name + ".first-failure"), exact(Rational(first), "roots in circles"),
             "From this valence to 60 the condition fails at s = 3/2, and so just below: mode 0 has "
             "overtaken mode 1. At "
             "the valence before it holds there. The conjecture does not extend to all valences."));
  std::string where;
  for (const Rational& at : {Rational(-7, 4), Rational(23, 4)}) {
    std::string failing;
    for (int n = 3; n <= most_valence; ++n) {
      if (n == 4) continue;  // regular
      const SpectralCondition condition = spectral_condition(f.turning, f.invariant, n);
      if (condition.decide(at) == Decision::no) failing += (failing.empty() ? "" : ", ") + std::to_string(n);
    }
    where += (where.empty() ? "" : "; ") + ("s = " + at.to_string() + ": valences " + failing);
  }
  results.claims.push_back(settle_statement(claim(id + ".failure"), true, where,
                                            "High valences fail, but valence 3 fails first: see mesh.range.",
                                            Rigour::certified));
}

// ---- Named schemes ---------------------------------------------------------------------------------------

std::vector<int> wide_valences(int first) {
  std::vector<int> result;
  for (int n = first; n <= most_valence; ++n) result.push_back(n);
  for (const int n : {40, 100}) result.push_back(n);
  return result;
}

bool holds_everywhere(const std::function<SpectralCondition(int)>& condition, int first) {
  return std::ranges::all_of(wide_valences(first),
                             [&](int n) { return condition(n).decide(Rational(0)) == Decision::yes; });
}

MeshScheme<Function> loop_1987_with_cosine() {
  return detail::loop_with_weight<Function>("loop-1987", [](int /*n*/) {
    const Function root =
        fraction<Function>(3, 8) + fraction<Function>(1, 4) * Function::variable(turn_variable);
    return fraction<Function>(5, 8) - root * root;
  });
}

void add_named(Results& results) {
  const auto of = [](const MeshScheme<Function>& scheme) {
    const ModeEquation turning = turning_modes(scheme);
    return [scheme, turning](int n) { return SpectralCondition(turning, invariant_mode(scheme, n), n); };
  };
  const auto all = [&](const char* id, const MeshScheme<Function>& scheme, const char* note) {
    results.claims.push_back(
        settle_statement(claim(id), holds_everywhere(of(scheme), 3), "true", note, Rigour::certified));
  };
  all("mesh.catmull-clark.eigenvalues", catmull_clark<Function>(),
      "lambda = (5 + c + sqrt((c+9)(c+1)))/16, c = cos(2 pi/n).");
  all("notes.loop.eigenvalues", loop<Function>(), "lambda = 3/8 + cos(2 pi/n)/4.");
  all("notes.loop.1987.eigenvalues", loop_1987_with_cosine(),
      "The same lambda; mode 0 has (3/8 + cos(2 pi/n)/4)^2, its square.");

  const MeshScheme<Function> plain = loop_without_exception<Function>();
  const Polynomial quarter = Polynomial(4) * Polynomial::variable(eigenvalue_variable) - Polynomial(1);
  const auto multiplicity = [&](const ModeEquation& e) {
    Polynomial rest = e.product().substitute(turn_variable, Polynomial(Rational(-1, 2)));
    int count = 0;
    while (divides(quarter, rest, rest)) ++count;
    return count;
  };
  const int first = multiplicity(turning_modes(plain));
  const int zero = multiplicity(invariant_mode(plain, 3));
  results.claims.push_back(settle_statement(
      claim("notes.loop.exception"), first == 1 && zero == 1,
      fmt::format("fails: 1/4 has the multiplicity {} in modes 1 and 2, and {} in mode 0", first, zero),
      "Mode 0 has 1/4 at every valence, modes 1 and 2 have 3/8 + cos(2 pi/3)/4 = 1/4: the sub-dominant "
      "eigenvalue "
      "is triple, and the limit is not a graph over a tangent plane. The weights 7/16 and 3/16 move mode 0 "
      "to "
      "1/16."));
}

void add_butterfly(Results& results) {
  const ModeEquation turning = turning_modes(butterfly<Function>());
  const auto at = [&](int n) {
    return SpectralCondition(turning, invariant_mode(butterfly<Function>(), n), n);
  };
  const Matrix<Rational> matrix = full_matrix(fan_matrix(butterfly<Rational>(), 3, 3));
  Matrix<Rational> shifted = matrix;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) shifted(i, i) -= Rational(1, 4);
  const auto geometric = static_cast<int>(null_space(shifted).size());
  int algebraic = 0;
  bool larger = false;
  for (const Eigenvalue& e : eigenvalues(matrix)) {
    if (e.exact && *e.exact == Algebraic(Rational(1, 4))) algebraic = e.multiplicity;
    larger = larger || (certainly_less(Interval(Rational(1, 4)), e.modulus()) &&
                        !(e.exact && *e.exact == Algebraic(1)));
  }
  if (larger) throw std::logic_error("1/4 is not sub-dominant");
  results.claims.push_back(settle_statement(
      claim("notes.butterfly.valence-3"), geometric < algebraic,
      fmt::format("1/4 is sub-dominant, {} times, with {} eigenvectors", algebraic, geometric),
      "Jordan blocks, and lambda is not simple in mode 1: the condition fails."));
  std::string failing;
  std::string modes;
  bool proved = true;
  for (const int n : wide_valences(4)) {
    const SpectralCondition condition = at(n);
    const Decision holds = condition.decide(Rational(0));
    proved = proved && holds == (n < 8 ? Decision::yes : Decision::no);
    if (holds != Decision::no) continue;
    const int mode = condition.rival(Rational(0)).mode;
    modes += fmt::format("{}{}: {}", modes.empty() ? "" : ", ", n, mode);
  }
  results.claims.push_back(settle_statement(claim("notes.butterfly.mode-2"), proved,
                                            "8 and above; at 4 .. 7 it holds",
                                            "Valence and mode of the largest: " + modes +
                                                ". The map of such a mode winds more than once around the "
                                                "vertex: normals converge, and the surface is not "
                                                "a graph.",
                                            Rigour::certified));
}

void add_figure(Results& results) {
  Figure figure{"mesh-range", "Where the eigenvalue condition holds at a vertex of valence n",
                "valence",    "s",
                {},           "set xrange [3:40]; set yrange [-2:6]"};
  for (const auto& [name, label, colour] :
       {std::tuple{"directional", "directional", "#0072b2"}, std::tuple{"literal", "literal", "#d55e00"}}) {
    const std::string series = std::string("mesh-range-") + name;
    const std::string style = std::string("linespoints pt 7 ps 0.4 lc rgb '") + colour + "'";
    figure.curves.push_back({series, "valence", "upper", label, style});
    figure.curves.push_back({series, "valence", "lower", "", style});
  }
  results.figures.push_back(std::move(figure));
}

}  // namespace

std::span<const ClaimHead> mesh_smoothness_heads() { return table(); }

Results run_mesh_smoothness() {
  Results results;
  add_blend(results);
  add_regular(results);
  add_named(results);
  add_butterfly(results);
  for (const Family& f :
       {family("directional", jspline_mesh(s)), family("literal", jspline_mesh_literal(s))}) {
    const std::map<int, Ends> ends = all_ends(f);
    add_ends(results, f, ends);
    add_conjecture(results, f, ends);
    if (f.name != "literal") continue;
    // s and 1 - s change places.
    const Ends& three = ends.at(3);
    const Enclosure lower = end_enclosure(three.lower_low, three.lower_high);
    results.claims.push_back(settle(claim("mesh.blend.as-printed"),
                                    certified(Rational(1) - lower.upper, Rational(1) - lower.lower, "cells"),
                                    "Below 3/2, the end that the paper gives for its conjecture, which is "
                                    "right for the formula with Sc and Sk "
                                    "interchanged: that settles the misprint."));
  }
  add_figure(results);
  return results;
}

}  // namespace subdiv
