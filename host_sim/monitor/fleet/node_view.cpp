#include "host_sim/monitor/fleet/node_view.hpp"

namespace host_sim::monitor {

std::uint64_t NodeView::integrity_failures() const {
  std::uint64_t failures = 0;
  for (const StreamView& stream : streams) {
    failures += stream.damaged + stream.malformed;
  }
  return failures;
}

}  // namespace host_sim::monitor
