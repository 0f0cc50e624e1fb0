#include "experiments/polyloop_curves.h"

#include <algorithm>
#include <iterator>

#include "experiments/polyloop_parts.h"
#include "experiments/simple_polygons.h"

namespace subdiv {
namespace {

const std::string share_of = "Share, over " + simple_polygons_text() + ", of those ";
const std::string by_masks = "By limit masks of *J_s, s = 1 - (old parameter)/8: ";
const std::string five = "Polygons of level 5, exact in doubles. ";
const std::string hausdorff =
    "The Hausdorff distance between L and the curve's polygon of level 5, by bounds in double that are "
    "refined "
    "until they decide by a margin far above rounding; rounding is not enclosed. ";
const std::string jerk =
    "The normal jerk of edge BC is the part of -A + 3B - 3C + D across it; polygons of level 5, which "
    "doubles hold exactly, jerks in intervals. ";
const std::string area_error =
    "E = area of the limit curve / area of the polygon - 1, exact by the area mask. ";

ClaimHead printed(std::string id, std::string section, std::string text, std::string definition,
                  ClaimKind kind = ClaimKind::exact) {
  return {std::move(id), "polyloops", std::move(section), std::move(text), kind, std::move(definition)};
}
ClaimHead tendency(std::string id, std::string section, std::string text, std::string definition) {
  return printed(std::move(id), std::move(section), std::move(text), std::move(definition),
                 ClaimKind::tendency);
}
ClaimHead own_share(std::string id, std::string section, std::string definition) {
  ClaimHead result = finding(std::move(id), std::move(section), std::move(definition));
  result.kind = ClaimKind::tendency;
  return result;
}

std::vector<ClaimHead> make_heads() {
  return {
      printed("polyloops.rd.mid-edges", "3.1",
              "the final curve Jrd interpolates the mid-edge points of L, but not the vertices of L",
              "The quadratic B-spline curve's weights of control points at mid-edges and vertices."),
      tendency("polyloops.j0.far", "3.1", "the final curve J0 is relatively far from sharp vertices of L",
               by_masks + share_of +
                   "on which the largest distance of a vertex from its limit point is greater for J0 than "
                   "for J2, J4, J5, J6 and J8, exact."),
      printed("polyloops.j0.mid-edges", "3.1", "does not interpolate the edge midpoints",
              by_masks + "the limit point of the middle of an edge, for J0."),
      printed("polyloops.j0.inside", "3.1", "It tends to push the vertices inside the turns",
              by_masks + "the limit point of vertex B under J0, between A and C."),
      printed("polyloops.j0.first-push", "3.1",
              "the first iteration of the push/pull pushes its original vertices far inwards the turn",
              "The share of the whole way of a vertex to its limit under J0 that the first step makes: is it "
              "more than half?"),
      printed("polyloops.j2.osculates", "3.1", "J2 osculates the edges at their midpoints",
              by_masks +
                  "does J2 touch the edges there: is the limit point of the middle of an edge that point?"),
      finding("polyloops.j2.osculates.tangent", "polyloops 3.1",
              "The tangent mask of *J_{3/4} at the middle of an edge, of P_{-2} .. P_3, exact."),
      finding("polyloops.j2.osculates.square", "polyloops 3.1",
              "On a square with edges 1: how far J2 passes outside the middle of an edge, in exact "
              "arithmetic."),
      printed("polyloops.j2.different", "3.1", "it is different and smoother than Jrd",
              "Different: are the limit curves on the square the same, by weights at all parameters i/2?"),
      printed("polyloops.j2.smoother", "3.1", "it is different and smoother than Jrd",
              "Smoother: the Hoelder exponent of the limits of *J_{3/4}, against that of the quadratic "
              "B-spline."),
      printed("polyloops.j8.interpolates", "3.1", "it interpolates the vertices of L",
              by_masks + "the limit point of a vertex, for J8."),
      printed("polyloops.j8.smooth", "3.1",
              "the polyloop converges to a smooth curve that interpolates the vertices of L",
              "The continuity of the limits of J8: at least C1, for all polyloops?"),
      printed("polyloops.j8.less-smooth", "3.1", "but appears less smooth",
              "The Hoelder exponents of the limits of J0, J2, J4, J5, J6 and J8: is that of J8 the least?"),
      printed("polyloops.j4.compromise", "3.1", "is a compromise between J0 and J8",
              "Is a step of J4 the average of those of J0 and J8?"),
      tendency("polyloops.j4.area", "3.1", "Usually, L and J4 have nearly equal areas",
               area_error + share_of + "with |E| < 1/20 for J4."),
      own_share("polyloops.j4.area.least", "polyloops 3.1",
                area_error + share_of + "for which |E| of J4 is the least among J0, J2, J4, J5, J6 and J8."),
      printed("polyloops.j5.compromise", "3.1", "J5 offers a different compromise between J0 and J8",
              "Is a step of J5 an average of those of J0 and J8 with positive weights, and another than J4?"),
      tendency("polyloops.j5.hausdorff", "3.1",
               "It is a better approximation of L than J4 when the quality of an approximation is measured "
               "by the Hausdorff distance",
               hausdorff + share_of + "for which J5 is nearer to L than J4."),
      printed("polyloops.j5.square", "3.1",
              "L is a better low-resolution approximation of J5 than it is of other subdivision curves",
              hausdorff + "On the square, the chapter's own polygon: is J5 the nearest of J0, J2, J4, J5, J6 "
                          "and J8?"),
      finding("polyloops.j5.square.best", "polyloops 3.1",
              "The s in (0, 3/4) at which *J_s on a square leaves as much between a corner and its limit "
              "point as between the middle of an edge and the limit point there, as old parameter 8 (1 - "
              "s)."),
      tendency("polyloops.j5.others", "3.1",
               "L is a better low-resolution approximation of J5 than it is of other subdivision curves",
               hausdorff + share_of + "for which J5 is the nearest of J0, J2, J4, J5, J6 and J8."),
      tendency("polyloops.j5.popping", "3.1",
               "yields a less visible popping artifact that the other subdivision schemes discussed so far",
               "The largest distance of a point of level k from its place on the polygon of level k - 1 "
               "under linear refinement. Share, over " +
                   simple_polygons_text() +
                   " and the levels 1 to 4, of those pairs for which that of J5 is the least of J0, J2, J4, "
                   "J5, J6 and J8."),
      tendency("polyloops.jerk.j0", "3.2", "the jerk of J0 (green) is barely visible",
               jerk + share_of +
                   "on which the largest normal jerk of J0 is below a twentieth of that of J8, in one "
                   "scale."),
      tendency("polyloops.jerk.j8", "3.2", "the jerk of J8 (red) is significant and irregularly distributed",
               jerk + share_of +
                   "on which the largest normal jerk of J8 is above twice its mean, and this ratio above "
                   "those of J0, J2, J4, J5 and J6."),
      own_share("polyloops.jerk.rising", "polyloops 3.2",
                jerk + share_of + "on which the largest normal jerk rises along J0, J2, J4, J5, J6, J8."),
      tendency("polyloops.jm.jerk", "3.2",
               "The intermediate curve Jm (shown in brown above between J0 and J8 has no noticeable jerk",
               jerk + share_of +
                   "on which the largest normal jerk of Jm, J(2) first and J(-2) last, is below a tenth of "
                   "that of J8."),
      own_share("polyloops.jm.jerk.least", "polyloops 3.2",
                jerk + share_of + "on which the largest normal jerk of Jm is below that of J0."),
      own_share("polyloops.jm.jerk.reversed", "polyloops 3.2",
                jerk + share_of +
                    "on which the largest normal jerk of the steps in reversed order, J(-2) J(-2) J(-2) J(0) "
                    "J(2), is below those of J0 and of Jm."),
      tendency("polyloops.jm.between", "3.2",
               "The intermediate curve Jm (shown in brown above between J0 and J8",
               share_of + "on which the area of Jm lies between those of J0 and J8, exact by area masks."),
      tendency("polyloops.jm.pleasant", "3.2",
               "produces more pleasant shapes than the other subdivision schemes",
               five +
                   "A curve is better shaped when its bending energy times its length, the integral of the "
                   "squared curvature (by circles) times the length, is smaller. " +
                   share_of + "for which that of Jm is the least, J0, J2, J4, J5, J6 and J8 the others."),
  };
}

const std::vector<ClaimHead>& table() {
  static const std::vector<ClaimHead> heads = make_heads();
  return heads;
}

void append(Results& results, Results part) {
  std::ranges::move(part.claims, std::back_inserter(results.claims));
  std::ranges::move(part.series, std::back_inserter(results.series));
}

}  // namespace

const std::vector<std::string>& stationary_polyloop_curves() {
  static const std::vector<std::string> names{"J0", "J2", "J4", "J5", "J6", "J8"};
  return names;
}

std::span<const ClaimHead> polyloop_curve_heads() { return table(); }

Results run_polyloop_curves() {
  Results results = run_polyloop_limits();
  append(results, run_polyloop_distances());
  append(results, run_polyloop_jerks());
  return results;
}

}  // namespace subdiv
