#pragma once

#include <chrono>

namespace subdiv {

/// A point in time after which a computation stops and says what it has reached.
class Deadline {
 public:
  /// That many seconds from now, of a clock that never goes back.
  explicit Deadline(double seconds) : end_(Clock::now() + std::chrono::duration<double>(seconds)) {}

  [[nodiscard]] bool passed() const { return Clock::now() >= end_; }
  /// Seconds left, 0 when passed.
  [[nodiscard]] double left() const {
    const std::chrono::duration<double> rest = end_ - Clock::now();
    return rest.count() > 0 ? rest.count() : 0;
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::chrono::time_point<Clock, std::chrono::duration<double>> end_;
};

}  // namespace subdiv
