#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "experiments/drawing.h"
#include "experiments/polyloop_curves.h"
#include "experiments/polyloop_shapes.h"
#include "schemes/algebra/matrix.h"
#include "schemes/polyloop/apply_operator.h"

namespace subdiv {
namespace {

const std::string on_square =
    "On the square figure-square.csv, operators in the order of the letters, r: refine, d: dual, t: "
    "tuck(1/2), "
    "u: tuck(-1). The area over that of the square of ";

const std::array table{
    finding("figure.polyloops.construction.quadratic", "polyloops 3.1, figure", on_square + "rdrdrdrd."),
    finding("figure.polyloops.construction.cubic", "polyloops 3.1, figure", on_square + "rddrddrdd."),
    finding("figure.polyloops.construction.four-point", "polyloops 3.1, figure",
            on_square + "rturtu, in place of the caption's rtutu (polyloops.rtu.caption)."),
};

using Plane = Eigen::Matrix<Rational, 2, 1>;
using Chain = VertexChain<Plane>;

PolyloopOperator<Rational> named(char letter) {
  switch (letter) {
    case 'r':
      return polyloop::refine<Rational>();
    case 'd':
      return polyloop::dual<Rational>();
    case 't':
      return polyloop::tuck(Rational(1, 2));
    default:
      return polyloop::untuck<Rational>();
  }
}

Chain after(const std::string& letters, const PlanePolygon& polygon) {
  Chain chain;
  for (const auto& [x, y] : polygon) chain.vertices.emplace_back(x, y);
  for (const char letter : letters) chain = apply(named(letter), chain);
  return chain;
}

PlanePolygon plane(const Chain& chain) {
  PlanePolygon result;
  for (const Plane& p : chain.vertices) result.emplace_back(p(0), p(1));
  return result;
}

Rational doubled_area(const PlanePolygon& p) {
  Rational sum(0);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto& next = p[(i + 1) % p.size()];
    sum += p[i].first * next.second - p[i].second * next.first;
  }
  return sum;
}

/// From every vertex B along M(B) = (A + C)/2 - B and back, as one line that follows the polyloop.
PlanePolygon laplace_vectors(const Chain& chain) {
  const Chain moved = apply(polyloop::tuck(Rational(1)), chain);
  PlanePolygon line;
  for (std::size_t i = 0; i < chain.vertices.size(); ++i) {
    const Plane& from = chain.vertices[i];
    const Plane& to = moved.vertices[i];
    line.emplace_back(from(0), from(1));
    line.emplace_back(to(0), to(1));
    line.emplace_back(from(0), from(1));
  }
  return line;
}

struct Row {
  const char* id;
  const char* name;
  const char* title;
  std::vector<std::string> sequences;  // the last one has its area taken
};

const std::array rows{
    Row{"figure.polyloops.construction.quadratic",
        "polyloop-construction-quadratic",
        "refine (r) and dual (d): the quadratic B-spline",
        {"r", "rd", "rdr", "rdrd", "rdrdrdrd"}},
    Row{"figure.polyloops.construction.cubic",
        "polyloop-construction-cubic",
        "refine (r) and dual twice (dd): the cubic B-spline",
        {"r", "rdd", "rddr", "rddrdd", "rddrddrdd"}},
    Row{"figure.polyloops.construction.four-point",
        "polyloop-construction-four-point",
        "refine (r), tuck(1/2) (t) and tuck(-1) (u): the four-point scheme",
        {"r", "rt", "rtu", "rturt", "rturtu"}},
};

}  // namespace

std::span<const ClaimHead> polyloop_construction_heads() { return table; }

Results run_polyloop_construction() {
  Results results;
  const PlanePolygon& square = stored_polyloop("square");
  for (const Row& row : rows) {
    Drawing drawing{row.name, row.title, {}, {row.id}};
    for (const std::string& letters : row.sequences) {
      const Chain chain = after(letters, square);
      drawing.panels.push_back({letters,
                                {{"", plane(chain), true, style::region(style::faint)},
                                 {"", laplace_vectors(chain), true, style::in_colour(style::blue, 1)},
                                 {"", plane(chain), true, style::points(1, 0.3)},
                                 {"", square, true, style::polygon}}});
    }
    add_drawing(results, drawing);
    const Rational area = doubled_area(plane(after(row.sequences.back(), square)));
    results.claims.push_back(
        settle(head(table, row.id), exact(area / doubled_area(square), "rational arithmetic")));
  }
  return results;
}

}  // namespace subdiv
