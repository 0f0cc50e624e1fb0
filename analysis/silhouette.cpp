#include "analysis/silhouette.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>

namespace subdiv {
namespace {

using Piece = std::pair<double, double>;

/// Evenly spaced horizontal lines, at the middles of strips.
struct Lines {
  double bottom = 0;
  double spacing = 0;
  int count = 0;

  [[nodiscard]] double height(int i) const { return bottom + (i + 0.5) * spacing; }
};

Lines lines_over(std::span<const PictureTriangle> first, std::span<const PictureTriangle> second, int count) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const auto& picture : {first, second}) {
    for (const PictureTriangle& triangle : picture) {
      for (const Eigen::Vector2d& p : triangle) {
        low = std::min(low, p.y());
        high = std::max(high, p.y());
      }
    }
  }
  if (!(low < high)) return {};
  return {low, (high - low) / count, count};
}

/// The interval that the line at height y cuts from a triangle that it meets.
Piece cut(const PictureTriangle& triangle, double y) {
  Piece piece{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector2d& p = triangle[k];
    const Eigen::Vector2d& q = triangle[(k + 1) % 3];
    if ((p.y() <= y) == (q.y() <= y)) continue;
    const double x = p.x() + (y - p.y()) / (q.y() - p.y()) * (q.x() - p.x());
    piece.first = std::min(piece.first, x);
    piece.second = std::max(piece.second, x);
  }
  return piece;
}

/// Disjoint pieces in order, with the same union.
void unite(std::vector<Piece>& pieces) {
  std::sort(pieces.begin(), pieces.end());
  std::size_t kept = 0;
  for (const Piece& piece : pieces) {
    if (kept > 0 && piece.first <= pieces[kept - 1].second) {
      pieces[kept - 1].second = std::max(pieces[kept - 1].second, piece.second);
    } else {
      pieces[kept++] = piece;
    }
  }
  pieces.resize(kept);
}

/// For each line the disjoint pieces that the picture covers.
std::vector<std::vector<Piece>> covered(std::span<const PictureTriangle> picture, const Lines& lines) {
  std::vector<std::vector<Piece>> result(static_cast<std::size_t>(lines.count));
  for (const PictureTriangle& triangle : picture) {
    const auto [low, high] = std::minmax({triangle[0].y(), triangle[1].y(), triangle[2].y()});
    const int from = std::max(0, static_cast<int>((low - lines.bottom) / lines.spacing - 1));
    const int to = std::min(lines.count - 1, static_cast<int>((high - lines.bottom) / lines.spacing + 1));
    for (int i = from; i <= to; ++i) {
      const Piece piece = cut(triangle, lines.height(i));
      if (piece.first <= piece.second) result[static_cast<std::size_t>(i)].push_back(piece);
    }
  }
  for (auto& pieces : result) unite(pieces);
  return result;
}

double total(const std::vector<Piece>& pieces) {
  double sum = 0;
  for (const Piece& piece : pieces) sum += piece.second - piece.first;
  return sum;
}

/// The length that both cover.
double common(const std::vector<Piece>& a, const std::vector<Piece>& b) {
  double sum = 0;
  for (std::size_t i = 0, k = 0; i < a.size() && k < b.size();) {
    sum += std::max(0.0, std::min(a[i].second, b[k].second) - std::max(a[i].first, b[k].first));
    if (a[i].second < b[k].second) {
      ++i;
    } else {
      ++k;
    }
  }
  return sum;
}

}  // namespace

View view_from(const Eigen::Vector3d& direction) {
  const Eigen::Vector3d right = Eigen::Vector3d::UnitZ().cross(direction);
  if (!(right.norm() > 0)) throw std::invalid_argument("a view from straight above has no upright axis");
  const Eigen::Vector3d towards = direction.normalized();
  return {right.normalized(), towards.cross(right).normalized(), towards};
}

void append_quad(std::vector<PictureTriangle>& picture, const View& view, const Eigen::Vector3d& a,
                 const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d) {
  picture.push_back({view.project(a), view.project(b), view.project(c)});
  picture.push_back({view.project(a), view.project(c), view.project(d)});
}

PictureAreas compare_pictures(std::span<const PictureTriangle> first, std::span<const PictureTriangle> second,
                              int lines) {
  if (lines < 1) throw std::invalid_argument("pictures are compared along at least one line");
  const Lines all = lines_over(first, second, lines);
  const auto a = covered(first, all);
  const auto b = covered(second, all);
  PictureAreas areas;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double in_a = total(a[i]);
    const double in_b = total(b[i]);
    areas.first += in_a * all.spacing;
    areas.second += in_b * all.spacing;
    areas.difference += std::max(0.0, in_a + in_b - 2 * common(a[i], b[i])) * all.spacing;
  }
  return areas;
}

}  // namespace subdiv
