#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "schemes/algebra/algebraic.h"
#include "schemes/evaluate/speed_steps.h"

namespace subdiv {

/// How far coordinates may be off in double: `relative` times the greatest coordinate of the net, and `tiny`
/// times the least positive double, by which products near 0 are rounded whatever their size.
struct RoundingBound {
  double relative = 0;  ///< times the greatest coordinate
  double tiny = 0;      ///< times the least positive double

  /// Rounded up.
  [[nodiscard]] double of(double greatest) const;
};

/// The speeds of some steps, with the rules of each in double: every weight is rounded once, from an
/// enclosure of the exact one.
class SpeedSchedule {
 public:
  /// Speeds sigma_k; none for no steps. Throws InputError for a speed outside (0, 1), and for one within
  /// 2^-64 of 0 or 1, beyond which nothing of a ring is left in double.
  explicit SpeedSchedule(std::vector<Algebraic> speeds);

  [[nodiscard]] std::size_t size() const { return speeds_.size(); }
  [[nodiscard]] const std::vector<Algebraic>& speeds() const { return speeds_; }
  [[nodiscard]] std::span<const SpeedStep<double>> steps() const { return steps_; }
  /// Of the vertex in each step (paper (1)).
  [[nodiscard]] std::vector<VertexWeights<double>> weights(int valence) const;
  /// The width in parameters of the narrowest of the rings and the hole, where the first border has width 1:
  /// the least of sigma_k prod_{i < k} (1 - sigma_i) and prod (1 - sigma_i).
  [[nodiscard]] double least_width() const { return least_width_; }
  /// No coefficient of a ring or of the last border is farther from that of the exact rules: the errors of
  /// weights, products and sums, followed through all steps. For rounding to nearest, without overflow.
  [[nodiscard]] RoundingBound rounding(int valence) const;

 private:
  std::vector<Algebraic> speeds_;
  std::vector<Interval> enclosures_;
  std::vector<SpeedStep<double>> steps_;
  double least_width_ = 1;
};

}  // namespace subdiv
