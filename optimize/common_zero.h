#pragma once

#include <optional>
#include <span>
#include <vector>

#include "optimize/common_form.h"
#include "schemes/algebra/interval.h"

namespace subdiv {

/// Are these values of residuals small enough to look for a common zero nearby?
[[nodiscard]] bool all_vanish(std::span<const double> residuals);

/// A point of the box where all residuals vanish, near a given one, when fewer of them than there are
/// parameters span the others: a curve or surface of zeros passes there, of which one point is proved by
/// fixing parameters and Krawczyk's test in the rest.
[[nodiscard]] std::optional<std::vector<Interval>> zero_on_a_family(const CommonForm& form,
                                                                    const std::vector<Range>& box,
                                                                    const std::vector<double>& near,
                                                                    long precision);

}  // namespace subdiv
