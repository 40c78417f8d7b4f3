#pragma once

#include <cstdint>

#include "hal/can_frame.hpp"
#include "hal/clock.hpp"

namespace app {

/// Bits that a classic frame takes on the bus at worst, with all stuff bits and the space behind
/// it (ISO 11898-1): 47 + 8 n and a stuff bit after each 4 of 34 + 8 n, or 67 and 54 where
/// extended.
constexpr std::uint32_t worst_bits(const hal::CanFrame& frame) {
  const std::uint32_t data = 8u * frame.length;
  return frame.extended ? 67 + data + (54 + data - 1) / 4 : 47 + data + (34 + data - 1) / 4;
}

/// Bounds the load of one node: in any span of time at most kBitsPerSecond times its length and
/// kBurstBits more. Room for one frame of 8 bytes is kept for what is urgent.
class BusBudget {
 public:
  static constexpr std::uint32_t kBitsPerSecond = 2'800;
  static constexpr std::uint32_t kBurstBits = 1'350;
  static constexpr std::uint32_t kReserveBits = 135;

  void start(hal::Time now) {
    credit_us_ = kFull_us;
    last_ = now;
  }

  void advance(hal::Time now) {
    const std::uint64_t elapsed_us = (now - last_).us;
    last_ = now;
    const std::uint32_t room_us = kFull_us - credit_us_;
    credit_us_ =
        elapsed_us < room_us ? credit_us_ + static_cast<std::uint32_t>(elapsed_us) : kFull_us;
  }

  [[nodiscard]] bool allows(std::uint32_t bits) const { return allows_urgent(bits + kReserveBits); }
  [[nodiscard]] bool allows_urgent(std::uint32_t bits) const {
    return credit_us_ >= bits * kBit_us;
  }
  /// Precondition: allows_urgent(bits).
  void spend(std::uint32_t bits) { credit_us_ -= bits * kBit_us; }

 private:
  /// Time that one bit has to be saved up for, rounded up.
  static constexpr std::uint32_t kBit_us = (1'000'000 + kBitsPerSecond - 1) / kBitsPerSecond;
  static constexpr std::uint32_t kFull_us = kBurstBits * kBit_us;

  std::uint32_t credit_us_ = 0;
  hal::Time last_{};
};

}  // namespace app
