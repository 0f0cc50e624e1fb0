#pragma once

#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

#include "schemes/evaluate/control_grid.h"
#include "schemes/evaluate/ringing.h"

namespace subdiv {

/// Motions (js-report 13). A moving point is Ringing over time. Here every point of a control polygon moves
/// along a trajectory of its own, a row of a grid, by a Ringing a row: n rows keep 5 n points a level for
/// J_{a,b}. An animated curve is Ringing over polygon() at each frame; neighbouring frames bound the strips
/// of a surface.
template <class R, class Point>
class MovingPolygon {
 public:
  /// Stands at frame 0. `grid` must outlive the object. Throws std::invalid_argument when the rows differ in
  /// size or the depth is negative, std::out_of_range as Ringing does.
  MovingPolygon(const Scheme<R>& scheme, const ControlGrid<Point>& grid, int depth)
      : grid_(&grid), scheme_(scheme), depth_(depth) {
    require_grid(grid);
    if (depth < 0) throw std::invalid_argument("a refinement depth is at least 0");
    frames_ = refined_points(grid.columns(), scheme.arity(), depth);
    polygon_.topology = grid.rows;
    earlier_work_.assign(static_cast<std::size_t>(depth) + 1, 0);
    start();
  }

  /// The frames 0 .. frames() - 1 of the motion, at times i / m^depth.
  [[nodiscard]] std::size_t frames() const { return frames_; }
  [[nodiscard]] std::size_t frame() const { return frame_; }
  [[nodiscard]] bool done() const { return frame_ >= frames_; }
  /// The polygon of the current frame. Behind the last frame of closed trajectories stands the first again;
  /// behind the last one of open trajectories there is none.
  [[nodiscard]] const ControlPolygon<Point>& polygon() const { return polygon_; }

  /// Moves all points to the next frame. Moving past the end does nothing.
  void advance() {
    if (done()) return;
    ++frame_;
    if (!done()) {
      for (auto& motion : motions_) motion.advance();
      read();
    } else if (grid_->columns().closed) {
      for (const auto& motion : motions_) note_work(motion);
      start();
    }
  }

  /// The footprint: points kept at each level by all rings together, and levels. polygon() adds one point a
  /// row.
  [[nodiscard]] std::size_t points_per_level() const {
    std::size_t sum = 0;
    for (const auto& motion : motions_) sum += motion.points_per_level();
    return sum;
  }
  [[nodiscard]] std::size_t levels() const { return earlier_work_.size(); }
  [[nodiscard]] std::size_t rings() const { return motions_.size(); }
  /// The work so far: points that all rings of a level have loaded (level 0) or computed.
  [[nodiscard]] std::size_t computed(std::size_t level) const {
    std::size_t sum = earlier_work_[level];
    for (const auto& motion : motions_) sum += motion.computed(level);
    return sum;
  }

 private:
  void start() {
    motions_.clear();
    if (frames_ == 0) return;
    for (const ControlPolygon<Point>& line : grid_->lines) motions_.emplace_back(scheme_, line, depth_);
    read();
  }
  void read() {
    polygon_.points.clear();
    for (const auto& motion : motions_) polygon_.points.push_back(motion.point());
  }
  void note_work(const Ringing<R, Point>& motion) {
    for (std::size_t level = 0; level < earlier_work_.size(); ++level)
      earlier_work_[level] += motion.computed(level);
  }

  const ControlGrid<Point>* grid_;
  Scheme<R> scheme_;
  int depth_;
  std::size_t frames_ = 0;
  std::size_t frame_ = 0;
  std::vector<Ringing<R, Point>> motions_;  // one a row
  ControlPolygon<Point> polygon_;
  std::vector<std::size_t> earlier_work_;  // of rings that have been started anew
};

}  // namespace subdiv
