#pragma once

#include <span>
#include <string>

#include "experiments/experiment.h"

namespace subdiv {

/// Throws InputError that names the Debian package when there is no gnuplot in PATH.
void require_gnuplot();

/// The figure as SVG text: in the style of figure_style.h, with title and
/// description for screen readers, no date, the same bytes on every run. Throws InputError
/// without gnuplot, std::runtime_error with gnuplot's own message when it rejects the script.
[[nodiscard]] std::string draw_svg(const Figure& figure, std::span<const Series> series);

}  // namespace subdiv
