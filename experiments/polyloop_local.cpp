#include <algorithm>
#include <array>
#include <iterator>

#include "analysis/polyloop/local_geometry.h"
#include "experiments/polyloop_curves.h"
#include "experiments/polyloop_parts.h"
#include "experiments/simple_polygons.h"
#include "schemes/algebra/taylor.h"

template <class R, std::size_t N>
struct Eigen::NumTraits<subdiv::Taylor<R, N>> : subdiv::detail::RingNumTraits<subdiv::Taylor<R, N>> {};

namespace subdiv {
namespace {

const std::string identity =
    "An identity of rational functions in the coordinates of A = B - u, B and C = B + v in the plane: ";
const std::string series =
    "The vertices are f(-h), f(0), f(h) (of an edge f(-3h/2) .. f(3h/2)) of a curve with free derivatives; "
    "as a power series in h over Q: ";
const std::string arc_length =
    "The vertices follow each other at arc length h on a plane curve of curvature k(t), k1 and k2 its "
    "derivatives by arc length; as a power series over Q(k, k1, k2) ";
const std::string uneven =
    "The vertices are f(-h), f(0), f(q h) of a plane curve with free derivatives; as a power series in h: ";

ClaimHead printed(std::string id, std::string text, std::string definition,
                  ClaimKind kind = ClaimKind::exact) {
  return {std::move(id), "polyloops", "1", std::move(text), kind, std::move(definition)};
}

const std::array table{
    printed("polyloops.velocity", "V=(AB+BC)/2=(B–A+C–B)/2=(C–A)/2=AC/2",
            "An identity of linear forms in A, B and C."),
    printed(
        "polyloops.velocity.average",
        "As you travel along an arc of J between vertices A and B, the average velocity vector will be AB",
        "The mean of f' over a unit of time, f any polynomial of degree 6 with free coefficients: the "
        "integral of its derivative is f(1) - f(0) = B - A."),
    finding("polyloops.velocity.order", "polyloops 1", series + "the error of V/h as velocity f'(0)."),
    printed("polyloops.acceleration", "g(B) = BC–AB = BC+BA = 2((A+C)/2–B)",
            "An identity of linear forms in A, B and C."),
    finding("polyloops.acceleration.order", "polyloops 1",
            series + "the error of g/h^2 as acceleration f''(0)."),
    printed("polyloops.jerk", "j(B) = g(C)–g(B) = 2((B+D)/2–C)–2((A+C)/2–B) = –A+3B–3C+D",
            "An identity of linear forms in A, B, C and D."),
    finding("polyloops.jerk.order", "polyloops 1",
            series + "the error of j/h^3 as third derivative in the middle of the edge, f'''(0)."),
    printed("polyloops.radius.height", "h=AB•AC.left.direction",
            identity + "AB . left(AC)/|AC| is the distance of B from the line AC, which is not negative. "
                       "The moduli are polyloops.radius.height.modulus."),
    finding("polyloops.radius.height.modulus", "polyloops 1",
            identity + "the square of AB . left(AC)/|AC| is that of the distance of B from the line AC."),
    printed("polyloops.radius.normal-component",
            "2h is the norm of the normal component of acceleration g(B)",
            identity + "the square of the part of g across AC is 4 h^2."),
    printed("polyloops.radius.parabola", "r=V2/(2h)",
            "V^2/(2h) of the vertices at times -1, 0 and 1 of x = v t + a t^2, y = b t^2, a parabola through "
            "them, is its radius of curvature |f'|^3/|f' x f''| at B, over Q(v, a, b)."),
    printed("polyloops.radius.normal-acceleration",
            "the normal acceleration of a point traveling on a circle of radius r with tangential velocity V "
            "is V2/r",
            "Of (r cos wt, r sin wt) as Taylor series at t = 0 over Q(r, w): |f'|^2 = (r w)^2, and f'' is "
            "(-(r w)^2/r, 0)."),
    printed("polyloops.radius.circle.acute",
            "this circle-fit solution yields unsatisfactory results when the angle at B is acute",
            "Arms AB and BC of the same length with the angle b between them: the circle's radius over the "
            "parabola's is 1/sin^2(b/2), an identity over Q(tan(b/2)): above 2 exactly for acute b."),
    finding("polyloops.radius.ratio", "polyloops 1",
            identity + "the circle's radius over the parabola's is 4 |AB| |BC| / |AC|^2 (its square)."),
    finding("polyloops.radius.circle.least", "polyloops 1",
            identity +
                "the circle's radius is at least |AB|/2 (and |BC|/2), however sharp the angle: 4 r^2 - "
                "|AB|^2 = (|AB| (AC . BC))^2/|AB x BC|^2."),
    printed("polyloops.radius.better", "A better estimate is provided by a parabolic-fit solution",
            "The smooth curve is the quintic B-spline curve J_{3/2} that passes through a polygon's vertices "
            "one unit of its parameter apart (direct retrofit). Share, over all vertices with an acute angle "
            "of " +
                simple_polygons_text() +
                ", of those at which the parabola's signed curvature is nearer to the true one than the "
                "circle's. Squares are exact, roots enclosed by intervals.",
            ClaimKind::tendency),
    finding(
        "polyloops.radius.parabola.circle", "polyloops 1",
        "On regular polygons of n vertices the parabola's radius is that of the circle times cos^2(pi/n), "
        "an identity over Q(tan(pi/n)); the circle's is exact."),
    finding("polyloops.radius.circle.order", "polyloops 1",
            arc_length + "the leading error of the circle's curvature."),
    finding("polyloops.radius.parabola.order", "polyloops 1",
            arc_length + "the leading error of the parabola's curvature."),
    finding("polyloops.radius.order", "polyloops 1",
            series + "both squared curvatures are k^2 + O(h^2), whatever the parametrisation."),
    finding("polyloops.radius.circle.uneven", "polyloops 1",
            uneven + "the circle's curvature is k + (q - 1)/3 dk/dt h + O(h^2)."),
    finding("polyloops.radius.parabola.uneven", "polyloops 1",
            uneven + "the parabola's curvature tends to 4 q/(1 + q)^2 k."),
    finding(
        "figure.polyloops.curvature", "polyloops 1",
        "The curve (t, t^3) at t = 1/2: the error of the circle's squared curvature at the step 1/64 over "
        "that at 1/128. The figure shows the errors of both curvatures on five curves."),
    finding("figure.polyloops.acute", "polyloops 1",
            "The circle's radius over the parabola's at a vertex between two edges 5 whose ends are 6 "
            "apart. The figure shows both radii by the angle at the vertex."),
};

using Function = RationalFunction;
using Linear = Vector<Function>;

Function variable(int i) { return Function::variable(i); }

Claim statement(const std::string& id, bool holds, const std::string& exact, const std::string& note = "") {
  return settle_statement(head(table, id), holds, exact, note);
}

// ---- Identities -------------------------------------------------------------------------------------------

/// A, B, C, D as points of one coordinate.
Linear letter(int i) { return Linear::Constant(1, variable(i)); }

void add_differences(Results& results) {
  const Linear a = letter(0);
  const Linear b = letter(1);
  const Linear c = letter(2);
  const Linear d = letter(3);
  const Function half = fraction<Function>(1, 2);
  const Function two(2);
  const Function three(3);
  const Linear velocity = vertex_velocity(a, c);
  results.claims.push_back(
      statement("polyloops.velocity", velocity == Linear(((b - a) + (c - b)) * half), "(C-A)/2"));
  // f = sum of c_k t^k, its derivative integrated from 0 to 1 term by term.
  Function mean(0);
  Function way(0);
  constexpr int degree = 6;
  for (int k = 1; k <= degree; ++k) {
    const Function derivative = Function(k) * variable(k);
    mean += derivative * fraction<Function>(1, k);
    way += variable(k);
  }
  results.claims.push_back(
      statement("polyloops.velocity.average", mean == way, "B - A",
                "So of every curve with a velocity, by the fundamental theorem of calculus."));
  const Linear at_b = vertex_acceleration(a, b, c);
  const Linear at_c = vertex_acceleration(b, c, d);
  const bool same = at_b == Linear((c - b) - (b - a)) && at_b == Linear((c - b) + (a - b)) &&
                    at_b == Linear(((a + c) * half - b) * two);
  results.claims.push_back(statement("polyloops.acceleration", same, "A-2B+C"));
  const Linear jerk = edge_jerk(a, b, c, d);
  const bool jerks = jerk == Linear(at_c - at_b) && jerk == Linear(d - c * three + b * three - a);
  results.claims.push_back(statement("polyloops.jerk", jerks, "-A+3B-3C+D"));
}

/// The angle at B between arms of the same length: tan(b/2) = x, ends at (-x, -1) and (x, -1).
std::pair<Function, Function> isosceles_curvatures() {
  const Function x = variable(0);
  const Linear a = pair_of(-x, Function(-1));
  const Linear b = pair_of(Function(0), Function(0));
  const Linear c = pair_of(x, Function(-1));
  return {squared_circle_curvature(a, b, c), squared_parabola_curvature(a, b, c)};
}

void add_radii(Results& results) {
  const Linear u = pair_of(variable(0), variable(1));  // AB
  const Linear v = pair_of(variable(2), variable(3));  // BC
  const Linear b = pair_of(Function(0), Function(0));
  const Linear a = b - u;
  const Linear& c = v;
  const Linear chord = c - a;
  const Function across = u(1) * chord(0) - u(0) * chord(1);  // AB . left(AC)
  const Function height = across * across / squared_length(chord);
  const Function distance = squared_area(u, chord) / squared_length(chord);
  // AB = (1, 0), BC = (0, 1): a turn to the left.
  const std::array<Function, 4> left_turn{Function(1), Function(0), Function(0), Function(1)};
  const Function at_left_turn = across.evaluate(std::span<const Function>(left_turn));
  const bool never_negative = height == distance && at_left_turn != Function(-1);
  results.claims.push_back(statement(
      "polyloops.radius.height", never_negative, "|AB . left(AC)|/|AC|",
      "The product has a sign: it is negative where the polyloop turns left, -1/sqrt 2 for AB = (1, 0), "
      "BC = (0, 1), and so would be the radius V^2/(2h). The distance is its modulus."));
  results.claims.push_back(
      statement("polyloops.radius.height.modulus", height == distance, "|AB . left(AC)|/|AC|"));
  const Linear acceleration = vertex_acceleration(a, b, c);
  const Function normal = squared_area(acceleration, chord) / squared_length(chord);
  results.claims.push_back(
      statement("polyloops.radius.normal-component", normal == Function(4) * height, "2h"));

  // f' = (v, 0) and f'' = (2a, 2b) at t = 0; the parabola through A, B, C at times -1, 0, 1.
  const Function speed = variable(0);
  const Function along = variable(1);
  const Function bend = variable(2);
  const Linear before = pair_of(along - speed, bend);
  const Linear after = pair_of(along + speed, bend);
  const Function curvature = Function(2) * bend / (speed * speed);
  results.claims.push_back(statement("polyloops.radius.parabola",
                                     squared_parabola_curvature(before, b, after) == curvature * curvature,
                                     "r = V^2/(2h)"));

  constexpr std::size_t terms = 3;
  using Jet = Taylor<Function, terms>;
  const Function r = variable(0);
  const Function w = variable(1);
  Jet x = Jet::constant(r);  // r cos wt, r sin wt
  Jet y;
  x.c[2] = -(r * w * w / Function(2));
  y.c[1] = r * w;
  const Function velocity = squared_length(pair_of(x.c[1], y.c[1]));
  const bool circular = velocity == r * w * r * w && Function(2) * x.c[2] == -(velocity / r) &&
                        (Function(2) * y.c[2]).is_zero();
  results.claims.push_back(statement("polyloops.radius.normal-acceleration", circular, "V^2/r"));

  const Function circle = squared_circle_curvature(a, b, c);
  const Function parabola = squared_parabola_curvature(a, b, c);
  const Function ratio =
      Function(16) * squared_length(u) * squared_length(v) / (squared_length(chord) * squared_length(chord));
  results.claims.push_back(
      statement("polyloops.radius.ratio", parabola == ratio * circle, "4 |AB| |BC| / |AC|^2"));
  const Function dot = chord(0) * v(0) + chord(1) * v(1);
  const bool least =
      (Function(4) / circle - squared_length(u)) * squared_area(u, v) == squared_length(u) * dot * dot;
  results.claims.push_back(
      statement("polyloops.radius.circle.least", least, "r >= |AB|/2 and r >= |BC|/2",
                "At a spike the circle's radius tends to half the longer edge, the parabola's to 0."));

  const auto [round, parabolic] = isosceles_curvatures();
  const Function tangent = variable(0);
  const Function sine = tangent * tangent / (Function(1) + tangent * tangent);  // sin^2(b/2)
  results.claims.push_back(statement(
      "polyloops.radius.circle.acute", round == sine * sine * parabolic, "1/sin^2(b/2)",
      "Above 2 exactly for b < 90 degrees, 4 at 60, without bound as b falls to 0: for arms 1 the circle's "
      "radius tends to 1/2, the parabola's to 0. Of x = t, y = c t^2 at t = -h, 0, h the parabola's "
      "radius is true at any angle, and the circle's is 1/sin^2(b/2) times too large; of a circle it is "
      "the reverse."));

  // On a regular polygon b = pi - 2 pi/n, and sin(b/2) = cos(pi/n) = 1/sqrt(1 + x^2) with x = tan(pi/n).
  const Function squared_cosine = Function(1) / (Function(1) + tangent * tangent);
  const std::array<Function, 1> inverse{Function(1) / tangent};  // tan(b/2)
  results.claims.push_back(statement(
      "polyloops.radius.parabola.circle", sine.evaluate(std::span<const Function>(inverse)) == squared_cosine,
      "r cos^2(pi/n)",
      "By polyloops.radius.circle.acute with b = pi - 2 pi/n. A square's is half its circle's radius, a "
      "triangle's a quarter."));
}

// ---- Orders -----------------------------------------------------------------------------------------------

constexpr std::size_t length_of_series = 7;
using Jet = Taylor<Function, length_of_series>;

/// f(a h), f = sum of coefficients t^k.
Jet at(const std::vector<Function>& coefficients, const Function& a) {
  Jet value;
  Function power(1);
  for (std::size_t k = 0; k < std::min(coefficients.size(), length_of_series); ++k) {
    value.c[k] = coefficients[k] * power;
    power *= a;
  }
  return value;
}

void add_orders_of_differences(Results& results) {
  std::vector<Function> free;  // Taylor coefficients f^(k)/k!
  for (int k = 0; k < static_cast<int>(length_of_series); ++k) free.push_back(variable(k));
  const auto point = [&](const Rational& a) {
    return Vector<Jet>(Vector<Jet>::Constant(1, at(free, Function(a))));
  };
  const auto error = [&](const Vector<Jet>& difference, std::size_t derivative, const Rational& factor,
                         std::size_t of) {
    Jet rest = difference(0);
    Rational factorial(1);
    for (std::size_t k = 2; k <= derivative; ++k) factorial *= Rational(static_cast<int>(k));
    rest.c[derivative] -= free[derivative] * Function(factorial);
    bool zero = true;
    for (std::size_t k = 0; k < of; ++k) zero = zero && rest.c[k].is_zero();
    return zero && rest.c[of] == free[of] * Function(factor);
  };
  const Rational half(1, 2);
  const Rational long_half(3, 2);
  // Of h^2 f'''/6 with f''' = 6 c_3, h^2 f''''/12 with f'''' = 24 c_4 and h^2 f^(5)/8 with f^(5) = 120 c_5.
  results.claims.push_back(statement(
      "polyloops.velocity.order",
      error(vertex_velocity(point(Rational(-1)), point(Rational(1))), 1, Rational(1), 3), "h^2 f'''/6"));
  results.claims.push_back(
      statement("polyloops.acceleration.order",
                error(vertex_acceleration(point(Rational(-1)), point(Rational(0)), point(Rational(1))), 2,
                      Rational(2), 4),
                "h^2 f''''/12"));
  results.claims.push_back(statement(
      "polyloops.jerk.order",
      error(edge_jerk(point(-long_half), point(-half), point(half), point(long_half)), 3, Rational(15), 5),
      "h^2 f^(5)/8"));
}

/// Squared curvatures times h^2 at 0 of three points (f(a h) - f(0))/h of a plane curve with f(0) = 0: series
/// that begin with k^2 h^2.
struct SquaredCurvatures {
  Jet circle;
  Jet parabola;
};

SquaredCurvatures squared_curvatures(const std::vector<Function>& x, const std::vector<Function>& y,
                                     const Function& after) {
  const auto divided = [](const std::vector<Function>& f) {
    return std::vector<Function>(f.begin() + 1, f.end());
  };
  const auto point = [&](const Function& a) {  // f(a h)/h = a (f(s)/s at s = a h)
    const Jet scale = Jet::constant(a);
    return pair_of(scale * at(divided(x), a), scale * at(divided(y), a));
  };
  const Vector<Jet> before = point(Function(-1));
  const Vector<Jet> here = pair_of(Jet(0), Jet(0));
  const Vector<Jet> behind = point(after);
  return {squared_circle_curvature(before, here, behind), squared_parabola_curvature(before, here, behind)};
}

void add_orders_of_curvatures(Results& results) {
  // Frenet: the coefficients of arc length for curvature k + k1 t + k2 t^2/2.
  const Function k = variable(0);
  const Function k1 = variable(1);
  const Function k2 = variable(2);
  const std::vector<Function> x{Function(0), Function(1), Function(0), -(k * k / Function(6)),
                                -(k * k1 / Function(8))};
  const std::vector<Function> y{Function(0), Function(0), k / Function(2), k1 / Function(6),
                                (k2 - k * k * k) / Function(24)};
  const SquaredCurvatures even = squared_curvatures(x, y, Function(1));
  const std::array<std::string, 3> names{"k", "k1", "k2"};
  constexpr std::size_t lead = 2;
  for (const auto& [id, jet] : {std::pair{"polyloops.radius.circle.order", even.circle},
                                std::pair{"polyloops.radius.parabola.order", even.parabola}}) {
    const bool second = jet.c[lead] == k * k && jet.c[lead + 1].is_zero();
    const Function coefficient = jet.c[lead + 2] / (Function(2) * k);  // of k itself
    results.claims.push_back(
        statement(id, second, "h^2 (" + coefficient.to_string(std::span<const std::string>(names)) + ")"));
  }

  // x = v t + x2 t^2 + .., y = y2 t^2 + ..: any parametrisation, the tangent along x.
  const Function v = variable(0);
  const Function x2 = variable(1);
  const Function y2 = variable(2);
  const Function y3 = variable(4);
  const Function q = variable(7);
  const std::vector<Function> free_x{Function(0), v, x2, variable(3), Function(0)};
  const std::vector<Function> free_y{Function(0), Function(0), y2, y3, variable(5)};
  const Function curvature = Function(2) * y2 / (v * v);
  const Function squared = curvature * curvature;
  const SquaredCurvatures uniform = squared_curvatures(free_x, free_y, Function(1));
  const bool both = uniform.circle.c[lead] == squared && uniform.circle.c[lead + 1].is_zero() &&
                    uniform.parabola.c[lead] == squared && uniform.parabola.c[lead + 1].is_zero();
  results.claims.push_back(statement("polyloops.radius.order", both, "k^2 + O(h^2)"));
  const SquaredCurvatures stretched = squared_curvatures(free_x, free_y, q);
  const Function change = (Function(6) * y3 * v - Function(12) * x2 * y2) / (v * v * v);  // dk/dt
  const Function first_order = Function(2) * curvature * (q - Function(1)) / Function(3) * change;
  results.claims.push_back(
      statement("polyloops.radius.circle.uneven",
                stretched.circle.c[lead] == squared && stretched.circle.c[lead + 1] == first_order,
                "k + (q - 1)/3 dk/dt h + O(h^2)", "Consistent at any q, of order one where q is not 1."));
  const Function factor = Function(4) * q / ((Function(1) + q) * (Function(1) + q));
  results.claims.push_back(statement(
      "polyloops.radius.parabola.uneven", stretched.parabola.c[lead] == factor * factor * squared,
      "4 q/(1 + q)^2 k",
      "The parabola's radius does not converge where consecutive steps keep a ratio q other than 1: for q = "
      "2 it is 9/8 of the true one. It takes the vertices as evenly spaced in time."));
}

}  // namespace

std::span<const ClaimHead> polyloop_local_heads() { return table; }

Results run_polyloop_local() {
  Results results;
  add_differences(results);
  add_radii(results);
  add_orders_of_differences(results);
  add_orders_of_curvatures(results);
  Results radii = run_polyloop_radii();
  std::ranges::move(radii.claims, std::back_inserter(results.claims));
  results.series = std::move(radii.series);
  results.figures = std::move(radii.figures);
  return results;
}

}  // namespace subdiv
