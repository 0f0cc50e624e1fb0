#include "analysis/mesh/characteristic_map.h"

#include <cmath>
#include <numbers>
#include <span>
#include <stdexcept>
#include <utility>

#include "analysis/mesh/derivative_bound.h"
#include "analysis/mesh/lattice_limits.h"
#include "analysis/mesh/spline_pieces.h"

namespace subdiv {
namespace {

constexpr int regular_rings(int reach) { return 2 * reach + 1; }

/// Where the ring begins: with regular faces all around, and at an even row for triangles, so that the
/// bisector of a sector meets the row in a vertex.
template <class R>
int inner_row(const MeshScheme<R>& scheme) {
  const int row = scheme.reach + 1;
  return scheme.split == MeshSplit::triangles && row % 2 != 0 ? row + 1 : row;
}

/// The pair of modes with the largest eigenvalue, mode 1 when it is among several.
struct LeadingMode {
  int mode = 1;
  Matrix<double> matrix;  // on all rings of the fan
  RealEigenpair<double> pair;
  double eigenvalue_of_mode_1 = 0;
};

LeadingMode leading_mode(const MeshScheme<double>& scheme, const FanMatrix<double>& fan) {
  constexpr double equal = 1e-12;
  const auto core = static_cast<Eigen::Index>(sector_places(fan.sides, eigenvalue_rings(scheme)).size());
  LeadingMode best;
  for (int mode = 1; 2 * mode < fan.valence; ++mode) {
    Matrix<double> matrix = mode_matrix(fan, mode);
    RealEigenpair<double> pair = dominant_eigenpair(matrix.topLeftCorner(core, core));
    if (mode == 1) best.eigenvalue_of_mode_1 = std::abs(pair.value);
    if (mode > 1 && std::abs(pair.value) <= std::abs(best.pair.value) + equal) continue;
    best.mode = mode;
    best.matrix = std::move(matrix);
    best.pair = std::move(pair);
  }
  return best;
}

/// Why an eigenvalue has no map; empty when it has one.
std::string fault_of(const RealEigenpair<double>& pair) {
  if (!pair.missing.empty()) return pair.missing;
  if (!(pair.value > 0)) return "the eigenvalue is not positive";
  if (!(pair.value < 1)) return "the eigenvalue is not below 1";
  return "";
}

/// What the signs of the Jacobian and the winding number say together.
void conclude(CharacteristicMap& map, const SignsFound& signs) {
  if (signs.both()) {
    map.regular = map.injective = Decision::no;
  } else if (!signs.open && (signs.positive || signs.negative)) {
    map.regular = Decision::yes;
    if (map.winding) map.injective = std::abs(*map.winding) == 1 ? Decision::yes : Decision::no;
  }
  const bool reversed = !signs.positive;
  map.jacobian_ratio = reversed ? signs.largest / signs.smallest : signs.smallest / signs.largest;
}

CharacteristicMap map_of(const LeadingMode& leading) {
  CharacteristicMap map;
  map.missing = fault_of(leading.pair);
  map.mode = leading.mode;
  map.eigenvalue = Interval(leading.pair.value);
  map.eigenvalue_of_mode_1 = leading.eigenvalue_of_mode_1;
  map.method = "eigenvalues of the modes";
  return map;
}

void require_valence(int valence) {
  if (valence < 3) throw std::invalid_argument("characteristic map: the valence is at least 3");
}

FanMatrix<double> rounded_fan(const MeshScheme<double>& scheme, int valence) {
  require_valence(valence);
  return fan_matrix(scheme, valence, regular_rings(scheme.reach));
}

/// How often the curve along a row winds about 0: its angle over half a sector, times 2 n.
std::optional<int> certified_winding(const CharacteristicNet<Interval>& net, const LatticeSpline& spline,
                                     int row) {
  constexpr int depth = 12;
  Interval angle(0);
  for (const std::vector<PlaneNumber<Interval>>& piece : row_curve(net, spline, row)) {
    const std::optional<Interval> part = turned_angle(piece, depth);
    if (!part) return std::nullopt;
    angle += *part;
  }
  const Interval turns = Interval(net.valence()) * angle / pi();
  const auto nearest = static_cast<int>(std::lround(turns.to_double()));
  const Interval error = turns - Interval(nearest);
  const Interval half(Rational(1, 2));
  if (!certainly_less(error, half) || !certainly_less(-error, half)) return std::nullopt;
  return nearest;
}

/// The same from limit points, sampled.
std::optional<int> sampled_winding(const CharacteristicNet<double>& net, const LatticeLimits& limits,
                                   int row) {
  double angle = 0;
  PlaneNumber<double> last = limits.point(net, row, 0);
  for (int b = 1; 2 * b <= (net.sides() == 4 ? 2 * row : row); ++b) {
    const PlaneNumber<double> next = limits.point(net, net.sides() == 4 ? row : row - b, b);
    const PlaneNumber<double> change = conjugate(last) * next;
    if (!(change.x > 0)) return std::nullopt;  // too far apart to tell the way around 0
    angle += std::atan2(change.y, change.x);
    last = next;
  }
  return static_cast<int>(std::lround(net.valence() * angle / std::numbers::pi));
}

}  // namespace

MeshSchemeForms mesh_scheme_forms(const MeshSchemeDescription& description) {
  MeshSchemeForms forms{std::nullopt, mesh_scheme<Interval>(description), mesh_scheme<double>(description)};
  try {
    forms.exact = mesh_scheme<Rational>(description);
  } catch (const OutsideRingError&) {  // an irrational parameter: no spline that this file knows
    forms.exact.reset();
  }
  return forms;
}

CharacteristicMap sampled_verdict(const MeshScheme<double>& scheme, const CharacteristicNet<double>& net,
                                  int levels) {
  constexpr double rounding = 1e-9;
  CharacteristicMap map;
  map.mode = net.mode();
  map.eigenvalue = Interval(net.eigenvalue());
  map.method = "sampled: derivative masks, " + std::to_string(levels) + " levels";
  const std::optional<LatticeLimits> limits = lattice_limits(scheme);
  if (!limits) {
    map.method = "sampled: no derivative masks in regular regions";
    return map;
  }
  const int row = inner_row(scheme) << levels;
  SignsFound signs;
  for (int a = 0; a <= 2 * row; ++a) {
    for (int b = 0; b <= a; ++b) {
      if (net.ring_of(a, b) < row || net.ring_of(a, b) > 2 * row) continue;
      const double jacobian = limits->jacobian(net, a, b);
      signs.smallest = std::min(signs.smallest, jacobian);
      signs.largest = std::max(signs.largest, jacobian);
    }
  }
  const double zero = rounding * std::max(signs.largest, -signs.smallest);
  signs.positive = signs.largest > zero;
  signs.negative = signs.smallest < -zero;
  signs.open = signs.positive ? std::abs(signs.smallest) <= zero : std::abs(signs.largest) <= zero;
  map.winding = sampled_winding(net, *limits, row);
  conclude(map, signs);
  return map;
}

std::optional<CharacteristicNet<double>> characteristic_net(const MeshScheme<double>& scheme, int valence,
                                                            int rings) {
  const FanMatrix<double> fan = rounded_fan(scheme, valence);
  const LeadingMode leading = leading_mode(scheme, fan);
  if (!fault_of(leading.pair).empty()) return std::nullopt;
  return characteristic_net(fan, leading.matrix, leading.mode, leading.pair, lattice_mask(scheme), rings);
}

CharacteristicMap sampled_characteristic_map(const MeshScheme<double>& scheme, int valence, int levels) {
  const FanMatrix<double> fan = rounded_fan(scheme, valence);
  const LeadingMode leading = leading_mode(scheme, fan);
  CharacteristicMap map = map_of(leading);
  if (!map.exists()) return map;
  const int rings = (2 * inner_row(scheme) << levels) + scheme.reach + 1;
  const CharacteristicNet<double> net =
      characteristic_net(fan, leading.matrix, leading.mode, leading.pair, lattice_mask(scheme), rings);
  CharacteristicMap verdict = sampled_verdict(scheme, net, levels);
  verdict.eigenvalue_of_mode_1 = map.eigenvalue_of_mode_1;
  return verdict;
}

CharacteristicMap spline_verdict(const CharacteristicNet<Interval>& net, const LatticeSpline& spline,
                                 int row) {
  constexpr int depth = 8;
  int parts = 4000;
  CharacteristicMap map;
  map.mode = net.mode();
  map.eigenvalue = net.eigenvalue();
  map.rigour = Rigour::certified;
  map.method = "Bernstein coefficients over intervals";
  SignsFound signs;
  for (const LatticeCell& cell : ring_cells(spline.sides, row)) {
    add_signs(signs, jacobian(net, spline, cell), depth, parts);
    if (signs.both()) break;
  }
  map.winding = certified_winding(net, spline, row);
  conclude(map, signs);
  return map;
}

namespace {

/// What is known of a scheme's regular limits, whatever the valence.
struct RegularLimits {
  std::optional<LatticeSpline> spline;
  std::optional<DerivativeBounds> bounds;
};

/// Remembers the last mask: callers ask for many valences of one scheme.
const RegularLimits& regular_limits(const LatticeMask<Rational>& mask, int sides) {
  struct Known {
    LatticeMask<Rational> mask;
    int sides;
    RegularLimits limits;
  };
  thread_local std::optional<Known> known;
  if (!known || known->sides != sides || !(known->mask == mask)) {
    RegularLimits limits;
    limits.spline = spline_with_mask(mask, sides);
    if (!limits.spline) limits.bounds = derivative_bounds(mask);
    known = Known{mask, sides, limits};
  }
  return known->limits;
}

}  // namespace

CharacteristicMap characteristic_map(const MeshSchemeForms& scheme, int valence) {
  CharacteristicMap sampled = sampled_characteristic_map(scheme.rounded, valence);
  if (!scheme.exact || !sampled.exists()) return sampled;
  const int sides = scheme.rounded.split == MeshSplit::quads ? 4 : 3;
  const RegularLimits& limits = regular_limits(lattice_mask(*scheme.exact), sides);
  if (!limits.spline && !limits.bounds) {
    sampled.method += "; limits assumed to be C1 in regular regions";
    return sampled;
  }

  const LeadingMode leading = leading_mode(scheme.rounded, rounded_fan(scheme.rounded, valence));
  const FanMatrix<Interval> fan = fan_matrix(scheme.enclosed, valence, regular_rings(scheme.enclosed.reach));
  const Matrix<Interval> matrix = mode_matrix(fan, leading.mode);
  const Eigen::Index core = leading.pair.vector.size();
  const RealEigenpair<Interval> pair = enclosed_eigenpair(matrix.topLeftCorner(core, core), leading.pair);
  if (!pair.missing.empty() || !certainly_positive(pair.value) || !certainly_less(pair.value, Interval(1)))
    return sampled;
  const int row = inner_row(scheme.enclosed);
  const LatticeMask<Interval> mask = lattice_mask(scheme.enclosed);
  const CharacteristicNet<Interval> net =
      characteristic_net(fan, matrix, leading.mode, pair, mask, 2 * row + mask.last());
  constexpr int levels = 6;
  CharacteristicMap verdict = limits.spline ? spline_verdict(net, *limits.spline, row)
                                            : enclosed_verdict(net, mask, *limits.bounds, levels);
  if (verdict.regular == Decision::undecided || verdict.injective == Decision::undecided) return sampled;
  if (!limits.spline) verdict.jacobian_ratio = sampled.jacobian_ratio;
  verdict.eigenvalue_of_mode_1 = sampled.eigenvalue_of_mode_1;
  return verdict;
}

}  // namespace subdiv
