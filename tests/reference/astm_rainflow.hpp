#pragma once

#include <cstddef>
#include <vector>

#include "host_sim/reference/cycle.hpp"

namespace host_sim::reference::testing {

/// Three-point rainflow counting, ASTM E1049-85 clause 5.4.4, on a stream of turning points.
/// Memory is bounded by the ranges that are still open.
class AstmRainflow {
 public:
  /// Takes the next turning point. Each cycle that it completes goes to `sink(Cycle, Extent)`: half
  /// cycles contain the starting point of the history, full cycles do not.
  template <typename Sink>
  void push(double turning_point_N, Sink&& sink) {
    points_.push_back(turning_point_N);
    while (points_.size() >= 3 && last_range_is_not_smaller()) {
      const std::size_t n = points_.size();
      if (n == 3) {
        sink(Cycle{points_[0], points_[1]}, Extent::kHalf);
        points_.erase(points_.begin());
      } else {
        sink(Cycle{points_[n - 3], points_[n - 2]}, Extent::kFull);
        points_[n - 3] = points_[n - 1];
        points_.resize(n - 2);
      }
    }
  }

  /// Hands every range still open to `sink` as a half cycle; the counter itself does not change.
  template <typename Sink>
  void rest(Sink&& sink) const {
    for (std::size_t i = 1; i < points_.size(); ++i) {
      sink(Cycle{points_[i - 1], points_[i]}, Extent::kHalf);
    }
  }

 private:
  /// X >= Y of the clause. Both ranges start at the point between them, so that their far ends
  /// decide it without the rounding of a difference.
  bool last_range_is_not_smaller() const {
    const std::size_t n = points_.size();
    const bool rising = points_[n - 1] > points_[n - 2];
    return rising ? points_[n - 1] >= points_[n - 3] : points_[n - 1] <= points_[n - 3];
  }

  std::vector<double> points_;
};

}  // namespace host_sim::reference::testing
