#pragma once

#include <cstdint>

namespace firmware::qemu_mps2 {

/// Priorities of the interrupts, most urgent first; the hardware has the high three bits at least.
inline constexpr std::uint32_t kSamplePriority = 0x00;
inline constexpr std::uint32_t kReceivePriority = 0x40;
inline constexpr std::uint32_t kSettlePriority = 0xe0;

/// Keeps PendSV away, and nothing else: BASEPRI, ARMv7-M Architecture Reference Manual (DDI 0403E),
/// B1.4.3. (hal::Hold)
struct SettleHold {
  void hold() { __asm__ volatile("msr basepri, %0" ::"r"(kSettlePriority) : "memory"); }
  void release() { __asm__ volatile("msr basepri, %0" ::"r"(0) : "memory"); }
};

}  // namespace firmware::qemu_mps2
