#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "firmware/app/intake.hpp"
#include "firmware/app/models.hpp"
#include "hal/devices.hpp"
#include "lifemodel/extension/corrector.hpp"
#include "lifemodel/extension/sample.hpp"

namespace app {

/// A sensor of input tension for the application, made of one that gives the samples of
/// lifemodel::extension, DriveSample or SheathSample, or of motor current where nothing is measured
/// besides. Boards without extensions do without it.
template <class SensorT, std::size_t kTendons>
class ExtendedSensor {
 public:
  using Sample = Moving<lifemodel::Tension>;
  using Models = ExtendedModels<kTendons>;

  /// Both outlive this object.
  ExtendedSensor(SensorT& sensor, const Models& models)
      : ExtendedSensor(sensor, models, std::make_index_sequence<kTendons>{}) {}

  hal::Result<Sample> isr_read(std::size_t tendon) {
    const auto sample = sensor_.isr_read(tendon);
    if (!sample) {
      correctors_[tendon].gap();
      return sample.error();
    }
    const auto& whole = extended(*sample);
    return Sample{correctors_[tendon].input_tension(whole, flags_[tendon]), whole.at.velocity};
  }
  /// The control loop left out periods, so that no tendon has a rate.
  void isr_missed() {
    for (auto& corrector : correctors_) {
      corrector.gap();
    }
  }
  /// What became of the samples of a tendon since the last call.
  [[nodiscard]] lifemodel::Flags isr_flags(std::size_t tendon) {
    return std::exchange(flags_[tendon], {});
  }

  /// The cycles that the sheath of a tendon has seen.
  void start_at(std::size_t tendon, std::uint64_t cycles) {
    constexpr std::uint64_t kHighest = 0xffffffffu;
    correctors_[tendon].start_at(static_cast<std::uint32_t>(cycles < kHighest ? cycles : kHighest));
  }

 private:
  static lifemodel::extension::DriveSample extended(lifemodel::MotorCurrent current) {
    return {current, {}};
  }
  template <class Extended>
  static const Extended& extended(const Extended& sample) {
    return sample;
  }

  template <std::size_t... kTendon>
  ExtendedSensor(SensorT& sensor, const Models& models, std::index_sequence<kTendon...>)
      : sensor_(sensor),
        correctors_{lifemodel::extension::Corrector(models[kTendon].nominal,
                                                    models[kTendon].extension)...} {}

  SensorT& sensor_;
  std::array<lifemodel::extension::Corrector, kTendons> correctors_;
  std::array<lifemodel::Flags, kTendons> flags_{};
};

}  // namespace app
