#pragma once

#include <optional>
#include <vector>

#include "analysis/jsr/ball_matrix.h"
#include "analysis/jsr/hull_gauge.h"
#include "analysis/jsr/number_field.h"
#include "schemes/algebra/matrix.h"

namespace subdiv {

/// A vertex or its conjugate, as a column of a basis.
struct HullColumn {
  int vertex;      ///< its number
  bool conjugate;  ///< whether the conjugate of the vertex is meant

  friend bool operator==(const HullColumn&, const HullColumn&) = default;
};

/// n vertices (or conjugates, in a complex hull) that are proved linearly independent: all vectors within
/// their balls are. Nothing when there are none that can be proved so.
[[nodiscard]] std::optional<std::vector<HullColumn>> spanning_columns(const std::vector<BallMatrix>& vertices,
                                                                      bool complex_hull, long precision);

/// Columns for a basis near an optimal combination: the largest terms of the combination as far as they are
/// safely independent, filled up from the spanning ones.
[[nodiscard]] std::vector<HullColumn> basis_near(const HullCombination& combination,
                                                 const std::vector<BallMatrix>& vertices,
                                                 const std::vector<HullColumn>& spanning);

/// A ball whose upper end bounds the gauge of every x in its ball in the balanced hull of any vertices in
/// theirs: x is written by the combination, with its coefficients on the basis solved for anew, and the rest
/// by the spanning columns, all in ball arithmetic. Not finite when these are not known to span.
[[nodiscard]] Interval gauge_bound(const BallMatrix& x, const std::vector<BallMatrix>& vertices,
                                   const HullCombination& combination, const std::vector<HullColumn>& basis,
                                   const std::vector<HullColumn>& spanning, long precision);

/// Whether x = sum c_j v_j over the basis with sum |c_j| <= 1, exactly. False when the basis is dependent.
[[nodiscard]] bool is_exactly_inside(const Vector<FieldElement>& x,
                                     const std::vector<Vector<FieldElement>>& basis);

}  // namespace subdiv
