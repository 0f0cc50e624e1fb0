#pragma once

#include <cstddef>

#include "schemes/evaluate/patch_table.h"

namespace subdiv::detail {

/// Lines first .. last - 1 of a patch's points: for each point x, y, z, with the control points likewise in
/// `controls`, 3 numbers each. Writes patch_line points a line. Every sum runs over k in its order, and
/// products and sums are rounded one by one, so that all instruction sets give the same bits.
void apply_patch_table(const PatchTable& table, const double* controls, std::size_t first, std::size_t last,
                       double* out);

}  // namespace subdiv::detail
