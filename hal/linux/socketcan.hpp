#pragma once

#include <cerrno>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "hal/can_port.hpp"
#include "hal/linux/can_calls.hpp"
#include "hal/linux/can_wire.hpp"

namespace hal::linux_os {

/// What a port has seen since the start, beyond CanStatus.
struct SocketCanCounts {
  std::uint32_t sent = 0;
  std::uint32_t queue_full = 0;  ///< ENOBUFS: the queue of the interface was full
  std::uint32_t refused = 0;     ///< send() failed for another reason
  std::uint32_t downs = 0;       ///< the interface was set down or vanished
  std::uint32_t reopened = 0;    ///< it was opened again after it had vanished
  CanFaults faults;
  TimestampSource timestamp_source = TimestampSource::none;  ///< of the last received frame
  std::int64_t timestamp_ns = 0;                             ///< of the last received frame
};

/// A CAN port over a raw socket. Nothing waits, but for recover(), which may take the lock of the
/// network configuration: the caller leaves growing pauses between its attempts.
///
/// The port is off while the controller is off the bus, while the interface is down and while it is
/// gone. recover() asks the kernel to restart the controller, which needs CAP_NET_ADMIN; where the
/// interface was set up with restart-ms the kernel does it alone, and the error frame of the
/// restart ends the state in both cases. An interface that has vanished is opened again by its
/// name.
template <class CallsT = CanCalls>
class BasicSocketCan {
 public:
  /// Throws DeviceError where the interface cannot be used. `calls` outlives the port.
  BasicSocketCan(CallsT& calls, const std::string& interface, std::span<const CanFilter> filters)
      : calls_(calls) {
    calls_.open(interface, filters);
    down_ = !calls_.is_up();
  }

  Error send(const CanFrame& frame) {
    if (status().state == CanState::off) {
      return Error::off;
    }
    const int error = calls_.send(to_kernel(frame));
    switch (error) {
      case 0:
        ++counts_.sent;
        return Error::none;
      case ENOBUFS:
      case EAGAIN:
        ++counts_.queue_full;
        return Error::full;
      default:
        ++counts_.refused;
        note_loss(error);
        return down_ || gone_ ? Error::off : Error::failed;
    }
  }

  std::optional<CanFrame> receive() {
    for (int i = 0; i < kMostReceipts && !gone_; ++i) {
      const CanReceipt receipt = calls_.receive();
      if (receipt.error != 0) {
        note_loss(receipt.error);
        return std::nullopt;
      }
      take_extras(receipt);
      if ((receipt.frame.can_id & CAN_ERR_FLAG) != 0) {
        take_error_frame(receipt.frame, status_, counts_.faults);
      } else if (const auto frame = from_kernel(receipt.frame)) {
        return frame;
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] CanStatus status() const {
    CanStatus status = status_;
    if (down_ || gone_) {
      status.state = CanState::off;
    }
    return status;
  }

  Error recover() {
    if (status().state != CanState::off) {
      return Error::none;
    }
    if (gone_ && !reopen()) {
      return Error::off;
    }
    down_ = !calls_.is_up();
    if (down_) {
      return Error::off;
    }
    return status_.state == CanState::off ? restart() : Error::none;
  }

  [[nodiscard]] const SocketCanCounts& counts() const { return counts_; }

 private:
  static constexpr int kMostReceipts = 32;

  void note_loss(int error) {
    if (error == ENETDOWN && !down_) {
      down_ = true;
      ++counts_.downs;
    } else if (error == ENODEV || error == ENXIO || error == EBADF) {
      gone_ = true;
      ++counts_.downs;
      lost_before_ = status_.lost;
      calls_.close();
    }
  }

  void take_extras(const CanReceipt& receipt) {
    if (receipt.dropped) {
      status_.lost = lost_before_ + *receipt.dropped;
    }
    counts_.timestamp_source = receipt.source;
    counts_.timestamp_ns = receipt.time_ns;
  }

  bool reopen() {
    if (calls_.reopen() != 0) {
      return false;
    }
    gone_ = false;
    ++counts_.reopened;
    status_.state = CanState::active;
    return true;
  }

  Error restart() {
    switch (calls_.restart()) {
      case CanRestart::asked:
        return Error::none;
      case CanRestart::not_off:
      case CanRestart::no_controller:
        status_.state = CanState::active;
        return Error::none;
      case CanRestart::by_kernel:
      case CanRestart::refused:
        break;
    }
    return Error::off;
  }

  CallsT& calls_;
  CanStatus status_;
  SocketCanCounts counts_;
  std::uint32_t lost_before_ = 0;
  bool down_ = false;
  bool gone_ = false;
};

using SocketCan = BasicSocketCan<CanCalls>;
static_assert(CanPort<SocketCan>);

}  // namespace hal::linux_os
