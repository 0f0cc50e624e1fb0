#include <array>

#include "experiments/area.h"
#include "experiments/basis_fit.h"
#include "experiments/characteristic_maps.h"
#include "experiments/curve_figures.h"
#include "experiments/exact_smoothness.h"
#include "experiments/experiment.h"
#include "experiments/family.h"
#include "experiments/hoelder_exponents.h"
#include "experiments/interpolation.h"
#include "experiments/lecture_notes.h"
#include "experiments/limit_masks.h"
#include "experiments/mesh_figures.h"
#include "experiments/mesh_smoothness.h"
#include "experiments/named_smoothness.h"
#include "experiments/polygon_curves.h"
#include "experiments/polyloop_curves.h"
#include "experiments/polyloop_smoothing.h"
#include "experiments/popping.h"
#include "experiments/ringing.h"
#include "experiments/smoothness.h"
#include "experiments/smoothness_maps.h"
#include "experiments/speed_characteristic_ring.h"
#include "experiments/speed_figures.h"
#include "experiments/speed_rings.h"
#include "experiments/speed_rules.h"
#include "experiments/speed_spectrum.h"
#include "experiments/surfaces.h"
#include "experiments/tension_ranges.h"
#include "experiments/two_parameter_smoothness.h"

namespace subdiv {

std::span<const Experiment> experiments() {
  static const std::array all{
      Experiment{"family", "The family (js-report 1, 3, 4; jsplines 1, 3, 4)", family_heads, run_family},
      Experiment{"smoothness", "Continuity of J_s (js-report 3, jsplines 3)", smoothness_heads,
                 run_smoothness},
      Experiment{"exact-smoothness", "Exact ranges of continuity (jsplines 3, 11; js-report 3)",
                 exact_smoothness_heads, run_exact_smoothness},
      Experiment{"hoelder-exponents", "Hoelder exponents of J_s (jsplines 3)", hoelder_exponent_heads,
                 run_hoelder_exponents},
      Experiment{"named-smoothness", "Continuity of the named curves (js-report 2 .. 8, jsplines 2 .. 12)",
                 named_smoothness_heads, run_named_smoothness},
      Experiment{"tension-ranges", "Four-point and dual four-point schemes (js-report 2, jsplines 2)",
                 tension_range_heads, run_tension_ranges},
      Experiment{"two-parameter-smoothness", "Continuity of J_{a,b} on exceptional lines (jsplines 6)",
                 two_parameter_smoothness_heads, run_two_parameter_smoothness},
      Experiment{"smoothness-maps", "Maps of continuity of J_{a,b} (jsplines 6)", smoothness_map_heads,
                 run_smoothness_maps},
      Experiment{"basis-fit", "Fits in the basis function (js-report 4, 9; jsplines 4)", basis_fit_heads,
                 run_basis_fit},
      Experiment{"limit-masks", "Limit masks, open ends, retrofitting (js-report 5, 11; jsplines 5, 9)",
                 limit_mask_heads, run_limit_masks},
      Experiment{"interpolation", "Vertex and mid-edge interpolation (js-report 5, 6, 7; jsplines 5, 6, 7)",
                 interpolation_heads, run_interpolation},
      Experiment{"area", "Area preservation (js-report 8, jsplines 8)", area_heads, run_area},
      Experiment{"popping", "Popping reduction (jsplines 11)", popping_heads, run_popping},
      Experiment{"polygon-curves", "Tendencies on a family of polygons (js-report 1 .. 9, jsplines 4 .. 11)",
                 polygon_curve_heads, run_polygon_curves},
      Experiment{"curve-figures", "Figures of curves (js-report, jsplines, notes)", curve_figure_heads,
                 run_curve_figures},
      Experiment{"lecture-notes", "Bezier curves, B-splines, the four-point rule, meshes (notes 1 .. 5)",
                 lecture_note_heads, run_lecture_notes},
      Experiment{"ringing", "Ringing (js-report 12, 14, appendix)", ringing_heads, run_ringing},
      Experiment{"surfaces", "Grid surfaces: ringing and popping (js-report 9, 13, 14; jsplines 10, 11)",
                 surface_heads, run_surfaces},
      Experiment{"mesh-smoothness", "Eigenvalues at extraordinary vertices (jsplines 10; notes 4, 5)",
                 mesh_smoothness_heads, run_mesh_smoothness},
      Experiment{"characteristic-maps", "Characteristic maps of mesh schemes (jsplines 10, notes 4, 5)",
                 characteristic_map_heads, run_characteristic_maps},
      Experiment{"mesh-figures", "Figures of meshes, weights of Loop and butterfly (jsplines 10; notes 4, 5)",
                 mesh_figure_heads, run_mesh_figures},
      Experiment{"polyloop-local", "Local estimates on polyloops (polyloops 1)", polyloop_local_heads,
                 run_polyloop_local},
      Experiment{"polyloop-smoothing", "Smoothing of polyloops (polyloops 2)", polyloop_smoothing_heads,
                 run_polyloop_smoothing},
      Experiment{"polyloop-operators", "Operators that make schemes (polyloops 2, 3.1)",
                 polyloop_operator_heads, run_polyloop_operators},
      Experiment{"polyloop-filters", "Figures of smoothing operators (polyloops 2)", polyloop_filter_heads,
                 run_polyloop_filters},
      Experiment{"polyloop-curves", "Curves of polyloops compared (polyloops 3)", polyloop_curve_heads,
                 run_polyloop_curves},
      Experiment{"polyloop-construction", "Curves of polyloops built step by step (polyloops 3.1)",
                 polyloop_construction_heads, run_polyloop_construction},
      Experiment{"polyloop-figures", "Figures of polyloops (polyloops 3)", polyloop_figure_heads,
                 run_polyloop_figures},
      Experiment{"speed-rules", "Rules and conversions of adjustable speed (speed II, III, IV, V)",
                 speed_rule_heads, run_speed_rules},
      Experiment{"speed-figures", "Figures that explain adjustable speed (speed, figures 2 .. 5, 10)",
                 speed_figure_heads, run_speed_figures},
      Experiment{"speed-spectrum", "Eigenvalues of adjustable speed (speed III)", speed_spectrum_heads,
                 run_speed_spectrum},
      Experiment{"speed-characteristic-ring", "The characteristic ring of adjustable speed (speed III, V)",
                 speed_characteristic_ring_heads, run_speed_characteristic_ring},
      Experiment{"speed-rings", "Surface rings of adjustable speed (speed II, IV)", speed_ring_heads,
                 run_speed_rings},
  };
  return all;
}

}  // namespace subdiv
