#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "host_sim/reference/cycle.hpp"

namespace host_sim::reference {

/// Four-point rainflow counting on a stream of turning points: of four successive points, the inner
/// two form a closed cycle when both lie within the closed interval of the outer two.
/// Points are compared, never subtracted, so that nesting is exact. Memory is bounded by the
/// residue.
class FourPointRainflow {
 public:
  /// Takes the next turning point and hands each cycle that it closes to `sink(Cycle)`.
  template <typename Sink>
  void push(double turning_point_N, Sink&& sink) {
    residue_.push_back(turning_point_N);
    while (residue_.size() >= 4 && inner_is_nested()) {
      const std::size_t n = residue_.size();
      sink(Cycle{residue_[n - 3], residue_[n - 2]});
      residue_[n - 3] = residue_[n - 1];
      residue_.resize(n - 2);
    }
  }

  /// The turning points that belong to no closed cycle, in order.
  std::span<const double> residue() const { return residue_; }

 private:
  bool inner_is_nested() const {
    const std::size_t n = residue_.size();
    const auto [outer_low, outer_high] = std::minmax(residue_[n - 4], residue_[n - 1]);
    const auto [inner_low, inner_high] = std::minmax(residue_[n - 3], residue_[n - 2]);
    return outer_low <= inner_low && inner_high <= outer_high;
  }

  std::vector<double> residue_;
};

}  // namespace host_sim::reference
