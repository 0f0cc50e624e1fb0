#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/enclosure.h"
#include "analysis/parameter_box.h"
#include "schemes/algebra/rational_function.h"

namespace subdiv {

/// The open set of the points (x_0, x_1) inside a box where some polynomials are positive.
struct PlaneDomain {
  ParameterBox box;                  ///< in which the domain lies
  std::vector<Polynomial> positive;  ///< polynomials that are positive throughout

  /// Whether the point is inside the box and all polynomials are positive there.
  [[nodiscard]] bool contains(const Rational& x0, const Rational& x1) const;
};

/// What is known of a function's sign on such a domain.
struct DomainSign {
  /// The cases.
  enum class Kind {
    positive,  ///< at every point of the domain, and finite
    negative,
    not_strict,  ///< 0, or no value, at some point of the domain, or both signs
    undecided
  };
  Kind kind = Kind::undecided;     ///< which of them
  Status status = Status::closed;  ///< else why it is undecided
  long cells = 0;                  ///< all that were looked at
  /// not_strict: a point where the function is 0 or has no value, or two with opposite signs.
  std::vector<std::vector<Rational>> witnesses;
};
/// "positive", "negative", "not strict" or "undecided".
[[nodiscard]] std::string to_string(DomainSign::Kind kind);

/// Signs of functions of x_0, x_1 on a domain, proved in exact arithmetic: a polynomial is factored over Q;
/// factors that the domain itself knows (the box's sides, the polynomials that are positive) have their sign;
/// of all others the Bernstein coefficients on cells of the box are taken, by halving (Farin: Curves and
/// Surfaces for CAGD, chapters 5, 16; Garloff 1986). Coefficients of one strict sign prove it on the closed
/// cell. A coefficient at a corner of the cell, where it is the value, may be 0 if the corner is not in the
/// domain. Cells without points of the domain are dropped: there a polynomial that should be positive has
/// only coefficients <= 0. Factors are remembered, so that one object should be asked for many functions.
///
/// Zeros at corners prove no wrong sign, because factors are irreducible over Q. A cell all of whose
/// coefficients have one strict sign, but for zeros at corners outside the domain, holds no zero but those
/// corners, unless the two ends of an edge are all the coefficients that the edge has and both 0: then the
/// factor vanishes on the edge's whole line, x_k = r with a rational r. So it does where one coefficient
/// stands for two corners, as the factor uses one variable alone. But an irreducible polynomial that vanishes
/// there is a multiple of x_k - r and changes sign across the line: if a point of the domain, which is open,
/// lay on it, so would points of both signs lie beside it, in cells that are not dropped, and the cell with
/// the wrong sign would not pass. Of reducible polynomials, as (x_0 - r)^2, this would be false.
class DomainSigns {
 public:
  /// A box with lower < upper, of dimension 2, and a non-empty domain (std::invalid_argument for another
  /// dimension). Each factor may use `cells` cells, and halve the box `depth` times in each direction.
  explicit DomainSigns(PlaneDomain domain, long cells = 4000, int depth = 30);

  /// f != 0 in x_0, x_1 alone (std::invalid_argument).
  [[nodiscard]] DomainSign sign(const Polynomial& f);
  [[nodiscard]] DomainSign sign(const RationalFunction& f);

  [[nodiscard]] const PlaneDomain& domain() const { return domain_; }

 private:
  [[nodiscard]] DomainSign factor_sign(const Polynomial& factor);

  PlaneDomain domain_;
  long cells_;
  int depth_;
  std::vector<Rational> inside_;  // a point of the domain; none when the search for one ended
  std::map<std::string, DomainSign> known_;
};

}  // namespace subdiv
