#include "analysis/cell_refinement.h"

#include <cstddef>
#include <utility>

namespace subdiv {

std::vector<MapCell> refine_cells(const CellDecider& decider, const ParameterBox& box, int depth,
                                  const Deadline& deadline) {
  std::vector<MapCell> result;
  std::vector<ParameterBox> pending{box};
  for (int level = 0; !pending.empty(); ++level) {
    std::vector<ParameterBox> next;
    for (ParameterBox& cell_box : pending) {
      MapCell cell{std::move(cell_box), Decision::undecided, 0, {}};
      if (!deadline.passed()) cell = decider.decide(cell.box);
      if (cell.below != Decision::undecided || level >= depth || deadline.passed()) {
        result.push_back(std::move(cell));
      } else {
        for (ParameterBox& child : halved(cell.box)) next.push_back(std::move(child));
      }
    }
    pending = std::move(next);
  }
  return result;
}

std::vector<ParameterBox> halved(const ParameterBox& box) {
  std::vector<ParameterBox> result;
  for (std::size_t c = 0; c < std::size_t{1} << box.lower.size(); ++c) {
    ParameterBox child = box;
    for (std::size_t k = 0; k < box.lower.size(); ++k) {
      const Rational middle = (box.lower[k] + box.upper[k]) / Rational(2);
      ((c >> k & 1) != 0 ? child.lower : child.upper)[k] = middle;
    }
    result.push_back(std::move(child));
  }
  return result;
}

}  // namespace subdiv
