#include "experiments/polyloop_shapes.h"

#include <algorithm>
#include <stdexcept>

#include "experiments/data.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

constexpr int eighths = 8;

/// One step of J(old): J_{1 - old/8}.
Mask<Rational> step(int old) { return jspline(Rational(eighths - old, eighths)); }

std::vector<PolyloopCurve> make_curves() {
  std::vector<PolyloopCurve> curves;
  for (const int old : {0, 2, 4, 5, 6, 8}) {
    const std::string name = "J" + std::to_string(old);
    curves.push_back({name, stationary(name, step(old))});
  }
  Scheme<Rational> mixed_scheme{"Jm", {}};
  for (const int old : {2, 0, -2, -2, -2}) mixed_scheme.steps.push_back(step(old));
  curves.push_back({"Jm", std::move(mixed_scheme)});
  return curves;
}

template <class Named>
const Named& named(const std::vector<Named>& all, const std::string& name) {
  const auto found = std::ranges::find(all, name, &Named::name);
  if (found == all.end()) throw std::logic_error("polyloops 3 has no " + name);
  return *found;
}

}  // namespace

const std::vector<PolyloopCurve>& polyloop_curves() {
  static const std::vector<PolyloopCurve> curves = make_curves();
  return curves;
}

const Scheme<Rational>& polyloop_curve(const std::string& name) {
  return named(polyloop_curves(), name).scheme;
}

const std::vector<StoredPolyloop>& stored_polyloops() {
  static const std::vector<StoredPolyloop> stored{
      {"square", polygon_from_data("figure-square.csv")},
      {"star", polygon_from_data("polyloop-star.csv")},
      {"non-convex", polygon_from_data("polyloop-non-convex.csv")},
      {"crossing", polygon_from_data("polyloop-crossing.csv")}};
  return stored;
}

const PlanePolygon& stored_polyloop(const std::string& name) {
  return named(stored_polyloops(), name).polygon;
}

Polyline refined(const Scheme<Rational>& scheme, const PlanePolygon& polygon, int level) {
  return refine(map_coefficients(scheme, [](const Rational& x) { return x.to_double(); }), in_double(polygon),
                level);
}

}  // namespace subdiv
