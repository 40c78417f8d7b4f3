#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host_sim/report/replay/report_data.hpp"

namespace host_sim {

/// Keeps at most `max_points` turning points of a stream. While all fit, all are kept. Beyond that
/// the list is thinned: of every run of k neighbouring turning points only the lowest and the
/// highest stay, and k doubles when the room is used up. The extremes of the whole stream are
/// therefore always among the kept points, and the points stay spread over the whole time.
class TurningPointBuilder {
 public:
  /// `max_points` is rounded up to a multiple of 4, at least 4.
  explicit TurningPointBuilder(std::size_t max_points = 2000);

  /// Adds a turning point; time must not fall. Amortised constant time.
  void push(double time_s, double tension_N);

  [[nodiscard]] TurningPoints finish() const;

 private:
  /// The lowest and the highest of a run; the same point twice in a run of one.
  struct Run {
    TurningPoint low;
    TurningPoint high;
    bool single;
  };
  static void merge(Run& into, const Run& later);
  void halve();

  std::size_t max_runs_;
  std::uint64_t points_per_run_ = 2;
  std::uint64_t points_in_last_ = 0;
  std::uint64_t total_ = 0;
  std::vector<Run> runs_;
};

}  // namespace host_sim
