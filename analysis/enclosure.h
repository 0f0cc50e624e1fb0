#pragma once

#include <string>

#include "schemes/algebra/algebraic.h"
#include "schemes/algebra/interval.h"
#include "schemes/algebra/rational.h"

namespace subdiv {

/// How far an answer can be trusted. exact: the very number, decided in exact arithmetic; certified: proved
/// to lie in the enclosure, in exact or outward-rounded arithmetic; approximate: computed, not proved.
enum class Rigour { exact, certified, approximate };

/// closed: the question is answered; otherwise the budget that ran out, and the enclosure is what was
/// reached.
enum class Status { closed, out_of_time, out_of_depth, out_of_precision, ambiguous };

/// A real number as an answer: lower <= value <= upper. Where rigour is approximate, the ends are the
/// computed value's estimated error bars and prove nothing.
struct Enclosure {
  Rational lower;                       ///< at most the value
  Rational upper;                       ///< at least the value
  Rigour rigour = Rigour::approximate;  ///< how far the ends can be trusted
  Status status = Status::closed;       ///< closed, or what kept the ends apart
  std::string method;                   ///< a few words: "exact rational", "Sturm", "interval Newton"
  std::string exact;  ///< the exact value when it has a closed form: "-33/26", "(1-sqrt(5))/2"; else empty

  [[nodiscard]] Rational width() const { return upper - lower; }
  [[nodiscard]] Rational midpoint() const { return (lower + upper) / Rational(2); }
  [[nodiscard]] bool contains(const Rational& q) const { return lower <= q && q <= upper; }
};

/// A rational number that was computed exactly: both ends are the number.
[[nodiscard]] Enclosure exact(const Rational& q, std::string method = "exact rational");
/// Exact: the closed form is kept as text, the ends enclose it to about 2^-precision.
[[nodiscard]] Enclosure exact(const Algebraic& x, std::string method = "algebraic number");
/// A proved enclosure: the ends of the ball, which must be finite (std::domain_error).
[[nodiscard]] Enclosure certified(const Interval& x, std::string method);
/// A proved enclosure with rational ends.
[[nodiscard]] Enclosure certified(Rational lower, Rational upper, std::string method);
/// A computed value with the number of digits after the point that are believed.
[[nodiscard]] Enclosure approximate(double value, int believed_decimals, std::string method);

/// "exact", "certified" or "approximate", as results/ prints it.
[[nodiscard]] std::string to_string(Rigour rigour);
/// "closed", or the budget that ran out in words.
[[nodiscard]] std::string to_string(Status status);

}  // namespace subdiv
