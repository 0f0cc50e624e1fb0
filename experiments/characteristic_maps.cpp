#include "experiments/characteristic_maps.h"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>

#include "analysis/mesh/characteristic_map.h"

namespace subdiv {
namespace {

const std::string map_is_smooth =
    "The characteristic map, of the eigenvector of the largest eigenvalue of the modes k, 0 < k < n/2: the "
    "Jacobian has one sign on the closed ring, and the winding number of its inner boundary is 1 or -1 (then "
    "the map is a covering of one sheet). ";
const std::string proved =
    map_is_smooth +
    "Signs of Bernstein coefficients over intervals, eigenvectors by Krawczyk's test, for the valences 3 .. "
    "30, 40, 50, 100 and 200.";

const std::array table{
    ClaimHead{
        "figure.characteristic-maps", "jsplines", "10, figure 13",
        "characteristic maps for our combined surface subdivision scheme at valences 3, 5, 6, 7, 8 and 20",
        ClaimKind::exact,
        "For s = -1/4, 1/2 and 3/2 with the directional extension of J_s: the 18 maps exist, and are "
        "regular and injective (sampled but for s = 3/2). Second route: one step of the scheme on the "
        "whole mesh of all sectors maps the drawn net to itself times the eigenvalue of its Fourier "
        "mode."},
    finding("mesh.characteristic-map.catmull-clark", "jsplines 10",
            "Catmull-Clark, bicubic pieces. " + proved),
    finding("mesh.characteristic-map.quintic", "jsplines 10",
            "The directional extension of J_{3/2}, biquintic pieces. " + proved),
    finding("mesh.characteristic-map.loop", "notes 4",
            "Loop's scheme with the weights of the notes, quartic triangles. " + proved),
    finding("mesh.characteristic-map.loop-1987", "notes 4",
            "Loop's scheme with his own weights, quartic triangles. " + proved),
    ClaimHead{"mesh.characteristic-map.sampled", "jsplines", "10, figure 14",
              "in each case, the surface is smooth, even at extraordinary vertices", ClaimKind::exact,
              "The schemes of the figure that are no splines, Kobbelt's and the directional extension of "
              "J_{1/2}, at the valences 3 .. 30. " +
                  map_is_smooth + "Sampled: derivative masks on the net after 3 steps."},
    finding(
        "notes.butterfly.winds-twice", "notes 5",
        "Butterfly at the valences 8 .. 30, 40, 50, 100 and 200: some mode k, 1 < k < n/2, has an "
        "eigenvalue above the spectral radius of mode 1, both over intervals. A map of mode k winds k + n "
        "m times around the vertex, m a whole number, never once: injectivity fails."),
};

std::vector<int> valences(int from) {
  constexpr int most = 30;
  std::vector<int> result;
  for (int n = from; n <= most; ++n) result.push_back(n);
  for (const int n : {40, 50, 100, 200}) result.push_back(n);
  return result;
}

MeshSchemeForms forms(const std::string& name) { return mesh_scheme_forms(parse_mesh_scheme(name)); }

Claim proved_smooth(const std::string& id, const std::string& name) {
  const MeshSchemeForms scheme = forms(name);
  std::string open;
  double least = 1;
  for (const int n : valences(3)) {
    const CharacteristicMap map = characteristic_map(scheme, n);
    const bool smooth = map.exists() && map.rigour == Rigour::certified && map.mode == 1 &&
                        map.regular == Decision::yes && map.injective == Decision::yes;
    if (!smooth) open += fmt::format(" {}", n);
    least = std::min(least, map.jacobian_ratio);
  }
  if (!open.empty())
    throw std::logic_error(name + ": the characteristic map is not proved at the valences" + open);
  return settle_statement(
      head(table, id), true, "regular and injective",
      fmt::format("The least Bernstein coefficient of the Jacobian over the largest is {:.3f} "
                  "or more.",
                  least),
      Rigour::certified);
}

Claim sampled_smooth() {
  bool holds = true;
  double least = 1;
  for (const char* name : {"kobbelt", "jspline-mesh:s=1/2"}) {
    const MeshScheme<double> scheme = forms(name).rounded;
    constexpr int most = 30;
    for (int n = 3; n <= most; ++n) {
      const CharacteristicMap map = sampled_characteristic_map(scheme, n);
      holds = holds && map.exists() && map.mode == 1 && map.regular == Decision::yes &&
              map.injective == Decision::yes;
      least = std::min(least, map.jacobian_ratio);
    }
  }
  return settle_statement(
      head(table, "mesh.characteristic-map.sampled"), holds, holds ? "regular and injective" : "not smooth",
      fmt::format("The least sampled Jacobian over the largest is {:.3f} or more.", least),
      Rigour::approximate);
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
                          "notices nothing. Turns of the leading mode by valence: " +
                              windings + ".",
                          Rigour::certified);
}

}  // namespace

std::span<const ClaimHead> characteristic_map_heads() { return table; }

Results run_characteristic_maps() {
  Results results;
  add_characteristic_map_figure(results, head(table, "figure.characteristic-maps"));
  results.claims.push_back(proved_smooth("mesh.characteristic-map.catmull-clark", "catmull-clark"));
  results.claims.push_back(proved_smooth("mesh.characteristic-map.quintic", "jspline-mesh:s=3/2"));
  results.claims.push_back(proved_smooth("mesh.characteristic-map.loop", "loop"));
  results.claims.push_back(proved_smooth("mesh.characteristic-map.loop-1987", "loop-1987"));
  results.claims.push_back(sampled_smooth());
  results.claims.push_back(butterfly());
  return results;
}

}  // namespace subdiv
