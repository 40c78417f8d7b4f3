#pragma once

#include <cstdint>

#include "hal/can_port.hpp"
#include "hal/clock.hpp"

namespace app {

/// Brings the controller back from bus-off, with a pause that doubles from 100 ms to 10 s while it
/// goes off again within ten seconds.
template <hal::CanPort CanT>
class BusWatch {
 public:
  explicit BusWatch(CanT& can) : can_(can) {}

  /// What has become of the bus since the last look.
  enum class Turn : std::uint8_t { none, went_off, came_back };

  Turn look(hal::Time now) {
    status_ = can_.status();
    const bool off = status_.state == hal::CanState::off;
    if (off && !off_) {
      off_ = true;
      pause_ = now < quiet_from_ ? doubled(pause_) : kShortest;
      retry_ = now + pause_;
      return Turn::went_off;
    }
    if (off && now >= retry_) {
      (void)can_.recover();
      pause_ = doubled(pause_);
      retry_ = now + pause_;
    }
    if (!off && off_) {
      off_ = false;
      quiet_from_ = now + kLongest;
      return Turn::came_back;
    }
    return Turn::none;
  }

  [[nodiscard]] const hal::CanStatus& status() const { return status_; }

 private:
  static constexpr hal::Time kShortest = hal::milliseconds(100);
  static constexpr hal::Time kLongest = hal::seconds(10);

  static constexpr hal::Time doubled(hal::Time pause) {
    return pause + pause < kLongest ? pause + pause : kLongest;
  }

  CanT& can_;
  hal::CanStatus status_;
  bool off_ = false;
  hal::Time pause_ = kShortest;
  hal::Time retry_{};
  hal::Time quiet_from_{};
};

}  // namespace app
