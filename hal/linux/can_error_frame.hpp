#pragma once

#include <linux/can.h>
#include <linux/can/error.h>

#include "hal/can_port.hpp"

namespace hal::linux_os {

/// What a raw socket asks to be told of. Bus errors are left out: they may flood.
inline constexpr can_err_mask_t kCanErrorClasses =
    CAN_ERR_TX_TIMEOUT | CAN_ERR_CRTL | CAN_ERR_BUSOFF | CAN_ERR_RESTARTED | CAN_ERR_CNT;

/// Faults that a driver told of, beyond what CanStatus holds.
struct CanFaults {
  std::uint32_t transmit_timeouts = 0;
  std::uint32_t overflows = 0;  ///< a queue of the controller was full
  std::uint32_t restarts = 0;   ///< after bus-off
};

/// The state that byte 1 of an error frame with CAN_ERR_CRTL tells of, or `before`.
constexpr CanState state_of(std::uint8_t controller, CanState before) {
  if ((controller & (CAN_ERR_CRTL_RX_PASSIVE | CAN_ERR_CRTL_TX_PASSIVE)) != 0) {
    return CanState::passive;
  }
  if ((controller & (CAN_ERR_CRTL_RX_WARNING | CAN_ERR_CRTL_TX_WARNING)) != 0) {
    return CanState::warning;
  }
  return (controller & CAN_ERR_CRTL_ACTIVE) != 0 ? CanState::active : before;
}

/// The state that error counters stand for (ISO 11898-1, fault confinement: 96 and 128).
constexpr CanState state_of_counters(std::uint8_t transmit, std::uint8_t receive) {
  const std::uint8_t worst = transmit > receive ? transmit : receive;
  if (worst >= 128) {
    return CanState::passive;
  }
  return worst >= 96 ? CanState::warning : CanState::active;
}

/// Takes in an error frame (linux/can/error.h). Precondition: CAN_ERR_FLAG is set in its id.
constexpr void take_error_frame(const ::can_frame& frame, CanStatus& status, CanFaults& faults) {
  if ((frame.can_id & CAN_ERR_TX_TIMEOUT) != 0) {
    ++faults.transmit_timeouts;
  }
  if ((frame.can_id & CAN_ERR_CNT) != 0) {
    status.transmit_errors = frame.data[6];
    status.receive_errors = frame.data[7];
    if (status.state != CanState::off) {
      status.state = state_of_counters(frame.data[6], frame.data[7]);
    }
  }
  if ((frame.can_id & CAN_ERR_CRTL) != 0) {
    if ((frame.data[1] & (CAN_ERR_CRTL_RX_OVERFLOW | CAN_ERR_CRTL_TX_OVERFLOW)) != 0) {
      ++faults.overflows;
    }
    if (status.state != CanState::off) {
      status.state = state_of(frame.data[1], status.state);
    }
  }
  if ((frame.can_id & CAN_ERR_RESTARTED) != 0) {
    ++faults.restarts;
    status.state = CanState::active;
  }
  if ((frame.can_id & CAN_ERR_BUSOFF) != 0 && status.state != CanState::off) {
    ++status.bus_offs;
    status.state = CanState::off;
  }
}

}  // namespace hal::linux_os
