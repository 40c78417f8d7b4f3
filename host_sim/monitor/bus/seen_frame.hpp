#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "hal/can_frame.hpp"

namespace host_sim::monitor {

/// What the controller of the monitor's own end reports of the bus (linux/can/error.h).
struct BusError {
  bool bus_off = false;
  bool restarted = false;
  bool error_passive = false;
  bool error_warning = false;
  bool receive_overflow = false;  ///< frames were lost before the monitor
  std::uint8_t transmit_errors = 0;
  std::uint8_t receive_errors = 0;
};

/// One frame as it was seen on the bus.
struct SeenFrame {
  /// Nanoseconds since the epoch of the clock that stamped it: 1970 for SocketCAN, candump -L with
  /// absolute times and PCAP, the start of the log for others. Never falls within one source.
  std::int64_t time_ns = 0;
  /// Where `error` is set its id is the class of the error, and its data hold more
  /// (linux/can/error.h). Of a remote request `length` is what it asks for.
  hal::CanFrame frame;
  std::optional<BusError> error;
  bool flexible_data_rate = false;  ///< CAN FD: counted, never decoded; `frame` holds its id alone
  std::uint8_t fd_flags = 0;        ///< bit 0 bit rate switch, bit 1 error state of the sender
  std::vector<std::byte> fd_data;   ///< 0 .. 64 bytes
  bool remote_request = false;
  std::uint32_t lost_before = 0;  ///< frames that the kernel had no room for before this one
};

}  // namespace host_sim::monitor
