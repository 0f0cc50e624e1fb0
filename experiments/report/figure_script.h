#pragma once

#include <span>
#include <string>

#include "experiments/experiment.h"

namespace subdiv {

/// The gnuplot commands that draw a figure in the project's style (figure_style.h), its data included. A row
/// in which a cell that is drawn is empty breaks the curve. Throws std::logic_error for a series, column or
/// cell that is missing or no decimal number.
[[nodiscard]] std::string figure_script(const Figure& figure, std::span<const Series> series);

/// What a figure shows in words, for readers who do not see it: its axes, its curves, its names.
[[nodiscard]] std::string figure_description(const Figure& figure);

}  // namespace subdiv
