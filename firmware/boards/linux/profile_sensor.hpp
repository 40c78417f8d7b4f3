#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "firmware/app/intake.hpp"
#include "hal/devices.hpp"
#include "hal/error.hpp"
#include "hal/files/profile.hpp"
#include "lifemodel/block/parameters.hpp"

namespace board {

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
static_assert(hal::CurrentSensor<ProfileSensor<lifemodel::MotorCurrent>>);

}  // namespace board
