#pragma once

#include <string>
#include <vector>

#include "analysis/mesh/fan_matrix.h"
#include "analysis/mesh/plane_number.h"

namespace subdiv {

/// Control points w^j v_p at place p of sector j, w = e^{2 pi i mode/n}, that the reflection about the first
/// spoke maps to their conjugates, are given by real numbers r, one a place (a, b):
///
///   v(a, 0) = r(a, 0),   v(a, a) = r(a, a) e^{i pi mode/n},
///   v(a, b) = r(a, b) + i r(b, a) and v(b, a) = w conj v(a, b) for a > b > 0.
///
/// For a simple real eigenvalue of a mode, 0 < mode, the eigenvector has this form up to a factor, because
/// schemes have no preferred orientation.
template <class R>
std::vector<PlaneNumber<R>> mode_values(int sides, int valence, int mode, int rings, const Vector<R>& r) {
  const std::vector<FanPlace> places = sector_places(sides, rings);
  const auto index = [&](int a, int b) {
    std::size_t p = 0;
    while (places[p].a != a || places[p].b != b) ++p;
    return p;
  };
  const PlaneNumber<R> w = turn<R>(mode, valence);
  const PlaneNumber<R> half = turn<R>(mode, 2 * valence);
  std::vector<PlaneNumber<R>> result(places.size());
  for (std::size_t p = 0; p < places.size(); ++p) {
    const auto& [sector, a, b] = places[p];
    const R& own = r(static_cast<Eigen::Index>(p));
    if (b == 0) {
      result[p] = {own, R(0)};
    } else if (a == b) {
      result[p] = own * half;
    } else if (a > b) {
      const std::size_t mirrored = index(b, a);
      result[p] = {own, r(static_cast<Eigen::Index>(mirrored))};
      result[mirrored] = w * conjugate(result[p]);
    }
  }
  return result;
}

/// The subdivision matrix on these real numbers: the block of the mode, a real matrix with one row a place.
/// Its eigenvalues are those of the complex block sum over j of blocks[j] w^j.
template <class R>
Matrix<R> mode_matrix(const FanMatrix<R>& fan, int mode) {
  const std::vector<FanPlace> places = sector_places(fan.sides, fan.rings);
  const Eigen::Index n = fan.places();
  std::vector<PlaneNumber<R>> block(static_cast<std::size_t>(n * n));
  for (int k = 0; k < fan.valence; ++k) {
    const PlaneNumber<R> w = turn<R>(mode * k % fan.valence, fan.valence);
    const Matrix<R>& part = fan.blocks[static_cast<std::size_t>(k)];
    for (Eigen::Index p = 0; p < n; ++p) {
      for (Eigen::Index q = 0; q < n; ++q) {
        if (is_zero(part(p, q))) continue;
        PlaneNumber<R>& entry = block[static_cast<std::size_t>(p * n + q)];
        entry = entry + part(p, q) * w;
      }
    }
  }
  std::vector<Eigen::Index> mirrored(static_cast<std::size_t>(n), -1);  // of a > b > 0: the place (b, a)
  for (std::size_t p = 0; p < places.size(); ++p) {
    for (std::size_t q = 0; q < places.size(); ++q) {
      if (places[p].a > places[p].b && places[q].a == places[p].b && places[q].b == places[p].a)
        mirrored[p] = static_cast<Eigen::Index>(q);
    }
  }
  const PlaneNumber<R> w = turn<R>(mode, fan.valence);
  const PlaneNumber<R> half = turn<R>(mode, 2 * fan.valence);
  const PlaneNumber<R> i{R(0), R(1)};
  Matrix<R> result = zero_matrix<R>(n, n);
  for (Eigen::Index p = 0; p < n; ++p) {
    const FanPlace& row = places[static_cast<std::size_t>(p)];
    if (row.b > row.a) continue;
    const auto entry = [&](Eigen::Index q) -> const PlaneNumber<R>& {
      return block[static_cast<std::size_t>(p * n + q)];
    };
    const auto set = [&](Eigen::Index q, const PlaneNumber<R>& value) {
      if (row.b == 0) {
        result(p, q) = value.x;
      } else if (row.a == row.b) {
        result(p, q) = (conjugate(half) * value).x;
      } else {
        result(p, q) = value.x;
        result(mirrored[static_cast<std::size_t>(p)], q) = value.y;
      }
    };
    for (Eigen::Index q = 0; q < n; ++q) {
      const FanPlace& column = places[static_cast<std::size_t>(q)];
      if (column.b == 0) {
        set(q, entry(q));
      } else if (column.a == column.b) {
        set(q, entry(q) * half);
      } else if (column.a > column.b) {
        const Eigen::Index other = mirrored[static_cast<std::size_t>(q)];
        set(q, entry(q) + entry(other) * w);
        set(other, i * (entry(q) - entry(other) * w));
      }
    }
  }
  return result;
}

/// An eigenvalue of a real matrix and its eigenvector, or why there is none of the kind wanted.
template <class R>
struct RealEigenpair {
  std::string missing;  ///< why there is none; empty when there is
  R value = R(0);       ///< the eigenvalue
  Vector<R> vector;     ///< the component of largest modulus is 1
};

/// The eigenvalue of largest modulus; missing when it is complex, or not simple up to rounding (eigenvalues
/// of a double one are known to half the digits).
[[nodiscard]] RealEigenpair<double> dominant_eigenpair(const Matrix<double>& matrix);

/// The eigenpair near a computed one, proved to exist and to be simple by Krawczyk's test: the equations
/// A v = lambda v, v_j = 1 have one solution in a box, with a regular Jacobian matrix in all of it, and
/// [A - lambda, -v; e_j, 0] is regular exactly for algebraically simple eigenvalues (Krawczyk 1969; Rump,
/// Guaranteed inclusions for the complex generalized eigenproblem, 1989).
[[nodiscard]] RealEigenpair<Interval> enclosed_eigenpair(const Matrix<Interval>& matrix,
                                                         const RealEigenpair<double>& computed);

}  // namespace subdiv
