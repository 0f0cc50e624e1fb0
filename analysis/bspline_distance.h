#pragma once

#include <utility>
#include <vector>

#include "analysis/basis_piece.h"
#include "analysis/enclosure.h"
#include "analysis/uniform_bspline.h"
#include "schemes/algebra/interval.h"

namespace subdiv {

/// How far the basis function phi_s of the J-spline scheme *J_s is from the centred uniform B-spline B_d,
/// proved for one rational s: enclosures of norms of e = phi_s - B_d over the real line and of the distance
/// of the curves.
///
/// Everything rests on one local bound. On I = [i, i+1] / 2^n, with the level-n coefficients P_k of phi_s,
/// let
///     w_j = 4^n (P_{j-1} - 2 P_j + P_{j+1}),  i-1 <= j <= i+2,     q_j = w_{j-1} - 2 w_j + w_{j+1},  j = i,
///     i+1.
/// Lemma. On I,  min w - kappa Q <= phi_s'' <= max w + kappa Q  with Q = max |q_j|, kappa = (1-s)/(2s) for 0
/// < s <= 1 and kappa = 0 for 1 <= s <= 3. Proof. One step gives w'_{2j+1} = (w_j + w_{j+1})/2, w'_{2j} = w_j
/// - (1-s)/4 q_j, q'_{2j} = (1 - s/2) q_j and q'_{2j+1} =
/// -(1-s)/4 (q_j + q_{j+1}). For 0 < s <= 1 both factors of q are at most 1 - s/2, so that w grows by at most
/// (1-s)/4 Q (1 - s/2)^k at step k: a geometric sum. For 1 <= s <= 3 the coefficients (s-1, 6-2s, s-1)/4 of
/// w'_{2j} are not negative. The windows of four and two close under halving, and w tends to phi'' as *J_s is
/// C^2 for 0 < s < 4.
///
/// Where B_d has no knot inside I, |e - chord of its end values| <= (|I|^2 / 8) max |e''| follows.

/// Limits of a proof by subdivision of the t-axis.
struct DistanceOptions {
  Rational tolerance = Rational::power_of_two(-112);  ///< an uncertainty below which no interval is halved
  long precision = 256;                               ///< bits of interval arithmetic
  int max_pieces = 100000;                            ///< intervals of t before the proof gives up
};

/// The integral of |e|, the largest |e|. For 0 < s <= 3 and degree >= 1, else std::domain_error. The status
/// is out_of_depth when the pieces ran out; the enclosure holds all the same.
[[nodiscard]] Enclosure bspline_distance_l1(const Rational& s, int degree,
                                            const DistanceOptions& options = {});
/// The largest |phi_s(t) - B_degree(t)| over all t for J_s: certified, by halving intervals of t.
[[nodiscard]] Enclosure bspline_distance_linf(const Rational& s, int degree,
                                              const DistanceOptions& options = {});

/// The least K for which the curves that *J_s and B_d make of any control polygon are nowhere farther apart,
/// at equal parameters, than K times its longest edge: K = sup over t of sum over k of |H_k(t)|, H_k(t) = sum
/// over m >= k of e(t+m). Indeed the difference at t is sum of e(t+m) P_{-m} = sum of H_k(t) (P_{-k} -
/// P_{-k+1}), as sum of e(t+m) = 0; collinear edges of one length, directed by the signs of H_k, attain it.
[[nodiscard]] Enclosure bspline_edge_bound(const Rational& s, int degree,
                                           const DistanceOptions& options = {});

/// e on pieces, for proofs of this kind.
class BsplineDifference {
 public:
  /// Throws std::domain_error unless 0 < s <= 3 and degree >= 1.
  BsplineDifference(const Rational& s, int degree, long precision);

  /// The difference on one interval of t.
  struct Piece {
    BasisPiece<Interval> basis;  ///< phi on the interval
    Interval left;               ///< e at the ends
    Interval right;              ///< e at its right end
    Interval curvature;          ///< holds e'' on the piece
  };
  /// The pieces of level 1 of [lower, upper], integers: no knot lies inside them.
  [[nodiscard]] std::vector<Piece> pieces(int lower, int upper) const;
  /// The pieces on the two halves of the interval, left one first.
  [[nodiscard]] std::pair<Piece, Piece> halves(const Piece& piece) const;
  /// The integral of e over the piece.
  [[nodiscard]] Interval integral(const Piece& piece) const;
  /// Its upper end is at least the most that e differs from its chord on the piece.
  [[nodiscard]] static Interval bow(const Piece& piece);
  [[nodiscard]] const UniformBspline& bspline() const { return bspline_; }

 private:
  [[nodiscard]] Piece describe(BasisPiece<Interval> basis) const;

  LocalBasis<Interval> basis_;
  UniformBspline bspline_;
  Interval kappa_;
  long precision_;
};

}  // namespace subdiv
