#include "analysis/three_tap_radius.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "analysis/sign_on_interval.h"
#include "schemes/algebra/specialize.h"
#include "schemes/algebra/univariate.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

Matrix<Function> columns(std::initializer_list<std::pair<Function, Function>> points) {
  Matrix<Function> result(2, static_cast<Eigen::Index>(points.size()));
  Eigen::Index column = 0;
  for (const auto& [x, y] : points) {
    result(0, column) = x;
    result(1, column) = y;
    ++column;
  }
  return result;
}

Matrix<Function> diamond() { return columns({{1, 0}, {0, 1}}); }
Matrix<Function> hexagon() { return columns({{1, 0}, {0, 1}, {1, 1}}); }

/// The orbit of the leading eigenvectors v1, v2 of T_1 T_0 and T_0 T_1, p = 4 / (7 + u^2), with w1 = T_0 v1 /
/// rho and its mirror image lengthened until T_1 w1 / rho comes to lie on an edge.
Matrix<Function> octagon() {
  const Function u = Function::variable(0);
  const Function y = (u + 1) * (u + 3) / 4;
  return columns({{2, u + 1}, {u + 1, 2}, {0, y}, {y, 0}});
}

std::vector<Matrix<Function>> matrices_at(const Function& p) {
  const Function q = Function(1) - Function(2) * p;
  std::vector<Matrix<Function>> result(2, zero_matrix<Function>(2, 2));
  result[0] << p, Function(0), p, q;
  result[1] << q, p, Function(0), p;
  return result;
}

void require(bool proved, const std::string& what) {
  if (!proved) throw std::logic_error("three-tap masks: " + what + " is not proved");
}

/// The polytope with proposed combinations, proved for all parameters.
ParametricPolytope proved_polytope(const Function& p, Matrix<Function> vertices, const Function& factor,
                                   const RealInterval& parameters) {
  auto polytope = propose_combinations(matrices_at(p), std::move(vertices), factor, sample(parameters));
  const auto flaw = polytope ? find_flaw(*polytope, parameters) : "the vertices do not span the plane";
  require(!flaw, "a bound (" + flaw.value_or("") + ")");
  return *polytope;
}

bool is_monotone(const Function& f, const RealInterval& range) {
  const Function slope = f.derivative(0);
  RealInterval inner = range;
  inner.lower_closed = inner.upper_closed = false;
  return is_positive(slope, inner) || is_positive(-slope, inner);
}

std::optional<Algebraic> image(const Function& f, const std::optional<Algebraic>& x) {
  return x ? std::optional(specialize(f, 0, *x)) : std::nullopt;
}

RadiusPiece proved_piece(const Function& p, const RealInterval& parameters, const Function& radius, Word word,
                         Matrix<Function> vertices, std::string shape) {
  RadiusPiece piece{parameters, p, parameters, radius, std::move(word), {}, std::move(shape)};
  require(is_monotone(p, parameters), "a substitution");
  piece.range.lower = image(p, parameters.lower);
  piece.range.upper = image(p, parameters.upper);
  if (piece.range.lower && piece.range.upper && *piece.range.upper < *piece.range.lower) {
    std::swap(piece.range.lower, piece.range.upper);
  }
  piece.polytope = proved_polytope(p, std::move(vertices), radius, parameters);
  const Matrix<Function> leading = product(piece.polytope.matrices, piece.word);
  Function eigenvalue(1);
  for (std::size_t i = 0; i < piece.word.size(); ++i) eigenvalue *= radius;
  require(is_nonnegative(radius, parameters), "a sign");
  require(is_eigenvalue(leading, eigenvalue) || is_eigenvalue(leading, -eigenvalue), "an eigenvalue");
  return piece;
}

RealInterval closed(std::optional<Rational> lower, std::optional<Rational> upper) {
  RealInterval result;
  if (lower) result.lower = Algebraic(*lower);
  if (upper) result.upper = Algebraic(*upper);
  result.lower_closed = lower.has_value();
  result.upper_closed = upper.has_value();
  return result;
}

std::vector<RadiusPiece> prove_pieces() {
  const Function p = Function::variable(0);
  const Function& u = p;
  const Function below = Function(1) - Function(2) * p;
  const Function bent = Function(4) / (Function(7) + u * u);
  const Rational quarter(1, 4);
  const Rational half(1, 2);
  std::vector<RadiusPiece> pieces;
  pieces.push_back(proved_piece(p, closed({}, Rational(0)), below, {0}, hexagon(), "hexagon"));
  pieces.push_back(proved_piece(p, closed(Rational(0), quarter), below, {0}, diamond(), "diamond"));
  pieces.push_back(
      proved_piece(bent, closed(Rational(1), Rational(3)), bent * (u + 1) / 2, {0, 1}, octagon(), "octagon"));
  pieces.push_back(proved_piece(p, closed(half, Rational(1)), p, {0}, hexagon(), "hexagon"));
  pieces.push_back(proved_piece(p, closed(Rational(1), {}), -below, {0}, hexagon(), "hexagon"));
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    require(pieces[i - 1].range.upper == pieces[i].range.lower, "that the pieces cover the line");
  }
  return pieces;
}

/// The parameter u of a piece that gives this p; the substitution is either u itself or even in u.
Algebraic parameter_of(const RadiusPiece& piece, const Algebraic& p) {
  if (piece.p == Function::variable(0)) return p;
  Algebraic u = sqrt(Algebraic(4) / p - Algebraic(7));
  require(specialize(piece.p, 0, u) == p, "an inverse");
  return u;
}

struct NormPiece {
  RealInterval range;
  Function norm;
};

/// The hexagon's factors for all p: extremal outside [0, 1/2] only.
std::vector<NormPiece> prove_norms() {
  const Function p = Function::variable(0);
  const Function below = Function(1) - Function(2) * p;
  const Rational half(1, 2);
  std::vector<NormPiece> pieces{{closed({}, Rational(0)), below},
                                {closed(Rational(0), half), Function(1) - p},
                                {closed(half, Rational(1)), p},
                                {closed(Rational(1), {}), -below}};
  for (const NormPiece& piece : pieces) (void)proved_polytope(p, hexagon(), piece.norm, piece.range);
  return pieces;
}

}  // namespace

std::vector<Matrix<Function>> three_tap_matrices() { return matrices_at(Function::variable(0)); }

const std::vector<RadiusPiece>& three_tap_radius_pieces() {
  static const std::vector<RadiusPiece> pieces = prove_pieces();
  return pieces;
}

Algebraic three_tap_radius(const Algebraic& p) {
  for (const RadiusPiece& piece : three_tap_radius_pieces()) {
    if (piece.range.contains(p)) return specialize(piece.radius, 0, parameter_of(piece, p));
  }
  throw std::logic_error("no piece of the radius contains " + p.to_string());
}

RealSet three_tap_radius_below(const Rational& bound) {
  std::vector<Algebraic> critical;
  for (const RadiusPiece& piece : three_tap_radius_pieces()) {
    if (piece.range.upper) critical.push_back(*piece.range.upper);
    const Polynomial equation = (piece.radius - Function(bound)).numerator();
    for (const RealRoot& root : real_roots(UnivariatePolynomial(equation, 0))) {
      if (piece.parameters.contains(root.value)) critical.push_back(specialize(piece.p, 0, root.value));
    }
  }
  return solve_by_cells(std::move(critical),
                        [&](const Algebraic& p) { return three_tap_radius(p) < Algebraic(bound); });
}

Rational three_tap_common_norm(const Rational& lower, const Rational& upper) {
  static const std::vector<NormPiece> pieces = prove_norms();
  if (lower > upper) throw std::domain_error("an empty interval");
  // Each factor is linear in p: its maximum stands at an end.
  Rational largest(0);
  for (const NormPiece& piece : pieces) {
    const Rational low = piece.range.lower ? std::max(lower, piece.range.lower->to_rational()) : lower;
    const Rational high = piece.range.upper ? std::min(upper, piece.range.upper->to_rational()) : upper;
    if (low > high) continue;
    largest = std::max({largest, specialize(piece.norm, 0, low), specialize(piece.norm, 0, high)});
  }
  return largest;
}

}  // namespace subdiv
