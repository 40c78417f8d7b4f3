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

  /// Takes a frame; nodes that are silent by its time vanish.
  void see(const SeenFrame& seen);
  /// It is as late as this: nodes vanish, and what is too old turns stale. Before a view is shown.
  void tick(std::int64_t now_ns);
  void source_is(FrameSource::State state, const std::string& description);

  [[nodiscard]] const FleetView& view() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace host_sim::monitor
