#pragma once

#include <vector>

#include "analysis/continuity_certificate.h"
#include "analysis/deadline.h"
#include "analysis/transition_matrices.h"

namespace subdiv {

/// The cells of a certificate for one parameter x_0 in [lower, upper], lower < upper; sides that are open end
/// where the next cell begins.
[[nodiscard]] std::vector<CertificateCell> certify_line(const NormalForm<RationalFunction>& form,
                                                        int continuity, const Rational& lower,
                                                        const Rational& upper, const Deadline& deadline,
                                                        const CertificateOptions& options);

/// Cells in ascending order, those of the same answer that touch made one.
[[nodiscard]] std::vector<CertificateCell> merged_line(std::vector<CertificateCell> cells);

}  // namespace subdiv
