#pragma once

#include <vector>

#include "analysis/enclosure.h"
#include "schemes/algebra/rational_function.h"
#include "schemes/mask.h"

namespace subdiv {

/// What switching a level of detail moves: with P(z) the symbol of the levels before and S(z) the next step,
/// the coefficients of (L(z) - S(z)) P(z^2) are the differences between the refined impulse and its linear
/// refinement, L(z) = (1+z)^2 / (2z) (jsplines 11).
[[nodiscard]] Laurent<RationalFunction> popping_difference(const Mask<RationalFunction>& step,
                                                           const Laurent<RationalFunction>& before);

/// A level k >= 1 of the greedy schedule of J_s: s_k minimises over all real s the largest coefficient of
/// popping_difference, P_k = S_{s_k}(z) P_{k-1}(z^2), P_0 = 1; disparity is that minimum.
struct PoppingLevel {
  Enclosure parameter;  ///< s_k
  Enclosure disparity;  ///< the least largest coefficient
};

/// Levels 1 .. `levels`. Exact rationals as long as they are short (their digits double at each level),
/// certified enclosures then.
///
/// Let v_i be minus the second differences of P_{k-1}'s coefficients, q the second differences of v, M = max
/// |v_i|, A = max |v_i + v_{i+1}|. Coefficient 2i of the difference is s/8 v_i up to its sign, coefficient
/// 2i+1 is (1-s)/16 (v_i + v_{i+1}). So the objective is max(|s| M/8, |1-s| A/16): for s in [0, 1] one term
/// rises, the other falls, outside one alone is larger than both at the end. The unique minimiser is s =
/// A/(2M+A), the minimum M A / (8 (2M+A)).
///
/// Lemma. M = |v_0| and A = |v_0 + v_1| at every level, for any steps with s in [0, 1]. Proof. Multiply v by
/// 4 at each level, so that
///     v'_{2j} = v_j - (1-s)/4 q_j,  v'_{2j+1} = (v_j + v_{j+1})/2,  q'_{2j} = (1 - s/2) q_j,  q'_{2j+1} =
///     -(1-s)/4 (q_j + q_{j+1}),
/// from v = (-1, 2, -1), q = (-1, 4, -6, 4, -1). Then |q_j| <= |q_0|, q_0 < 0, persists: (1-s)/2 <= 1 - s/2.
/// Hence |v_j| <= v_0 persists: |v'_{2j}| <= v_0 + (1-s)/4 |q_0| = v'_0. Hence |v_j + v_{j+1}| <= v_0 + v_1
/// persists, as v'_0 + v'_1 = v_0 + (1-s)/4 |q_0| + (v_0 + v_1)/2.
///
/// With x = 1 - v_1/v_0 this is the recursion x_0 = 3/2, s_k = (2 - x_{k-1})/(4 - x_{k-1}), x_k = x_{k-1} (6
/// - x_{k-1})/8, a logistic map; and the unscaled v_0 obeys M_0 = 2, M_k = M_{k-1}/(4 - x_{k-1}), disparity
/// s_k M_{k-1}/8.
[[nodiscard]] std::vector<PoppingLevel> popping_schedule(int levels);

/// The limit of s_k, proved: on (0, 3/2] the recursion multiplies x by (6-x)/8, positive and at most 3/4, so
/// x decreases to its only fixed point 0 and s_k increases to (2-0)/(4-0); 1/2 - s_k = x/(2(4-x)) <=
/// (3/10)(3/4)^(k-1).
[[nodiscard]] Enclosure popping_limit();

}  // namespace subdiv
