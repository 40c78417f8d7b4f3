#pragma once

#include <array>
#include <optional>

#include "firmware/boards/linux/config.hpp"
#include "hal/error.hpp"
#include "hal/linux/gpiod_lines.hpp"

namespace board {

inline hal::linux_os::LineSpec spec_of(const LineConfig& line) {
  return {line.line, line.active_low};
}

/// Drive enable and brake in one request, and the emergency stop. Without a configuration there are
/// no lines: outputs go nowhere, and nobody stops.
class SafetyLines {
 public:
  /// Throws hal::linux_os::DeviceError.
  explicit SafetyLines(const std::optional<GpioConfig>& config) {
    if (config) {
      const std::array lines{spec_of(config->drive_enable), spec_of(config->brake)};
      outputs_.emplace(config->chip, lines);
      stop_.emplace(config->chip, spec_of(config->emergency_stop), config->debounce);
    }
  }
  SafetyLines(const SafetyLines&) = delete;
  SafetyLines& operator=(const SafetyLines&) = delete;

  struct Output {
    hal::Error set(bool on) { return outputs ? outputs->set(index, on) : hal::Error::none; }

    std::optional<hal::linux_os::GpioOutputs>& outputs;
    std::size_t index;
  };
  struct Stop {
    hal::Result<bool> asserted() { return stop ? stop->asserted() : hal::Result<bool>(false); }

    std::optional<hal::linux_os::GpioEmergencyStop>& stop;
  };

  Output drive_enable{outputs_, 0};
  Output brake{outputs_, 1};
  Stop emergency_stop{stop_};

 private:
  std::optional<hal::linux_os::GpioOutputs> outputs_;
  std::optional<hal::linux_os::GpioEmergencyStop> stop_;
};

/// An output that need not be there.
class OptionalOutput {
 public:
  /// Throws hal::linux_os::DeviceError.
  OptionalOutput(const std::optional<GpioConfig>& gpio,
                 std::optional<LineConfig> GpioConfig::*which) {
    if (gpio && (*gpio).*which) {
      output_.emplace(gpio->chip, spec_of(*((*gpio).*which)));
    }
  }
  hal::Error set(bool on) { return output_ ? output_->set(on) : hal::Error::none; }

 private:
  std::optional<hal::linux_os::GpioOutput> output_;
};

}  // namespace board
