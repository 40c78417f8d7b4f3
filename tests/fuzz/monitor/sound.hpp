#pragma once

#include <algorithm>

#include "host_sim/monitor/bus/seen_frame.hpp"
#include "tests/fuzz/io/require.hpp"

namespace host_sim::fuzz {

/// What every reader of frames holds to.
inline void require_sound(const monitor::SeenFrame& seen) {
  const hal::CanFrame& frame = seen.frame;
  require(seen.time_ns >= 0);
  require(frame.length <= 8 && seen.fd_data.size() <= 64);
  require(frame.id <= (frame.extended || seen.error ? 0x1fff'ffffu : 0x7ffu));
  require(seen.flexible_data_rate || seen.fd_data.empty());
  require(!seen.flexible_data_rate || frame.length == 0);
  require(std::all_of(frame.data.begin() + frame.length, frame.data.end(),
                      [](std::byte byte) { return byte == std::byte{0}; }));
}

}  // namespace host_sim::fuzz
