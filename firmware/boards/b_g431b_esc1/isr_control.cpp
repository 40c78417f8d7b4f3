#include "firmware/boards/b_g431b_esc1/application.hpp"
#include "firmware/boards/b_g431b_esc1/control_loop.hpp"
#include "firmware/boards/b_g431b_esc1/interrupts.hpp"
#include "firmware/boards/b_g431b_esc1/registers.hpp"

// This file and all that it reaches lie in RAM, so that no sample and no emergency stop is lost
// while the flash is busy; see the linker script.
namespace board {

extern "C" void isr_control() {
  isr_period(hardware(), application().app());
  registers::system_control().icsr.write(hal::stm32g4::core::kPendSvSet);
}

extern "C" void isr_nmi() {
  if (!hardware().flash.isr_ecc_error()) {
    fail_safe();
  }
}

}  // namespace board
