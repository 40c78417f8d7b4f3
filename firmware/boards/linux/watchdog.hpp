#pragma once

#include "firmware/boards/linux/lines.hpp"
#include "hal/devices.hpp"
#include "hal/linux/monotonic_clock.hpp"
#include "hal/linux/service_manager.hpp"

namespace board {

/// Toggles the watchdog pin at each feed, and feeds the watchdog of systemd.
class Watchdog {
 public:
  Watchdog(const std::optional<GpioConfig>& gpio, hal::linux_os::ServiceManager& manager)
      : pin_(gpio, &GpioConfig::watchdog), manager_(manager) {}

  void feed() {
    level_ = !level_;
    // A pin that fails is noticed by what it feeds.
    static_cast<void>(pin_.set(level_));
    manager_.alive(hal::linux_os::MonotonicClock().now());
  }

 private:
  OptionalOutput pin_;
  hal::linux_os::ServiceManager& manager_;
  bool level_ = false;
};
static_assert(hal::Watchdog<Watchdog>);

}  // namespace board
