#include "analysis/mesh/derivative_bound.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace subdiv {
namespace {

using Complex = std::complex<double>;

constexpr double unit_roundoff = std::numeric_limits<double>::epsilon();
constexpr double rounding = 1e-12;  // relative, of a few operations

/// The sums over the four residue classes are 1.
bool reproduces_constants(const LatticeMask<Rational>& mask) {
  std::array<Rational, 4> sums;
  for (int i = -mask.last(); i <= mask.last(); ++i) {
    for (int j = -mask.last(); j <= mask.last(); ++j)
      sums.at(2 * static_cast<std::size_t>(std::abs(i % 2)) + static_cast<std::size_t>(std::abs(j % 2))) +=
          mask(i, j);
  }
  return std::ranges::all_of(sums, [](const Rational& sum) { return sum == Rational(1); });
}

/// Points of the plane net as doubles, with a bound of their errors.
class RoundedNet {
 public:
  /// margin: the rows before the first spoke.
  RoundedNet(const CharacteristicNet<Interval>& net, int margin)
      : net_(net),
        margin_(margin),
        points_(static_cast<std::size_t>(net.rings() + 1) *
                static_cast<std::size_t>(net.rings() + margin_ + 1)) {
    for (int a = 0; a <= net.rings(); ++a) {
      for (int b = -margin_; b <= net.rings(); ++b) {
        const int ring = b < 0 && net.sides() == 3 ? a : net.ring_of(a, std::abs(b));
        if (ring > net.rings() || (net.sides() == 3 && a + b < 0)) continue;
        const PlaneNumber<Interval> p = net.at(a, b);
        at(a, b) = {p.x.to_double(), p.y.to_double()};
        radius_ = std::max({radius_, p.x.radius(), p.y.radius()});
        size_ = std::max(size_, std::abs(at(a, b)));
      }
    }
  }
  [[nodiscard]] const Complex& operator()(int a, int b) const { return points_[slot(a, b)]; }
  /// Of a point, and of a difference of two: rounding to double and subtraction, with room to spare.
  [[nodiscard]] double error() const { return 4 * (unit_roundoff * size_ + radius_); }

 private:
  [[nodiscard]] Complex& at(int a, int b) { return points_[slot(a, b)]; }
  [[nodiscard]] std::size_t slot(int a, int b) const {
    return static_cast<std::size_t>(a) * static_cast<std::size_t>(net_.rings() + margin_ + 1) +
           static_cast<std::size_t>(b + margin_);
  }
  const CharacteristicNet<Interval>& net_;
  int margin_;
  std::vector<Complex> points_;
  double radius_ = 0;
  double size_ = 0;
};

struct Disc {
  Complex centre;
  double radius = 0;
};

/// Where the limit of values lies on the square (a, b).
template <class Value>
Disc disc_of(const LatticeWindow& window, int a, int b, double error, Value&& value) {
  const Complex centre = value(a + window.reference.a, b + window.reference.b);
  double spread = 0;
  for (int i = 0; i < window.size.a; ++i) {
    for (int j = 0; j < window.size.b; ++j)
      spread = std::max(spread, std::norm(value(a + window.first.a + i, b + window.first.b + j) - centre));
  }
  return {centre, (window.factor * (std::sqrt(spread) + 2 * error) + error) * (1 + rounding)};
}

/// The sign of the determinant of any two vectors in the discs, times a number below its least modulus over
/// the product of the discs' outer radii; 0 when it may vanish.
double sign_of_determinant(const Disc& u, const Disc& v) {
  const double at_centres = (std::conj(u.centre) * v.centre).imag();
  const double far_u = std::abs(u.centre) + u.radius;
  const double far_v = std::abs(v.centre) + v.radius;
  const double error = u.radius * far_v + v.radius * far_u + rounding * far_u * far_v;
  return std::abs(at_centres) > error ? at_centres : 0;
}

/// The matrices A_e, and c.
struct Steps {
  std::vector<Matrix<double>> matrices;
  Eigen::Index reference = 0;
};

/// Words are prolonged until rho is at most `contraction`, up to a length and a number of products in all.
struct Words {
  double contraction;
  int length;
  int products;
};

/// alpha and rho of a product, with or without j = c.
struct Sums {
  double alpha;
  double rho;
};
Sums sums_of(const Matrix<double>& product, Eigen::Index reference, bool all) {
  Matrix<double> part = product;
  if (!all) part.col(reference).setZero();
  const double alpha = part.row(reference).cwiseAbs().sum();
  part.rowwise() -= part.row(reference).eval();
  return {alpha, part.cwiseAbs().rowwise().sum().maxCoeff()};
}

/// A bound of the rounding errors of the sums, k = length: k (n + 2) roundings of numbers up to norm^k, and n
/// of them in a sum, with room to spare.
double error_of_sums(const Steps& steps, int length) {
  constexpr int room = 8;
  double norm = 1;
  for (const Matrix<double>& m : steps.matrices)
    norm = std::max(norm, m.cwiseAbs().rowwise().sum().maxCoeff());
  const auto n = static_cast<double>(steps.matrices.front().rows());
  return room * length * (n + 2) * n * unit_roundoff * std::pow(norm, length);
}

/// Visits words as described: leaf(product) for those that are not prolonged.
template <class Leaf>
void visit_words(const Steps& steps, const Words& words, const Matrix<double>& product, int length,
                 int& products, Leaf&& leaf) {
  if (length > 0 && (length == words.length || products <= 0 ||
                     sums_of(product, steps.reference, false).rho <= words.contraction)) {
    leaf(product);
    return;
  }
  for (const Matrix<double>& m : steps.matrices) {
    --products;
    visit_words(steps, words, m * product, length + 1, products, leaf);
  }
}

std::optional<double> difference_factor(const Steps& steps, const Words& words) {
  const double error = error_of_sums(steps, words.length);
  const Eigen::Index n = steps.matrices.front().rows();
  double factor = 0;
  int products = words.products;
  visit_words(steps, words, Matrix<double>::Identity(n, n), 0, products, [&](const Matrix<double>& product) {
    const auto [alpha, rho] = sums_of(product, steps.reference, false);
    const double contraction = rho + error;
    factor = std::max(factor, contraction < 1 ? (alpha + error) / (1 - contraction) * (1 + rounding)
                                              : std::numeric_limits<double>::infinity());
    if (!std::isfinite(factor)) products = 0;  // one word is enough
  });
  if (!std::isfinite(factor)) return std::nullopt;
  return factor;
}

/// The mask as a product c(i, j) = p(i) r(j) of masks with the sums 2, if it is one.
using CurveMask = std::vector<Rational>;  // from index -last on
std::optional<std::pair<CurveMask, CurveMask>> tensor_factors(const LatticeMask<Rational>& mask) {
  const int last = mask.last();
  const std::size_t size = 2 * static_cast<std::size_t>(last) + 1;
  CurveMask first(size);
  CurveMask second(size);
  const auto slot = [&](int i) {
    const int index = i + last;
    return static_cast<std::size_t>(index);
  };
  const Rational half(1, 2);
  for (int i = -last; i <= last; ++i) {
    for (int j = -last; j <= last; ++j) {
      first[slot(i)] += half * mask(i, j);
      second[slot(j)] += half * mask(i, j);
    }
  }
  for (int i = -last; i <= last; ++i) {
    for (int j = -last; j <= last; ++j) {
      if (mask(i, j) != first[slot(i)] * second[slot(j)]) return std::nullopt;
    }
  }
  return std::pair{std::move(first), std::move(second)};
}

/// The norm max sum_j |b_j| on the unit interval of a scheme of curves that reproduces constants, with the
/// window first .. first + size - 1.
std::optional<double> curve_norm(const CurveMask& mask, int last, int first, int size) {
  Steps steps;
  steps.reference = size / 2;
  for (const int e : {0, 1}) {
    Matrix<double> half = Matrix<double>::Zero(size, size);
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        const int slot = last + e + first + row - 2 * (first + column);
        if (0 <= slot && slot <= 2 * last)
          half(row, column) = mask[static_cast<std::size_t>(slot)].to_double();
      }
    }
    steps.matrices.push_back(std::move(half));
  }
  constexpr int length = 14;
  constexpr int products = 20000;
  const Words words{0.1, length, products};
  const std::optional<double> factor = difference_factor(steps, words);
  if (!factor) return std::nullopt;
  const double error = error_of_sums(steps, length);
  double norm = 0;
  int left = products;
  visit_words(steps, words, Matrix<double>::Identity(size, size), 0, left,
              [&](const Matrix<double>& product) {
                const auto [alpha, rho] = sums_of(product, steps.reference, true);
                norm = std::max(norm, (alpha + error + *factor * (rho + error)) * (1 + rounding));
              });
  return norm;
}

/// The winding number from discs that contain consecutive pieces of the curve from the first spoke to the
/// bisector: it is the mode up to a multiple of the valence.
std::optional<int> winding_of(const std::vector<Disc>& discs, int mode, int valence) {
  double angle = 0;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const double share = discs[i].radius / std::abs(discs[i].centre);
    constexpr double eighth_of_a_turn = std::numbers::sqrt2 / 2 - 0.01;
    if (!(share < eighth_of_a_turn)) return std::nullopt;
    // Two discs in a row have a point of the curve in common and are seen from 0 under less than a quarter of
    // a turn each: the angle between their centres is the one below half a turn.
    if (i > 0) angle += std::arg(std::conj(discs[i - 1].centre) * discs[i].centre);
  }
  // The ends of the curve are less than an eighth of a turn away from the centres of the first and last disc.
  const double turns = angle / std::numbers::pi - static_cast<double>(mode) / valence;
  return mode + valence * static_cast<int>(std::lround(turns));
}

}  // namespace

std::optional<LatticeWindow> lattice_window(const LatticeMask<Rational>& mask) {
  if (!reproduces_constants(mask)) return std::nullopt;
  const int last = mask.last();
  LatticeOffset low{last, last};
  LatticeOffset high{-last, -last};
  for (int i = -last; i <= last; ++i) {
    for (int j = -last; j <= last; ++j) {
      if (is_zero(mask(i, j))) continue;
      low = {std::min(low.a, i), std::min(low.b, j)};
      high = {std::max(high.a, i), std::max(high.b, j)};
    }
  }
  LatticeWindow window{{1 - high.a, 1 - high.b}, {high.a - low.a, high.b - low.b}, {0, 0}, 0};
  // Windows of squares side by side have to share points for limits to be continuous across their border.
  if (window.size.a < 2 || window.size.b < 2) return std::nullopt;
  window.reference = {window.first.a + window.size.a / 2, window.first.b + window.size.b / 2};
  if (const auto factors = tensor_factors(mask)) {
    const std::optional<double> first = curve_norm(factors->first, last, window.first.a, window.size.a);
    if (!first) return std::nullopt;
    const std::optional<double> second = curve_norm(factors->second, last, window.first.b, window.size.b);
    if (!second) return std::nullopt;
    window.factor = *first * *second * (1 + rounding);
    return window;
  }
  const int n = window.size.a * window.size.b;
  Steps steps;
  steps.reference = (window.size.a / 2) * window.size.b + window.size.b / 2;
  for (const LatticeOffset e : {LatticeOffset{0, 0}, {0, 1}, {1, 0}, {1, 1}}) {
    Matrix<double> quarter = Matrix<double>::Zero(n, n);
    for (int row = 0; row < n; ++row) {
      for (int column = 0; column < n; ++column) {
        const int i =
            e.a + window.first.a + row / window.size.b - 2 * (window.first.a + column / window.size.b);
        const int j =
            e.b + window.first.b + row % window.size.b - 2 * (window.first.b + column % window.size.b);
        if (mask.contains(i, j)) quarter(row, column) = mask(i, j).to_double();
      }
    }
    steps.matrices.push_back(std::move(quarter));
  }
  constexpr int length = 8;
  constexpr int products = 4000;
  const std::optional<double> factor = difference_factor(steps, Words{0.4, length, products});
  if (!factor) return std::nullopt;
  window.factor = *factor;
  return window;
}

std::optional<LatticeMask<Rational>> derivative_scheme(const LatticeMask<Rational>& mask,
                                                       bool first_direction) {
  const int last = mask.last();
  LatticeMask<Rational> result(last);
  for (int line = -last; line <= last; ++line) {
    Rational quotient;
    for (int i = -last; i <= last; ++i) {
      quotient = (first_direction ? mask(i, line) : mask(line, i)) - quotient;
      if (i < last) (first_direction ? result(i + 1, line) : result(line, i + 1)) = Rational(2) * quotient;
    }
    if (!is_zero(quotient)) return std::nullopt;
  }
  return result;
}

std::optional<DerivativeBounds> derivative_bounds(const LatticeMask<Rational>& mask) {
  const LatticeMask<Rational> own = trimmed(mask);
  const std::optional<LatticeMask<Rational>> first = derivative_scheme(own, true);
  const std::optional<LatticeMask<Rational>> second = derivative_scheme(own, false);
  if (!first || !second) return std::nullopt;
  const std::optional<LatticeWindow> along = lattice_window(*first);
  if (!along) return std::nullopt;
  const std::optional<LatticeWindow> across = lattice_window(*second);
  if (!across) return std::nullopt;
  const std::optional<LatticeWindow> position = lattice_window(own);
  if (!position) return std::nullopt;
  return DerivativeBounds{*position, {*along, *across}};
}

CharacteristicMap enclosed_verdict(CharacteristicNet<Interval> net, const LatticeMask<Interval>& mask,
                                   const DerivativeBounds& bounds, int levels) {
  const bool quads = net.sides() == 4;
  const int reach = mask.last() - 1;
  // Quads: the squares between rows r and 2 r. Triangles: those with r <= a + b <= 2 r + 1 cover the ring
  // between the rows r + 1 and 2 r + 2; r is so large that windows stay in the two sectors at the spoke.
  const int r = quads ? reach + 1 : 2 * reach + 1;
  const int row = quads ? r : r + 1;
  std::vector<LatticeOffset> squares;
  for (int a = 0; a <= 2 * r + 1; ++a) {
    for (int b = 0; b <= a; ++b) {
      const int at = net.ring_of(a, b);
      if (r <= at && at <= (quads ? 2 * r - 1 : 2 * r + 1)) squares.push_back({a, b});
    }
  }
  CharacteristicMap map;
  map.mode = net.mode();
  map.eigenvalue = net.eigenvalue();
  map.rigour = Rigour::certified;
  SignsFound signs;
  signs.open = true;
  for (int level = 0; level <= levels && !signs.both(); ++level) {
    extend(net, mask, ((2 * row + 2) << level) + 2 * mask.last() + 2);
    const RoundedNet points(net, mask.last() + 1);
    if (!map.winding) {
      std::vector<Disc> curve;
      const int from = row << level;
      for (int b = 0; 2 * b < (quads ? 2 * from : from); ++b) {
        curve.push_back(disc_of(bounds.position, quads ? from : from - 1 - b, b, points.error(),
                                [&](int i, int j) { return points(i, j); }));
      }
      map.winding = winding_of(curve, net.mode(), net.valence());
    }
    std::vector<LatticeOffset> open;
    for (const auto& [a, b] : squares) {
      const Disc u = disc_of(bounds.derivatives[0], a, b, points.error(),
                             [&](int i, int j) { return points(i + 1, j) - points(i, j); });
      const Disc v = disc_of(bounds.derivatives[1], a, b, points.error(),
                             [&](int i, int j) { return points(i, j + 1) - points(i, j); });
      const double sign = sign_of_determinant(u, v);
      signs.positive = signs.positive || sign > 0;
      signs.negative = signs.negative || sign < 0;
      if (sign != 0) continue;
      for (const auto& [i, j] : {LatticeOffset{0, 0}, {0, 1}, {1, 0}, {1, 1}})
        open.push_back({2 * a + i, 2 * b + j});
    }
    squares = std::move(open);
    map.method = "discs of derivatives, " + std::to_string(level + 1) + " levels";
    if (squares.empty() && map.winding) break;
  }
  signs.open = !squares.empty();
  if (signs.both()) {
    map.regular = map.injective = Decision::no;
  } else if (!signs.open) {
    map.regular = Decision::yes;
    if (map.winding) map.injective = std::abs(*map.winding) == 1 ? Decision::yes : Decision::no;
  }
  return map;
}

}  // namespace subdiv
