#pragma once

#include <vector>

#include "schemes/adjustable_speed/sector_stencil.h"
#include "schemes/algebra/rational_function.h"

namespace subdiv {

/// Whether the points of a step around a vertex of valence n are those of a Catmull-Clark step, place by
/// place: `rules` are those of sector_places(4, 3). The three rings are quads of the two rings split at their
/// centres, where new vertices, edge points and face points take turns, and none reads a control point that
/// Catmull-Clark's at its place does not read.
[[nodiscard]] bool mimics_catmull_clark(int valence,
                                        const std::vector<SectorStencil<RationalFunction>>& rules);

}  // namespace subdiv
