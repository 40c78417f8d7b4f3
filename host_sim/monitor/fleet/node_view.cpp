#include "host_sim/monitor/fleet/node_view.hpp"

#include "host_sim/monitor/fleet/damage_watch.hpp"

namespace host_sim::monitor {

protocol::LifeState NodeView::life_state() const {
  return status ? graver(gravest_state, status->value.state) : protocol::LifeState::unknown;
}

std::uint64_t NodeView::integrity_failures() const {
  std::uint64_t failures = 0;
  for (const StreamView& stream : streams) {
    failures += stream.damaged + stream.malformed;
  }
  return failures;
}

}  // namespace host_sim::monitor
