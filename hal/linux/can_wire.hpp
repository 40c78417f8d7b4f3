#pragma once

#include <linux/can.h>

#include <algorithm>
#include <cstring>
#include <optional>

#include "hal/can_frame.hpp"

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

}  // namespace hal::linux_os
