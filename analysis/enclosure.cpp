#include "analysis/enclosure.h"

#include <utility>

namespace subdiv {

Enclosure exact(const Rational& q, std::string method) {
  return {q, q, Rigour::exact, Status::closed, std::move(method), q.to_string()};
}

Enclosure exact(const Algebraic& x, std::string method) {
  if (x.is_rational()) return exact(x.to_rational(), std::move(method));
  const Interval ball = x.to_interval();
  return {ball.lower(), ball.upper(), Rigour::exact, Status::closed, std::move(method), x.to_string()};
}

Enclosure certified(const Interval& x, std::string method) {
  return certified(x.lower(), x.upper(), std::move(method));
}

Enclosure certified(Rational lower, Rational upper, std::string method) {
  return {std::move(lower), std::move(upper), Rigour::certified, Status::closed, std::move(method), ""};
}

Enclosure approximate(double value, int believed_decimals, std::string method) {
  const Rational centre = Rational::from_double(value);
  const Rational margin = pow(Rational(10), -believed_decimals) / Rational(2);
  return {centre - margin, centre + margin, Rigour::approximate, Status::closed, std::move(method), ""};
}

std::string to_string(Rigour rigour) {
  switch (rigour) {
    case Rigour::exact:
      return "exact";
    case Rigour::certified:
      return "certified";
    case Rigour::approximate:
      break;
  }
  return "approximate";
}

std::string to_string(Status status) {
  switch (status) {
    case Status::closed:
      return "closed";
    case Status::out_of_time:
      return "out of time";
    case Status::out_of_depth:
      return "out of depth";
    case Status::out_of_precision:
      return "out of precision";
    case Status::ambiguous:
      break;
  }
  return "ambiguous";
}

}  // namespace subdiv
