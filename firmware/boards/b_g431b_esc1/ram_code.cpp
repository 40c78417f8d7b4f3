#include "firmware/boards/b_g431b_esc1/application.hpp"
#include "firmware/boards/b_g431b_esc1/board_flash.hpp"
#include "firmware/boards/b_g431b_esc1/control_loop.hpp"
#include "firmware/boards/b_g431b_esc1/interrupts.hpp"
#include "firmware/boards/b_g431b_esc1/pins.hpp"
#include "firmware/boards/b_g431b_esc1/registers.hpp"

// This file and all that it reaches lie in RAM, so that no sample and no emergency stop is lost
// while the flash is busy; see the linker script.
namespace boards::b_g431b_esc1 {

extern "C" void isr_control() {
  if (isr_period(hardware(), application().app())) {
    registers::system_control().icsr.write(hal::stm32g4::core::kPendSvSet);
  }
}

extern "C" void isr_nmi() {
  if (!hardware().flash.isr_ecc_error()) {
    fail_safe();
  }
}

namespace {

class WithoutSettling {
 public:
  WithoutSettling() { mask_priority(kSettlePriority); }
  WithoutSettling(const WithoutSettling&) = delete;
  WithoutSettling& operator=(const WithoutSettling&) = delete;
  ~WithoutSettling() { mask_priority(before_); }

 private:
  std::uint32_t before_ = masked_priority();
};

}  // namespace

hal::Error BoardFlash::erase(std::uint32_t page) {
  const WithoutSettling only_the_loop;
  return operations_.erase(page);
}

hal::Error BoardFlash::program(std::uint32_t offset, hal::stm32g4::DoubleWord value) {
  const WithoutSettling only_the_loop;
  return operations_.program(offset, value);
}

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

}  // namespace boards::b_g431b_esc1
