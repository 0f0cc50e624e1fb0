#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "schemes/evaluate/aligned_vector.h"
#include "schemes/evaluate/block_table.h"
#include "schemes/evaluate/control_polygon.h"

// Ringing in blocks: the rings of many levels become one ring, and a table makes a whole block of points from
// its window at once (block_table.h). Every point has the same operations in the same order wherever
// evaluation begins, on any number of threads and any instruction set: results are the same bits.

namespace subdiv {

/// Consecutive points of a curve: coordinate c of point first + k is coordinates[c][k], 0 <= k < count.
template <class T>
struct CurveBlock {
  std::size_t first = 0;                  ///< index of the first point
  std::size_t count = 0;                  ///< the number of points
  std::span<const T* const> coordinates;  ///< an array for each coordinate
};

template <class T>
class CurveBlocks;

namespace detail {
template <class T>
struct Copy;
}

/// The points of a part of a curve, block after block, in memory that depends on the scheme alone.
template <class T>
class BlockStream {
 public:
  /// The next block, valid until the next call; a block without points at the end.
  [[nodiscard]] CurveBlock<T> next();

 private:
  friend class CurveBlocks<T>;
  BlockStream(const CurveBlocks<T>& curve, std::size_t first, std::size_t last);

  /// Points begin .. end - 1 of a level between two tables, or of the control polygon.
  struct Level {
    long long begin = 0;
    long long end = 0;
    std::size_t capacity = 0;  // of a coordinate
    AlignedVector<T> storage;
    std::vector<const T*> points;  // of each coordinate: point `begin`
    std::vector<T*> ends;          // of each coordinate: where point `end` goes
  };
  void require(std::size_t level, long long begin, long long end);
  void require_controls(long long begin, long long end);
  void apply(std::size_t table, long long parent, std::size_t parents, std::span<T* const> out,
             std::span<const detail::Copy<T>> copies = {});
  CurveBlock<T> next(std::span<T* const> out, std::span<const detail::Copy<T>> copies);
  void write_cached(std::span<T* const> out);
  void write_past_caches(std::span<T* const> out);

  const CurveBlocks<T>* curve_;
  std::size_t next_;
  std::size_t last_;
  std::vector<Level> levels_;  // level k holds what table k is applied to
  AlignedVector<T> block_;
  std::vector<T*> block_begins_;  // of each coordinate
  std::vector<const T*> block_points_;
};

/// Which stores write large outputs. Past the caches is faster where the output is larger than they are, and
/// leaves them to others; `chosen` takes it from 16 MiB on.
enum class Stores { chosen, cached, past_caches };

/// How a whole curve is written; it changes no bit of it.
struct WriteOptions {
  int threads = 1;                 ///< at least 1
  Stores stores = Stores::chosen;  ///< which stores
};

/// A refined curve that is evaluated by blocks. T is double or float; any number of coordinates.
///
/// Coordinates that are not finite follow IEEE arithmetic. A weight of a table may be zero, and 0 times NaN
/// or infinity is NaN: a control point that is not finite spoils all points that depend on it, and may spoil
/// others of the blocks whose windows hold it. Beyond reach() it changes nothing.
template <class T>
class CurveBlocks {
 public:
  /// `controls` must outlive the object. Throws std::invalid_argument when a coordinate has not one value a
  /// point or the depth is negative; std::overflow_error beyond 2^62 points; std::out_of_range when an open
  /// polygon has too few added points.
  CurveBlocks(BlockStages<T> stages, const CoordinateArrays<T>& controls);
  template <class R>
  CurveBlocks(const Scheme<R>& scheme, const CoordinateArrays<T>& controls, int depth)
      : CurveBlocks(block_stages<T>(scheme, depth), controls) {}

  /// Points of the curve, and coordinates of a point.
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t dimension() const { return controls_->coordinates.size(); }
  [[nodiscard]] const BlockStages<T>& stages() const { return stages_; }
  /// Control points of other indices than t + first .. t + last do not change the points at parameters in
  /// [t, t + 1), t whole, not even when they are not finite.
  [[nodiscard]] IndexWindow reach() const;
  /// The footprint of one stream beside the tables, in bytes: what is kept of all levels, and the block.
  /// Writing past the caches takes two more blocks.
  [[nodiscard]] std::size_t stream_bytes() const;

  /// Points first .. last - 1. Throws std::out_of_range unless first <= last <= size().
  [[nodiscard]] BlockStream<T> stream(std::size_t first, std::size_t last) const;
  [[nodiscard]] BlockStream<T> stream() const { return stream(0, size()); }

  /// consume(const CurveBlock<T>&) for the blocks of points first .. last - 1 in their order.
  template <class Consumer>
  void for_each_block(std::size_t first, std::size_t last, Consumer&& consume) const {
    BlockStream<T> points = stream(first, last);
    for (CurveBlock<T> block = points.next(); block.count > 0; block = points.next()) consume(block);
  }

  /// Points first .. last - 1 into one array a coordinate, out[c][0] that of point `first`.
  void write(std::size_t first, std::size_t last, std::span<T* const> out,
             const WriteOptions& options = {}) const;
  /// The whole curve.
  void write(std::span<T* const> out, const WriteOptions& options = {}) const {
    write(0, size(), out, options);
  }
  /// Points first .. last - 1 with the coordinates of a point side by side, out[0] the first of point
  /// `first`.
  void write_interleaved(std::size_t first, std::size_t last, T* out, int threads = 1) const;

  /// The sum of all points, in each coordinate. Partial sums are of type T, in an order that does not depend
  /// on the threads; those of chunks are added in double.
  [[nodiscard]] std::vector<double> sum(int threads = 1) const;

 private:
  friend class BlockStream<T>;
  void require_points() const;

  BlockStages<T> stages_;
  const CoordinateArrays<T>* controls_;
  std::size_t size_ = 0;
};

extern template class BlockStream<double>;
extern template class BlockStream<float>;
extern template class CurveBlocks<double>;
extern template class CurveBlocks<float>;

}  // namespace subdiv
