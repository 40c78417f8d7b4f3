#pragma once

#include <chrono>
#include <cstddef>
#include <gpiod.hpp>
#include <span>
#include <string>
#include <vector>

#include "hal/linux/edge_follower.hpp"
#include "hal/linux/gpiod_request.hpp"
#include "hal/result.hpp"

namespace hal::linux_os {

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
