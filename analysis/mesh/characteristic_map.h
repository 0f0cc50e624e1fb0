#pragma once

#include <optional>
#include <string>

#include "analysis/decision.h"
#include "analysis/enclosure.h"
#include "analysis/mesh/characteristic_net.h"
#include "analysis/mesh/spline_pieces.h"
#include "schemes/mesh/mesh_catalogue.h"
#include "schemes/mesh/mesh_scheme.h"

namespace subdiv {

/// The characteristic map of a scheme at a vertex of valence n (Reif: A unified approach to subdivision
/// algorithms near extraordinary vertices, 1995): the limit surface in the plane whose control net is the
/// eigenvector of the largest eigenvalue lambda among those of pairs of Fourier modes k, -k (0 < k < n/2),
/// as the complex numbers w^j v_p, w = e^{2 pi i k/n}. Whether lambda is sub-dominant among all modes is the
/// eigenvalue condition, which is asked elsewhere. Where lambda is sub-dominant, limit surfaces of almost all
/// data have a tangent plane and are C^1 at the vertex when the map is regular and injective.
///
/// The map f lives on n sectors of the plane's lattice without the vertex, and f(x/2) = lambda f(x): the ring
/// between the distances r and 2 r (in rows of faces) says all. It is made of regular pieces, r = reach + 1,
/// on which f is C^1 where the scheme is in regular regions. By rotation and reflection half a sector is
/// enough.
///
/// regular: the Jacobian has one strict sign on the closed ring. Then f is a local homeomorphism.
///
/// injective, by topology: let f be regular and not 0 on the curve c of the ring's inner boundary. 1. f is
/// nowhere 0: the ring's outer boundary is f(c)/lambda, with the same winding number about 0; the difference
/// of the two, 0, counts the zeros in the ring, all with the Jacobian's sign. 2. So f maps the punctured
/// plane X of sectors into C \ {0}, and it does so properly: with 0 < m <= |f| <= M on the ring, its copy 2^j
/// times as large is mapped into m <= lambda^j |f| <= M, so that a compact set of C \ {0} meets the images of
/// finitely many rings, and its preimage is a closed part of finitely many compact ones. 3. A proper local
/// homeomorphism between connected, locally compact Hausdorff spaces is a covering with finitely many sheets;
/// of C \ {0} by an annulus X the number of sheets is |winding number of f(c)|, the index of the image of X's
/// fundamental group. So f is injective exactly when that number is 1 or -1. A map with Jacobians of both
/// signs is not injective: it has both local degrees.
struct CharacteristicMap {
  /// Why there is no such map: "eigenvalue not simple in its mode", "complex eigenvalue", ..; else empty. All
  /// below is then without meaning but for rigour and method.
  std::string missing;
  int mode = 1;                     ///< k, the Fourier mode of lambda
  Interval eigenvalue;              ///< encloses lambda when certified, else the computed value
  double eigenvalue_of_mode_1 = 0;  ///< the largest modulus in mode 1, approximate; lambda's when mode = 1
  Decision regular = Decision::undecided;    ///< whether the Jacobian has one strict sign
  Decision injective = Decision::undecided;  ///< whether no two points have the same image
  /// Of the map once around the vertex, counted on its curve; n divides winding - mode.
  std::optional<int> winding;
  /// The smallest Jacobian found over the largest (the samples', or the Bernstein coefficients'),
  /// approximate; negative when signs differ.
  double jacobian_ratio = 0;
  Rigour rigour = Rigour::approximate;  ///< of regular and injective
  std::string method;                   ///< how they were decided, in a few words

  [[nodiscard]] bool exists() const { return missing.empty(); }
};

/// One scheme over the rings in which the question is asked: exact says which limit surfaces are splines (it
/// is never asked for rules at the extraordinary vertex), enclosed proves.
struct MeshSchemeForms {
  std::optional<MeshScheme<Rational>> exact;  ///< none where parameters are irrational
  MeshScheme<Interval> enclosed;              ///< for proofs
  MeshScheme<double> rounded;                 ///< in double, for what is not proved
};

/// Of a scheme without free parameters.
[[nodiscard]] MeshSchemeForms mesh_scheme_forms(const MeshSchemeDescription& description);

/// Certified in two ways where the scheme has an exact form: where regular limit surfaces are known
/// polynomials (uniform tensor-product B-splines of odd degree, quartic three-direction box splines), by
/// Bernstein coefficients (milliseconds); else, where limits are proved C^1 by contraction, by discs that
/// contain the derivatives (derivative_bound.h; some 10 ms, up to a second where the Jacobian comes close to
/// 0). Sampled where neither decides. That the mode chosen has the largest eigenvalue is computed, not
/// proved. valence >= 3.
[[nodiscard]] CharacteristicMap characteristic_map(const MeshSchemeForms& scheme, int valence);

/// Approximate, for any scheme: exact derivative masks of the regular lattice, applied to the eigenvector's
/// net after `levels` steps; the curve's winding number from its limit points.
[[nodiscard]] CharacteristicMap sampled_characteristic_map(const MeshScheme<double>& scheme, int valence,
                                                           int levels = 3);

/// The net of that eigenvector with the first spoke on the positive real axis, for drawing; nothing when the
/// map does not exist. rings >= 2 reach + 1.
[[nodiscard]] std::optional<CharacteristicNet<double>> characteristic_net(const MeshScheme<double>& scheme,
                                                                          int valence, int rings);

/// The verdicts on a given net, whatever it comes from, that extends at least reach + 1 rings beyond row
/// 2^(levels + 1) r; or certified, for a net that extends reach + 1 rings beyond row 2 r, on which a spline's
/// pieces between the rows r and 2 r are taken as limits. r is even for triangles.
[[nodiscard]] CharacteristicMap sampled_verdict(const MeshScheme<double>& scheme,
                                                const CharacteristicNet<double>& net, int levels);
/// The verdict where limits are splines, from the pieces of the ring at a row of faces.
[[nodiscard]] CharacteristicMap spline_verdict(const CharacteristicNet<Interval>& net,
                                               const LatticeSpline& spline, int row);

}  // namespace subdiv
