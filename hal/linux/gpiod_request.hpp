#pragma once

#include <gpiod.hpp>
#include <span>
#include <string>
#include <vector>

namespace hal::linux_os {

/// A line of a gpiochip.
struct LineSpec {
  std::string line;         ///< its name, or its offset in digits
  bool active_low = false;  ///< asserted is the low level
};

/// The name under which the lines are held, as gpioinfo shows it.
inline constexpr const char* kGpioConsumer = "tendonlife";

/// Opens a chip by path, by name (`gpiochip0`) or by label. Throws DeviceError that says which
/// chips there are.
::gpiod::chip open_gpio_chip(const std::string& chip);

/// Asks for lines with these settings, all or none, in one request. `offsets` receives theirs.
/// Throws DeviceError where a line is missing, or in use, and by whom.
::gpiod::line_request request_lines(const std::string& chip, std::span<const LineSpec> lines,
                                    ::gpiod::line_settings settings,
                                    std::vector<::gpiod::line::offset>& offsets);

}  // namespace hal::linux_os
