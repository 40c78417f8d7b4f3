#pragma once

#include <linux/can.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hal/linux/can_wire.hpp"
#include "hal/linux/descriptor.hpp"

namespace hal::linux_os {

/// Who took the time of a received frame.
enum class TimestampSource : std::uint8_t { none, software, hardware };

/// What recvmsg() gave.
struct CanReceipt {
  int error = 0;  ///< errno, 0 where `frame` is one
  ::can_frame frame{};
  std::optional<std::uint32_t> dropped;  ///< of this socket so far (SO_RXQ_OVFL)
  std::int64_t time_ns = 0;              ///< of the clock of `source`
  TimestampSource source = TimestampSource::none;
};

/// What became of a request to restart a controller that is off the bus.
enum class CanRestart : std::uint8_t {
  asked,          ///< an error frame will report that it is done
  not_off,        ///< the controller is not off the bus
  by_kernel,      ///< the kernel restarts it itself, after restart-ms
  no_controller,  ///< vcan, vxcan: there is nothing to restart
  refused,        ///< no privilege (CAP_NET_ADMIN), or the interface is down
};

/// The calls of the kernel that SocketCan makes; nothing waits, but for restart(), which takes the
/// lock of the network configuration. A test puts its own in this place.
class CanCalls {
 public:
  /// Throws DeviceError where the interface is missing, is no CAN interface or cannot be used.
  void open(const std::string& interface, std::span<const CanFilter> filters);
  /// The same without an exception, for an interface that was there once; errno, or 0.
  int reopen();
  void close() { socket_ = {}; }

  /// errno, 0 where the frame is in the queue.
  int send(const ::can_frame& frame);
  CanReceipt receive();
  /// Whether the interface is there and up.
  [[nodiscard]] bool is_up() const;
  CanRestart restart();

 private:
  int configure();

  std::string interface_;
  std::vector<::can_filter> filters_;
  Descriptor socket_;
};

/// Asks the kernel by netlink to restart the controller of an interface (RTM_NEWLINK with
/// IFLA_CAN_RESTART). Gives 0 or the errno of the answer.
int request_can_restart(int interface_index);

/// The CAN interfaces of this machine, for messages: `can0, vcan0`, or `none`.
std::string can_interfaces();

}  // namespace hal::linux_os
