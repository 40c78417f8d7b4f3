#pragma once

#include <linux/can.h>
#include <linux/can/error.h>

#include <algorithm>
#include <cstring>
#include <optional>

#include "hal/can_frame.hpp"
#include "hal/can_port.hpp"

namespace hal::linux_os {

/// What a raw socket is to pass on: data frames whose id agrees with `id` where `mask` has ones.
struct CanFilter {
  std::uint32_t id = 0;
  std::uint32_t mask = CAN_EFF_MASK;
  bool extended = false;
};

/// The filter as the kernel takes it (linux/can.h). Remote frames and frames of the other format
/// never pass.
constexpr ::can_filter to_kernel(const CanFilter& filter) {
  const std::uint32_t bits = filter.extended ? CAN_EFF_MASK : CAN_SFF_MASK;
  return {(filter.id & bits) | (filter.extended ? CAN_EFF_FLAG : 0),
          (filter.mask & bits) | CAN_EFF_FLAG | CAN_RTR_FLAG};
}

inline ::can_frame to_kernel(const CanFrame& frame) {
  ::can_frame out{};
  out.can_id = frame.extended ? (frame.id & CAN_EFF_MASK) | CAN_EFF_FLAG : frame.id & CAN_SFF_MASK;
  out.can_dlc = std::min<std::uint8_t>(frame.length, CAN_MAX_DLEN);
  std::memcpy(out.data, frame.data.data(), out.can_dlc);
  return out;
}

/// Nothing for what is no data frame.
inline std::optional<CanFrame> from_kernel(const ::can_frame& in) {
  if ((in.can_id & (CAN_ERR_FLAG | CAN_RTR_FLAG)) != 0 || in.can_dlc > CAN_MAX_DLEN) {
    return std::nullopt;
  }
  CanFrame frame;
  frame.extended = (in.can_id & CAN_EFF_FLAG) != 0;
  frame.id = in.can_id & (frame.extended ? CAN_EFF_MASK : CAN_SFF_MASK);
  frame.length = in.can_dlc;
  std::memcpy(frame.data.data(), in.data, in.can_dlc);
  return frame;
}

/// What a raw socket asks to have reported. Bus errors are left out: they may flood.
inline constexpr can_err_mask_t kCanErrorClasses =
    CAN_ERR_TX_TIMEOUT | CAN_ERR_CRTL | CAN_ERR_BUSOFF | CAN_ERR_RESTARTED | CAN_ERR_CNT;

/// Faults that a driver reported, beyond what CanStatus holds.
struct CanFaults {
  std::uint32_t transmit_timeouts = 0;
  std::uint32_t overflows = 0;  ///< a queue of the controller was full
  std::uint32_t restarts = 0;   ///< after bus-off
};

/// The state that byte 1 of an error frame with CAN_ERR_CRTL reports, or `before`.
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

/// Takes in an error frame (linux/can/error.h). @pre CAN_ERR_FLAG is set in its id
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
