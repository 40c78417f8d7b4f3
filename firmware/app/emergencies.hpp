#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "firmware/protocol/messages.hpp"

namespace app {

/// Bits of the error register (CiA 301, 7.5.2.2).
namespace error_register {
inline constexpr std::uint8_t kGeneric = 1u << 0;
inline constexpr std::uint8_t kCurrent = 1u << 1;
inline constexpr std::uint8_t kCommunication = 1u << 4;
inline constexpr std::uint8_t kDeviceProfile = 1u << 5;
inline constexpr std::uint8_t kManufacturer = 1u << 7;
}  // namespace error_register

/// What is still to be reported on the bus of events that begin and end.
///
/// None is forgotten: an event waits until it is reported, and one that ended before is reported
/// all the same, followed by its end. There is a place for each event, so that there always is
/// room.
class Emergencies {
 public:
  using Code = protocol::EmergencyCode;

  /// The event is there, or it is not.
  void set(Code code, bool there) {
    const std::uint32_t bit = bit_of(code);
    if (there && (active_ & bit) == 0) {
      active_ |= bit;
      begun_ |= bit;
    } else if (!there && (active_ & bit) != 0) {
      active_ &= ~bit;
      ended_ = true;
    }
  }
  /// Forgets that what is active was reported.
  void report_again() { begun_ |= active_; }

  [[nodiscard]] bool active(Code code) const { return (active_ & bit_of(code)) != 0; }
  [[nodiscard]] bool waiting() const { return begun_ != 0 || ended_; }

  /// What to report next, without the damage; nothing if all is. Call reported() when it has left.
  [[nodiscard]] std::optional<protocol::Emergency> next() const {
    for (std::size_t i = 0; i < kCodes.size(); ++i) {
      if ((begun_ & (1u << i)) != 0) {
        return protocol::Emergency{kCodes[i], registers(active_ | (1u << i)), 0};
      }
    }
    if (ended_) {
      return protocol::Emergency{Code::none, registers(active_), 0};
    }
    return std::nullopt;
  }
  void reported() {
    if (begun_ != 0) {
      begun_ &= begun_ - 1;
    } else {
      ended_ = false;
    }
  }

 private:
  /// The most urgent first.
  static constexpr std::array kCodes{
      Code::emergency_stop, Code::tendon_broken, Code::overload,       Code::life_worn,
      Code::tendon_slack,   Code::life_replace,  Code::life_inspect,   Code::sensor,
      Code::parameters,     Code::settings,      Code::record_damaged, Code::storage,
      Code::deadline,       Code::bus,           Code::authority};
  static_assert(kCodes.size() <= 32);

  static constexpr std::uint32_t bit_of(Code code) {
    std::uint32_t bit = 1;
    for (const Code known : kCodes) {
      if (known == code) {
        return bit;
      }
      bit <<= 1;
    }
    return 0;
  }

  static constexpr std::uint8_t register_of(Code code) {
    switch (code) {
      case Code::none:
        return 0;
      case Code::overload:
      case Code::sensor:
        return error_register::kCurrent;
      case Code::bus:
        return error_register::kCommunication;
      case Code::tendon_broken:
      case Code::tendon_slack:
      case Code::life_inspect:
      case Code::life_replace:
      case Code::life_worn:
        return error_register::kDeviceProfile;
      case Code::emergency_stop:
      case Code::storage:
      case Code::record_damaged:
      case Code::parameters:
      case Code::settings:
      case Code::deadline:
      case Code::authority:
        return error_register::kManufacturer;
    }
    return 0;
  }

  static constexpr std::uint8_t registers(std::uint32_t events) {
    std::uint32_t bits = events != 0 ? error_register::kGeneric : 0u;
    for (std::size_t i = 0; i < kCodes.size(); ++i) {
      if ((events & (1u << i)) != 0) {
        bits |= register_of(kCodes[i]);
      }
    }
    return static_cast<std::uint8_t>(bits);
  }

  std::uint32_t active_ = 0;
  std::uint32_t begun_ = 0;
  bool ended_ = false;
};

}  // namespace app
