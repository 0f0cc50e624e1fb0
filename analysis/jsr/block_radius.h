#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analysis/deadline.h"
#include "analysis/decision.h"
#include "analysis/jsr/matrix_family.h"
#include "analysis/jsr/word.h"
#include "schemes/algebra/algebraic.h"

namespace subdiv {

/// Certified bounds of the joint spectral radius of one family.
struct BlockRadius {
  Interval lower;                          ///< its lower end counts
  Interval upper;                          ///< its upper end counts
  bool closed = false;                     ///< the radius is that of the words; lower and upper are one ball
  std::optional<Algebraic> exact{};        ///< the closed form, when closed
  Decision bounded = Decision::undecided;  ///< all products T_w / radius^|w|
  std::vector<Word> words{};               ///< whose radius is the lower bound
  std::size_t vertices = 0;                ///< of the polytope that gives the upper bound
};

/// Either the best bounds within the time, or only the attempts that can close.
enum class Wanted { bounds, closed_polytope };

/// A family without common invariant subspaces is what this is made for; others may stay open. Stops at the
/// deadline with the bounds reached.
[[nodiscard]] BlockRadius block_radius(const MatrixFamily& family, std::size_t most_vertices,
                                       const Deadline& deadline, Wanted wanted = Wanted::bounds);

}  // namespace subdiv
