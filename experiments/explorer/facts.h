#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/explorer/jspline_exponent.h"

namespace subdiv::explorer {

/// What `reproduce` has proved of the smoothness of *J_{a,b}, as the page carries it.
struct Facts {
  /// *J_s is C^order exactly for lower < s < upper, or for s = lower = upper.
  struct Range {
    int order;
    Rational lower;
    Rational upper;
    std::string claim;
  };
  /// On the line p a + q b = r: limits are C^order exactly for lower < b < upper.
  struct Line {
    int order;
    std::array<Rational, 3> line;
    Rational lower;
    Rational upper;
    std::string claim;

    [[nodiscard]] bool contains(const Rational& a, const Rational& b) const {
      return line[0] * a + line[1] * b == line[2];
    }
  };
  /// A closed cell in which the scheme is C^order throughout, or nowhere.
  struct Cell {
    int order;
    bool smooth;
    std::array<Rational, 2> a;
    std::array<Rational, 2> b;
  };
  std::vector<Range> ranges;
  std::vector<Line> lines;
  std::vector<Cell> cells;
  bool c2_is_decided = false;  // limits are C2 on the diagonal's and the lines' ranges alone: smooth.ab.c2
};

/// One fact a line: "range 2 0 4 CLAIM", "line 1 1 0 2 -1 7 CLAIM", "cell 1 in -2.7 -2.6 0 1", "c2-decided".
/// Throws std::invalid_argument for anything else.
[[nodiscard]] Facts parse_facts(std::string_view text);

/// What is proved of the limits of *J_{a,b}: they are C^proved (-1: nothing is known) and not C^refuted
/// (-1: nothing is known). Decided when refuted = proved + 1.
struct Continuity {
  int proved = -1;
  int refuted = -1;
  std::string reason;               // in words
  std::vector<std::string> claims;  // ids
};
[[nodiscard]] Continuity continuity(const Facts& facts, const Rational& a, const Rational& b);

/// What is proved of the exponent: both ends, where there are any.
struct ExponentBounds {
  std::optional<Rational> lower;
  std::optional<Rational> upper;
  std::string formula;  // where the exponent has a closed form
  std::string reason;
};
[[nodiscard]] ExponentBounds exponent_bounds(const Facts& facts, const Rational& a, const Rational& b);

}  // namespace subdiv::explorer
