#include "experiments/mesh_smoothness.h"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "analysis/eigenvalues.h"
#include "analysis/mesh/exact_condition.h"
#include "analysis/mesh/lattice_mask.h"
#include "analysis/mesh/mesh_condition.h"
#include "analysis/mesh/spectral_condition.h"
#include "experiments/mesh_smoothness_limit.h"
#include "experiments/mesh_smoothness_ranges.h"
#include "experiments/mesh_smoothness_text.h"
#include "experiments/report/figure_style.h"
#include "schemes/jspline.h"
#include "schemes/mesh/butterfly.h"
#include "schemes/mesh/jspline_mesh.h"
#include "schemes/mesh/loop.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

const std::string section = "jsplines 10";

constexpr int most_valence = 30;

std::vector<ClaimHead> make_table() {
  std::vector<ClaimHead> table{
      ClaimHead{
          "mesh.blend", "jsplines", "10", "(1-s)Sc + sSk, where Sc is Catmull-Clark and Sk Kobbelt",
          ClaimKind::exact,
          "A combination that is the cubic B-spline's scheme at s = 1 and the four-point scheme's at s = 0, "
          "as J_s is: the tensor products at the regular vertex, from the symbols."},
      ClaimHead{"mesh.blend.literal", "jsplines", "10",
                "reduce to the tensor-product of the corresponding curve subdivision schemes",
                ClaimKind::exact, "Symbols: J_s(z) J_s(w) against " + literal_scheme},
      ClaimHead{
          "mesh.blend.directional", "jsplines", "10",
          "reduce to the tensor-product of the corresponding curve subdivision schemes", ClaimKind::exact,
          directional_scheme + "Rules at a regular vertex and two rings around it over Q(s), against the "
                               "products of the masks of J_s."},
      ClaimHead{"mesh.eigenvectors", "jsplines", "10",
                "sub-dominant left eigenvectors of the subdivision matrix", ClaimKind::exact,
                directional_scheme +
                    "At a regular vertex, over Q(s): coordinates of the lattice must be an "
                    "eigenvector for 1/2 (the characteristic map is the identity). Refined points "
                    "are the rows of the matrix times the control points."},
  };
  for (ClaimHead& head : std::vector<ClaimHead>{
           finding("mesh.catmull-clark.eigenvalues", section,
                   "Catmull-Clark. " + eigenvalue_condition + "Valences 3 .. 30, 40, 100."),
           finding(
               "notes.loop.eigenvalues", "notes 4",
               "Loop with the weights of the notes. " + eigenvalue_condition + "Valences 3 .. 30, 40, 100."),
           finding("notes.loop.exception", "notes 4",
                   "Loop with 5/8 + 3/(8n) at valence 3, too, without the special weights. " +
                       eigenvalue_condition),
           finding(
               "notes.loop.1987.eigenvalues", "notes 4",
               "Loop with his own weights of 1987. " + eigenvalue_condition + "Valences 3 .. 30, 40, 100."),
           ClaimHead{"notes.butterfly.valence-3", "notes", "5",
                     "not smooth at vertices of the control mesh that have degree 3", ClaimKind::exact,
                     "Butterfly at valence 3: multiplicities of 1/4 in the characteristic polynomial and the "
                     "dimension of its eigenspace, over Q. " +
                         eigenvalue_condition},
           finding("notes.butterfly.mode-2", "notes 5",
                   "Butterfly: the valences among 4 .. 30, 40, 100 at which it fails. " +
                       eigenvalue_condition)}) {
    table.push_back(std::move(head));
  }
  for (ClaimHead& head : valence_limit_heads()) table.push_back(std::move(head));
  for (ClaimHead& head : mesh_range_heads()) table.push_back(std::move(head));
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
                       "z^3 w^3 (J_s(z) J_s(w) - (1-s) J_0(z) J_0(w) - s J_1(z) J_1(w)) is the polynomial "
                       "found, which is 0 only at s = 0 and 1: "
                       ""
                       "the tensor product is quadratic in s. The papers' scheme is J_s x J_s in regular "
                       "regions only if it is "
                       "extended in each direction on its own, as the directional scheme is."));
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
        FanPlace place = places[static_cast<std::size_t>(q)];
        place.sector = k;
        const auto [i, j] = lattice_offset(4, place);
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
  all("notes.loop.1987.eigenvalues",
      loop_1987<Function>([](int /*n*/) { return Function::variable(turn_variable); }),
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
      claim("notes.loop.exception"),
      first == 1 && zero == 1 && exact_condition(loop_without_exception<Rational>(), 3) == Decision::no,
      fmt::format("fails: 1/4 has the multiplicity {} in modes 1 and 2, and {} in mode 0", first, zero),
      "Mode 0 has 1/4 at every valence, modes 1 and 2 have 3/8 + cos(2 pi/3)/4 = 1/4: the sub-dominant "
      "eigenvalue is triple. The weights 7/16 and 3/16 move mode 0 to 1/16."));
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
      "Jordan blocks: the condition fails."));
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
  results.claims.push_back(settle_statement(
      claim("notes.butterfly.mode-2"), proved, "8 and above; at 4 .. 7 it holds",
      "That it fails is proved; valence and mode of the largest, computed in double precision: " + modes +
          ". For the maps see notes.butterfly.winds-twice.",
      Rigour::certified));
}

void add_figure(Results& results) {
  Figure figure{"mesh-range",
                "Where the eigenvalue condition holds at a vertex of n edges: between the two lines",
                "edges n at the vertex",
                "parameter s",
                {},
                "set xrange [3:40]; set yrange [-2:6.2]; set xtics (3, 5, 10, 15, 20, 25, 30, 35, 40)",
                {"mesh.range.", "mesh.valence-limit."}};
  for (const std::string name : {"directional", "literal"}) {
    const std::string series = "mesh-range-" + name;
    const std::string drawn = style::marked(figure.curves.size() / 2);
    figure.curves.push_back({series, "valence", "upper", name, drawn});
    figure.curves.push_back({series, "valence", "lower", "", drawn});
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
  add_valence_limits(results, table());
  add_mesh_ranges(results, table());
  add_figure(results);
  return results;
}

}  // namespace subdiv
