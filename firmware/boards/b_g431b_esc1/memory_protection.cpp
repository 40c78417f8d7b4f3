#include "firmware/boards/b_g431b_esc1/memory_protection.hpp"

#include <cstdint>

#include "firmware/boards/b_g431b_esc1/registers.hpp"
#include "hal/stm32g4/registers/mpu.hpp"

// Defined by the linker script.
extern "C" std::uint32_t stack_guard[];

namespace board {

void guard_stack() {
  using hal::stm32g4::bit;
  namespace mpu = hal::stm32g4::mpu;
  auto& unit = registers::mpu();
  unit.rnr.write(0);
  unit.rbar.write(static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(stack_guard)));
  unit.rasr.write(mpu::kNoAccess | mpu::kNormalMemory | mpu::kSize32 | mpu::kEnableRegion);
  unit.ctrl.write(mpu::kDefaultMapElsewhere | mpu::kEnable);
  // A fault of its own, which becomes a hard fault where it cannot stack.
  hal::stm32g4::set_bits(registers::system_control().shcsr, bit(16));
}

}  // namespace board
