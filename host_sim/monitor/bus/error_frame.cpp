#include "host_sim/monitor/bus/error_frame.hpp"

#include <linux/can.h>
#include <linux/can/error.h>

#ifndef CAN_ERR_CNT  // of kernels before 6.0, whose drivers set the counters with CAN_ERR_CRTL
#define CAN_ERR_CNT 0x00000200U
#endif

namespace host_sim::monitor {

BusError bus_error_of(const hal::CanFrame& frame) {
  const auto byte = [&frame](std::size_t i) {
    return std::to_integer<std::uint8_t>(frame.data[i]);
  };
  const auto has = [&frame](std::uint32_t kind) { return (frame.id & kind) != 0; };
  const std::uint8_t controller = has(CAN_ERR_CRTL) ? byte(1) : std::uint8_t{0};
  const auto says = [controller](int bits) { return (controller & bits) != 0; };
  BusError error{.bus_off = has(CAN_ERR_BUSOFF),
                 .restarted = has(CAN_ERR_RESTARTED),
                 .error_passive = says(CAN_ERR_CRTL_RX_PASSIVE | CAN_ERR_CRTL_TX_PASSIVE),
                 .error_warning = says(CAN_ERR_CRTL_RX_WARNING | CAN_ERR_CRTL_TX_WARNING),
                 .receive_overflow = says(CAN_ERR_CRTL_RX_OVERFLOW)};
  if (has(CAN_ERR_CNT) || has(CAN_ERR_CRTL)) {
    error.transmit_errors = byte(6);
    error.receive_errors = byte(7);
  }
  return error;
}

}  // namespace host_sim::monitor
