#pragma once

#include <vector>

#include "analysis/deadline.h"
#include "analysis/map_cell.h"

namespace subdiv {

/// Decides the box, and halves undecided cells in all directions, the largest first, at most `depth` times
/// and until the deadline has passed. The cells cover the box.
[[nodiscard]] std::vector<MapCell> refine_cells(const CellDecider& decider, const ParameterBox& box,
                                                int depth, const Deadline& deadline);

/// The cell halved in all directions.
[[nodiscard]] std::vector<ParameterBox> halved(const ParameterBox& box);

}  // namespace subdiv
