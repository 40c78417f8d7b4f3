#include "firmware/boards/b_g431b_esc1/interrupts.hpp"
#include "firmware/boards/b_g431b_esc1/pins.hpp"
#include "firmware/boards/b_g431b_esc1/registers.hpp"

// This file lies in RAM; see the linker script.
namespace board {

[[noreturn]] void fail_safe() {
  hal::stm32g4::drive(pins::drive_enable(), hal::stm32g4::Level::low);
  hal::stm32g4::drive(pins::brake_release(), hal::stm32g4::Level::low);
  __asm__ volatile("dsb" ::: "memory");
  registers::system_control().aircr.write(hal::stm32g4::core::kSystemReset);
  while (true) {
  }
}

extern "C" [[noreturn, gnu::used]] void fail_safe_on_fresh_stack() {
  fail_safe();
}

// The stack may have run over: what was on it is not needed any more.
extern "C" [[gnu::naked]] void isr_fault() {
  __asm__ volatile(
      "ldr r0, =stack_top\n"
      "mov sp, r0\n"
      "b fail_safe_on_fresh_stack\n"
      ".ltorg\n");
}

}  // namespace board
