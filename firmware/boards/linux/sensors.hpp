#pragma once

#include <memory>
#include <variant>

#include "firmware/boards/linux/config.hpp"
#include "firmware/boards/linux/profile_sensor.hpp"
#include "firmware/boards/linux/setup.hpp"
#include "hal/linux/iio.hpp"

namespace board {

/// What the profiles of a configuration hold. Throws hal::files::InputError.
hal::files::InputKind profile_kind(const Config& config);

/// Whether the samples are motor current. Throws hal::files::InputError.
bool measures_current(const Config& config);

/// Plays the profiles of a configuration. Throws hal::files::InputError.
template <class SampleT>
ProfileSensor<SampleT> profile_sensor(const Setup& setup) {
  std::vector<RecordedSamples<SampleT>> tendons;
  for (std::size_t i = 0; i < setup.parameters.size(); ++i) {
    tendons.push_back(read_samples<SampleT>(setup.config.tendons[i].profile, setup.parameters[i]));
  }
  return {std::move(tendons), setup.config.sensor.at_end == AtEnd::repeat};
}

/// Motor current of whatever source the configuration names.
class CurrentSensor {
 public:
  using Sample = lifemodel::MotorCurrent;

  /// Throws hal::linux_os::DeviceError or hal::files::InputError.
  explicit CurrentSensor(const Setup& setup);

  hal::Result<Sample> isr_read(std::size_t tendon) {
    if (auto* const profile = std::get_if<ProfileSensor<Sample>>(&source_)) {
      return profile->isr_read(tendon);
    }
    if (auto* const buffer = std::get_if<std::unique_ptr<hal::linux_os::IioBuffer>>(&source_)) {
      return (*buffer)->isr_read(tendon);
    }
    return std::get<hal::linux_os::IioSysfs>(source_).isr_read(tendon);
  }
  [[nodiscard]] bool at_end() const {
    const auto* const profile = std::get_if<ProfileSensor<Sample>>(&source_);
    return profile != nullptr && profile->at_end();
  }

 private:
  using Source = std::variant<ProfileSensor<Sample>, hal::linux_os::IioSysfs,
                              std::unique_ptr<hal::linux_os::IioBuffer>>;
  static Source open(const Setup& setup);

  Source source_;
};
static_assert(hal::CurrentSensor<CurrentSensor>);

}  // namespace board
