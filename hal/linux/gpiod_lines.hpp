#pragma once

#include <chrono>
#include <cstddef>
#include <gpiod.hpp>
#include <span>
#include <string>
#include <vector>

#include "hal/error.hpp"
#include "hal/linux/edge_follower.hpp"

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

/// Output lines of one chip that are held together, in one request. They are released together,
/// when this goes: the kernel then makes inputs of them, and what the wiring pulls them to is what
/// they are. The wiring must therefore hold the drive off and the brake on.
class GpioOutputs {
 public:
  /// All lines begin as not asserted. Throws DeviceError.
  GpioOutputs(const std::string& chip, std::span<const LineSpec> lines);

  /// Of one thread only. @pre i < number of lines
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

/// Edges of one input line, both directions, debounced by the kernel, with the monotonic clock.
class GpioEdges {
 public:
  /// Throws DeviceError.
  GpioEdges(const std::string& chip, const LineSpec& line, std::chrono::microseconds debounce);

  Result<std::size_t> read(std::span<Edge> out);
  Result<bool> level();

 private:
  static constexpr std::size_t kBufferEdges = 16;

  std::vector<::gpiod::line::offset> offsets_;
  ::gpiod::line_request request_;
  ::gpiod::edge_event_buffer buffer_;
};

/// The emergency stop. Of one thread only.
class GpioEmergencyStop {
 public:
  /// The debounce time of the kernel; 1 to 5 ms suit a contact.
  GpioEmergencyStop(const std::string& chip, const LineSpec& line,
                    std::chrono::microseconds debounce)
      : edges_(chip, line, debounce) {}

  Result<bool> asserted() { return follower_.asserted(); }
  [[nodiscard]] const EdgeFollower<GpioEdges>& follower() const { return follower_; }

 private:
  GpioEdges edges_;
  EdgeFollower<GpioEdges> follower_{edges_};
};

}  // namespace hal::linux_os
