#pragma once

#include <cstdint>

#include "hal/clock.hpp"
#include "hal/devices.hpp"

namespace app {

/// The emergency stop: holds the drive off and the brake on, from the first sight of it until the
/// next start with the stop released. An input that cannot be read counts as a stop.
template <class Devices>
class Safety {
 public:
  explicit Safety(Devices& devices) : devices_(devices) {}

  /// Lets the drive go, unless the stop is pulled.
  void start() { check(); }

  void check() {
    const auto asserted = devices_.emergency_stop.asserted();
    pulled_ = !asserted || *asserted;
    locked_ = locked_ || pulled_;
    apply();
  }

  /// The controller is going down: drive off, brake on.
  void stop() {
    locked_ = true;
    apply();
  }

  [[nodiscard]] bool pulled() const { return pulled_; }
  [[nodiscard]] bool locked() const { return locked_; }
  /// False while the lines do not do what they have to; they are set again at each check.
  [[nodiscard]] bool obeyed() const { return obeyed_; }

 private:
  void apply() {
    obeyed_ = hal::set_motion(devices_.drive_enable, !locked_, devices_.brake, locked_) ==
              hal::Error::none;
  }

  Devices& devices_;
  bool pulled_ = false;
  bool locked_ = false;
  bool obeyed_ = false;
};

/// Whether the control loop runs, and whether it was late.
class Liveness {
 public:
  /// Without a period for so long the control loop is dead.
  static constexpr hal::Time kDead = hal::milliseconds(100);
  /// For so long after a missed period it counts as late.
  static constexpr hal::Time kLate = hal::seconds(10);

  void start(hal::Time now) { moved_ = now; }

  /// `periods` counts the periods of the loop and wraps.
  bool alive(hal::Time now, std::uint32_t periods) {
    if (periods != periods_) {
      periods_ = periods;
      moved_ = now;
    }
    return now < moved_ + kDead;
  }

  /// `missed` counts the periods that were left out and wraps.
  bool late(hal::Time now, std::uint32_t missed) {
    if (missed != missed_) {
      missed_ = missed;
      late_until_ = now + kLate;
    }
    return now < late_until_;
  }

 private:
  std::uint32_t periods_ = 0;
  std::uint32_t missed_ = 0;
  hal::Time moved_{};
  hal::Time late_until_{};
};

}  // namespace app
