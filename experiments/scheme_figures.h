#pragma once

#include <string>

#include "experiments/experiment.h"

namespace subdiv {

/// A figure of a scheme of one's own, with its series.
///
/// Without a range (`over` empty): the basis function and its derivatives as far as the limits are proved to
/// be smooth, three of them at most, at points i / m^level. With one, "w=LO..HI": the Hoelder exponent of the
/// limits against the only free parameter, at equal distances, as enclosures, and the ranges in which C^0,
/// C^1, .. are certified. Throws InputError.
[[nodiscard]] Results scheme_figure(const std::string& name, const std::string& scheme,
                                    const std::string& over);

}  // namespace subdiv
