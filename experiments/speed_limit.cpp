#include <array>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "analysis/adjustable_speed/speed_spectrum.h"
#include "analysis/mesh/fan_matrix.h"
#include "experiments/speed_parts.h"
#include "experiments/speed_printed.h"
#include "schemes/mesh/catmull_clark.h"

namespace subdiv {
namespace {

using Function = RationalFunction;
using Net = FormNet<Function>;
using Form = SectorForm<Function>;
using speed_variables::beta;
using speed_variables::gamma;
using speed_variables::sigma;
using speed_variables::valence;

const Function& s = sigma;
const Function q = Function(1) - s;
const Function& n = valence;

const std::string any_valence =
    "Identity between combinations of the points of a net whose sectors are counted without end, so for "
    "every "
    "valence n; n is a variable in the vertex's rule. ";
const std::string limit_point =
    "Left eigenvector, sum 1, to the eigenvalue 1 of one step on the vertex and the means over all sectors "
    "of "
    "the points at each of the 6 places of two rings, over Q(sigma, beta, gamma). ";

std::string text(const Function& f) { return f.to_factored_string(speed_variables::names); }

int edge_place() { return sector_place(1, 0).place; }
int face_place() { return sector_place(1, 1).place; }

/// A step on the vertex and the means over all sectors.
Matrix<Function> mean_matrix(const Net& step) {
  constexpr Eigen::Index size = SectorNet<Function>::places + 1;
  Matrix<Function> result = zero_matrix<Function>(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const Form row = i == 0 ? step.centre() : averaged(step.at(0, static_cast<int>(i) - 1));
    result(i, 0) = row.vertex;
    for (Eigen::Index j = 1; j < size; ++j) result(i, j) = row.mean_weight(static_cast<int>(j) - 1);
  }
  return result;
}

/// The combination whose value no step changes, if there is just one of sum 1.
std::optional<Form> invariant_form(const Net& step) {
  Matrix<Function> shifted = mean_matrix(step).transpose();
  for (Eigen::Index i = 0; i < shifted.rows(); ++i) shifted(i, i) -= Function(1);
  const auto basis = null_space(shifted);
  if (basis.size() != 1) return std::nullopt;
  Function sum(0);
  for (const Function& weight : basis[0]) sum += weight;
  if (sum.is_zero()) return std::nullopt;
  Form result;
  result.vertex = basis[0](0) / sum;
  for (Eigen::Index j = 1; j < basis[0].size(); ++j)
    add_to_weight(result.mean, static_cast<int>(j) - 1, Function(basis[0](j) / sum));
  return result;
}

/// One step of Catmull-Clark at a vertex of one valence; its forms count sectors right from valence 5 on,
/// where the offsets -2 .. 2 are different.
Net catmull_clark_at(int number) {
  const FanMatrix<Function> fan = fan_matrix(catmull_clark<Function>(), number, 2);
  std::vector<Form> places;
  for (Eigen::Index p = 0; p < fan.places(); ++p) {
    Form form;
    form.vertex = fan.pull(p);
    for (int k = 0; k < number; ++k) {
      for (Eigen::Index r = 0; r < fan.places(); ++r) {
        const std::pair<int, int> point{2 * k <= number ? k : k - number, static_cast<int>(r)};
        add_to_weight(form.at, point, fan.blocks[static_cast<std::size_t>(k)](p, r));
      }
    }
    places.push_back(std::move(form));
  }
  Form vertex;
  vertex.vertex = fan.centre;
  for (Eigen::Index p = 0; p < fan.places(); ++p)
    add_to_weight(vertex.mean, static_cast<int>(p), Function(Function(number) * fan.spread(p)));
  return {std::move(vertex), std::move(places)};
}

/// One step of Catmull-Clark, n a variable: the vertex's weights are linear in 1/n, read off at two valences
/// and verified at others; all other rules are the same at all valences.
Net catmull_clark_step() {
  constexpr int low = 7;
  constexpr int high = 8;
  const Form at_low = catmull_clark_at(low).centre();
  const Form at_high = catmull_clark_at(high).centre();
  const auto linear = [](const Function& v_low, const Function& v_high, const Function& m) {
    const Function slope = (v_low - v_high) * Function(low * high) / Function(high - low);
    return v_low + slope * (Function(1) / m - fraction<Function>(1, low));
  };
  const auto vertex_at = [&](const Function& m) {
    const auto mean = [&](int place) {
      return linear(at_low.mean_weight(place), at_high.mean_weight(place), m);
    };
    return central_form<Function>(linear(at_low.vertex, at_high.vertex, m), mean(edge_place()),
                                  mean(face_place()));
  };
  const Net at_large = catmull_clark_at(high);
  std::vector<Form> places;
  for (int p = 0; p < static_cast<int>(SectorNet<Function>::places); ++p) {
    places.push_back(at_large.at(0, p));
    if (!(places.back() == catmull_clark_at(low).at(0, p))) throw std::logic_error("rules change with n");
  }
  for (const int other : {3, 4, 5, 12}) {
    if (!(catmull_clark_at(other).centre() == vertex_at(Function(other))))
      throw std::logic_error("the vertex rule is not linear in 1/n");
  }
  return {vertex_at(n), std::move(places)};
}

/// x_0 = 1/2 in all weights.
Form at_half(const Form& form) {
  const std::vector<Function> point{fraction<Function>(1, 2), beta, gamma, n, speed_variables::tau};
  const auto value = [&](const Function& f) { return f.evaluate(std::span<const Function>(point)); };
  Form result;
  result.vertex = value(form.vertex);
  for (const auto& [place, w] : form.mean) add_to_weight(result.mean, place, value(w));
  for (const auto& [place, w] : form.at) add_to_weight(result.at, place, value(w));
  return result;
}

bool same_places(const Net& a, const Net& b, int p) { return at_half(a.at(0, p)) == at_half(b.at(0, p)); }

// ---- (1)

/// The one pair (beta, gamma) for which the limit point of the converted net is Catmull-Clark's, and the
/// determinant of its two linear equations: the limit's denominator times the weights of edge and face
/// neighbours minus Catmull-Clark's. Those of the vertex follow, as both sums are 1.
struct UniqueWeights {
  VertexWeights<Function> weights;
  Function determinant;
};
UniqueWeights unique_weights() {
  const Form limit = substituted(printed_limit(s, {beta, gamma}),
                                 change_of_knots(uniform_knots<Function>(), unit_speed_knots(s)));
  const Form wanted = catmull_clark_limit();
  Matrix<Function> matrix = zero_matrix<Function>(2, 2);
  Vector<Function> right = Vector<Function>::Constant(2, Function(0));
  // The limit's weight of the vertex is sigma (sigma^2 + 2 q) over the denominator.
  const Function denominator = s * (s * s + Function(2) * q) / printed_limit(s, {beta, gamma}).vertex;
  const std::array places{edge_place(), face_place()};
  for (Eigen::Index i = 0; i < 2; ++i) {
    const int place = places.at(static_cast<std::size_t>(i));
    const Function equation = (limit.mean_weight(place) - wanted.mean_weight(place)) * denominator;
    matrix(i, 0) = equation.derivative(1);
    matrix(i, 1) = equation.derivative(2);
    right(i) = matrix(i, 0) * beta + matrix(i, 1) * gamma - equation;
  }
  const std::optional<Vector<Function>> found = solve(matrix, right);
  if (!found) throw std::logic_error("the limit's equations have no unique solution");
  return {{(*found)(0), (*found)(1)}, matrix(0, 0) * matrix(1, 1) - matrix(0, 1) * matrix(1, 0)};
}

void add_weights(Results& results, std::span<const ClaimHead> heads) {
  const auto statement = [&](const char* id, bool holds, std::string found, std::string note = "") {
    results.claims.push_back(settle_statement(head(heads, id), holds, std::move(found), std::move(note)));
  };
  const UniqueWeights unique = unique_weights();
  const VertexWeights<Function> printed = printed_vertex_weights(s);
  const Function below = Function(9) + (n - Function(4)) * (q + Function(1)) * (q + Function(1));
  // Positive for n >= 3 and sigma in (0, 1): below >= 9 - (q + 1)^2.
  const bool always = unique.determinant == (Function(1) + q) * (s * s + Function(2) * q) * below /
                                                (Function(27) * (n + Function(5)) * q * q * q);
  const std::string note = fmt::format(
      "The two linear equations have the determinant (1 + σ̄)(σ^2 + 2σ̄)(9 + (n-4)(σ̄+1)^2)/(27 (n+5) σ̄^3), "
      "positive for {}.",
      "n >= 3 and σ in (0, 1)");
  statement("speed.eq1.beta", always && unique.weights.beta == printed.beta, text(unique.weights.beta), note);
  statement("speed.eq1.gamma", always && unique.weights.gamma == printed.gamma, text(unique.weights.gamma),
            note);
  const Form limit =
      substituted(printed_limit(s, printed), change_of_knots(uniform_knots<Function>(), unit_speed_knots(s)));
  statement("speed.eq1.limit", limit == catmull_clark_limit(), "n/(n+5), 4/(n+5), 1/(n+5)",
            "Weights of the vertex, of the mean of its edge neighbours and of that of the face neighbours.");
  const LineWeights<Function> row = inserted_rows(s)[0];
  const VertexWeights<Function> regular{Function(4) * row[1] * row[2], Function(4) * row[2] * row[2]};
  const VertexWeights<Function> at_4 = vertex_weights(s, 4);
  statement("speed.eq1.regular", at_4.beta == regular.beta && at_4.gamma == regular.gamma,
            fmt::format("β = {}, γ = {}", text(regular.beta), text(regular.gamma)));
}

// ---- The limit point

void add_limit_point(Results& results, std::span<const ClaimHead> heads) {
  const auto statement = [&](const char* id, bool holds, std::string found, std::string note = "") {
    results.claims.push_back(settle_statement(head(heads, id), holds, std::move(found), std::move(note)));
  };
  const Net step = step_of_speed<Function>(s, {beta, gamma});
  const std::optional<Form> found = invariant_form(step);
  const Form printed = printed_limit(s, {beta, gamma});
  if (!found) throw std::logic_error("the step has no unique invariant combination");
  const Function edges = found->mean_weight(edge_place());
  const Function faces = found->mean_weight(face_place());
  statement("speed.limit.structure",
            found->at.empty() && found->mean.size() == 2 && found->sum() == Function(1),
            "the vertex and the means of its edge and face neighbours");
  statement("speed.limit.beta", edges == printed.mean_weight(edge_place()), text(edges));
  statement("speed.limit.gamma", faces == printed.mean_weight(face_place()), text(faces));
  const std::vector<Function> polynomial = characteristic_polynomial(mean_matrix(step));
  Function slope(0);
  for (std::size_t i = 1; i < polynomial.size(); ++i) slope += Function(static_cast<int>(i)) * polynomial[i];
  const Function below = s * (s * s + Function(2) * q) / printed.vertex;
  Function others(1);
  for (const int power : {3, 4, 5, 6}) others *= Function(1) - value_of_text(fmt::format("q^{}", power));
  statement(
      "speed.limit.unique", slope == others * s * below, "σ (1 - σ̄^3)(1 - σ̄^4)(1 - σ̄^5)(1 - σ̄^6) D",
      fmt::format("D = {}, the denominator of the printed formulas, is positive for β, γ >= 0: there 1 is "
                  "a simple eigenvalue and the limit point unique.",
                  text(below)));
  const Net catmull = catmull_clark_step();
  const std::optional<Form> classical = invariant_form(catmull);
  statement("speed.catmull-clark.limit",
            classical && *classical == catmull_clark_limit() &&
                substituted(catmull_clark_limit(), catmull) == catmull_clark_limit(),
            "(4 sum of edges + sum of faces + n^2 v)/(n (n + 5))");
}

// ---- Catmull-Clark

void add_catmull_clark(Results& results, std::span<const ClaimHead> heads) {
  const auto statement = [&](const char* id, bool holds, std::string found, std::string note = "") {
    results.claims.push_back(settle_statement(head(heads, id), holds, std::move(found), std::move(note)));
  };
  const Function half = fraction<Function>(1, 2);
  const Net step = step_of_speed(half, printed_vertex_weights(half));
  const Net there = change_of_knots(uniform_knots<Function>(), unit_speed_knots(half));
  const Net back = change_of_knots(unit_speed_knots(half), uniform_knots<Function>());
  const Net catmull = catmull_clark_step();
  const bool same = composed(back, composed(step, there)) == catmull;
  statement("speed.eq11.catmull-clark", same && composed(back, there) == Net(), "the rules of Catmull-Clark");
  statement("speed.catmull-clark", same, "after the change of knots (11), for every valence",
            "Without it the nets differ from the second ring on, see speed.catmull-clark.plain; the surfaces "
            "are the same.");
  const bool first_ring = step.centre() == catmull.centre() && same_places(step, catmull, edge_place()) &&
                          same_places(step, catmull, face_place());
  bool second_ring = false;
  for (const auto& [a, b] : {std::pair{2, 0}, {2, 1}, {2, 2}, {1, 2}})
    second_ring = second_ring || same_places(step, catmull, sector_place(a, b).place);
  const LineWeights<Function> row = inserted_rows(half)[2];
  const bool rows = row[2] == fraction<Function>(7, 8) && row[3] == fraction<Function>(1, 8);
  statement("speed.catmull-clark.plain", first_ring && !second_ring && rows,
            "p1, p2, p3 are those of Catmull-Clark; p4, p5, p6, p7 are not",
            "Along a line P'_2 = (7 P_1 + P_2)/8 over the knots 1, 2, 4 in place of (P_0 + 6 P_1 + P_2)/8 "
            "over 1, 2, 3.");
}

/// (beta, gamma) for which the quadratic factor of mode 0 has the roots r1 and r2.
VertexWeights<Function> weights_of_roots(const Function& r1, const Function& r2) {
  const Function sum = Function(2) - Function(2) * s * (q * q + Function(1)) - r1 - r2;
  const Function share = (r1 * r2 - q * q * q * q + q * q * q * sum) / (s * q * q);
  return {sum - share, share};
}

void add_range(Results& results, std::span<const ClaimHead> heads) {
  results.claims.push_back(settle_statement(head(heads, "speed.eq1.c1"), lambda_is_subdominant(),
                                            "below λ, for all n >= 3 and σ in (0, 1)",
                                            "The other condition, a regular and injective characteristic "
                                            "ring, does not depend on β and γ. The range "
                                            "that the paper does not print is that of speed.eq1.range."));
  const Function x = Function::variable(eigenvalue_variable);
  const Function r1 = Function::variable(3);  // no valence here
  const Function r2 = Function::variable(4);
  const std::vector<Function> polynomial =
      characteristic_polynomial(mean_matrix(step_of_speed(s, weights_of_roots(r1, r2))));
  Function value(0);
  for (auto c = polynomial.rbegin(); c != polynomial.rend(); ++c) value = value * x + *c;
  Function product = (x - Function(1)) * (x - r1) * (x - r2);
  for (const int power : {3, 4, 5, 6}) product *= x - value_of_text(fmt::format("q^{}", power));
  results.claims.push_back(settle_statement(head(heads, "speed.eq1.range"), value == product,
                                            "the open triangle with the corners (r1, r2) = (λ, λ), (λ, -λ), "
                                            "(-λ, -λ) in β + γ = 2 - 2σ(1 + σ̄^2) - r1 - "
                                            "r2, σσ̄^2 γ = r1 r2 - σ̄^4 + σ̄^3 (β + γ)",
                                            "Eigenvalues of mode 0 are 1, powers of σ̄ and r1, r2. The "
                                            "relation between (β, γ) and (r1 + r2, r1 r2) is "
                                            "affine, and real quadratics with both roots in |x| < λ form the "
                                            "triangle of the three products (Jury). (1) lies inside for λ "
                                            "of (8), see speed.subdominant."));
}

}  // namespace

VertexWeights<Function> printed_vertex_weights(const Function& speed) {
  const Function p = Function(1) - speed;
  const Function below = Function(9) + (n - Function(4)) * (p + Function(1)) * (p + Function(1));
  return {Function(18) * speed * p * (speed * speed + p) / below,
          Function(9) * speed * speed * p * p / below};
}

SectorForm<Function> catmull_clark_limit() {
  const Function below = n + Function(5);
  return central_form<Function>(n / below, Function(4) / below, Function(1) / below);
}

SectorForm<Function> printed_limit(const Function& speed, const VertexWeights<Function>& weights) {
  const Function p = Function(1) - speed;
  const auto& [b, g] = weights;
  const Function below = (speed * speed + Function(3) * p) * b + (Function(2) * p * p + p + Function(1)) * g +
                         speed * (speed * speed + Function(2) * p);
  const Function edges = (Function(2) * p * (b + g) + speed * b) / below;
  const Function faces = (p * p * (b + Function(2) * g) + speed * g) / below;
  return central_form<Function>(Function(1) - edges - faces, edges, faces);
}

std::vector<ClaimHead> speed_limit_heads() {
  const std::string unique =
      "The unique weights for which the limit point of a converted Catmull-Clark net, (11), is "
      "Catmull-Clark's: "
      "solution of two linear equations over Q(sigma, n). ";
  return {
      speed_head("speed.eq1.beta", "II, equation (1)", "β := 18σσ̄(σ^2+σ̄)/(9+(n−4)(σ̄+1)^2)", unique),
      speed_head("speed.eq1.gamma", "II, equation (1)", "γ := 9σ^2σ̄^2/(9+(n−4)(σ̄+1)^2)", unique),
      speed_head(
          "speed.eq1.limit", "II and III",
          "The specific choice of β and γ places the central limit point at the central limit point of "
          "Catmull-Clark subdivision",
          "The limit point of adjustable speed with (1), of the net that (11) gives, as a combination of the "
          "Catmull-Clark net. " +
              any_valence),
      finding(
          "speed.eq1.regular", "speed II, equation (1)",
          "(1) at n = 4: four times the weight of an edge and of a face neighbour when +-qa are inserted in "
          "both directions, over Q(sigma)."),
      speed_head(
          "speed.limit.structure", "III",
          "The stencil for computing the extraordinary point is structurally equivalent. We only need to "
          "replace α, β, γ by ᾰ := 1 − β̆ − γ̆, β̆, γ̆",
          limit_point + "The places where it is not 0."),
      speed_head("speed.limit.beta", "III", "β̆ := (2σ̄(β+γ)+σβ)/((σ^2+3σ̄)β+(2σ̄^2+σ̄+1)γ+σ(σ^2+2σ̄))",
                 limit_point + "Its weight of the mean of the edge neighbours."),
      speed_head("speed.limit.gamma", "III", "γ̆ := (σ̄^2(β+2γ)+σγ)/((σ^2+3σ̄)β+(2σ̄^2+σ̄+1)γ+σ(σ^2+2σ̄))",
                 limit_point + "Its weight of the mean of the face neighbours."),
      finding(
          "speed.limit.unique", "speed III",
          "The derivative at 1 of the characteristic polynomial of mode 0, over Q(sigma, beta, gamma): not 0 "
          "where 1 is a simple eigenvalue."),
      finding("speed.catmull-clark.limit", "speed III",
              "The limit point of Catmull-Clark by its own rules: the left eigenvector to 1, sum 1, over "
              "Q(n); the "
              "rule of the vertex is linear in 1/n, read off at two valences and verified at four more."),
      speed_head(
          "speed.catmull-clark", "abstract", "For σ = 1/2, the Catmull-Clark algorithm is recovered",
          "One step at sigma = 1/2, with (1), between the change (11) and its inverse, against the rules of "
          "Catmull-Clark on two rings. " +
              any_valence),
      speed_head(
          "speed.eq11.catmull-clark", "III",
          "applying (11), then (3) and reversing (11) proves that σ = 1/2 yields a subdivision scheme "
          "coinciding with Catmull-Clark subdivision",
          "The product of the three against the rules of Catmull-Clark on two rings; (11) and its inverse "
          "cancel. " +
              any_valence),
      finding("speed.catmull-clark.plain", "speed abstract",
              "The rules at sigma = 1/2 that are those of Catmull-Clark without a change of knots. " +
                  any_valence),
      speed_head(
          "speed.eq1.c1", "II", "The weights β and γ are chosen within a range that yields C1 surfaces",
          "What C1 asks of beta and gamma, which enter mode 0 alone: with (1) its eigenvalues but 1 are "
          "below "
          "lambda of (8) in modulus, for every valence n >= 3 and every sigma in (0, 1)."),
      finding(
          "speed.eq1.range", "speed II",
          "The (beta, gamma), real, for which mode 0 has no eigenvalue but 1, q^3 .. q^6 and two in |x| < "
          "lambda, for any lambda > 0: the range that the paper speaks of and does not give, as far as it "
          "rests on beta and gamma."),
  };
}

void add_speed_limit(Results& results, std::span<const ClaimHead> heads) {
  add_weights(results, heads);
  add_limit_point(results, heads);
  add_catmull_clark(results, heads);
  add_range(results, heads);
}

}  // namespace subdiv
