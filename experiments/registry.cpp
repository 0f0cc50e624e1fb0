#include <array>

#include "experiments/area.h"
#include "experiments/basis_fit.h"
#include "experiments/experiment.h"
#include "experiments/family.h"
#include "experiments/interpolation.h"
#include "experiments/limit_masks.h"
#include "experiments/popping.h"
#include "experiments/smoothness.h"

namespace subdiv {

std::span<const Experiment> experiments() {
  static const std::array all{
      Experiment{"family", "The family (js-report 1, 3, 4; jsplines 1, 3, 4)", family_heads, run_family},
      Experiment{"smoothness", "Continuity of J_s (js-report 3, jsplines 3)", smoothness_heads,
                 run_smoothness},
      Experiment{"basis-fit", "Fits in the basis function (js-report 4, 9; jsplines 4)", basis_fit_heads,
                 run_basis_fit},
      Experiment{"limit-masks", "Limit masks, open ends, retrofitting (js-report 5, 11; jsplines 5, 9)",
                 limit_mask_heads, run_limit_masks},
      Experiment{"interpolation", "Vertex and mid-edge interpolation (js-report 5, 6, 7; jsplines 5, 6, 7)",
                 interpolation_heads, run_interpolation},
      Experiment{"area", "Area preservation (js-report 8, jsplines 8)", area_heads, run_area},
      Experiment{"popping", "Popping reduction (jsplines 11)", popping_heads, run_popping},
  };
  return all;
}

}  // namespace subdiv
