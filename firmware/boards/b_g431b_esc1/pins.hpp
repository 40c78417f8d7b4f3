#pragma once

#include "firmware/boards/b_g431b_esc1/registers.hpp"
#include "hal/stm32g4/pins.hpp"

/// Lines of the B-G431B-ESC1, UM2516; README.md has the table with the connectors.
namespace boards::b_g431b_esc1::pins {

using Pin = hal::stm32g4::Pin<registers::Register>;

inline Pin drive_enable() {
  return {registers::gpio_b(), 3};
}
inline Pin brake_release() {
  return {registers::gpio_a(), 15};
}
inline Pin emergency_stop() {
  return {registers::gpio_b(), 7};
}
inline Pin status_light() {
  return {registers::gpio_c(), 6};
}
inline Pin can_receive() {
  return {registers::gpio_a(), 11};
}
inline Pin can_transmit() {
  return {registers::gpio_b(), 9};
}
/// High shuts the transceiver down.
inline Pin can_shutdown() {
  return {registers::gpio_c(), 11};
}
/// High closes the 120 ohm of the bus.
inline Pin can_termination() {
  return {registers::gpio_c(), 14};
}

/// DS12589, table of alternate functions: FDCAN1 on PA11 and PB9.
inline constexpr std::uint32_t kCanFunction = 9;

}  // namespace boards::b_g431b_esc1::pins
