#pragma once

#include <cstdint>

#include "hal/stm32g4/registers/core.hpp"

namespace board {

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

}  // namespace board
