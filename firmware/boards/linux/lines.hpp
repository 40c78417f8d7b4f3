#pragma once

#include <array>
#include <optional>

#include "firmware/boards/linux/config.hpp"
#include "hal/error.hpp"
#include "hal/linux/gpiod_emergency_stop.hpp"
#include "hal/linux/gpiod_output.hpp"
#include "hal/result.hpp"

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
      lines_.emplace(*config, lines);
    }
  }

  /// Off before the brake closes, on after it has opened.
  hal::Error set(bool drive, bool brake) {
    if (!lines_) {
      return hal::Error::none;
    }
    const hal::Error first = drive ? set(kBrake, brake) : set(kDrive, drive);
    const hal::Error second = drive ? set(kDrive, drive) : set(kBrake, brake);
    return first != hal::Error::none ? first : second;
  }
  hal::Result<bool> stop_asserted() {
    return lines_ ? lines_->stop.asserted() : hal::Result<bool>(false);
  }

 private:
  enum Output : std::size_t { kDrive, kBrake };

  struct Lines {
    Lines(const GpioConfig& config, std::span<const hal::linux_os::LineSpec> specs)
        : outputs(config.chip, specs),
          stop(config.chip, spec_of(config.emergency_stop), config.debounce) {}

    hal::linux_os::GpioOutputs outputs;
    hal::linux_os::GpioEmergencyStop stop;
  };

  hal::Error set(Output output, bool on) { return lines_->outputs.set(output, on); }

  std::optional<Lines> lines_;
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
