// The ternary four-point scheme of Hassan, Ivrissimtzis, Dodgson & Sabin (2002), from its mask to a certified
// range.
#include <iostream>
#include <vector>

#include "analysis/continuity_certificate.h"
#include "analysis/hoelder.h"
#include "analysis/limit_mask.h"
#include "analysis/sum_rules.h"
#include "optimize/objectives.h"
#include "schemes/evaluate/ringing.h"

using namespace subdiv;

/// The mask over any ring of coefficients: rationals, intervals, rational functions of mu. New points stand
/// at thirds of the edges, old ones stay.
template <class R>
Mask<R> ternary_four_point(const R& mu) {
  const R far = fraction<R>(-1, 18) - mu / R(6);
  const R end = fraction<R>(-1, 18) + mu / R(6);
  const R near = fraction<R>(13, 18) + mu / R(2);
  const R next = fraction<R>(7, 18) - mu / R(2);
  return {3, Laurent<R>(-5, {end, far, R(0), next, near, R(1), near, next, R(0), far, end})};
}

int main() {
  // One scheme, over the rationals.
  const Mask<Rational> mask = ternary_four_point(Rational(1, 11));
  const SmoothnessReport<Rational> report = smoothness_report(normal_form(mask));
  std::cout << "sum rules        " << sum_rules(mask).order << "\n"
            << "continuity       C" << report.limits.continuity << "\n"
            << "Hoelder exponent " << report.limits.exponent.exact << " = "
            << to_significant(report.limits.exponent.midpoint(), 10) << ".. ("
            << to_string(report.limits.exponent.rigour) << ")\n";

  // All of them at once, over the rational functions of mu: for which mu in [-1, 1] are the limits C2?
  const Mask<RationalFunction> family = ternary_four_point(RationalFunction::variable(0));
  const ContinuityCertificate certificate = certify_continuity(family, 2, {{Rational(-1)}, {Rational(1)}});
  for (const CertificateCell& cell : certificate.cells) {
    std::cout << "C2 " << to_string(cell.smooth) << " for mu in " << RealSet{cell.sides}.to_string() << "\n";
  }

  // The mu for which the differences of order 3 shrink fastest in one step.
  const Summary best =
      minimise(stationary("ternary", family), parse_objective("difference-norm:continuity=2"), Norm::linf,
               {{Rational(1, 15), Rational(1, 9)}}, {"mu"});
  std::cout << "best mu          " << best.minimiser.at(0).exact << ", norm " << best.minimum.exact << " ("
            << to_string(best.termination) << ")\n";

  // Points of a curve, one after the other, exact; `controls` outlives the rings.
  const auto controls = closed_polygon(std::vector<Rational>{0, 4, 4, 0});
  Ringing<Rational, Rational> rings(stationary("ternary", mask), controls, 1);
  for (const Rational& x : rings) std::cout << x.to_string() << " ";
  std::cout << "\n";
}
