#include "experiments/verifier/cover.h"

#include <algorithm>
#include <set>
#include <sstream>

namespace subdiv::verifier {
namespace {

std::size_t size_of(int degree) { return static_cast<std::size_t>(degree) + 1; }

/// The number of entries between neighbours along the axis.
std::size_t stride(const std::vector<int>& degrees, std::size_t axis) {
  std::size_t result = 1;
  for (std::size_t k = axis + 1; k < degrees.size(); ++k) result *= size_of(degrees[k]);
  return result;
}

Rational binomial(int n, int k) {
  Rational result(1);
  for (int i = 1; i <= k; ++i) result *= Rational(n - k + i, i);
  return result;
}

/// Every line of entries along the axis sent through `map`, in place.
template <class Map>
void along(std::vector<Rational>& table, const std::vector<int>& degrees, std::size_t axis, Map map) {
  const std::size_t step = stride(degrees, axis);
  const std::size_t length = size_of(degrees[axis]);
  std::vector<Rational> line(length);
  for (std::size_t begin = 0; begin < table.size(); ++begin) {
    if (begin / step % length != 0) continue;
    for (std::size_t i = 0; i < length; ++i) line[i] = table[begin + i * step];
    line = map(line);
    for (std::size_t i = 0; i < length; ++i) table[begin + i * step] = line[i];
  }
}

/// From coefficients of powers of x to Bernstein coefficients over the range; over [lo, inf) of the
/// polynomial in u times (1 - u)^n, x = lo + u/(1 - u).
std::vector<Rational> to_bernstein(const std::vector<Rational>& powers, const Range& range) {
  const int n = static_cast<int>(powers.size()) - 1;
  const auto at = [](auto& v, int i) -> auto& { return v[static_cast<std::size_t>(i)]; };
  const Rational width = range.upper ? *range.upper - range.lower : Rational(1);
  std::vector<Rational> shifted(powers.size());
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= i; ++j) {
      at(shifted, j) += at(powers, i) * binomial(i, j) * pow(range.lower, i - j) * pow(width, j);
    }
  }
  std::vector<Rational> result(powers.size());
  for (int j = 0; j <= n; ++j) {
    for (int k = j; k <= (range.upper ? n : j); ++k) {
      at(result, k) += at(shifted, j) * (range.upper ? binomial(k, j) : Rational(1)) / binomial(n, j);
    }
  }
  return result;
}

/// Whether coefficients that are nowhere negative make a polynomial that is positive at every point of the
/// cell but its open ends: on each of the smallest faces that hold a point of the cell, one ends' choice for
/// each axis with a closed end, some coefficient is positive.
bool is_positive_on_faces(const Cover& cover, const Cell& cell, const std::vector<Rational>& coefficients) {
  std::vector<std::size_t> faces{0};  // by axis two bits: 1 the lower end, 2 the upper end, 0 neither
  for (std::size_t axis = 0; axis < cover.degrees.size(); ++axis) {
    const auto [lower_open, upper_open] = cell.open[axis];
    std::vector<std::size_t> more;
    for (const std::size_t face : faces) {
      if (!lower_open) more.push_back(face | std::size_t{1} << (2 * axis));
      if (!upper_open) more.push_back(face | std::size_t{2} << (2 * axis));
      if (lower_open && upper_open) more.push_back(face);
    }
    faces = std::move(more);
  }
  const auto on_face = [&](std::size_t entry, std::size_t face) {
    for (std::size_t axis = 0; axis < cover.degrees.size(); ++axis) {
      const std::size_t n = size_of(cover.degrees[axis]);
      const std::size_t i = entry / stride(cover.degrees, axis) % n;
      const std::size_t end = face >> (2 * axis) & 3U;
      if ((end == 1 && i != 0) || (end == 2 && i != n - 1)) return false;
    }
    return true;
  };
  return std::all_of(faces.begin(), faces.end(), [&](std::size_t face) {
    for (std::size_t entry = 0; entry < coefficients.size(); ++entry) {
      if (coefficients[entry].sign() > 0 && on_face(entry, face)) return true;
    }
    return false;
  });
}

void walk(const Cover& cover, const Cell& cell, std::istringstream& tokens) {
  std::string token;
  need(static_cast<bool>(tokens >> token), "the cover is cut off");
  const auto axis = std::find(cover.names.begin(), cover.names.end(), token);
  if (axis == cover.names.end()) {
    need(holds(cover, cell, token), "the sign is not proved on a cell");
    return;
  }
  const auto [first, second] = halves(cover, cell, static_cast<std::size_t>(axis - cover.names.begin()));
  walk(cover, first, tokens);
  walk(cover, second, tokens);
}

}  // namespace

std::pair<Cover, Cell> pose(Condition condition, bool strict, std::vector<Sparse> polynomials,
                            const Ranges& ranges) {
  std::set<std::string> names;
  for (const Sparse& p : polynomials) {
    for (const auto& [m, c] : p) {
      for (const auto& factor : m) names.insert(factor.first);
    }
  }
  Cover cover{condition, strict, {names.begin(), names.end()}, {}};
  Cell cell;
  std::size_t size = 1;
  for (const std::string& x : cover.names) {
    need(ranges.contains(x), "no range for " + x);
    const Range& range = ranges.at(x);
    long low = 0;
    long high = 0;
    for (const Sparse& p : polynomials) {
      for (const auto& [m, c] : p) {
        low = std::min(low, power_of(m, x));
        high = std::max(high, power_of(m, x));
      }
    }
    if (low < 0) {  // an even power of what is not 0 changes no sign
      need(range.lower.sign() > 0 || (range.upper && range.upper->sign() < 0),
           x + " may be 0 in a denominator");
      const long even = -low + (-low) % 2;
      for (Sparse& p : polynomials) p = p * Sparse{{{{x, even}}, Rational(1)}};
      high += even;
    }
    need(high <= 500 && cover.degrees.size() < 16, "too high a degree, or too many variables");
    cover.degrees.push_back(static_cast<int>(high));
    cell.open.emplace_back(range.lower_open, range.upper_open);
    size *= size_of(cover.degrees.back());
    need(size <= 1000000, "too many coefficients");
  }
  for (const Sparse& p : polynomials) {
    std::vector<Rational> table(size);
    for (const auto& [m, c] : p) {
      std::size_t place = 0;
      for (std::size_t axis = 0; axis < cover.names.size(); ++axis) {
        place += static_cast<std::size_t>(power_of(m, cover.names[axis])) * stride(cover.degrees, axis);
      }
      table[place] = c;
    }
    for (std::size_t axis = 0; axis < cover.names.size(); ++axis) {
      const Range& range = ranges.at(cover.names[axis]);
      along(table, cover.degrees, axis,
            [&](const std::vector<Rational>& line) { return to_bernstein(line, range); });
    }
    cell.coefficients.push_back(std::move(table));
  }
  return {std::move(cover), std::move(cell)};
}

std::pair<Cell, Cell> halves(const Cover& cover, const Cell& cell, std::size_t axis) {
  std::pair<Cell, Cell> result{cell, cell};
  result.first.open[axis].second = false;
  result.second.open[axis].first = false;
  const auto casteljau = [](std::vector<Rational> line, bool first) {
    std::vector<Rational> half(line.size());
    const Rational middle(1, 2);
    for (std::size_t k = 0; k < half.size(); ++k) {
      const std::size_t last = half.size() - 1 - k;
      if (first) {
        half[k] = line[0];
      } else {
        half[last] = line[last];
      }
      for (std::size_t i = 0; i < last; ++i) line[i] = (line[i] + line[i + 1]) * middle;
    }
    return half;
  };
  for (std::size_t p = 0; p < cell.coefficients.size(); ++p) {
    along(result.first.coefficients[p], cover.degrees, axis,
          [&](const auto& line) { return casteljau(line, true); });
    along(result.second.coefficients[p], cover.degrees, axis,
          [&](const auto& line) { return casteljau(line, false); });
  }
  return result;
}

bool holds(const Cover& cover, const Cell& cell, const std::string& token) {
  const auto& all = cell.coefficients;
  const std::vector<Rational>& bound = all.back();
  std::size_t entry = 0;
  Rational sign(1);
  if (cover.condition == Condition::peak) {
    const bool names_entry = token.size() > 1 && token.size() < 8 && (token[0] == '+' || token[0] == '-') &&
                             token.find_first_not_of("0123456789", 1) == std::string::npos;
    need(names_entry, "a cell of the cover names no entry: " + token);
    entry = std::stoul(token.substr(1));
    need(entry + 1 < all.size(), "there is no entry " + token);
    sign = Rational(token[0] == '+' ? 1 : -1);
  } else {
    need(token == ".", "unknown cell " + token);
    if (cover.condition == Condition::nonzero) {
      const auto first =
          std::find_if(all[0].begin(), all[0].end(), [](const Rational& c) { return c.sign() != 0; });
      if (first == all[0].end()) return false;
      sign = Rational(first->sign());
    }
  }
  std::vector<Rational> margin = bound;
  for (std::size_t i = 0; i < bound.size(); ++i) {
    if (cover.condition == Condition::rows) {
      for (std::size_t p = 0; p + 1 < all.size(); ++p) margin[i] -= abs(all[p][i]);
    } else {
      margin[i] = sign * all[entry][i] - bound[i];
    }
    if (margin[i].sign() < 0) return false;
  }
  return !cover.strict || is_positive_on_faces(cover, cell, margin);
}

void check_cover(const Cover& cover, const Cell& cell, std::string_view tokens) {
  std::istringstream stream{std::string(tokens)};
  walk(cover, cell, stream);
  std::string more;
  need(!(stream >> more), "the cover has too many cells");
}

}  // namespace subdiv::verifier
