#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "hal/result.hpp"
#include "lifemodel/quantity/units.hpp"

namespace hal::qemu_mps2 {

/// In place of a raw sample: there is none.
inline constexpr std::int32_t kNoSample = std::numeric_limits<std::int32_t>::min();

/// Gives the motor currents that the player has put there, raw values of lifemodel::MotorCurrent.
template <std::size_t kTendons>
class PlayedSensor {
 public:
  using Sample = lifemodel::MotorCurrent;

  void put(std::span<const std::int32_t, kTendons> raw) {
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      raw_[tendon] = raw[tendon];
    }
  }
  void set_failed(bool failed) { failed_ = failed; }

  Result<Sample> isr_read(std::size_t tendon) {
    if (failed_) {
      return Error::failed;
    }
    if (raw_[tendon] == kNoSample) {
      return Error::missing;
    }
    return Sample::from_raw(raw_[tendon]);
  }

 private:
  std::array<std::int32_t, kTendons> raw_{};
  bool failed_ = false;
};

}  // namespace hal::qemu_mps2
