#pragma once

#include <cstddef>
#include <gpiod.hpp>
#include <span>
#include <string>
#include <vector>

#include "hal/error.hpp"
#include "hal/linux/gpiod_request.hpp"

namespace hal::linux_os {

/// Output lines of one chip that are held together, in one request. They are released together,
/// when this goes: the kernel then makes inputs of them, and what the wiring pulls them to is what
/// they are. The wiring must therefore hold the drive off and the brake on.
class GpioOutputs {
 public:
  /// All lines begin as not asserted. Throws DeviceError.
  GpioOutputs(const std::string& chip, std::span<const LineSpec> lines);

  /// Precondition: i < number of lines. Of one thread only.
  Error set(std::size_t i, bool asserted);

 private:
  std::vector<::gpiod::line::offset> offsets_;
  ::gpiod::line_request request_;
};

/// One line that is alone in its request.
class GpioOutput {
 public:
  GpioOutput(const std::string& chip, const LineSpec& line) : lines_(chip, std::span(&line, 1)) {}
  Error set(bool asserted) { return lines_.set(0, asserted); }

 private:
  GpioOutputs lines_;
};

}  // namespace hal::linux_os
