#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analysis/decision.h"
#include "analysis/jsr/word.h"
#include "analysis/parameter_box.h"
#include "analysis/real_set.h"
#include "schemes/algebra/rational_function.h"
#include "schemes/mask.h"

namespace subdiv {

/// Why a cell of a certificate is decided.
enum class Ground {
  none,      ///< undecided
  polytope,  ///< yes: the matrices map polytopes into themselves and contract
  product,   ///< no: a product has too large a spectral radius
  sum_rule,  ///< no: the sum rule of order continuity + 1 fails
  value,     ///< the smoothness of one scheme (hoelder.h)
};

/// Parameters, one interval for each, for all of which the answer is the same.
struct CertificateCell {
  Decision smooth = Decision::undecided;  ///< whether the scheme is smooth for all parameters of the cell
  std::vector<RealInterval> sides;        ///< an interval for each parameter
  Ground ground = Ground::none;           ///< why it is decided
  std::size_t vertices = 0;               ///< of the largest polytope, up to sign
  std::vector<Word> words;                ///< of the products
  /// One polytope that does not move serves the whole cell: then sequences of steps that take a different
  /// parameter from the cell at every level are as smooth.
  bool sequences = false;
};

/// A value of the only parameter at which the scheme is not smooth, or not known to be, while the shifts of
/// its basis function are linearly dependent: its limits can be smoother there (unstable_shifts.h).
struct DependentValue {
  Algebraic value;                               ///< of the parameter
  Decision limits_smooth = Decision::undecided;  ///< whether limits are smooth there all the same
};

/// What was decided for a box of parameters, cell by cell.
struct ContinuityCertificate {
  int factors = 0;                     ///< smoothing factors for all parameters
  std::vector<CertificateCell> cells;  ///< they cover the box; for one parameter ascending and merged
  /// Where the cells are `no` for their sum rules: all parameters at which these vanish are left out. Empty
  /// for one parameter, where such values have cells of their own.
  std::vector<Polynomial> exceptions;
  Rational undecided{0};  ///< an upper bound of the undecided cells' volume
  /// For one parameter and a binary symbol whose cofactor has at most 4 roots; nothing otherwise.
  std::optional<std::vector<DependentValue>> dependent;

  /// yes or no when all cells say so; undecided when one is or when exceptions are; nothing when they differ.
  [[nodiscard]] std::optional<Decision> status() const;
};

/// Where a certificate gives up; what is left then is undecided.
struct CertificateOptions {
  double seconds = 10;  ///< of wall-clock time
  /// Cells are halved at most so often; nothing: 30 times for one parameter, 10 for two, 6 for more.
  std::optional<int> depth;
  std::size_t vertices = 120;  ///< of one polytope, up to sign
};

/// Throws std::domain_error, with the first value, where a denominator of a mask in one parameter vanishes in
/// the box of this parameter.
void require_no_pole(const Mask<RationalFunction>& mask, const ParameterBox& box);

/// For which parameters in the box a binary or ternary scheme is C^continuity in the sense of its
/// differences, continuity >= 0: those of order `continuity` of m^(k continuity) times the k-th refinement
/// tend to zero. `yes` holds for the limits, too.
///
/// With the symbol m (sigma/m)^n b(z), n the largest number that serves all parameters, and continuity < n
/// this is the question where the joint spectral radius of b is below m^(n-1-continuity). Cells are halved
/// until they are decided (map_cell.h). For one parameter the products that expand give the exact ends of
/// what can be smooth (expanding_line.h), and polytopes prove it right up to these ends where they close
/// (contraction_end.h). With continuity >= n the scheme is not smooth but where further sum rules hold.
///
/// A side of the box may be one value. Throws std::domain_error where a denominator vanishes in the box of
/// one parameter, and when the first sum rule does not hold.
[[nodiscard]] ContinuityCertificate certify_continuity(const Mask<RationalFunction>& mask, int continuity,
                                                       const ParameterBox& box,
                                                       const CertificateOptions& options = {});

}  // namespace subdiv
