#pragma once

#include "host_sim/monitor/fleet/node_view.hpp"

namespace host_sim::monitor::test {

/// Node 5 with one of everything, at 10 s.
inline FleetView made_view() {
  constexpr std::int64_t kS = 1'000'000'000;
  namespace detail = protocol::detail;
  FleetView fleet;
  fleet.now_ns = 10 * kS;
  fleet.source = "can0";
  fleet.bit_rate_bit_s = 1e6;
  fleet.frames = 42;
  fleet.bus_load_percent = 1.5;
  NodeView& node = fleet.nodes[5];
  node.node = 5;
  node.last_seen_ns = 9 * kS;
  node.highest_damage_ppb = 123'456'789;
  node.heartbeat = {protocol::NmtState::operational, 9 * kS, false};
  node.status = {protocol::LifeStatus{.state = protocol::LifeState::inspect,
                                      .damage_ppb = 123'456'789,
                                      .worst_tendon = 2,
                                      .storage_ok = true},
                 9 * kS, true};
  node.identity = {detail::Identity{1, 0x12, 0xdeadbeef}, 8 * kS, false};
  node.remaining = {detail::RemainingLife{15, 65534, 0xffff}, 8 * kS, false};
  node.tendons[2] = {detail::TendonDamage{2, 1, protocol::LifeState::normal}, 8 * kS, false};
  node.bins[64 * 2 + 8 * 3 + 4] = {detail::RainflowBin{2, 3, 4, 31, 77}, 8 * kS, false};
  StreamView stream;
  stream.frame = "LifeStatus";
  stream.good = 90;
  stream.lost = 2;
  stream.damaged = 3;
  stream.intervals[20] = 89;
  node.streams.push_back(stream);
  node.events.push_back({EventKind::state, kS, "inspect", protocol::LifeState::inspect});
  node.curve.push_back({kS, 123'000'000, std::nullopt});
  node.curve.push_back({9 * kS, 123'456'789, 5});
  return fleet;
}

}  // namespace host_sim::monitor::test
