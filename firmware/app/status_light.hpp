#pragma once

#include <cstdint>

#include "firmware/protocol/messages.hpp"
#include "hal/clock.hpp"

namespace app {

/// What the status light shows: lit while all is well, one, two or three flashes every two seconds
/// as the life is used (inspect, replace, worn), even slow blinking when locked, broken or at
/// fault, and even fast blinking when asked to identify.
class StatusLight {
 public:
  void start(hal::Time now) { began_ = now; }

  void identify(hal::Time now, std::uint8_t duration_s) {
    identify_until_ = now + hal::seconds(duration_s);
  }

  [[nodiscard]] bool lit(hal::Time now, protocol::LifeState state, bool at_fault) {
    if (began_ + kPeriod <= now) {
      const hal::Time next = began_ + kPeriod;
      began_ = next + kPeriod <= now ? now : next;
    }
    const auto phase_ms = static_cast<std::uint32_t>((now - began_).us) / 1000;
    if (now < identify_until_) {
      return phase_ms / 50 % 2 == 0;
    }
    if (at_fault || state == protocol::LifeState::unknown) {
      return phase_ms / 500 % 2 == 0;
    }
    if (state == protocol::LifeState::normal) {
      return true;
    }
    const std::uint32_t flashes =
        static_cast<std::uint32_t>(state) - static_cast<std::uint32_t>(protocol::LifeState::normal);
    return phase_ms / 150 % 2 == 0 && phase_ms / 300 < flashes;
  }

 private:
  static constexpr hal::Time kPeriod = hal::seconds(2);
  hal::Time began_{};
  hal::Time identify_until_{};
};

}  // namespace app
