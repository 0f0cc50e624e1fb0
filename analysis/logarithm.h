#pragma once

#include <optional>

#include "analysis/enclosure.h"
#include "schemes/algebra/algebraic.h"

namespace subdiv {

/// offset - log_base(x) / divisor for x > 0 in an enclosure, base and divisor at least 1 and 2. With the
/// closed form of x the result has one too: a rational number when a power of x is a power of the base, else
/// a text such as "3-log2(73/100)", with ends that enclose it.
[[nodiscard]] Enclosure minus_logarithm(const Rational& offset, int base, int divisor, const Enclosure& x,
                                        const std::optional<Algebraic>& closed_form);

}  // namespace subdiv
