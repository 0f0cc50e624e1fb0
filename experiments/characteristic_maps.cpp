#include "experiments/characteristic_maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "analysis/mesh/characteristic_map.h"
#include "analysis/mesh/mesh_condition.h"
#include "schemes/mesh/loop.h"

namespace subdiv {
namespace {

const std::string map_is_smooth =
    "The map of an eigenvector of mode 1, the eigenvalue enclosed and proved simple (it is the largest of "
    "all "
    "modes k, 0 < k < n/2, as computed; that it is sub-dominant is a record of its own): the Jacobian has "
    "one "
    "sign on the closed ring, and the winding number of its inner boundary is 1 or -1 (then the map is a "
    "covering of one sheet). ";
const std::string proved =
    map_is_smooth +
    "Signs of Bernstein coefficients over intervals, eigenvectors by Krawczyk's test, for the valences 3 .. "
    "30, 40, 50, 100 and 200.";

const std::string by_discs =
    "Derivatives on squares of the lattice lie in discs around divided differences: their schemes contract, "
    "and norms of their basis functions are bounded; eigenvectors by Krawczyk's test.";

const std::string smooth_there =
    "1 > lambda > all other moduli but lambda's double in mode n - 1, lambda simple in mode 1, and its "
    "characteristic map regular and injective (Reif 1995).";

const std::array table{
    ClaimHead{
        "figure.characteristic-maps", "jsplines", "10, figure 13",
        "characteristic maps for our combined surface subdivision scheme at valences 3, 5, 6, 7, 8 and 20",
        ClaimKind::exact,
        "For s = -1/4, 1/2 and 3/2 with the directional extension of J_s: the 18 maps of mode 1 exist, and "
        "are "
        "regular and injective. Second route: one step of the scheme on the "
        "whole mesh of all sectors maps the drawn net to itself times the eigenvalue of its Fourier "
        "mode."},
    finding("mesh.characteristic-map.catmull-clark", "jsplines 10",
            "Catmull-Clark, bicubic pieces. " + proved),
    finding("mesh.characteristic-map.quintic", "jsplines 10",
            "The directional extension of J_{3/2}, biquintic pieces. " + proved),
    finding("mesh.characteristic-map.loop", "notes 4",
            "Loop's scheme with the weights of the notes, quartic triangles. " + proved),
    ClaimHead{"notes.loop.smooth", "notes", "4",
              "converges to a smooth (having a tangent plane everywhere) surface", ClaimKind::exact,
              "Loop's scheme with the weights of the notes, valences 3 .. 30, 40, 50, 100 and 200, at "
              "vertices, and so at all points of meshes of these valences without border: " +
                  smooth_there + " Nothing is said of other valences."},
    finding("mesh.characteristic-map.loop-1987", "notes 4",
            "Loop's scheme with his own weights, quartic triangles. " + proved),
    finding("mesh.characteristic-map.kobbelt", "jsplines 10",
            "Kobbelt's scheme, valences 3 .. 30. " + map_is_smooth + by_discs),
    finding("mesh.characteristic-map.directional", "jsplines 10",
            "The directional extension of J_s, s = -1/4, 0, .., 3/2 in quarters, valences 3 .. 30. " +
                map_is_smooth + by_discs),
    finding("mesh.characteristic-map.literal", "jsplines 10",
            "The blend (1 - s) Kobbelt + s Catmull-Clark, s = 0, 1/4, .., 3/2, valences 3 .. 30. " +
                map_is_smooth + by_discs),
    ClaimHead{"mesh.smooth.directional", "jsplines", "10",
              "we conjecture that the surfaces are smooth for -1/4 < s < 3/2 up to at least valence 30",
              ClaimKind::exact,
              "On the paper's grid, s in quarters, its two ends included, and valences 3 .. 30, with the "
              "directional extension of J_s: " +
                  smooth_there},
    ClaimHead{"mesh.smooth.literal", "jsplines", "10",
              "we conjecture that the surfaces are smooth for -1/4 < s < 3/2 up to at least valence 30",
              ClaimKind::exact,
              "On the paper's grid, s = 0, 1/4, .., 3/2 and valences 3 .. 30, with (1 - s) Kobbelt + s "
              "Catmull-Clark: " +
                  smooth_there},
    finding(
        "notes.butterfly.winds-twice", "notes 5",
        "Butterfly at the valences 8 .. 30, 40, 50, 100 and 200: some mode k, 1 < k < n/2, has an "
        "eigenvalue above the spectral radius of mode 1, both over intervals. A map of mode k winds k + n "
        "m times around the vertex, m a whole number, never once: injectivity fails."),
};

/// Those of jsplines 10, up to 30.
std::vector<int> paper_valences(int from = 3) {
  constexpr int most = 30;
  std::vector<int> result;
  for (int n = from; n <= most; ++n) result.push_back(n);
  return result;
}

std::vector<int> valences(int from) {
  std::vector<int> result = paper_valences(from);
  for (const int n : {40, 50, 100, 200}) result.push_back(n);
  return result;
}

MeshSchemeForms forms(const std::string& name) { return mesh_scheme_forms(parse_mesh_scheme(name)); }

bool is_proved(const CharacteristicMap& map) {
  return map.exists() && map.rigour == Rigour::certified && map.mode == 1 && map.regular == Decision::yes &&
         map.injective == Decision::yes;
}

constexpr const char* by_samples = "Jacobian, sampled,";
constexpr const char* by_coefficients = "Bernstein coefficient of the Jacobian";

std::string ratio_note(const char* smallest, double least) {
  return fmt::format("The least {} over the largest is {:.3f} or more.", smallest, least);
}

/// The maps of one scheme; `smallest` says what their Jacobians' ratios are.
Claim proved_maps(const std::string& id, const std::string& name, const std::vector<int>& at,
                  const char* smallest) {
  const MeshSchemeForms scheme = forms(name);
  std::string open;
  double least = 1;
  for (const int n : at) {
    const CharacteristicMap map = characteristic_map(scheme, n);
    if (!is_proved(map)) open += fmt::format(" {}", n);
    least = std::min(least, map.jacobian_ratio);
  }
  if (!open.empty())
    throw std::logic_error(name + ": the characteristic map is not proved at the valences" + open);
  return settle_statement(head(table, id), true, "regular and injective", ratio_note(smallest, least),
                          Rigour::certified);
}

/// Beyond a circle just inside the map's eigenvalue lies one eigenvalue of mode 1 and none of the others:
/// that one, then, is the map's.
bool is_subdominant(const SpectralCondition& condition, const Rational& s, const CharacteristicMap& map) {
  if (condition.decide(s) != Decision::yes) return false;
  const Interval radius = (map.eigenvalue * Interval(1 - std::ldexp(1.0, -20))).center();
  const auto beyond = condition.beyond(s, s, radius);
  if (!beyond || !certainly_less(radius, map.eigenvalue)) return false;
  for (std::size_t mode = 0; mode < beyond->size(); ++mode) {
    if ((*beyond)[mode] != (mode == 1 ? 1 : 0)) return false;
  }
  return true;
}

/// The quarters s = first/4 .. 3/2, the upper end of the paper's interval, which begins at -1/4.
std::vector<Rational> quarters(long first) {
  std::vector<Rational> result;
  for (long k = first; k <= 6; ++k) result.emplace_back(k, 4);
  return result;
}

/// All valences 3 .. 30 at all these s of a family: the record of the maps, and that of smoothness.
void add_grid(Results& results, const std::string& family, const std::string& name,
              const std::vector<Rational>& tensions) {
  const MeshScheme<RationalFunction> free = symbolic_mesh_scheme(parse_mesh_scheme(family + ":s=s"));
  const ModeEquation turning = turning_modes(free);
  const ModeEquation invariant = invariant_modes(free);
  std::string open;
  bool smooth = true;
  double least = 1;
  for (const int n : paper_valences()) {
    const SpectralCondition condition = spectral_condition(turning, invariant, n);
    for (const Rational& s : tensions) {
      const CharacteristicMap map = characteristic_map(forms(family + ":s=" + s.to_string()), n);
      if (!is_proved(map)) open += fmt::format(" s = {} at valence {}", s.to_string(), n);
      smooth = smooth && is_proved(map) && is_subdominant(condition, s, map);
      least = std::min(least, map.jacobian_ratio);
    }
  }
  if (!open.empty()) throw std::logic_error(family + ": the characteristic map is not proved:" + open);
  results.claims.push_back(settle_statement(head(table, "mesh.characteristic-map." + name), true,
                                            "regular and injective", ratio_note(by_samples, least),
                                            Rigour::certified));
  const std::string note =
      "Proved at the points of the grid, limits being C1 in regular regions there. Between them the "
      "eigenvalues are proved, too (mesh.conjecture." +
      name + ".eigenvalues); the maps are not.";
  if (!smooth) throw std::logic_error(family + ": smoothness on the grid is not proved");
  results.claims.push_back(
      settle_statement(head(table, "mesh.smooth." + name), true, "smooth", note, Rigour::certified));
}

Claim smooth_loop() {
  const MeshSchemeForms scheme = forms("loop");
  const MeshScheme<RationalFunction> symbolic = loop<RationalFunction>();
  const ModeEquation turning = turning_modes(symbolic);
  bool smooth = true;
  for (const int n : valences(3)) {
    const SpectralCondition condition(turning, invariant_mode(symbolic, n), n);
    const CharacteristicMap map = characteristic_map(scheme, n);
    smooth = smooth && is_proved(map) && is_subdominant(condition, Rational(0), map);
  }
  if (!smooth) throw std::logic_error("loop: smoothness is not proved");
  return settle_statement(
      head(table, "notes.loop.smooth"), true, "smooth",
      "For almost all control points, as Reif's theorem says: those for which the two leading directions at "
      "a vertex are parallel or 0 (all points equal, say) may have no tangent plane. Away from extraordinary "
      "vertices the surfaces are quartic box splines, C2 as functions of the lattice.",
      Rigour::certified);
}

Matrix<Interval> square(const Matrix<Interval>& m) {
  Matrix<Interval> result = zero_matrix<Interval>(m.rows(), m.cols());
  for (Eigen::Index i = 0; i < m.rows(); ++i) {
    for (Eigen::Index j = 0; j < m.cols(); ++j) {
      for (Eigen::Index k = 0; k < m.cols(); ++k) add_product(result(i, j), m(i, k), m(k, j));
    }
  }
  return result;
}

/// An upper bound of the spectral radius: a norm's root of the power 2^k.
Interval radius_bound(Matrix<Interval> power) {
  constexpr int squarings = 9;
  Interval bound(1);
  double exponent = 1;
  Interval scale(0);  // the logarithm of what was divided out, over the exponent
  for (int k = 0; k <= squarings; ++k) {
    Interval norm(0);
    for (Eigen::Index i = 0; i < power.rows(); ++i) {
      Interval sum(0);
      for (Eigen::Index j = 0; j < power.cols(); ++j) sum += abs(power(i, j));
      norm = max(norm, sum);
    }
    scale += log(norm) / Interval(exponent);
    bound = exp(scale);
    power = power.unaryExpr([&](const Interval& x) { return x / norm; });
    power = square(power);
    exponent *= 2;
  }
  return bound;
}

Claim butterfly() {
  const MeshSchemeForms scheme = forms("butterfly");
  std::string windings;
  for (const int n : valences(8)) {
    const CharacteristicMap map = sampled_characteristic_map(scheme.rounded, n);
    const FanMatrix<Interval> fan = fan_matrix(scheme.enclosed, n, eigenvalue_rings(scheme.enclosed));
    const FanMatrix<double> computed = fan_matrix(scheme.rounded, n, eigenvalue_rings(scheme.rounded));
    const RealEigenpair<Interval> pair =
        enclosed_eigenpair(mode_matrix(fan, map.mode), dominant_eigenpair(mode_matrix(computed, map.mode)));
    const bool proved_above = map.exists() && map.mode > 1 && pair.missing.empty() &&
                              certainly_less(radius_bound(mode_matrix(fan, 1)), pair.value);
    if (!proved_above || map.regular != Decision::yes || map.winding != map.mode)
      throw std::logic_error(fmt::format("butterfly: the leading mode at valence {} is not proved", n));
    windings += fmt::format("{}{}: {}", windings.empty() ? "" : ", ", n, *map.winding);
  }
  return settle_statement(head(table, "notes.butterfly.winds-twice"), true, "not injective",
                          "The maps are regular, sampled: normals have a limit, and a test of normals alone "
                          "notices nothing. Turns of the mode that leads, as computed, by valence: " +
                              windings + ".",
                          Rigour::certified);
}

}  // namespace

std::span<const ClaimHead> characteristic_map_heads() { return table; }

Results run_characteristic_maps() {
  Results results;
  add_characteristic_map_figure(results, head(table, "figure.characteristic-maps"));
  results.claims.push_back(
      proved_maps("mesh.characteristic-map.catmull-clark", "catmull-clark", valences(3), by_coefficients));
  results.claims.push_back(
      proved_maps("mesh.characteristic-map.quintic", "jspline-mesh:s=3/2", valences(3), by_coefficients));
  results.claims.push_back(proved_maps("mesh.characteristic-map.loop", "loop", valences(3), by_coefficients));
  results.claims.push_back(smooth_loop());
  results.claims.push_back(
      proved_maps("mesh.characteristic-map.loop-1987", "loop-1987", valences(3), by_coefficients));
  results.claims.push_back(
      proved_maps("mesh.characteristic-map.kobbelt", "kobbelt", paper_valences(), by_samples));
  add_grid(results, "jspline-mesh", "directional", quarters(-1));
  add_grid(results, "jspline-mesh-literal", "literal", quarters(0));
  results.claims.push_back(butterfly());
  return results;
}

}  // namespace subdiv
