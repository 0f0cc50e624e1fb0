#include "schemes/evaluate/curve_blocks.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

#include "schemes/evaluate/block_kernel.h"
#include "schemes/evaluate/parallel_chunks.h"

namespace subdiv {

namespace {

/// Points of a coordinate that are made at once, about: a few blocks that fit the fastest cache.
constexpr std::size_t points_at_once = 512;
/// Points that a thread takes at once, about: the first blocks of every level cost little beside them.
constexpr std::size_t points_of_chunk = std::size_t{1} << 17U;
/// So that partial sums take constant memory.
constexpr std::size_t most_partial_sums = 4096;
/// From this output on the stores go past the caches.
constexpr std::size_t large_output_bytes = std::size_t{1} << 24U;

long long floor_quotient(long long i, long long m) { return (i >= 0 ? i : i - m + 1) / m; }
long long ceiling_quotient(long long i, long long m) { return -floor_quotient(-i, m); }

template <class T>
std::size_t blocks_at_once(const BlockTable<T>& table) {
  return std::max<std::size_t>(1, points_at_once / table.outputs);
}

template <class T>
std::size_t points_at_once_of(const BlockStages<T>& stages) {
  return blocks_at_once(stages.tables.back()) * stages.tables.back().outputs;
}

/// How far p is behind the begin of a cache line.
template <class T>
std::size_t values_into_line(const T* p) {
  return reinterpret_cast<std::uintptr_t>(p) % cache_line / sizeof(T);
}

/// The most points that are needed at once of each level: level k is what table k is applied to.
template <class T>
std::vector<std::size_t> level_spans(const BlockStages<T>& stages) {
  std::vector<std::size_t> spans(stages.tables.size());
  std::size_t blocks = blocks_at_once(stages.tables.back());
  for (std::size_t k = spans.size(); k-- > 0;) {
    spans[k] = blocks + static_cast<std::size_t>(stages.tables[k].window.size()) - 1;
    if (k > 0) blocks = spans[k] / stages.tables[k - 1].outputs + 2;
  }
  return spans;
}

template <class T>
std::size_t level_capacity(const BlockStages<T>& stages, const std::vector<std::size_t>& spans,
                           std::size_t level) {
  if (level == 0) return spans[0];
  const BlockTable<T>& maker = stages.tables[level - 1];
  return spans[level] + 2 * maker.outputs + maker.padding();
}

template <class T>
std::size_t block_capacity(const BlockStages<T>& stages) {
  const std::size_t points = points_at_once_of(stages) + stages.tables.back().padding();
  return (points + line_values<T> - 1) / line_values<T> * line_values<T>;
}

/// work(begin, end) for the pieces of first .. last - 1 between multiples of a chunk.
template <class Work>
void for_each_part(std::size_t first, std::size_t last, int threads, const Work& work) {
  const std::size_t first_chunk = first / points_of_chunk;
  const std::size_t chunks = first < last ? (last - 1) / points_of_chunk + 1 - first_chunk : 0;
  for_each_chunk(chunks, threads, [&](std::size_t chunk) {
    const std::size_t begin = (first_chunk + chunk) * points_of_chunk;
    work(std::max(first, begin), std::min(last, begin + points_of_chunk));
  });
}

}  // namespace

// ---- A stream

template <class T>
BlockStream<T>::BlockStream(const CurveBlocks<T>& curve, std::size_t first, std::size_t last)
    : curve_(&curve), next_(first), last_(last), levels_(curve.stages().tables.size()) {
  const std::size_t dimension = curve.dimension();
  const std::vector<std::size_t> spans = level_spans(curve.stages());
  for (std::size_t k = 0; k < levels_.size(); ++k) {
    levels_[k].capacity = level_capacity(curve.stages(), spans, k);
    levels_[k].storage.resize(levels_[k].capacity * dimension);
    levels_[k].points.resize(dimension);
    levels_[k].ends.resize(dimension);
  }
  const std::size_t capacity = block_capacity(curve.stages());
  block_.resize(capacity * dimension);
  for (std::size_t c = 0; c < dimension; ++c) block_begins_.push_back(block_.data() + c * capacity);
  block_points_.resize(dimension);
}

template <class T>
CurveBlock<T> BlockStream<T>::next() {
  return next(block_begins_, {});
}

/// The next block in `out`, which has room for block_capacity; the copies are made meanwhile.
template <class T>
CurveBlock<T> BlockStream<T>::next(std::span<T* const> out, std::span<const detail::Copy<T>> copies) {
  const std::size_t first = next_;
  if (first >= last_) return {first, 0, block_points_};
  const BlockTable<T>& table = curve_->stages_.tables.back();
  const std::size_t parent = first / table.outputs;
  const std::size_t parents = std::min(blocks_at_once(table), (last_ - 1) / table.outputs + 1 - parent);
  apply(levels_.size() - 1, static_cast<long long>(parent), parents, out, copies);
  for (std::size_t c = 0; c < out.size(); ++c) block_points_[c] = out[c] + (first - parent * table.outputs);
  next_ = std::min(last_, (parent + parents) * table.outputs);
  return {first, next_ - first, block_points_};
}

template <class T>
void BlockStream<T>::write_cached(std::span<T* const> out) {
  const std::size_t first = next_;
  for (CurveBlock<T> block = next(); block.count > 0; block = next())
    for (std::size_t c = 0; c < out.size(); ++c)
      std::copy_n(block.coordinates[c], block.count, out[c] + (block.first - first));
}

/// Each block is copied while the next one is computed, in whole lines of `out`: what is left of a line waits
/// before the next block.
template <class T>
void BlockStream<T>::write_past_caches(std::span<T* const> out) {
  constexpr std::size_t line = line_values<T>;
  const std::size_t dimension = out.size();
  const std::size_t capacity = line + block_capacity(curve_->stages_);
  std::array<AlignedVector<T>, 2> blocks;
  std::array<std::vector<T*>, 2> begins;
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    blocks[k].resize(capacity * dimension);
    for (std::size_t c = 0; c < dimension; ++c) begins[k].push_back(blocks[k].data() + c * capacity + line);
  }
  std::vector<T*> to(out.begin(), out.end());  // where the next copy goes
  std::vector<std::size_t> waiting(dimension, 0);
  std::vector<detail::Copy<T>> copies(dimension);
  std::size_t turn = 0;
  for (CurveBlock<T> block = next(begins[turn], copies); block.count > 0;
       block = next(begins[turn], copies)) {
    turn = 1 - turn;
    for (std::size_t c = 0; c < dimension; ++c) {
      T* const from = begins[1 - turn][c] + (block.coordinates[c] - begins[1 - turn][c]) - waiting[c];
      std::copy_n(copies[c].from + copies[c].count, waiting[c], from);
      const std::size_t count = waiting[c] + block.count;
      const std::size_t left = std::min(count, values_into_line(to[c] + count));
      copies[c] = {from, to[c], count - left};
      to[c] += count - left;
      waiting[c] = left;
    }
  }
  for (std::size_t c = 0; c < dimension; ++c) {
    copies[c].count += waiting[c];
    detail::copy_past_caches(copies[c]);
  }
  detail::finish_copies();
}

/// Blocks parent .. parent + parents - 1 of a table; none or one copy for each coordinate meanwhile.
template <class T>
void BlockStream<T>::apply(std::size_t table, long long parent, std::size_t parents, std::span<T* const> out,
                           std::span<const detail::Copy<T>> copies) {
  const BlockTable<T>& rule = curve_->stages_.tables[table];
  const long long begin = parent + rule.window.first;
  require(table, begin, parent + static_cast<long long>(parents) + rule.window.last);
  const Level& level = levels_[table];
  for (std::size_t c = 0; c < out.size(); ++c) {
    detail::apply_table(rule, level.points[c] + (begin - level.begin), parents, out[c],
                        copies.empty() ? detail::Copy<T>() : copies[c]);
  }
}

/// Makes points begin .. end - 1 of a level available; begin never decreases.
template <class T>
void BlockStream<T>::require(std::size_t level, long long begin, long long end) {
  if (level == 0) return require_controls(begin, end);
  Level& points = levels_[level];
  const auto B = static_cast<long long>(curve_->stages_.tables[level - 1].outputs);
  if (begin > points.end || points.begin == points.end)
    points.begin = points.end = floor_quotient(begin, B) * B;
  if (end <= points.end) return;
  // What is needed no more makes room for whole blocks behind the rest.
  const long long dropped = std::clamp(begin - points.begin, 0LL, points.end - points.begin);
  const long long kept = points.end - points.begin - dropped;
  for (std::size_t c = 0; c < points.points.size(); ++c) {
    T* const values = points.storage.data() + c * points.capacity;
    std::copy(values + dropped, values + dropped + kept, values);
    points.points[c] = values;
    points.ends[c] = values + kept;
  }
  const long long blocks = ceiling_quotient(end - points.end, B);
  apply(level - 1, points.end / B, static_cast<std::size_t>(blocks), points.ends);
  points.begin += dropped;
  points.end += blocks * B;
}

/// The polygon's own memory where the points stand side by side in it; otherwise copies. Points beyond the
/// ends of an open polygon, which only weights zero are applied to, are zero.
template <class T>
void BlockStream<T>::require_controls(long long begin, long long end) {
  Level& points = levels_[0];
  const CoordinateArrays<T>& controls = *curve_->controls_;
  const Topology& topology = controls.topology;
  const auto count = static_cast<std::size_t>(end - begin);
  const auto first = -static_cast<long long>(topology.before);
  const long long last = first + static_cast<long long>(topology.points) - 1;
  const auto exists = [&](long long i) { return topology.closed || (first <= i && i <= last); };
  const bool side_by_side =
      exists(begin) && exists(end - 1) && topology.slot(begin) + count <= topology.points;
  for (std::size_t c = 0; c < points.points.size(); ++c) {
    const std::vector<T>& values = controls.coordinates[c];
    if (side_by_side) {
      points.points[c] = values.data() + topology.slot(begin);
      continue;
    }
    T* const copies = points.storage.data() + c * points.capacity;
    for (long long i = begin; i < end; ++i) copies[i - begin] = exists(i) ? values[topology.slot(i)] : T(0);
    points.points[c] = copies;
  }
  points.begin = begin;
  points.end = end;
}

// ---- A curve
// --------------------------------------------------------------------------------------------------

template <class T>
CurveBlocks<T>::CurveBlocks(BlockStages<T> stages, const CoordinateArrays<T>& controls)
    : stages_(std::move(stages)),
      controls_(&controls),
      size_(refined_points(controls.topology, stages_.arity, stages_.depth)) {
  for (const std::vector<T>& values : controls.coordinates) {
    if (values.size() != controls.topology.points) {
      throw std::invalid_argument("a coordinate has " + std::to_string(values.size()) + " values for " +
                                  std::to_string(controls.topology.points) + " points");
    }
  }
  require_points();
}

/// The control points that points 0 and size() - 1 depend on.
template <class T>
void CurveBlocks<T>::require_points() const {
  if (controls_->topology.closed || size_ == 0) return;
  long long first = 0;
  auto last = static_cast<long long>(size_) - 1;
  for (auto table = stages_.tables.rbegin(); table != stages_.tables.rend(); ++table) {
    const auto B = static_cast<long long>(table->outputs);
    first = ceiling_quotient(first - table->support.last, B);
    last = floor_quotient(last - table->support.first, B);
  }
  (void)controls_->topology.slot(first);
  (void)controls_->topology.slot(last);
}

template <class T>
IndexWindow CurveBlocks<T>::reach() const {
  IndexWindow reach{0, static_cast<int>(stages_.tables.back().outputs) - 1};
  for (auto table = stages_.tables.rbegin(); table != stages_.tables.rend(); ++table) {
    const auto B = static_cast<int>(table->outputs);
    reach = {floor_divide(reach.first, B) + table->window.first,
             floor_divide(reach.last, B) + table->window.last};
    const auto next = table + 1;
    if (next != stages_.tables.rend()) reach.last += static_cast<int>(next->outputs) - 1;
  }
  return reach;
}

template <class T>
std::size_t CurveBlocks<T>::stream_bytes() const {
  const std::vector<std::size_t> spans = level_spans(stages_);
  std::size_t values = block_capacity(stages_);
  for (std::size_t k = 0; k < spans.size(); ++k) values += level_capacity(stages_, spans, k);
  return values * dimension() * sizeof(T);
}

template <class T>
BlockStream<T> CurveBlocks<T>::stream(std::size_t first, std::size_t last) const {
  if (first > last || last > size_) {
    throw std::out_of_range("points " + std::to_string(first) + " to " + std::to_string(last) +
                            " of a curve of " + std::to_string(size_));
  }
  return BlockStream<T>(*this, first, last);
}

template <class T>
void CurveBlocks<T>::write(std::size_t first, std::size_t last, std::span<T* const> out,
                           const WriteOptions& options) const {
  if (out.size() != dimension()) throw std::invalid_argument("one array a coordinate is needed");
  (void)stream(first, last);
  const std::size_t bytes = (last - first) * dimension() * sizeof(T);
  const bool past_caches = options.stores == Stores::past_caches ||
                           (options.stores == Stores::chosen && bytes >= large_output_bytes);
  for_each_part(first, last, options.threads, [&](std::size_t begin, std::size_t end) {
    BlockStream<T> points = stream(begin, end);
    std::vector<T*> to(out.begin(), out.end());
    for (T*& p : to) p += begin - first;
    if (past_caches) {
      points.write_past_caches(to);
    } else {
      points.write_cached(to);
    }
  });
}

template <class T>
void CurveBlocks<T>::write_interleaved(std::size_t first, std::size_t last, T* out, int threads) const {
  (void)stream(first, last);
  for_each_part(first, last, threads, [&](std::size_t begin, std::size_t end) {
    for_each_block(begin, end, [&](const CurveBlock<T>& block) {
      const std::size_t dimension = block.coordinates.size();
      T* const to = out + (block.first - first) * dimension;
      for (std::size_t c = 0; c < dimension; ++c) {
        const T* const from = block.coordinates[c];
        for (std::size_t k = 0; k < block.count; ++k) to[k * dimension + c] = from[k];
      }
    });
  });
}

template <class T>
std::vector<double> CurveBlocks<T>::sum(int threads) const {
  // A chunk begins at a block, so that the blocks of a point, and its lane, are the same in any run.
  const std::size_t block_points = points_at_once_of(stages_);
  const std::size_t least_points = std::max(points_of_chunk, size_ / most_partial_sums);
  const std::size_t chunk_points = (least_points + block_points - 1) / block_points * block_points;
  const std::size_t chunks = (size_ + chunk_points - 1) / chunk_points;
  constexpr std::size_t lanes = detail::sum_lanes<T>;
  std::vector<double> sums(chunks * dimension(), 0.0);
  for_each_chunk(chunks, threads, [&](std::size_t chunk) {
    AlignedVector<T> partial(dimension() * lanes, T(0));
    const std::size_t begin = chunk * chunk_points;
    for_each_block(begin, std::min(size_, begin + chunk_points), [&](const CurveBlock<T>& block) {
      for (std::size_t c = 0; c < block.coordinates.size(); ++c)
        detail::add_to_lanes(block.coordinates[c], block.count, partial.data() + c * lanes);
    });
    for (std::size_t i = 0; i < partial.size(); ++i)
      sums[chunk * dimension() + i / lanes] += static_cast<double>(partial[i]);
  });
  std::vector<double> total(dimension(), 0.0);
  for (std::size_t i = 0; i < sums.size(); ++i) total[i % dimension()] += sums[i];
  return total;
}

template class BlockStream<double>;
template class BlockStream<float>;
template class CurveBlocks<double>;
template class CurveBlocks<float>;

}  // namespace subdiv
