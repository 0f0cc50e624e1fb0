#include "experiments/lecture_notes.h"

#include <iterator>
#include <numeric>

#include <fmt/format.h>

#include "experiments/lecture_note_parts.h"

namespace subdiv {
namespace notes {

std::vector<Combination> control_points(int n) {
  std::vector<Combination> points;
  for (int i = 0; i <= n; ++i) points.push_back(control_point(i));
  return points;
}

std::string to_string(const Combination& point) {
  std::int64_t denominator = 1;
  for (const Rational& weight : point.coefficients()) {
    while (!(weight * Rational(denominator)).is_integer()) ++denominator;
  }
  std::string text;
  for (int i = point.first(); i <= point.last(); ++i) {
    const Rational weight = point[i] * Rational(denominator);
    if (is_zero(weight)) continue;
    const std::string factor = weight == Rational(1) ? "" : weight.to_string() + " ";
    text += fmt::format("{}{}P{}", text.empty() ? "" : " + ", factor, i);
  }
  return denominator == 1 ? text : fmt::format("({})/{}", text, denominator);
}

}  // namespace notes

std::span<const ClaimHead> lecture_note_heads() {
  static const std::vector<ClaimHead> all = [] {
    std::vector<ClaimHead> heads;
    for (const auto part : {notes::bezier_heads(), notes::spline_heads(), notes::mesh_heads()})
      heads.insert(heads.end(), part.begin(), part.end());
    return heads;
  }();
  return all;
}

Results run_lecture_notes() {
  Results results = notes::run_bezier();
  for (Results part : {notes::run_splines(), notes::run_meshes()}) {
    std::ranges::move(part.claims, std::back_inserter(results.claims));
    std::ranges::move(part.series, std::back_inserter(results.series));
    std::ranges::move(part.figures, std::back_inserter(results.figures));
  }
  return results;
}

}  // namespace subdiv
