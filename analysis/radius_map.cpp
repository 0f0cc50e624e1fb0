#include "analysis/radius_map.h"

#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

#include "analysis/cell_refinement.h"
#include "analysis/transition_matrices.h"

namespace subdiv {
Rational RadiusMap::volume(Decision below) const {
  Rational sum(0);
  for (const MapCell& cell : cells) {
    if (cell.below == below) sum += cell.box.volume();
  }
  return sum;
}

RadiusMap radius_map(const std::vector<Matrix<RationalFunction>>& family, const Rational& bound,
                     const ParameterBox& box, const RadiusMapOptions& options) {
  const std::size_t dimension = box.lower.size();
  if (dimension == 0 || dimension > static_cast<std::size_t>(max_free_parameters) ||
      box.upper.size() != dimension) {
    throw std::domain_error("a map needs a box of 1 to " + std::to_string(max_free_parameters) +
                            " parameters");
  }
  const CellDecider decider(divided(family, bound), dimension, options.cell);
  RadiusMap map;
  const std::function<void(const ParameterBox&, int)> visit = [&](const ParameterBox& cell_box, int depth) {
    MapCell cell = decider.decide(cell_box);
    if (cell.below != Decision::undecided || depth == 0) {
      map.cells.push_back(std::move(cell));
    } else {
      for (const ParameterBox& child : halved(cell_box)) visit(child, depth - 1);
    }
  };
  visit(box, options.depth);
  return map;
}

RadiusMap continuity_map(const Mask<RationalFunction>& mask, int continuity, const ParameterBox& box,
                         const RadiusMapOptions& options) {
  const NormalForm<RationalFunction> form = normal_form(mask);
  if (continuity < 0 || continuity > form.factors - 1) {
    throw std::domain_error("the symbol has " + std::to_string(form.factors) +
                            " smoothing factors for all parameters, so C^" + std::to_string(continuity) +
                            " has no map");
  }
  const Rational bound = pow(Rational(form.arity), form.factors - 1 - continuity);
  return radius_map(transition_matrices(form), bound, box, options);
}

}  // namespace subdiv
