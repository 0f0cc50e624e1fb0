#pragma once

#include "analysis/mesh/mode_equation.h"
#include "analysis/real_set.h"

namespace subdiv {

/// The spectrum of adjustable speed subdivision at a vertex of valence n, speed s, q = 1 - s, with the
/// weights (1) of Karciauskas & Peters: statements for all valences and all speeds in (0, 1) at once.
///
/// Beside 1, q^3, q^4, q^5, q^6 the eigenvalues are the roots of
///
///   mode 0:      P(x) = x^2 + B x + C                             (paper (6)),
///   mode k != 0: Q(x) = x^2 - T x + q^4,  T = q (s^2 (1 + c) + 2 q),  c = cos(2 pi k/n)  (paper (7)).
///
/// The roots of Q are real, T^2 - 4 q^4 = q^2 s^2 (1 + c) (s^2 (1 + c) + 4 q); X(c) >= q^2, the larger one,
/// grows with c. lambda is X at k = 1, and X(c) < 1 for c < 1, since Q(1) > 0 and the product q^4 < 1.
///
/// Which of P and X(c) wins. With D = 9 + (n - 4)(1 + q)^2 and E = D (1 - c), identities over Q(q, D, c):
///
///   P - Q = a x - b,   a = s q alpha/D,   alpha = 9 q (1 + q) + s (18 - E),   b = 9 s q^4 (1 + q)/D > 0,
///   a q^2 - b = s^2 q^3 (18 - E)/D,
///   a^2 Q(b/a) = s^4 q^6 G/D^2,   G = (18 - E)^2 - 9 (1 + c)(1 + q) alpha.
///
/// So P(X) > 0 if E < 18 (then a > 0, and a x > b from q^2 on), and also if alpha > 0 and G < 0 (then b/a
/// lies between the roots of Q); P(X) < 0 if alpha < 0, or if alpha > 0, E > 18 and G > 0. Moreover C = q^4 -
/// b has |C| < q^4, and P(-x) = (T - B) x - b + Q(x) > Q(x) for x >= q^2. Then both roots of P lie in |x| < X
/// exactly when P(X) > 0 (Jury's conditions).

/// P and Q as polynomials in x = x_7 with leading coefficient 1, read off the matrix: s = x_0, beta = x_1 and
/// gamma = x_2 free; s = x_0, c = x_5.
struct SpeedQuadratics {
  Polynomial invariant;  ///< P, of mode 0
  Polynomial turning;    ///< Q, of the modes k != 0
};
/// Both, read off the matrix.
[[nodiscard]] SpeedQuadratics speed_quadratics();

/// P and Q with the weights (1), and the others by their definitions above: functions of q = x_0, D = x_1, c
/// = x_2 and x = x_7.
struct SpeedComparison {
  RationalFunction P;           ///< P(x)
  RationalFunction P_mirrored;  ///< P(-x)
  RationalFunction Q;           ///< Q(x)
  RationalFunction a;           ///< P - Q = a x - b
  RationalFunction b;           ///< see a
  RationalFunction alpha;       ///< alpha, whose sign is that of a
  RationalFunction E;           ///< E = D (1 - c)
  RationalFunction G;           ///< G, whose sign is that of Q(b/a)
};
/// All of them as written above.
[[nodiscard]] SpeedComparison speed_comparison();

/// The identities above.
[[nodiscard]] bool identities_hold(const SpeedComparison& comparison);
/// |C| < q^4, that is 0 < b < 2 q^4, on (0, 1) for a D that depends on q alone.
[[nodiscard]] bool product_is_small(const SpeedComparison& comparison, const RationalFunction& denominator);
/// P(-x) - Q(x) = e x - b with e q^2 > b on (0, 1), for a D and a c that depend on q alone.
[[nodiscard]] bool mirrored_is_larger(const SpeedComparison& comparison, const RationalFunction& denominator,
                                      const RationalFunction& turn);

/// All of these for every valence n >= 3 and every speed: C at the smallest D, that of n = 3; P(-x) there,
/// and for n >= 4 at D = 9 and c = -1, because e q^2 - b grows with D and c.
[[nodiscard]] bool mode_0_is_compared();

/// That lambda is sub-dominant, 1 > lambda > |all others| but for its copy in mode n - 1, for every valence n
/// >= 3 and every speed: mode_0_is_compared, and E < 18 for c = cos(2 pi/n). D is at most the larger of 9 and
/// 4 n - 7, and 1 - c < 2 pi^2/n^2, so that E < 8 pi^2/n < 18 from n = 5 on.
[[nodiscard]] bool lambda_is_subdominant();

/// The speeds at which mode 0 stays below the larger root of (7) for k = 2, valence 5 <= n <= 40: an open set
/// whose ends are algebraic numbers. Given that, the latter, mu, is the largest modulus after 1 and lambda.
[[nodiscard]] RealSet speeds_with_mode_2_next(int valence);
/// Whether that is so at every speed for all valences from `first` >= 5 on (proved from 6 on): E < 18 for c =
/// cos(4 pi/n) from n = 18 on, as E < 32 pi^2/n; the others one by one.
[[nodiscard]] bool mode_2_is_next_from(int first);

/// mu > lambda^2 for every valence n != 4 with mu = X(cos(4 pi/n)), and mu = lambda^2 for n = 4: in the
/// variables s, v with lambda = q W, W = q + s v, 1 + cos(2 pi/n) = v^2/W (v > 0; 1 + c >= 1/2 makes v >=
/// 1/2),
///
///   Q_2(lambda^2) = -s^2 q^3 (v - 1)^2 (1 + q^2) (s (v - 1)^2 + v^2 + 2 v - 1).
[[nodiscard]] bool mode_2_exceeds_square();

/// At valence 3, where mode 2 repeats mode 1: the speeds at which all moduli after 1 and lambda are below
/// lambda^2. An open set whose ends are algebraic numbers.
[[nodiscard]] RealSet speeds_with_next_below_square_at_3();

}  // namespace subdiv
