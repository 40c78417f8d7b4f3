#pragma once

#include "hal/digital.hpp"

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
    if (locked_ != applied_ || !obeyed_) {
      apply();
    }
  }

  /// The controller is going down: drive off, brake on.
  void stop() {
    locked_ = true;
    apply();
  }

  [[nodiscard]] bool pulled() const { return pulled_; }
  [[nodiscard]] bool locked() const { return locked_; }
  /// False while the lines do not do what they have to; it is tried again at each check.
  [[nodiscard]] bool obeyed() const { return obeyed_; }

 private:
  void apply() {
    // Off before the brake closes, on after it has opened.
    const hal::Error first = locked_ ? devices_.drive_enable.set(false) : devices_.brake.set(false);
    const hal::Error second = locked_ ? devices_.brake.set(true) : devices_.drive_enable.set(true);
    obeyed_ = first == hal::Error::none && second == hal::Error::none;
    applied_ = locked_;
  }

  Devices& devices_;
  bool pulled_ = false;
  bool locked_ = false;
  bool applied_ = true;
  bool obeyed_ = false;
};

}  // namespace app
