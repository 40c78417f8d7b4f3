#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "host_sim/monitor/bus/frame_source.hpp"
#include "host_sim/monitor/fleet/node_view.hpp"

namespace host_sim::monitor {

/// Follows every node of a bus from its frames. By one thread; views are handed out as copies.
class Fleet {
 public:
  /// @param bit_rate_bit_s what the load of the bus is a share of
  explicit Fleet(double bit_rate_bit_s = 1e6);
  ~Fleet();

  void see(const SeenFrame& seen);
  /// Time passes without a frame: what is too old turns stale, nodes vanish.
  void tick(std::int64_t now_ns);
  void source_is(FrameSource::State state, const std::string& description);

  [[nodiscard]] const FleetView& view() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace host_sim::monitor
