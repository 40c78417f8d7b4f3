#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>

#include "firmware/app/intake.hpp"
#include "hal/devices.hpp"
#include "lifemodel/estimator.hpp"
#include "lifemodel/extension/sample.hpp"
#include "lifemodel/input/capstan.hpp"
#include "lifemodel/quantity/flags.hpp"
#include "lifemodel/support/shared_word.hpp"
#include "lifemodel/watch/wire_watch.hpp"

namespace app {

/// What the application gives a sensor that extends the model, and asks of it.
template <class T>
concept ExtendingSensor = requires(T& sensor, std::size_t tendon) {
  sensor.isr_missed();
  sensor.start_at(tendon, std::uint64_t{});
  { sensor.isr_flags(tendon) } -> std::same_as<lifemodel::Flags>;
};

using lifemodel::Velocity;

/// A sample of output tension, which the estimator carries to the motor end.
struct OutputTension {
  lifemodel::Tension tension;
  lifemodel::Direction direction;
  lifemodel::Angle bend;
  Velocity velocity{};  ///< 0 where it is not measured
};

/// A sample of input tension or motor current with the velocity of the tendon, positive while
/// pulling.
template <class SampleT>
struct Moving {
  SampleT sample;
  Velocity velocity{};
};

/// Takes the samples of all tendons into the estimator, in the interrupt of the control loop, and
/// reports to the rest of the application how that goes.
template <std::size_t kTendons, class LayoutT = lifemodel::DefaultLayout>
class Intake {
 public:
  using Estimator = lifemodel::Estimator<kTendons, LayoutT>;

  /// Samples in a row without a value that make the sensor faulty.
  static constexpr std::uint32_t kFaultySamples = 16;

  /// What is watched of a tendon besides its cycles.
  void watch(std::size_t tendon, const lifemodel::Parameters& parameters) {
    watches_[tendon] =
        lifemodel::WireWatch(parameters.watch, parameters.hysteresis, parameters.sample_period_us);
  }
  [[nodiscard]] lifemodel::WatchReading watched(std::size_t tendon) const {
    return watches_[tendon].reading();
  }

  /// A tendon without parameters is left out.
  void leave_out(std::size_t tendon) { left_out_[tendon] = true; }

  /// Flags of the samples of a tendon so far, its peak and its break are not those of its new wire:
  /// they go before its next sample is taken in, because only the interrupt may write them.
  void begin_wire(std::size_t tendon) {
    if (!forgetting(tendon)) {
      asked_.release(asked_.own() ^ (std::uint32_t{1} << tendon));
    }
  }
  /// True until they are gone.
  [[nodiscard]] bool forgetting(std::size_t tendon) const {
    return (((asked_.own() ^ done_.acquire()) >> tendon) & 1u) != 0;
  }

  /// The peaks of all tendons since the last call are sought anew, from the next sample on.
  void begin_window() {
    if (((asked_.own() ^ done_.acquire()) & kWindow) == 0) {
      asked_.release(asked_.own() ^ kWindow);
    }
  }

  /// True where the estimator's push() has said so of a tendon.
  template <hal::Sensor SensorT>
  bool isr_sample(SensorT& sensor, Estimator& estimator) {
    isr_forget(estimator);
    bool due = false;
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      if (left_out_[tendon]) {
        continue;
      }
      const auto sample = sensor.isr_read(tendon);
      if (sample) [[likely]] {
        if constexpr (ExtendingSensor<SensorT>) {
          lifemodel::Flags& flags = estimator.input_flags(tendon);
          flags = flags | sensor.isr_flags(tendon);
        }
        due = isr_push(estimator, tendon, *sample) || due;
        without_[tendon].set_relaxed(0);
      } else {
        isr_miss(estimator, tendon, 1);
        const std::uint32_t without = without_[tendon].own();
        without_[tendon].set_relaxed(without < kFaultySamples ? without + 1 : without);
      }
    }
    periods_.set_relaxed(periods_.own() + 1);
    return due;
  }

  void isr_missed(std::uint32_t periods, Estimator& estimator) {
    isr_forget(estimator);
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      if (!left_out_[tendon]) {
        isr_miss(estimator, tendon, periods);
      }
    }
    missed_.set_relaxed(missed_.own() + periods);
  }

  /// Periods of the control loop so far; wraps.
  [[nodiscard]] std::uint32_t periods() const { return periods_.relaxed(); }
  /// Periods that were missed; wraps.
  [[nodiscard]] std::uint32_t missed() const { return missed_.relaxed(); }
  [[nodiscard]] bool sensor_ok() const {
    for (const auto& without : without_) {
      if (without.relaxed() == kFaultySamples) {
        return false;
      }
    }
    return true;
  }

 private:
  void isr_forget(Estimator& estimator) {
    const std::uint32_t asked = asked_.acquire();
    const std::uint32_t open = asked ^ done_.own();
    if (open == 0) [[likely]] {
      return;
    }
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      if (((open >> tendon) & 1u) != 0) {
        estimator.input_flags(tendon) = {};
        watches_[tendon].begin();
      }
      if ((open & kWindow) != 0) {
        watches_[tendon].begin_window();
      }
    }
    done_.release(asked);
  }

  void isr_miss(Estimator& estimator, std::size_t tendon, std::uint32_t samples) {
    estimator.push_missing(tendon, samples);
    watches_[tendon].miss(samples);
  }

  bool isr_push(Estimator& estimator, std::size_t tendon, lifemodel::Tension tension,
                Velocity velocity = {}) {
    watches_[tendon].push(tension, velocity);
    return estimator.push(tendon, tension);
  }
  bool isr_push(Estimator& estimator, std::size_t tendon, lifemodel::MotorCurrent current,
                Velocity velocity = {}) {
    if (!estimator.parameters(tendon).has_drive()) {
      isr_miss(estimator, tendon, 1);
      return false;
    }
    return isr_push(estimator, tendon, estimator.input_tension(tendon, current), velocity);
  }
  bool isr_push(Estimator& estimator, std::size_t tendon, const OutputTension& sample) {
    return isr_push(estimator, tendon,
                    estimator.input_tension(tendon, sample.tension, sample.direction, sample.bend),
                    sample.velocity);
  }
  template <class Sample>
  bool isr_push(Estimator& estimator, std::size_t tendon, const Moving<Sample>& moving) {
    return isr_push(estimator, tendon, moving.sample, moving.velocity);
  }

  static constexpr std::uint32_t kWindow = std::uint32_t{1} << 31;
  static_assert(kTendons <= 31, "a bit each, and one of all");

  std::array<lifemodel::WireWatch, kTendons> watches_;
  std::array<bool, kTendons> left_out_{};
  lifemodel::SharedWord<std::uint32_t> asked_;  ///< changes a bit to have something begun anew
  lifemodel::SharedWord<std::uint32_t> done_;   ///< follows
  std::array<lifemodel::SharedWord<std::uint32_t>, kTendons> without_{};
  lifemodel::SharedWord<std::uint32_t> periods_;
  lifemodel::SharedWord<std::uint32_t> missed_;
};

}  // namespace app
