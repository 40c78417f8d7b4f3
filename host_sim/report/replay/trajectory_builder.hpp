#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host_sim/report/replay/report_data.hpp"

namespace host_sim {

/// Keeps at most `max_points` + 1 readings of a stream: every k-th and always the first and the
/// last, where k doubles when the room is used up.
class TrajectoryBuilder {
 public:
  /// `max_points` is rounded up to an even number of at least 2.
  explicit TrajectoryBuilder(std::size_t max_points = 1000);

  /// Adds a reading; time must not fall. Amortised constant time.
  void push(double time_s, double damage);

  [[nodiscard]] Trajectory finish() const;

 private:
  struct Reading {
    double time_s;
    double damage;
  };

  std::size_t max_points_;
  std::uint64_t stride_ = 1;
  std::uint64_t pushed_ = 0;
  Reading last_{};
  std::vector<Reading> kept_;
};

}  // namespace host_sim
