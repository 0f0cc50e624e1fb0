#include "experiments/polyloop_parts.h"

#include <algorithm>

#include <fmt/format.h>

#include "analysis/hausdorff_distance.h"
#include "analysis/limit_points.h"
#include "experiments/area_schemes.h"
#include "experiments/polyloop_curves.h"
#include "experiments/polyloop_shapes.h"
#include "schemes/algebra/univariate.h"

namespace subdiv {
namespace {

const ClaimHead& head_of(const std::string& id) { return head(polyloop_curve_heads(), id); }
const std::vector<std::string>& names() { return stationary_polyloop_curves(); }
int family_size() { return static_cast<int>(simple_polygons().size()); }

/// Distances are computed in double, not enclosed.
Claim statement(const std::string& id, bool holds, std::string exact, std::string note = "") {
  return settle_statement(head_of(id), holds, std::move(exact), std::move(note), Rigour::approximate);
}

Claim share(const std::string& id, int count, std::string note = "") {
  return settle_share(head_of(id), count, family_size(), std::move(note), Rigour::approximate);
}

/// The Hausdorff distances of several curves from a polygon, with bounds as close as a comparison asks.
class Distances {
 public:
  Distances(const PlanePolygon& polygon, const std::vector<std::string>& curves)
      : polygon_(in_double(polygon)) {
    for (const std::string& name : curves) curves_.push_back({refined(polyloop_curve(name), polygon), {}, 1});
  }

  /// Whether curve a is nearer than b; false where they are equally far, to about 1e-9.
  bool nearer(std::size_t a, std::size_t b) {
    constexpr double finest = 1e-9;
    for (double tolerance = 1e-1; tolerance > finest; tolerance /= 32) {
      const DistanceBounds of_a = bounds(curves_[a], tolerance);
      const DistanceBounds of_b = bounds(curves_[b], tolerance);
      if (of_a.upper + finest < of_b.lower) return true;
      if (of_b.upper + finest < of_a.lower) return false;
    }
    return false;
  }
  bool nearest(std::size_t a) {
    for (std::size_t b = 0; b < curves_.size(); ++b) {
      if (b != a && !nearer(a, b)) return false;
    }
    return true;
  }
  DistanceBounds fine(std::size_t a) {
    constexpr double tolerance = 1e-6;
    return bounds(curves_[a], tolerance);
  }

 private:
  struct Entry {
    Polyline curve;
    DistanceBounds known;
    double tolerance;
  };
  const DistanceBounds& bounds(Entry& entry, double tolerance) {
    if (entry.known.upper == 0 || entry.tolerance > tolerance) {
      entry.known = hausdorff_distance(polygon_, entry.curve, tolerance);
      entry.tolerance = tolerance;
    }
    return entry.known;
  }

  Polyline polygon_;
  std::vector<Entry> curves_;
};

constexpr std::size_t place_of_j4 = 2;
constexpr std::size_t place_of_j5 = 3;

/// On the square with corners (+-1/2, +-1/2) a corner's limit point is at the distance sqrt(2) c(s) from it,
/// and a mid-edge's limit point m(s) beyond the edge: 2 c^2 = m^2.
Algebraic balanced_parameter() {
  const Scheme<RationalFunction> scheme = repeated_jspline(RationalFunction::variable(0));
  const Laurent<RationalFunction> corner = vertex_limit_mask(scheme);
  const Laurent<RationalFunction> side = edge_limit_mask(scheme);
  const auto height = [](const Laurent<RationalFunction>& mask) {
    RationalFunction sum(0);
    for (int j = mask.first(); j <= mask.last(); ++j)
      sum += (residue(j, 4) < 2 ? mask[j] : -mask[j]) * fraction<RationalFunction>(1, 2);
    return sum - fraction<RationalFunction>(1, 2);
  };
  const RationalFunction c = height(corner);
  const RationalFunction m = height(side);
  const RationalFunction balance = RationalFunction(2) * c * c - m * m;
  std::vector<Algebraic> found;
  for (const RealRoot& root : real_roots(UnivariatePolynomial(balance.numerator(), 0))) {
    if (Algebraic(0) < root.value && root.value < Algebraic(Rational(3, 4))) found.push_back(root.value);
  }
  if (found.size() != 1) throw std::logic_error("no single balanced parameter on the square");
  return found.front();
}

void add_distances(Results& results) {
  int nearer = 0;
  std::vector<int> nearest(names().size(), 0);
  for (const PlanePolygon& polygon : simple_polygons()) {
    Distances distances(polygon, names());
    nearer += distances.nearer(place_of_j5, place_of_j4) ? 1 : 0;
    for (std::size_t i = 0; i < nearest.size(); ++i) nearest[i] += distances.nearest(i) ? 1 : 0;
  }
  results.claims.push_back(share("polyloops.j5.hausdorff", nearer));

  Distances square(stored_polyloop("square"), names());
  std::string measured;
  for (std::size_t i = place_of_j4; i <= place_of_j5 + 1; ++i) {
    measured += fmt::format("{}{} {:.4f}", measured.empty() ? "" : ", ", names()[i], square.fine(i).upper);
  }
  results.claims.push_back(statement(
      "polyloops.j5.square", square.nearest(place_of_j5), square.nearest(place_of_j5) ? "true" : "false",
      "J6 is nearer on a square: of edges 5 the distances of the polygons of level 5 are " + measured +
          ". Limit curves differ from that by at most 0.0011. Of these the best is about J(5.66), see "
          "polyloops.j5.square.best."));
  const Algebraic s = balanced_parameter();
  results.claims.push_back(settle(head_of("polyloops.j5.square.best"),
                                  exact(Algebraic(8) - Algebraic(8) * s, "exact by limit masks"),
                                  "Of the limit curves, not of polygons of level 5. A larger s takes the "
                                  "curve farther from the corners, a smaller one farther beyond the edges."));
  std::string counts;
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    counts += fmt::format("{}{}: {}", counts.empty() ? "" : ", ", names()[i], nearest[i]);
  }
  results.claims.push_back(share(
      "polyloops.j5.others", nearest[place_of_j5],
      "The polygon nearest to L is, of the six of level 5, counted by polygons L, that of " + counts + "."));
}

void add_popping(Results& results) {
  constexpr int levels = 4;
  std::vector<std::vector<double>> moved;  // of curve, polygon and level
  for (const std::string& name : names()) {
    std::vector<double>& of_curve = moved.emplace_back();
    for (const PlanePolygon& polygon : simple_polygons()) {
      Polyline parent = in_double(polygon);
      for (int level = 1; level <= levels; ++level) {
        Polyline fine = refined(polyloop_curve(name), polygon, level);
        of_curve.push_back(largest_displacement(parent, fine, 2));
        parent = std::move(fine);
      }
    }
  }
  // Displacements are differences of coordinates that doubles hold exactly; only the length of the vector
  // rounds, by less than the margin.
  constexpr double margin = 1e-9;
  std::vector<int> least(moved.size(), 0);
  for (std::size_t i = 0; i < moved.front().size(); ++i) {
    for (std::size_t a = 0; a < moved.size(); ++a) {
      bool below = true;
      for (std::size_t b = 0; b < moved.size(); ++b)
        below = below && (a == b || moved[a][i] + margin < moved[b][i]);
      least[a] += below ? 1 : 0;
    }
  }
  std::string counts;
  for (std::size_t i = 0; i < least.size(); ++i)
    counts += fmt::format("{}{}: {}", counts.empty() ? "" : ", ", names()[i], least[i]);
  results.claims.push_back(settle_share(
      head_of("polyloops.j5.popping"), least[place_of_j5], levels * family_size(),
      "The least is, counted by pairs of a polygon and a level, that of " + counts + ".", Rigour::certified));
}

/// Every curve on every stored polygon: area and distance relative to it, normal jerk.
void add_measures(Results& results) {
  const auto cell = [](double x) { return fmt::format("{:.10g}", x); };
  Series measures{
      "polyloop-measures",
      {"polygon", "curve", "area", "hausdorff lower", "hausdorff upper", "jerk largest", "jerk mean"},
      {}};
  std::vector<std::string> all = names();
  all.emplace_back("Jm");
  for (const auto& [polygon_name, polygon] : stored_polyloops()) {
    Distances distances(polygon, all);
    const double own = signed_area(in_double(polygon));
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Polyline curve = refined(polyloop_curve(all[i]), polygon);
      const NormalJerk of = normal_jerk(curve);
      const DistanceBounds distance = distances.fine(i);
      measures.rows.push_back({polygon_name, all[i], cell(signed_area(curve) / own), cell(distance.lower),
                               cell(distance.upper), cell(of.largest), cell(of.mean)});
    }
  }
  results.series.push_back(std::move(measures));
}

}  // namespace

Results run_polyloop_distances() {
  Results results;
  add_distances(results);
  add_popping(results);
  add_measures(results);
  return results;
}

}  // namespace subdiv
