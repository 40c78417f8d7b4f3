#pragma once

#include <chrono>
#include <optional>
#include <span>

#include "host_sim/monitor/bus/frame_source.hpp"
#include "host_sim/monitor/fleet/fleet.hpp"
#include "host_sim/monitor/watch/observer.hpp"

namespace host_sim::monitor {

/// Follows a source until it is at its end and no observer outlives it, until an observer wants the
/// end, the program is interrupted, or `most` is over.
/// @throws InputError for a log that is none
void watch(FrameSource& source, Fleet& fleet, std::span<Observer* const> observers,
           std::optional<std::chrono::milliseconds> most = std::nullopt);

}  // namespace host_sim::monitor
