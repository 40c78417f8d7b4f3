#include "host_sim/monitor/fleet/histories.hpp"

#include <utility>

namespace host_sim::monitor {
namespace {

void drop_every_second(std::deque<DamagePoint>& curve) {
  std::deque<DamagePoint> kept;
  for (std::size_t i = 0; i < curve.size(); i += 2) {
    kept.push_back(curve[i]);
  }
  curve = std::move(kept);
}

}  // namespace

void DamageCurve::add(NodeView& view, const DamagePoint& point) {
  std::deque<DamagePoint>& curve = view.curve;
  const std::size_t count = curve.size();
  if (count >= 2 && curve[count - 1].time_ns - curve[count - 2].time_ns < step_ns_) {
    curve.back() = point;
    return;
  }
  if (count == NodeView::kMostPoints) {
    drop_every_second(curve);
    step_ns_ *= 2;
  }
  curve.push_back(point);
}

void add_event(NodeView& view, Event event) {
  if (view.events.size() == NodeView::kMostEvents) {
    view.events.pop_front();
  }
  view.events.push_back(std::move(event));
}

}  // namespace host_sim::monitor
