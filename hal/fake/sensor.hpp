#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "hal/fake/clock.hpp"
#include "hal/fake/faults.hpp"
#include "hal/sensor.hpp"

namespace hal::fake {

/// A sensor that gives what it was told: one sample with give(), or a script of them with play(),
/// one at each call. Then there is nothing new.
///
/// A fault takes the place of a sample: the sample is gone, as with a real one.
template <class SampleT, std::size_t kTendons = 1>
class Sensor {
 public:
  using Sample = SampleT;

  explicit Sensor(const Clock& clock) : clock_(clock) {}

  void give(std::size_t tendon, const Sample& sample) { tendons_[tendon].given = sample; }
  /// The script outlives its use. Samples given before go first.
  void play(std::size_t tendon, std::span<const Sample> script) {
    tendons_[tendon].script = script;
  }

  Result<Sample> isr_read(std::size_t tendon) {
    if (tendon >= kTendons) {
      return Error::out_of_range;
    }
    const std::optional<Sample> sample = take(tendons_[tendon]);
    if (const auto fault = faults.next(clock_.now())) {
      return *fault;
    }
    return sample ? Result<Sample>(*sample) : Result<Sample>(Error::missing);
  }

  Faults<Error> faults;

 private:
  struct Tendon {
    std::optional<Sample> given;
    std::span<const Sample> script;
  };

  static std::optional<Sample> take(Tendon& tendon) {
    if (tendon.given) {
      const std::optional<Sample> sample = tendon.given;
      tendon.given.reset();
      return sample;
    }
    if (tendon.script.empty()) {
      return std::nullopt;
    }
    const Sample sample = tendon.script.front();
    tendon.script = tendon.script.subspan(1);
    return sample;
  }

  const Clock& clock_;
  std::array<Tendon, kTendons> tendons_{};
};

static_assert(hal::CurrentSensor<Sensor<lifemodel::MotorCurrent, 2>>);

}  // namespace hal::fake
