#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/curve_measures.h"
#include "schemes/algebra/rational.h"
#include "schemes/mask.h"

namespace subdiv::explorer {

/// One step J_{a,b}.
struct Step {
  Rational a;
  Rational b;
};

/// A curve to draw: the last step repeats. An open one ends as `subdivlab refine --open reflected` ends it:
/// P_{-k} = 2 P_0 - P_k.
struct Request {
  std::vector<Step> steps;
  int levels = 0;
  bool closed = true;
  bool retrofit = false;  // the limit passes through the points: `refine --retrofit direct`
  std::vector<std::vector<double>> points{{}, {}};  // all x, all y
};

/// One entry a line: "step 0.836 0.836", "levels 5", "open", "retrofit", "point 1.5 2". Throws
/// std::invalid_argument that says what is wrong, also for more than 2^18 refined points.
[[nodiscard]] Request parse_request(std::string_view text);

/// The schemes of the steps, exact and in double.
[[nodiscard]] Scheme<Rational> exact_scheme(const std::vector<Step>& steps);
[[nodiscard]] Scheme<double> double_scheme(const std::vector<Step>& steps);

/// The refined curve and what is measured of it, in double.
struct Curve {
  Polyline polygon;  // what is refined: the given points, or those that the limit passes from
  Polyline curve;    // points after `levels` steps, without those that only carry the ends of an open curve
  double length = 0;
  std::optional<double> polygon_area;  // of the given points; closed curves have areas
  std::optional<double> area;          // of the refined polygon
  std::optional<double>
      limit_area;  // of the limit curve, by the exact area mask; none where that does not exist
  std::vector<double> curvature;  // at each point, of the circle through it and its neighbours, left positive
  std::vector<double>
      jerk;  // across edge i, from point i; 8^levels times: at unit spacing of the points given
  NormalJerk jerk_of_level;  // of the refined polygon as it is, as `subdivlab measure` prints it
};

/// `with_limit_area` costs an elimination in rationals. Throws std::domain_error where the points cannot be
/// retrofitted.
[[nodiscard]] Curve evaluate(const Request& request, bool with_limit_area);

}  // namespace subdiv::explorer
