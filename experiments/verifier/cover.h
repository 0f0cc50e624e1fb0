#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/verifier/quotient.h"

namespace subdiv::verifier {

/// The values of an indeterminate: an interval with open or closed ends; no upper end: infinity.
struct Range {
  Rational lower;
  std::optional<Rational> upper;
  bool lower_open = false;
  bool upper_open = false;
};
using Ranges = std::map<std::string, Range>;

/// What has to hold at every point: sign: entry 0 > bound; rows: sum of |entries| < bound; peak: some |entry|
/// > bound; nonzero: entry 0 is never 0 (bound 0).
enum class Condition { sign, rows, peak, nonzero };

/// A condition on polynomials over a box, by their Bernstein coefficients: entries first, the bound last. A
/// cell is a box with its own coefficients; halving is de Casteljau's.
struct Cover {
  Condition condition = Condition::sign;
  bool strict = true;
  std::vector<std::string> names;  // of the axes, ascending
  std::vector<int> degrees;        // by axis
};
struct Cell {
  std::vector<std::vector<Rational>> coefficients;  // by polynomial; the last axis runs fastest
  std::vector<std::pair<bool, bool>> open;          // by axis: whether the lower, upper end is left out
};

/// The cover's problem on the whole box, for entries and bound that are Laurent polynomials in the names of
/// `ranges`. Rejected when a name has no range, or negative powers of a name that may be 0.
[[nodiscard]] std::pair<Cover, Cell> pose(Condition condition, bool strict, std::vector<Sparse> polynomials,
                                          const Ranges& ranges);
/// The two halves of a cell across an axis.
[[nodiscard]] std::pair<Cell, Cell> halves(const Cover& cover, const Cell& cell, std::size_t axis);
/// Whether the coefficients alone prove the condition on the cell. The token is "." or, for a peak, the sign
/// and number of an entry, "+3". Coefficients may be 0 where no point of the cell depends on them alone.
[[nodiscard]] bool holds(const Cover& cover, const Cell& cell, const std::string& token);
/// Checks the tokens of a cover, cells in the order of a walk; Rejected when a cell does not hold.
void check_cover(const Cover& cover, const Cell& cell, std::string_view tokens);

}  // namespace subdiv::verifier
