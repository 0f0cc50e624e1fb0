#include "experiments/polyloop_parts.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "analysis/polyloop/enclosed_jerk.h"
#include "experiments/polyloop_curves.h"
#include "experiments/polyloop_shapes.h"

namespace subdiv {
namespace {

const ClaimHead& head_of(const std::string& id) { return head(polyloop_curve_heads(), id); }
const std::vector<std::string>& names() { return stationary_polyloop_curves(); }
int family_size() { return static_cast<int>(simple_polygons().size()); }

Claim share(const std::string& id, int count, std::string note = "") {
  return settle_share(head_of(id), count, family_size(), std::move(note), Rigour::certified);
}

using Jerks = std::vector<EnclosedNormalJerk>;  // of each polygon

Jerks jerks_of(const Scheme<Rational>& scheme) {
  Jerks result;
  for (const PlanePolygon& polygon : simple_polygons())
    result.push_back(enclosed_normal_jerk(refined(scheme, polygon)));
  return result;
}

/// How many of the pairs (a_i, b_i) have a below `factor` b.
int below(const Jerks& a, const Jerks& b, const Rational& factor = Rational(1)) {
  int count = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    count += certainly_less(a[i].largest, Interval(factor) * b[i].largest) ? 1 : 0;
  return count;
}

/// The least, the median and the greatest of a_i / b_i.
std::string ratios_text(const Jerks& a, const Jerks& b) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < a.size(); ++i)
    ratios.push_back(a[i].largest.to_double() / b[i].largest.to_double());
  std::ranges::sort(ratios);
  return fmt::format("The ratio runs from {:.3g} to {:.3g}, median {:.3g}.", ratios.front(), ratios.back(),
                     ratios[ratios.size() / 2]);
}

Interval irregularity(const EnclosedNormalJerk& of) { return of.largest / of.mean; }

void add_jerks(Results& results) {
  std::vector<Jerks> of;
  for (const std::string& name : names()) of.push_back(jerks_of(polyloop_curve(name)));
  const Jerks& cubic = of.front();
  const Jerks& four_point = of.back();
  const Jerks jm = jerks_of(polyloop_curve("Jm"));
  Scheme<Rational> backwards = polyloop_curve("Jm");
  std::ranges::reverse(backwards.steps);
  const Jerks reversed = jerks_of(backwards);
  const Rational barely(1, 20);
  const Rational unnoticed(1, 10);
  results.claims.push_back(
      share("polyloops.jerk.j0", below(cubic, four_point, barely),
            ratios_text(cubic, four_point) + " It is about halved by each further level."));
  int irregular = 0;
  int rising = 0;
  int both = 0;
  for (std::size_t i = 0; i < cubic.size(); ++i) {
    const Interval ratio = irregularity(four_point[i]);
    bool most = certainly_less(Interval(2), ratio);
    bool rises = true;
    for (std::size_t k = 0; k + 1 < of.size(); ++k) {
      most = most && certainly_less(irregularity(of[k][i]), ratio);
      rises = rises && certainly_less(of[k][i].largest, of[k + 1][i].largest);
    }
    irregular += most ? 1 : 0;
    rising += rises ? 1 : 0;
    both += certainly_less(reversed[i].largest, min(cubic[i].largest, jm[i].largest)) ? 1 : 0;
  }
  results.claims.push_back(share("polyloops.jerk.j8", irregular));
  results.claims.push_back(share("polyloops.jerk.rising", rising));
  results.claims.push_back(share(
      "polyloops.jm.jerk", below(jm, four_point, unnoticed),
      ratios_text(jm, four_point) +
          fmt::format(" Below a twentieth on {}. The limit of Jm is C3, and its jerks fall by 8 with each "
                      "further level in the end; those of J8, of exponent 2, by about 4.",
                      below(jm, four_point, barely))));
  results.claims.push_back(share("polyloops.jm.jerk.least", below(jm, cubic), ratios_text(jm, cubic)));
  results.claims.push_back(
      share("polyloops.jm.jerk.reversed", both,
            "Reversed steps end with J(2) and leave a smaller shape. " + ratios_text(reversed, jm)));
}

/// The integral of the squared curvature times the length, curvatures by circles.
double bending(const Polyline& polyline) {
  const std::vector<double>& x = polyline.coordinates[0];
  const std::vector<double>& y = polyline.coordinates[1];
  const std::size_t n = x.size();
  double energy = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t a = (i + n - 1) % n;
    const std::size_t c = (i + 1) % n;
    const double before = std::hypot(x[i] - x[a], y[i] - y[a]);
    const double after = std::hypot(x[c] - x[i], y[c] - y[i]);
    const double chord = std::hypot(x[c] - x[a], y[c] - y[a]);
    const double twice_area = (x[i] - x[a]) * (y[c] - y[i]) - (y[i] - y[a]) * (x[c] - x[i]);
    const double curvature = 2 * twice_area / (before * after * chord);
    energy += curvature * curvature * (before + after) / 2;
  }
  return energy * length(polyline);
}

void add_shapes(Results& results) {
  std::vector<int> above(names().size(), 0);
  int least = 0;
  for (const PlanePolygon& polygon : simple_polygons()) {
    const double jm = bending(refined(polyloop_curve("Jm"), polygon));
    bool best = true;
    for (std::size_t i = 0; i < names().size(); ++i) {
      const bool worse = jm < bending(refined(polyloop_curve(names()[i]), polygon));
      above[i] += worse ? 1 : 0;
      best = best && worse;
    }
    least += best ? 1 : 0;
  }
  std::string counts;
  for (std::size_t i = 0; i < above.size(); ++i)
    counts += fmt::format("{}{} on {}", counts.empty() ? "" : ", ", names()[i], above[i]);
  results.claims.push_back(
      settle_share(head_of("polyloops.jm.pleasant"), least, family_size(),
                   "Jm has less than J0, J2 and so on, each taken alone, as follows: " + counts + ".",
                   Rigour::approximate));
}

}  // namespace

Results run_polyloop_jerks() {
  Results results;
  add_jerks(results);
  add_shapes(results);
  return results;
}

}  // namespace subdiv
