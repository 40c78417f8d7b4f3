#pragma once

#include <atomic>

#include "firmware/boards/linux/report.hpp"
#include "firmware/boards/linux/setup.hpp"

namespace boards::linux_controller {

/// Runs the application until `stop` is set or the profile is at its end. Throws
/// std::runtime_error, its what() one line: hal::linux_os::DeviceError where a device cannot be
/// used, hal::files::InputError or OutputError where a file cannot.
Report run(const Setup& setup, const std::atomic<bool>& stop);

}  // namespace boards::linux_controller
