#include "experiments/polygon_curves.h"

#include <algorithm>
#include <iterator>

#include "experiments/simple_polygons.h"

namespace subdiv {
namespace {

const std::string share_of = "Share, over " + simple_polygons_text() + ", of those ";
const std::string area_error =
    "E = area of the limit curve / area of the polygon - 1, exact by the area mask. ";
const std::string disparity =
    "The disparity of level k is the largest distance of a point of level k from its place on the polygon of "
    "level k - 1 under linear refinement J_{0,1}, exact. ";
const std::string pairs = "Share, over " + simple_polygons_text() + " and the levels 1 to 4, of those pairs ";
const std::string iteration =
    "P <- P + (C - L P) from P = C until every limit point is within 1/1000 of its target, for polygons of "
    "longer sides 89 to 199; counted in floating point with a proved bound on the rounding errors. ";
const std::string b2_distance =
    "The distances are those of the limit curves at the parameters i/64, every control point a unit apart "
    "and "
    "both basis functions centred; compared in outward-rounded arithmetic. ";

const std::string bending_energy =
    "A curve is better shaped when its bending energy times its length, the integral of the squared "
    "curvature "
    "times the length, is smaller: a number without units, 4 pi^2 for circles; of polygons of level 7, in "
    "floating point. ";
const std::string local_effect =
    "One vertex of a closed loop of 12 points moves by 1: how far the points of the retrofitted limit curve "
    "at "
    "the parameters i/16 move, exact. ";

ClaimHead tendency(std::string id, std::string document, std::string section, std::string printed,
                   std::string definition) {
  return {std::move(id),      std::move(document), std::move(section),
          std::move(printed), ClaimKind::tendency, std::move(definition)};
}
ClaimHead own_share(std::string id, std::string section, std::string definition) {
  return {std::move(id), "subdivlab",         std::move(section),
          std::nullopt,  ClaimKind::tendency, std::move(definition)};
}

std::vector<ClaimHead> make_heads() {
  return {
      tendency("family.area-usually", "js-report", "1",
               "J_{1/2} usually nearly preserves the area enclosed by a 2D curve",
               area_error + share_of + "with |E| < 1/20 for *J_{1/2}."),
      tendency(
          "family.area-usually.abstract", "js-report", "abstract",
          "encloses a surface area that is usually very close to the area enclosed by the original control "
          "polygon",
          area_error + share_of + "with |E| < 1/50 for *J_{1/2}."),
      own_share(
          "family.area-usually.against-ends", "js-report 1",
          area_error + share_of + "for which |E| of *J_{1/2} is smaller than those of *J_0 and of *J_1."),
      tendency("area.tendency.rs", "js-report", "8",
               "J_0.836 followed by *J_-0.531 yields a C1 curve, with usually a smaller area error",
               area_error + share_of +
                   "for which |E| of {J_0.836, *J_-0.531} is smaller than those of *J_0.46415 and of "
                   "{J_-0.0299, *J_{3/2}}, the two recommended before."),
      tendency("area.tendency.c2", "jsplines", "8 (js-report 8)",
               "Adjusting s in *J_s will typically produce a C2 curve",
               area_error + share_of +
                   "for which some s in (0, 4), where *J_s is C2, gives E = 0; all real roots of the exact "
                   "rational function E(s)."),
      tendency("popping.fixed", "jsplines", "11", "*J_0.375 works well",
               disparity + pairs + "for which that of *J_{3/8} is smaller than those of *J_0 and of *J_1."),
      tendency("popping.fixed.js-report", "js-report", "abstract",
               "J_{3/8} tends to reduce the error between consecutive refinements",
               "The error is the Hausdorff distance between the polygons of levels k - 1 and k, in floating "
               "point. " +
                   pairs + "for which that of *J_{3/8} is smaller than those of *J_0 and of *J_1."),
      own_share("popping.fixed.maillot-stam", "jsplines 11",
                disparity + pairs +
                    "for which that of *J_{3/8} is smaller than that of *J_{3/10}, the value of Maillot and "
                    "Stam that the document improves upon."),
      tendency("fit.linear.tendency.l1", "js-report", "9",
               "the L1 norm performs better for most applications",
               disparity + pairs +
                   "for which that of *J_.304763 (L1) is smaller than that of *J_.152773 "
                   "(Linf)."),
      ClaimHead{
          "retrofit.realtime", "jsplines", "5",
          "The iterative technique converged in realtime when -0.75<s<1.5", ClaimKind::exact,
          "The iteration converges for all s in (-3/4, 3/2), on bounded infinite data and on all closed "
          "loops of 3 to 12 points."},
      ClaimHead{
          "retrofit.realtime.rate", "subdivlab", "jsplines 5", std::nullopt, ClaimKind::exact,
          "The largest factor by which a step multiplies errors, over s in [-3/4, 3/2] and bounded infinite "
          "data. Alternating data shrink most slowly, and their factor 1 - L(-1) rises with s."},
      ClaimHead{"retrofit.realtime.slower", "jsplines", "5",
                "the convergence speed deteriorates as s approaches 2", ClaimKind::exact,
                "On [3/2, 2) alternating data shrink most slowly, by the factor 1 - L(-1): does it rise "
                "strictly, to 1 at s = 2?"},
      ClaimHead{"retrofit.realtime.iterations", "subdivlab", "jsplines 5", std::nullopt, ClaimKind::exact,
                iteration + "The largest number of steps over " + simple_polygons_text() +
                    " and s = -0.75, -0.70, .., 1.5."},
      ClaimHead{
          "retrofit.realtime.js-report", "js-report", "5",
          "For -0.86<s<2 this iterative technique worked well and converged quickly for all of our test "
          "cases",
          ClaimKind::not_reproducible, "The document does not name its test cases."},
      own_share("retrofit.realtime.quick", "js-report 5",
                iteration + "Share, over " + simple_polygons_text() +
                    " and s = -0.85, -0.80, .., 1.95, of those pairs that need at most 50 steps."),
      tendency(
          "retrofit.local.nearby", "jsplines", "6",
          "the effect of tweaking a control vertex of C is usually most significant in the nearby portion "
          "of *P",
          local_effect + "Share, over s = -0.85, -0.80, .., 1.95 but 0, of those for which it is largest "
                         "on one of the two spans that meet at the vertex."),
      ClaimHead{"retrofit.local.whole", "jsplines", "6", "but may affect the whole curve", ClaimKind::exact,
                local_effect + "s = 3/2: is it different from 0 on every span?"},
      tendency("fit.tendency.l1.js-report", "js-report", "4",
               "the L1 norm will typically perform better in practice than other norms",
               b2_distance + share_of +
                   "for which the mean distance of *J_.689 (L1) from the quadratic B-spline curve is smaller "
                   "than that of *J_.639 (Linf)."),
      tendency("fit.tendency.l1.jsplines", "jsplines", "4",
               "the L1 norm produces what we perceive as a closer match",
               share_of +
                   "for which the Hausdorff distance of *J_.689 (L1) from the quadratic B-spline curve is "
                   "smaller than that of *J_.639 (Linf); polygons of the limit curves at i/64, in floating "
                   "point."),
      own_share("fit.tendency.linf", "jsplines 4",
                b2_distance + share_of +
                    "for which the largest distance of *J_.639 (Linf) from the quadratic B-spline curve is "
                    "smaller than that of *J_.689 (L1)."),
      tendency(
          "popping.fixed.close", "jsplines", "12",
          "This result is useful when it is desired to produce a limit shape that is close to the control "
          "shape (in the Hausdorff distance sense)",
          "The Hausdorff distance between the limit curve, as a polygon through its points at i/64, and its "
          "control polygon, in floating point. " +
              share_of + "for which that of *J_{3/8} is smaller than those of *J_0 and of *J_1."),
      tendency("vertex.tendency.rounded", "jsplines", "12",
               "{J_-33/26, *J_1.5} yields more rounded and hence aesthetically preferable results",
               bending_energy + share_of +
                   "for which {J_-33/26, *J_{3/2}} is better than {J_{-7/4,59/52}, *J_{3/2}}, which "
                   "interpolates the vertices exactly."),
      tendency(
          "edge.tendency.shape", "js-report", "7 (jsplines 7)",
          "interpolating mid-edge points is easier and produces a better shaped curve in general",
          bending_energy + share_of +
              "for which {J_29/59, *J_{3/2}} (mid-edges) is better than {J_-33/26, *J_{3/2}} (vertices)."),
  };
}

void append(Results& results, Results part) {
  std::ranges::move(part.claims, std::back_inserter(results.claims));
  std::ranges::move(part.series, std::back_inserter(results.series));
  std::ranges::move(part.figures, std::back_inserter(results.figures));
}

}  // namespace

std::span<const ClaimHead> polygon_curve_heads() {
  static const std::vector<ClaimHead> heads = make_heads();
  return heads;
}

Results run_polygon_curves() {
  Results results = run_polygon_areas();
  append(results, run_polygon_popping());
  append(results, run_polygon_retrofits());
  append(results, run_polygon_fits());
  return results;
}

}  // namespace subdiv
