#pragma once

#include <cstdint>

#include "host_sim/monitor/fleet/node_view.hpp"

namespace host_sim::monitor {

/// Keeps the damage curve of a view within kMostPoints: points come a step apart, and when there is
/// no room every second one goes and the step doubles. The last point is always the newest.
class DamageCurve {
 public:
  /// Two points are at least so far apart at first: the cycle of the status.
  static constexpr std::int64_t kFirstStep_ns = 100'000'000;

  void add(NodeView& view, const DamagePoint& point);

 private:
  std::int64_t step_ns_ = kFirstStep_ns;
};

/// Puts an event behind the others; where there is no room the oldest goes.
void add_event(NodeView& view, Event event);

}  // namespace host_sim::monitor
