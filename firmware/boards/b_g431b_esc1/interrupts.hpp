#pragma once

#include <cstdint>

#include "hal/stm32g4/core.hpp"

namespace boards::b_g431b_esc1 {

/// The control loop interrupts settling, and settling the idle loop.
inline constexpr std::uint32_t kLoopPriority = hal::stm32g4::core::priority(1);
inline constexpr std::uint32_t kSettlePriority = hal::stm32g4::core::priority(15);

/// BASEPRI, DDI 0403E B1.4.3: keeps away what has this priority or a lower one; 0 keeps nothing.
inline std::uint32_t masked_priority() {
  std::uint32_t value = 0;
  __asm__ volatile("mrs %0, basepri" : "=r"(value));
  return value;
}
inline void mask_priority(std::uint32_t value) {
  __asm__ volatile("msr basepri, %0\n\tisb" ::"r"(value) : "memory");
}

/// hal::Hold: keeps settling away.
class SettleHold {
 public:
  void hold() { mask_priority(kSettlePriority); }
  void release() { mask_priority(0); }
};

/// Drive off, brake on, and the device starts again. Runs from RAM, needs no stack of what went
/// before, and works whatever was started so far.
[[noreturn]] void fail_safe();

/// Handlers in the vector table.
extern "C" {
[[noreturn]] void isr_reset();  ///< the entry of the device
void isr_nmi();                 ///< a damaged double word in a guarded read, or the end
void isr_control();             ///< ADC1 and ADC2: one period of the control loop
void isr_settle();              ///< PendSV: counts cycles below the control loop
void isr_fault();               ///< faults, and what nobody expects: fail_safe() on a fresh stack
}

}  // namespace boards::b_g431b_esc1
