#include "experiments/lecture_notes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "analysis/hausdorff_distance.h"
#include "experiments/data.h"
#include "schemes/bspline.h"
#include "schemes/evaluate/level_by_level.h"
#include "schemes/four_point.h"
#include "tests/experiments/find_claim.h"

namespace subdiv {
namespace {

const Results& results() {
  static const Results once = run_lecture_notes();
  return once;
}
const Claim& found(const std::string& id) { return test::find_claim(results().claims, id); }
double value(const std::string& id) { return test::value_of(results().claims, id); }

using Numbers = std::vector<double>;

double cubic(const Numbers& p, double t) {
  const double s = 1 - t;
  return s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3];
}
Numbers random_numbers(std::mt19937& random, int count) {
  std::uniform_real_distribution<double> number(-1, 1);
  Numbers result;
  for (int i = 0; i < count; ++i) result.push_back(number(random));
  return result;
}
/// The largest second difference.
double bend(const Numbers& p) {
  double largest = 0;
  for (std::size_t i = 1; i + 1 < p.size(); ++i)
    largest = std::max(largest, std::abs(p[i - 1] - 2 * p[i] + p[i + 1]));
  return largest;
}

TEST(LectureNotes, EveryClaimIsSettledAndFourAreRefuted) {
  EXPECT_EQ(results().claims.size(), lecture_note_heads().size());
  const std::set<std::string> refuted{"notes.bezier.shifts", "notes.cubic.sequence.2",
                                      "notes.loop.manifold.necessary", "notes.loop.manifold.solid"};
  for (const Claim& claim : results().claims) {
    const Verdict expected = !claim.head.printed               ? Verdict::established
                             : refuted.contains(claim.head.id) ? Verdict::refuted
                                                               : Verdict::reproduced;
    EXPECT_EQ(claim.verdict, expected) << claim.head.id;
    EXPECT_EQ(claim.rigour,
              claim.head.id == "notes.loop.valence-3.better" ? Rigour::certified : Rigour::exact)
        << claim.head.id;
    if (claim.verdict == Verdict::refuted) {
      EXPECT_FALSE(claim.note.empty()) << claim.head.id;
    }
  }
}

// The printed recursion on numbers, against Bernstein's polynomials.
TEST(LectureNotes, TheHalvesOfACubicInNumbers) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 20; ++trial) {
    const Numbers p = random_numbers(random, 4);
    const double p01 = (p[0] + p[1]) / 2;
    const double p12 = (p[1] + p[2]) / 2;
    const double p23 = (p[2] + p[3]) / 2;
    const double p012 = (p01 + p12) / 2;
    const double p123 = (p12 + p23) / 2;
    const double p0123 = (p012 + p123) / 2;
    for (double t = 0; t <= 1; t += 0.125) {
      EXPECT_NEAR(cubic({p[0], p01, p012, p0123}, t), cubic(p, t / 2), 1e-15);
      EXPECT_NEAR(cubic({p0123, p123, p23, p[3]}, t), cubic(p, (1 + t) / 2), 1e-15);
    }
    EXPECT_LE(bend({p[0], p01, p012, p0123}), value("notes.bezier.rate") * bend(p) + 1e-15);
  }
  EXPECT_EQ(found("notes.bezier.p0123").exact, "(P0 + 3 P1 + 3 P2 + P3)/8");
}

// By sampling: never beyond the bound, and attained by i^2/2.
TEST(LectureNotes, DistancesOfCubicsBySampling) {
  const auto distances = [](const Numbers& p) {
    double polygon = 0;
    double chord = 0;
    for (int k = 0; k <= 300; ++k) {
      const double t = k / 300.0;
      const auto leg = static_cast<std::size_t>(std::min(2, k / 100));
      const double part = 3 * t - static_cast<double>(leg);
      polygon = std::max(polygon, std::abs(cubic(p, t) - (1 - part) * p[leg] - part * p[leg + 1]));
      chord = std::max(chord, std::abs(cubic(p, t) - (1 - t) * p[0] - t * p[3]));
    }
    return std::pair{polygon / bend(p), chord / bend(p)};
  };
  std::mt19937 random(5);
  for (int trial = 0; trial < 100; ++trial) {
    const auto [polygon, chord] = distances(random_numbers(random, 4));
    EXPECT_LE(polygon, value("notes.bezier.polygon.distance") + 1e-12);
    EXPECT_LE(chord, value("notes.bezier.chord.distance") + 1e-12);
  }
  const auto [polygon, chord] = distances({0, 0.5, 2, 4.5});
  EXPECT_NEAR(polygon, value("notes.bezier.polygon.distance"), 1e-12);
  EXPECT_NEAR(chord, value("notes.bezier.chord.distance"), 1e-12);
}

TEST(LectureNotes, ShiftsRoundDownByAtMostThis) {
  std::mt19937 random(9);
  std::uniform_int_distribution<int> coordinate(-1000, 1000);
  double largest = 0;
  for (int trial = 0; trial < 100000; ++trial) {
    const int a = coordinate(random);
    const int b = coordinate(random);
    const int c = coordinate(random);
    const int d = coordinate(random);
    const auto half = [](int x, int y) { return static_cast<int>(std::floor((x + y) / 2.0)); };
    const int by_shifts = half(half(half(a, b), half(b, c)), half(half(b, c), half(c, d)));
    largest = std::max(largest, (a + 3.0 * b + 3.0 * c + d) / 8 - by_shifts);
  }
  EXPECT_EQ(largest, value("notes.bezier.shifts.error"));
}

// By integer arithmetic: whether every sum that a split halves is even.
TEST(LectureNotes, SplitsByShiftsThatAreExact) {
  const auto is_exact = [](int a, int b, int c, int d) {
    bool even = true;
    const auto half = [&](int x, int y) {
      even = even && (x + y) % 2 == 0;
      return (x + y) / 2;
    };
    const int bc = half(b, c);
    (void)half(half(half(a, b), bc), half(bc, half(c, d)));
    return even;
  };
  EXPECT_TRUE(is_exact(0, 2, 4, 6)) << "no multiples of 8";
  EXPECT_EQ(value("notes.bezier.shifts.multiples"), 8);
  for (int m = 1; m <= 16; ++m) {
    bool all = true;
    for (int k = 0; k < 625; ++k)  // factors -2 .. 2 of m
      all = all && is_exact(m * (k % 5 - 2), m * (k / 5 % 5 - 2), m * (k / 25 % 5 - 2), m * (k / 125 - 2));
    EXPECT_EQ(all, m % 8 == 0) << m;
  }
  EXPECT_EQ(found("notes.bezier.shifts").verdict, Verdict::refuted);
  EXPECT_NE(found("notes.bezier.shifts").note.find("only if 8 divides m"), std::string::npos);
}

TEST(LectureNotes, ExponentsByLibraryFunctions) {
  EXPECT_EQ(found("notes.bezier.exponent.least").exact, "2^-1021");
  const auto decremented = [](double x) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &x, sizeof x);
    bits -= std::uint64_t{1} << 52U;
    std::memcpy(&x, &bits, sizeof x);
    return x;
  };
  for (int e = -1021; e <= 1023; ++e)
    EXPECT_EQ(decremented(std::ldexp(-1.75, e)), std::ldexp(-1.75, e - 1)) << e;
  EXPECT_NE(decremented(std::ldexp(1.0, -1022)), std::ldexp(1.0, -1023));
  EXPECT_NE(decremented(0.0), 0.0);
  EXPECT_EQ(std::numeric_limits<double>::denorm_min() / 2, 0) << "rounded";
}

// Deep refinement in doubles stands for the limit.
TEST(LectureNotes, WhereOpenCubicsBeginByRefinement) {
  Numbers p{1, 7, -2, 5, 3};
  for (int step = 0; step < 40; ++step) {  // of the first points alone
    p = {(p[0] + p[1]) / 2, (p[0] + 6 * p[1] + p[2]) / 8, (p[1] + p[2]) / 2};
  }
  EXPECT_NEAR(p[1], (1 + 4 * 7 - 2) / 6.0, 1e-12);
  EXPECT_EQ(found("notes.cubic.start").exact, "(P0 + 4 P1 + P2)/6");
}

TEST(LectureNotes, TheSecondSequenceByTheMaskOfDegreeTwo) {
  const auto polygon = open_polygon(Numbers{1, 10, 100, 1000}, 1, 1);
  Mask<double> mask = map_coefficients(bspline<Rational>(2), [](const Rational& x) { return x.to_double(); });
  const auto fine = refine_once(mask, polygon);
  EXPECT_EQ(fine.points.back(), (100 + 3 * 1000) / 4.0) << "printed: /2";
  EXPECT_EQ(fine.points.front(), (3 + 10) / 4.0);
  EXPECT_EQ(fine.points.size(), 6U);
}

// The fine polygon of a sequence of random data, 14 levels down, against the control polygon.
TEST(LectureNotes, DistancesOfCubicSplinesBySampling) {
  const double bound = value("notes.bsplines.distance");
  for (double a = -1; a <= 1; a += 0.25) {
    for (double b = -1; b <= 1; b += 0.25) {
      const Numbers p{0.3, a, b, -0.6};
      for (double t = 0; t <= 1; t += 0.01) {  // the span from P_1 to P_2
        const double s = 1 - t;
        const double spline = (s * s * s * p[0] + (3 * t * t * t - 6 * t * t + 4) * p[1] +
                               (3 * s * s * s - 6 * s * s + 4) * p[2] + t * t * t * p[3]) /
                              6;
        EXPECT_LE(std::abs(spline - s * p[1] - t * p[2]), bound * bend(p) + 1e-14);
      }
    }
  }
}

// By the library's own refinement of open polygons, which knows nothing of the printed sequences: rules reach
// from -3 to 3 about an index, so that two points at each end bear no span.
TEST(LectureNotes, FourPointEndsByTheMask) {
  Mask<double> mask =
      map_coefficients(four_point(Rational(1, 16)), [](const Rational& x) { return x.to_double(); });
  auto polygon = open_polygon(Numbers{3, -1, 4, 1, -5, 9, 2, 6}, 2, 2);
  for (int step = 0; step < 10; ++step) polygon = refine_once(mask, polygon);
  const Numbers curve = curve_points(polygon);
  ASSERT_EQ(curve.size(), 3U * 1024 + 1);
  EXPECT_EQ(curve.front(), 4);  // P_2
  EXPECT_EQ(curve.back(), 9);   // P_5, the third from the end of eight
}

// Four are 3, 1, 0 of them, five stay five, six grow: printed points in numbers, until none has its four.
TEST(LectureNotes, FewestPointsOfAFourPointCurve) {
  const auto sizes = [](std::size_t count) {
    Numbers p(count, 1.0);
    std::vector<std::size_t> result;
    for (int step = 0; step < 3; ++step) {
      Numbers fine;
      const std::size_t last = p.size() - 1;
      for (std::size_t i = 1; !p.empty() && i < last; ++i) {
        fine.push_back(p[i]);
        if (i + 1 < last) fine.push_back((-p[i - 1] + 9 * p[i] + 9 * p[i + 1] - p[i + 2]) / 16);
      }
      p = fine;
      result.push_back(p.size());
    }
    return result;
  };
  EXPECT_EQ(sizes(4), (std::vector<std::size_t>{3, 1, 0}));
  EXPECT_EQ(sizes(5), (std::vector<std::size_t>{5, 5, 5}));
  EXPECT_EQ(sizes(6), (std::vector<std::size_t>{7, 9, 13}));
  EXPECT_EQ(value("notes.four-point.fewest"), 6);
  const std::string& note = found("notes.four-point.fewest").note;
  for (const char* part :
       {"4 control points: 3, 1, 0", "5 control points: 5, 5, 5", "6 control points: 7, 9, 13"})
    EXPECT_NE(note.find(part), std::string::npos) << note;
}

// Centre and ring at valence 3, all data alike around it: the trace less 1 is the other eigenvalue; 1/4 is
// what data of modes 1 and 2 are multiplied by.
TEST(LectureNotes, Valence3NeedsItsOwnWeights) {
  const auto other = [](double centre) { return centre + (3 + 1 + 1) / 8.0 - 1; };
  const double turning = (3 - 1) / 8.0;  // 1, w, w^2 at the ring: 3/8 + (w + w^2)/8
  EXPECT_EQ(other(5 / 8.0), turning) << "three directions shrink alike";
  EXPECT_EQ(other(7 / 16.0), 1 / 16.0);
  EXPECT_EQ(found("notes.loop.valence-3.better").verdict, Verdict::reproduced);
}

TEST(LectureNotes, TwoCubesThatShareAnEdgeAreNoManifold) {
  const Claim& solid = found("notes.loop.manifold.solid");
  EXPECT_EQ(solid.verdict, Verdict::refuted);
  EXPECT_EQ(solid.exact, "1 edge with four triangles");
  EXPECT_NE(solid.note.find("is refused: face "), std::string::npos) << solid.note;
}

// Second divided differences of the four-point curve of a unit impulse grow with every level, those of the
// cubic B-spline stay.
TEST(LectureNotes, RidgesOfTheButterflyHaveNoSecondDerivative) {
  const auto bends = [](const Mask<Rational>& exact_mask, int level) {
    const Mask<double> mask = map_coefficients(exact_mask, [](const Rational& x) { return x.to_double(); });
    Laurent<double> points(1);
    for (int k = 0; k < level; ++k) points = refine_sequence(mask, points);
    return bend(points.coefficients()) * std::pow(4.0, level);
  };
  const Mask<Rational> four = four_point(Rational(1, 16));
  EXPECT_GT(bends(four, 10), bends(four, 8) + 0.4);
  EXPECT_GT(bends(four, 8), bends(four, 6) + 0.4);
  EXPECT_NEAR(bends(bspline<Rational>(3), 10), 2, 1e-9) << "B_3'' is -2 at 0";
}

TEST(LectureNotes, TheAreaOfTheBezierFigureByShoelaces) {
  const auto points = polygon_from_data("figure-bezier.csv");
  Numbers x;
  Numbers y;
  for (const auto& [a, b] : points) {
    x.push_back(a.to_double());
    y.push_back(b.to_double());
  }
  double doubled = 0;
  constexpr int parts = 20000;
  for (int k = 0; k < parts; ++k) {
    const double t = static_cast<double>(k) / parts;
    const double next = static_cast<double>(k + 1) / parts;
    doubled += cubic(x, t) * cubic(y, next) - cubic(y, t) * cubic(x, next);
  }
  doubled += cubic(x, 1) * cubic(y, 0) - cubic(y, 1) * cubic(x, 0);
  EXPECT_NEAR(value("figure.notes.bezier"), doubled / 2, 1e-6);
}

TEST(LectureNotes, TheBezierFigureNamesItsPoints) {
  const auto figure = std::ranges::find(results().figures, "figure-notes-bezier", &Figure::name);
  ASSERT_NE(figure, results().figures.end());
  const auto count = [&](const std::string& name) {
    return std::ranges::count(figure->texts, name, &FigureText::text);
  };
  for (const char* name : {"P0", "P1", "P2", "P3"}) EXPECT_EQ(count(name), 2) << name;
  for (const char* name : {"P01", "P12", "P23", "P012", "P123", "P0123"}) EXPECT_EQ(count(name), 1) << name;
}

/// The numbers of a column, as far as it goes.
Numbers column(const Series& series, const std::string& name) {
  const auto place = std::ranges::find(series.columns, name);
  EXPECT_NE(place, series.columns.end()) << name;
  Numbers result;
  for (const auto& row : series.rows) {
    const std::string& cell = row[static_cast<std::size_t>(place - series.columns.begin())];
    if (!cell.empty()) result.push_back(std::stod(cell));
  }
  return result;
}

TEST(LectureNotes, TheAdaptiveFigureKeepsItsTolerance) {
  const Series& series = test::find_series(results(), "figure-notes-adaptive");
  const Numbers x = column(series, "1.2 x");
  const Numbers y = column(series, "1.2 y");
  EXPECT_EQ(static_cast<double>(x.size()), value("figure.notes.adaptive") + 1);
  EXPECT_LT(value("figure.notes.adaptive"), value("figure.notes.adaptive.uniform"));
  Numbers px;
  Numbers py;
  for (const auto& [a, b] : polygon_from_data("figure-hairpin.csv")) {
    px.push_back(a.to_double());
    py.push_back(b.to_double());
  }
  Polyline fine{{4001, false, 0, 0}, {{}, {}}};
  for (int k = 0; k <= 4000; ++k) {
    fine.coordinates[0].push_back(cubic(px, k / 4000.0));
    fine.coordinates[1].push_back(cubic(py, k / 4000.0));
  }
  EXPECT_LE(hausdorff_distance(make_polyline({x, y}, false), fine, 1e-5).upper, 0.02 + 1e-4);
  // The shortest chord is where the curve turns back: at its largest x.
  std::size_t shortest = 0;
  const auto length_of = [&](std::size_t i) { return std::hypot(x[i + 1] - x[i], y[i + 1] - y[i]); };
  for (std::size_t i = 0; i + 1 < x.size(); ++i)
    if (length_of(i) < length_of(shortest)) shortest = i;
  const double most = *std::ranges::max_element(fine.coordinates[0]);
  EXPECT_NEAR(x[shortest], most, 0.2);
}

}  // namespace
}  // namespace subdiv
