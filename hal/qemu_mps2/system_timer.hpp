#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/clock.hpp"
#include "hal/error.hpp"
#include "hal/qemu_mps2/register.hpp"
#include "lifemodel/support/shared_word.hpp"

namespace hal::qemu_mps2 {

/// SysTick, ARMv7-M Architecture Reference Manual (DDI 0403E), B3.3.2.
struct SysTickRegisters {
  Register control;
  Register reload;
  Register current;
};
static_assert(offsetof(SysTickRegisters, control) == 0x0);
static_assert(offsetof(SysTickRegisters, reload) == 0x4);
static_assert(offsetof(SysTickRegisters, current) == 0x8);

namespace sys_tick {

inline constexpr std::uint32_t kEnable = 1u << 0;
inline constexpr std::uint32_t kInterruptEnable = 1u << 1;
inline constexpr std::uint32_t kProcessorClock = 1u << 2;
inline constexpr std::uint32_t kHighestReload = 0xff'ffff;

}  // namespace sys_tick

/// The interrupt of the control loop and the clock, both out of SysTick. now() is for every context
/// that SysTick interrupts, and for its own handler after isr_tick().
///
/// `kTicksPerMicrosecond` of the processor's clock.
template <std::uint32_t kTicksPerMicrosecond, class Registers = SysTickRegisters>
class SystemTimer {
 public:
  explicit SystemTimer(Registers& registers) : registers_(registers) {}

  /// Interrupts every `period_us` from now on. out_of_range where the counter is too short for it.
  Error start(std::uint32_t period_us) {
    if (period_us == 0 ||
        period_us > (sys_tick::kHighestReload + std::uint32_t{1}) / kTicksPerMicrosecond) {
      return Error::out_of_range;
    }
    period_us_ = period_us;
    registers_.control.write(0);
    registers_.reload.write(period_us * kTicksPerMicrosecond - 1);
    registers_.current.write(0);
    registers_.control.write(sys_tick::kEnable | sys_tick::kInterruptEnable |
                             sys_tick::kProcessorClock);
    return Error::none;
  }

  /// First thing in the handler.
  void isr_tick() {
    low_.set_relaxed(low_.own() + 1);
    if (low_.own() == 0) {
      high_.set_relaxed(high_.own() + 1);
    }
  }

  [[nodiscard]] Time now() const {
    std::uint32_t high = 0;
    std::uint32_t low = 0;
    std::uint32_t gone_us = 0;
    do {
      high = high_.acquire();
      low = low_.acquire();
      gone_us = gone();
    } while (high != high_.acquire() || low != low_.acquire());
    const std::uint64_t periods = (std::uint64_t{high} << 32) | low;
    return {periods * period_us_ + gone_us};
  }

 private:
  /// Time since the period began. The counter shows 0 for one clock when a period ends; QEMU shows
  /// it until it has delivered the interrupt, and then the period is over and not yet counted.
  [[nodiscard]] std::uint32_t gone() const {
    std::uint32_t left = registers_.current.read();
    if (left == 0) {
      left = registers_.current.read();
    }
    return (period_us_ * kTicksPerMicrosecond - left) / kTicksPerMicrosecond;
  }

  Registers& registers_;
  std::uint32_t period_us_ = 0;
  lifemodel::SharedWord<std::uint32_t> low_;  ///< periods that are over
  lifemodel::SharedWord<std::uint32_t> high_;
};

}  // namespace hal::qemu_mps2
