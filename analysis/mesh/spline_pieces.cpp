#include "analysis/mesh/spline_pieces.h"

#include <array>

#include "schemes/algebra/elimination.h"

namespace subdiv {
namespace {

constexpr int box_degree = 4;
constexpr int box_coefficients = 15;

/// The lattice points, from the first corner of an upright triangle, whose box splines do not vanish on it.
constexpr std::array<LatticeOffset, 12> box_points{
    {{0, 0}, {1, 0}, {0, 1}, {-1, 0}, {-1, 1}, {0, -1}, {1, -1}, {2, -1}, {2, 0}, {1, 1}, {0, 2}, {-1, 2}}};

Matrix<Interval> enclosed(const Matrix<Rational>& m) {
  return m.unaryExpr([](const Rational& q) { return Interval(q); });
}

/// Row i: the Bernstein coefficient i on [0, 1] of the spline with knots at the integers and the control
/// points at 1 - h, .., h, h = (degree + 1)/2: the polar form at 0 (degree - i times) and 1 (i times), by
/// de Boor's algorithm.
Matrix<Rational> bezier_of_bspline(int degree) {
  Matrix<Rational> result(degree + 1, degree + 1);
  for (int column = 0; column <= degree; ++column) {
    for (int i = 0; i <= degree; ++i) {
      std::vector<Rational> c(static_cast<std::size_t>(degree) + 1, Rational(0));
      c[static_cast<std::size_t>(column)] = Rational(1);
      for (int level = 1; level <= degree; ++level) {
        const int at = level <= i ? 1 : 0;
        for (int j = degree; j >= level; --j) {
          const Rational share(at - (j - degree), degree + 1 - level);
          Rational& own = c[static_cast<std::size_t>(j)];
          own = (Rational(1) - share) * c[static_cast<std::size_t>(j) - 1] + share * own;
        }
      }
      result(i, column) = c.back();
    }
  }
  return result;
}

/// The box spline at the point (p, q)/4: two steps of its subdivision bring the points that decide it to
/// lattice points, where it has the values 1/2 and, six times, 1/12 (the eigenvector of the mask for 1).
Rational box_spline(const LatticeMask<Rational>& mask, int p, int q) {
  const auto at_lattice = [](int a, int b) {
    if (a == 0 && b == 0) return Rational(1, 2);
    const bool neighbour = std::abs(a) <= 1 && std::abs(b) <= 1 && a != b;
    return neighbour ? Rational(1, 12) : Rational(0);
  };
  // phi(x) = sum over o of c(o) phi(2 x - o), x = (p, q)/4.
  Rational result;
  const int last = mask.last();
  for (int i = -last; i <= last; ++i) {
    for (int j = -last; j <= last; ++j) {
      for (int k = -last; k <= last; ++k) {
        for (int l = -last; l <= last; ++l)
          result += mask(i, j) * mask(k, l) * at_lattice(p - 2 * i - k, q - 2 * j - l);
      }
    }
  }
  return result;
}

/// Row: a Bernstein coefficient (i, j), i outer, of the box spline's quartic on the upright triangle; column:
/// a control point of box_points. From its values at the points (i, j)/4, which determine a quartic.
Matrix<Rational> bezier_of_box_spline() {
  const LatticeMask<Rational> mask = spline_mask({3, box_degree});
  const auto binomial = [](int n, int k) {
    Rational result(1);
    for (int i = 1; i <= k; ++i) result *= Rational(n - k + i, i);
    return result;
  };
  std::vector<LatticeOffset> points;
  for (int i = 0; i <= box_degree; ++i) {
    for (int j = 0; i + j <= box_degree; ++j) points.push_back({i, j});
  }
  Matrix<Rational> bernstein(box_coefficients, box_coefficients);
  for (Eigen::Index row = 0; row < box_coefficients; ++row) {
    const auto [p, q] = points[static_cast<std::size_t>(row)];
    for (Eigen::Index column = 0; column < box_coefficients; ++column) {
      const auto [i, j] = points[static_cast<std::size_t>(column)];
      bernstein(row, column) = binomial(box_degree, i) * binomial(box_degree - i, j) *
                               pow(Rational(p, box_degree), i) * pow(Rational(q, box_degree), j) *
                               pow(Rational(box_degree - p - q, box_degree), box_degree - i - j);
    }
  }
  Matrix<Rational> result(box_coefficients, static_cast<Eigen::Index>(box_points.size()));
  for (std::size_t column = 0; column < box_points.size(); ++column) {
    Vector<Rational> values(box_coefficients);
    for (Eigen::Index row = 0; row < box_coefficients; ++row) {
      const auto [p, q] = points[static_cast<std::size_t>(row)];
      values(row) = box_spline(mask, p - box_degree * box_points.at(column).a,
                               q - box_degree * box_points.at(column).b);
    }
    result.col(static_cast<Eigen::Index>(column)) = *solve_linear(bernstein, values);
  }
  return result;
}

const Matrix<Interval>& tensor_factor(int degree) {
  static const Matrix<Interval> cubic = enclosed(bezier_of_bspline(3));
  static const Matrix<Interval> quintic = enclosed(bezier_of_bspline(5));
  thread_local Matrix<Interval> other;
  if (degree == 3) return cubic;
  if (degree == 5) return quintic;
  other = enclosed(bezier_of_bspline(degree));
  return other;
}

int row_of(int sides, const LatticeCell& cell) {
  if (sides == 4) return std::max(cell.a, cell.b);
  return cell.upright ? cell.a + cell.b : cell.a + cell.b + 1;
}

}  // namespace

LatticeMask<Rational> spline_mask(const LatticeSpline& spline) {
  const bool quads = spline.sides == 4;
  const int last = quads ? (spline.degree + 1) / 2 : 2;
  LatticeMask<Rational> mask(last);
  // Each factor (1 + direction)/2, from a centred delta scaled to the sum 4; shifts are chosen so that the
  // powers of pairs of factors, direction^-1 (1 + direction)^2, stay centred.
  mask(0, 0) = Rational(4);
  const std::vector<LatticeOffset> directions = quads ? std::vector<LatticeOffset>{{1, 0}, {0, 1}}
                                                      : std::vector<LatticeOffset>{{1, 0}, {0, 1}, {-1, 1}};
  const int times = quads ? (spline.degree + 1) / 2 : 1;
  for (const LatticeOffset& d : directions) {
    for (int k = 0; k < times; ++k) {
      LatticeMask<Rational> next(last);
      for (int i = -last; i <= last; ++i) {
        for (int j = -last; j <= last; ++j) {
          for (const int step : {-1, 0, 1}) {
            const int a = i - step * d.a;
            const int b = j - step * d.b;
            if (mask.contains(a, b)) next(i, j) += Rational(step == 0 ? 2 : 1, 4) * mask(a, b);
          }
        }
      }
      mask = std::move(next);
    }
  }
  return mask;
}

std::optional<LatticeSpline> spline_with_mask(const LatticeMask<Rational>& mask, int sides) {
  const LatticeMask<Rational> own = trimmed(mask);
  const LatticeSpline spline{sides, sides == 4 ? 2 * own.last() - 1 : box_degree};
  if (own == spline_mask(spline)) return spline;
  return std::nullopt;
}

std::vector<LatticeCell> ring_cells(int sides, int r) {
  std::vector<LatticeCell> cells;
  for (int a = 0; a < 2 * r; ++a) {
    for (int b = 0; b <= a; ++b) {
      for (const bool upright : {true, false}) {
        const LatticeCell cell{a, b, upright};
        const int row = row_of(sides, cell);
        if ((sides == 4 && !upright) || row < r || row >= 2 * r) continue;
        cells.push_back(cell);
      }
    }
  }
  return cells;
}

std::pair<SquarePatch, SquarePatch> square_piece(const CharacteristicNet<Interval>& net, int degree,
                                                 const LatticeCell& cell) {
  const Matrix<Interval>& factor = tensor_factor(degree);
  const int h = (degree + 1) / 2;
  SquarePatch x(degree, degree);
  SquarePatch y(degree, degree);
  for (int q = 0; q <= degree; ++q) {
    std::vector<PlaneNumber<Interval>> line(static_cast<std::size_t>(degree) +
                                            1);  // along the first direction
    for (int p = 0; p <= degree; ++p) {
      const PlaneNumber<Interval> point = net.at(cell.a + 1 - h + p, cell.b + 1 - h + q);
      for (int i = 0; i <= degree; ++i) {
        add_product(line[static_cast<std::size_t>(i)].x, factor(i, p), point.x);
        add_product(line[static_cast<std::size_t>(i)].y, factor(i, p), point.y);
      }
    }
    for (int i = 0; i <= degree; ++i) {
      for (int j = 0; j <= degree; ++j) {
        add_product(x(i, j), factor(j, q), line[static_cast<std::size_t>(i)].x);
        add_product(y(i, j), factor(j, q), line[static_cast<std::size_t>(i)].y);
      }
    }
  }
  return {std::move(x), std::move(y)};
}

std::pair<TrianglePatch, TrianglePatch> triangle_piece(const CharacteristicNet<Interval>& net,
                                                       const LatticeCell& cell) {
  static const Matrix<Interval> factor = enclosed(bezier_of_box_spline());
  TrianglePatch x(box_degree);
  TrianglePatch y(box_degree);
  for (std::size_t column = 0; column < box_points.size(); ++column) {
    const auto [a, b] = box_points.at(column);
    const PlaneNumber<Interval> point =
        cell.upright ? net.at(cell.a + a, cell.b + b) : net.at(cell.a + 1 - a, cell.b + 1 - b);
    Eigen::Index row = 0;
    for (int i = 0; i <= box_degree; ++i) {
      for (int j = 0; i + j <= box_degree; ++j, ++row) {
        add_product(x(i, j), factor(row, static_cast<Eigen::Index>(column)), point.x);
        add_product(y(i, j), factor(row, static_cast<Eigen::Index>(column)), point.y);
      }
    }
  }
  return {std::move(x), std::move(y)};
}

SquarePatch jacobian(const CharacteristicNet<Interval>& net, const LatticeSpline& spline,
                     const LatticeCell& cell) {
  const auto determinant = [](const auto& x, const auto& y) {
    return derivative_u(x) * derivative_v(y) - derivative_v(x) * derivative_u(y);
  };
  if (spline.sides == 4) {
    const auto [x, y] = square_piece(net, spline.degree, cell);
    return determinant(x, y);
  }
  // A triangle that is not upright is turned by 180 degrees: both derivatives change their signs.
  const auto [x, y] = triangle_piece(net, cell);
  return over_square(determinant(x, y));
}

std::vector<std::vector<PlaneNumber<Interval>>> row_curve(const CharacteristicNet<Interval>& net,
                                                          const LatticeSpline& spline, int r) {
  std::vector<std::vector<PlaneNumber<Interval>>> result;
  for (int b = 0; b < r; ++b) {
    const int a = spline.sides == 4 ? r : r - 1 - b;
    if (b > a) break;
    std::vector<PlaneNumber<Interval>> piece;
    if (spline.sides == 4) {
      const auto [x, y] = square_piece(net, spline.degree, {a, b});
      for (int j = 0; j <= spline.degree; ++j) piece.push_back({x(0, j), y(0, j)});
    } else {  // the side of the upper triangle from (a + 1, b), its third corner, to (a, b + 1), its second
      const auto [x, y] = triangle_piece(net, {a, b, false});
      for (int i = 0; i <= box_degree; ++i) piece.push_back({x(i, box_degree - i), y(i, box_degree - i)});
    }
    result.push_back(std::move(piece));
  }
  return result;
}

}  // namespace subdiv
