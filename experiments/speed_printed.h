#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "experiments/experiment.h"
#include "schemes/adjustable_speed/sector_stencil.h"
#include "schemes/algebra/rational_function.h"

namespace subdiv {

/// The weights that the paper on adjustable speed prints, entry by entry, against those of the rules. x_0 is
/// sigma; the texts are expressions in s = sigma, q = 1 - sigma and the paper's abbreviations e1, e2, f1 ..
/// f4, d1, d2.

/// w^source_target: the weight of the point p with the label `source` = ij, 1 <= i, j <= 4 (33 the vertex,
/// the lattice place (3 - i, 3 - j)), in the point `target`.
struct PrintedWeight {
  std::string target;
  int source = 0;
  std::string text;
};

/// Target and source.
using PrintedIndex = std::pair<std::string, int>;

struct PrintedTable {
  std::string equation;  // "11"
  std::string symbol;    // "w"
  std::string section;
  std::string definition;  // of the weights computed
  std::vector<PrintedWeight> weights;
  /// The computed weights of the targets.
  std::map<std::string, SectorStencil<RationalFunction>> rules;
  /// Entries equal to a given one by the symmetries that the paper states.
  std::function<std::vector<PrintedIndex>(const PrintedIndex&)> images;
};

/// (4): targets are the numbers k = 8 .. 11 of refined points.
[[nodiscard]] const PrintedTable& printed_refinement();
/// (11): targets are the numbers k = 1 .. 7 of points of the converted net.
[[nodiscard]] const PrintedTable& printed_conversion();
/// (13), without the factor 1/(1 + q)^2: targets are the indices ij of Bezier coefficients.
[[nodiscard]] const PrintedTable& printed_border();

/// What the table (3), lost in the copy at hand, must have said: targets are the numbers k = 2 .. 7. The
/// texts are this project's; holds and is_complete prove them.
[[nodiscard]] const PrintedTable& recovered_refinement();

/// A text in s, q and the abbreviations.
[[nodiscard]] RationalFunction value_of_text(const std::string& text);
/// The same with the paper's Greek letters.
[[nodiscard]] std::string greek(const std::string& text);

/// The weight of a labelled point.
[[nodiscard]] RationalFunction weight_of(const SectorStencil<RationalFunction>& stencil, int label);
/// Whether the printed weight is the computed one.
[[nodiscard]] bool holds(const PrintedTable& table, const PrintedWeight& printed);
/// Whether the printed weights and their images are all that are not 0, in the given targets.
[[nodiscard]] bool is_complete(const PrintedTable& table);

/// The computed weights of the refined points, by their numbers k = 2 .. 13 (figure 5, right).
[[nodiscard]] const std::map<std::string, SectorStencil<RationalFunction>>& refined_by_number();
/// The number k = 1 .. 13 of a refined point (figure 5, right) as the label ij of the place.
[[nodiscard]] int label_of_number(int k);

/// A claim for each weight, and their verdicts.
[[nodiscard]] std::vector<ClaimHead> printed_weight_heads();
void add_printed_weights(Results& results, std::span<const ClaimHead> heads);

}  // namespace subdiv
