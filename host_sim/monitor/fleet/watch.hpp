#pragma once

#include <chrono>
#include <optional>
#include <span>
#include <string>

#include "host_sim/monitor/bus/frame_source.hpp"
#include "host_sim/monitor/bus/seen_frame.hpp"
#include "host_sim/monitor/fleet/fleet.hpp"
#include "host_sim/monitor/fleet/node_view.hpp"

namespace host_sim::monitor {

/// What follows a bus beside the fleet: a view of it, a log, a page. Called by one thread, and has
/// to return soon.
class Observer {
 public:
  Observer() = default;
  Observer(const Observer&) = delete;
  Observer& operator=(const Observer&) = delete;
  virtual ~Observer() = default;

  /// Every frame, when the fleet has seen it.
  virtual void see(const SeenFrame& /*seen*/) {}
  /// What is known, at least ten times a second.
  virtual void update(const FleetView& /*view*/) {}
  /// The user has asked it to end.
  [[nodiscard]] virtual bool wants_end() { return false; }
  /// It is kept for what it shows when the log is at its end, until somebody ends it.
  [[nodiscard]] virtual bool outlives_log() const { return false; }
  /// Nothing more is seen: what is left to do is done, or trouble() says why not.
  virtual void finish() {}
  /// What keeps it from its work, for the user; empty where nothing does.
  [[nodiscard]] virtual std::string trouble() const { return {}; }
};

/// Follows a source until it is at its end and no observer outlives it, until an observer wants the
/// end, the program is interrupted, or `most` is over.
/// @throws InputError for a log that is none
void watch(FrameSource& source, Fleet& fleet, std::span<Observer* const> observers,
           std::optional<std::chrono::milliseconds> most = std::nullopt);

}  // namespace host_sim::monitor
