#include <cstdint>

#include "firmware/boards/b_g431b_esc1/fault.hpp"
#include "firmware/boards/b_g431b_esc1/interrupts.hpp"
#include "firmware/boards/b_g431b_esc1/places.hpp"
#include "firmware/boards/b_g431b_esc1/registers.hpp"

// This file and all that it reaches lie in RAM, so that no sample is lost while the flash is busy;
// see the linker script.
namespace board {

extern "C" void isr_control() {
  Hardware& devices = hardware();
  auto& app = application().app();
  const std::uint32_t now_us = devices.clock.isr_tick();
  devices.sensor.isr_latch();
  devices.emergency_stop.isr_sample();
  devices.can.isr_receive();
  const std::uint32_t missed = devices.timing.isr_period(now_us, kLoopPeriod_us);
  if (missed != 0) {
    app.isr_missed(missed);
  }
  app.isr_sample();
  registers::system_control().icsr.write(hal::stm32g4::core::kPendSvSet);
}

extern "C" void isr_nmi() {
  if (!hardware().flash.isr_ecc_error()) {
    fail_safe();
  }
}

}  // namespace board
