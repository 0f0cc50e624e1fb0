#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "analysis/adjustable_speed/sector_form.h"
#include "experiments/experiment.h"
#include "schemes/algebra/rational_function.h"

namespace subdiv {

/// The parts of the experiment on the rules of adjustable speed: heads, and the claims of a table that holds
/// them.

/// The head of an exact claim that the paper prints.
[[nodiscard]] inline ClaimHead speed_head(std::string id, std::string section, std::string text,
                                          std::string definition) {
  return {std::move(id),   "speed",          std::move(section),
          std::move(text), ClaimKind::exact, std::move(definition)};
}

/// (1), the limit point and Catmull-Clark.
[[nodiscard]] std::vector<ClaimHead> speed_limit_heads();
void add_speed_limit(Results& results, std::span<const ClaimHead> heads);

/// Changes of knots: (10), sigma from step to step, sigma towards 1.
[[nodiscard]] std::vector<ClaimHead> speed_change_heads();
void add_speed_changes(Results& results, std::span<const ClaimHead> heads);

/// Variables of the identities: x_0 .. x_4, and the names that texts give them.
namespace speed_variables {
inline const RationalFunction sigma = RationalFunction::variable(0);
inline const RationalFunction beta = RationalFunction::variable(1);
inline const RationalFunction gamma = RationalFunction::variable(2);
inline const RationalFunction valence = RationalFunction::variable(3);
inline const RationalFunction tau = RationalFunction::variable(4);
inline const std::vector<std::string> names{"σ", "β", "γ", "n", "τ"};
}  // namespace speed_variables

/// Paper (1) with n and the speed free.
[[nodiscard]] VertexWeights<RationalFunction> printed_vertex_weights(const RationalFunction& speed);
/// f > 0 for all sigma in (0, 1) and all real n >= 3, f in sigma and n alone: in powers of n - 3 the constant
/// term of the numerator has one strict sign for all these sigma, every other coefficient has it too or is 0,
/// and so it is with the denominator, with the same sign. false: not so, or not seen so.
[[nodiscard]] bool is_positive_at_all_valences(const RationalFunction& f);

/// (4 sum of edges + sum of faces + n^2 v)/(n (n + 5)): Catmull-Clark's limit point.
[[nodiscard]] SectorForm<RationalFunction> catmull_clark_limit();
/// The limit point of adjustable speed by the paper's formulas for beta and gamma with a breve.
[[nodiscard]] SectorForm<RationalFunction> printed_limit(const RationalFunction& speed,
                                                         const VertexWeights<RationalFunction>& weights);

}  // namespace subdiv
