#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/boards/qemu_mps2/image/recording.hpp"
#include "hal/error.hpp"
#include "hal/qemu_mps2/virtual_devices.hpp"
#include "lifemodel/extension/needs.hpp"
#include "lifemodel/extension/sample.hpp"
#include "lifemodel/numeric/sine.hpp"

namespace boards::qemu_mps2 {

/// Played motor currents in surroundings that follow a rule: the rotor swings by 1.5 turns either
/// way, a period in 1,000 samples, and the winding warms from 20 degrees by 1 a second at 1 kHz.
class SwingingDrive {
 public:
  using Sample = lifemodel::extension::DriveSample;
  static constexpr lifemodel::extension::Measured kMeasured{
      .velocity = true, .rotor = true, .sheath = true, .winding = true};

  void put(std::span<const std::int32_t, kTendons> raw) {
    currents_.put(raw);
    ++samples_;
  }
  void set_failed(bool failed) { currents_.set_failed(failed); }

  hal::Result<Sample> isr_read(std::size_t tendon) {
    const auto current = currents_.isr_read(tendon);
    if (!current) {
      return current.error();
    }
    return Sample{*current, covariates()};
  }

 private:
  [[nodiscard]] lifemodel::extension::Covariates covariates() const {
    constexpr std::uint32_t kThousandth = 4'294'967;
    constexpr std::int32_t kRoom = 20 << lifemodel::extension::Temperature::kFractionBits;
    const lifemodel::numeric::Phase phase = samples_ * kThousandth;
    lifemodel::extension::Covariates at;
    // 82 mm/s at most.
    at.velocity = lifemodel::Velocity::from_raw(
        static_cast<std::int32_t>((std::int64_t{lifemodel::numeric::sine(phase)} * 82) >> 16));
    at.rotor.raw = std::int64_t{lifemodel::numeric::cosine(phase)} * -6;
    at.sheath = lifemodel::extension::Temperature::from_raw(kRoom);
    at.winding = lifemodel::extension::Temperature::from_raw(
        kRoom + static_cast<std::int32_t>(samples_ * 66));
    return at;
  }

  hal::qemu_mps2::PlayedSensor<kTendons> currents_;
  std::uint32_t samples_ = 0;
};

}  // namespace boards::qemu_mps2
