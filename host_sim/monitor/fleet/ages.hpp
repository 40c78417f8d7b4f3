#pragma once

#include <cstdint>

#include "firmware/protocol/schema/frames.hpp"
#include "host_sim/monitor/fleet/node_view.hpp"

namespace host_sim::monitor {

/// A value is stale when it is older than so many cycles of its frame, a node has vanished when
/// nothing was heard for so many heartbeats.
inline constexpr std::int64_t kCycles = 3;

/// Three cycle times of a frame.
constexpr std::int64_t limit_ns(const protocol::schema::Frame& frame) {
  return kCycles * frame.cycle_ms * 1'000'000;
}

inline constexpr std::int64_t kVanished_ns = limit_ns(protocol::schema::kHeartbeatFrame);

/// Marks what is older than its limit at `now_ns`, and all of a node that has vanished. The pages
/// share one frame and come in turn, so a page has as many cycles as there are pages; the tendons
/// and the bins share one page each, and come in turn there.
void mark_stale(NodeView& view, std::int64_t now_ns);

}  // namespace host_sim::monitor
