#pragma once

#include <span>
#include <string>

#include "experiments/experiment.h"

namespace subdiv {

/// Throws InputError that names the Debian package when there is no gnuplot in PATH.
void require_gnuplot();

/// The gnuplot commands that draw a figure, its data included. A row in which a cell that is drawn is empty
/// breaks the curve. Throws std::logic_error for a series, column or cell that is missing or no decimal
/// number.
[[nodiscard]] std::string figure_script(const Figure& figure, std::span<const Series> series);

/// The figure as SVG text: fixed size and font, no date, the same bytes on every run. Throws InputError
/// without gnuplot, std::runtime_error with gnuplot's own message when it rejects the script.
[[nodiscard]] std::string draw_svg(const Figure& figure, std::span<const Series> series);

}  // namespace subdiv
