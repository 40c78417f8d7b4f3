#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "firmware/app/intake.hpp"
#include "firmware/boards/linux/config.hpp"
#include "firmware/boards/linux/setup.hpp"
#include "firmware/boards/linux/surroundings.hpp"
#include "hal/devices.hpp"
#include "hal/error.hpp"
#include "hal/files/profile.hpp"
#include "hal/linux/iio.hpp"
#include "hal/linux/monotonic_clock.hpp"
#include "lifemodel/block/parameter_block.hpp"
#include "lifemodel/extension/needs.hpp"
#include "lifemodel/extension/sample.hpp"

namespace boards::linux_controller {

/// The samples of a profile, one for each period of the loop. Periods without a row, and values
/// that the sample cannot hold, are holes.
template <class SampleT>
struct RecordedSamples {
  std::vector<SampleT> samples;
  std::vector<bool> holes;  ///< as long as `samples`
};

/// Longest recording that is played, in samples.
inline constexpr std::size_t kMostSamples = 50'000'000;

/// What the profiles hold, the same for all. Throws hal::files::InputError where they differ.
hal::files::InputKind kind_of(std::span<const std::filesystem::path> profiles);

/// Reads a whole profile of this kind. Its rows must be a whole number of periods apart, to a tenth
/// of a period. Throws hal::files::InputError.
template <class SampleT>
RecordedSamples<SampleT> read_samples(const std::filesystem::path& path,
                                      const lifemodel::Parameters& parameters);

extern template RecordedSamples<lifemodel::MotorCurrent> read_samples(const std::filesystem::path&,
                                                                      const lifemodel::Parameters&);
extern template RecordedSamples<lifemodel::Tension> read_samples(const std::filesystem::path&,
                                                                 const lifemodel::Parameters&);
extern template RecordedSamples<app::OutputTension> read_samples(const std::filesystem::path&,
                                                                 const lifemodel::Parameters&);
extern template RecordedSamples<lifemodel::extension::DriveSample> read_samples(
    const std::filesystem::path&, const lifemodel::Parameters&);
extern template RecordedSamples<lifemodel::extension::SheathSample> read_samples(
    const std::filesystem::path&, const lifemodel::Parameters&);

/// Plays recordings in place of a sensor, one a tendon and one sample a call, from memory.
template <class SampleT>
class ProfileSensor {
 public:
  using Sample = SampleT;

  ProfileSensor(std::vector<RecordedSamples<SampleT>> tendons, bool repeat)
      : tendons_(std::move(tendons)), next_(tendons_.size(), 0), repeat_(repeat) {}

  /// missing in a hole, and after the end.
  hal::Result<Sample> isr_read(std::size_t tendon) {
    if (tendon >= tendons_.size()) {
      return hal::Error::out_of_range;
    }
    const RecordedSamples<SampleT>& recorded = tendons_[tendon];
    std::size_t& next = next_[tendon];
    if (next == recorded.samples.size()) {
      if (!repeat_) {
        return hal::Error::missing;
      }
      next = 0;
    }
    const std::size_t at = next++;
    if (recorded.holes[at]) {
      return hal::Error::missing;
    }
    return recorded.samples[at];
  }

  /// True once every recording has been played, never where they are repeated.
  [[nodiscard]] bool at_end() const {
    for (std::size_t i = 0; i < tendons_.size(); ++i) {
      if (repeat_ || next_[i] < tendons_[i].samples.size()) {
        return false;
      }
    }
    return true;
  }

 private:
  std::vector<RecordedSamples<SampleT>> tendons_;
  std::vector<std::size_t> next_;
  bool repeat_;
};

/// What the profiles of a configuration hold. Throws hal::files::InputError.
hal::files::InputKind profile_kind(const Config& config);

/// What the sensor of a configuration gives. Throws hal::files::InputError.
lifemodel::extension::Input input_of(const Config& config);

/// What it gives of a tendon besides. Throws hal::files::InputError.
lifemodel::extension::Measured measured_by(const Config& config, const TendonConfig& tendon);

/// Whether the samples are motor current. Throws hal::files::InputError.
bool measures_current(const Config& config);

/// Plays the profiles of a configuration. Throws hal::files::InputError.
template <class SampleT>
ProfileSensor<SampleT> profile_sensor(const Setup& setup) {
  std::vector<RecordedSamples<SampleT>> tendons;
  for (std::size_t i = 0; i < setup.models.size(); ++i) {
    tendons.push_back(
        read_samples<SampleT>(setup.config.tendons[i].profile, setup.models[i].nominal));
  }
  return {std::move(tendons), setup.config.sensor.at_end == AtEnd::repeat};
}

/// Motor current of IIO.
class CurrentSensor {
 public:
  using Sample = lifemodel::MotorCurrent;

  /// Throws hal::linux_os::DeviceError.
  /// @pre the configuration has no profiles
  explicit CurrentSensor(const Setup& setup);

  hal::Result<Sample> isr_read(std::size_t tendon) {
    if (auto* const buffer = std::get_if<std::unique_ptr<hal::linux_os::IioBuffer>>(&source_)) {
      return (*buffer)->isr_read(tendon);
    }
    return std::get<hal::linux_os::IioSysfs>(source_).isr_read(tendon);
  }

 private:
  using Source = std::variant<hal::linux_os::IioSysfs, std::unique_ptr<hal::linux_os::IioBuffer>>;
  static Source open(const Setup& setup);

  Source source_;
};
static_assert(hal::CurrentSensor<CurrentSensor>);

/// Motor current of IIO and what it was taken in, for an extended model.
class DriveSensor {
 public:
  using Sample = lifemodel::extension::DriveSample;

  /// Throws hal::linux_os::DeviceError.
  explicit DriveSensor(const Setup& setup) : current_(setup), surroundings_(setup.config) {}

  hal::Result<Sample> isr_read(std::size_t tendon) {
    // The current is taken in any case, so that no old one is left in a buffer.
    const auto current = current_.isr_read(tendon);
    if (!current) {
      return current.error();
    }
    const auto at = surroundings_.isr_read(tendon, clock_.now());
    return at ? hal::Result<Sample>(Sample{*current, *at}) : at.error();
  }
  /// Of the other thread.
  void poll(hal::Time now) { surroundings_.poll(now); }
  void take(const hal::CanFrame& frame, hal::Time now) { surroundings_.take(frame, now); }

 private:
  CurrentSensor current_;
  Surroundings surroundings_;
  hal::linux_os::MonotonicClock clock_;
};

}  // namespace boards::linux_controller
