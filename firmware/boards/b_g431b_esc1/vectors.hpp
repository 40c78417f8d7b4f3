#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "hal/stm32g4/registers/core.hpp"

namespace board {

/// DDI 0403E B1.5.3, and RM0440 14.3 for the interrupts of category 2 devices.
struct VectorTable {
  std::uint32_t* initial_stack;
  std::array<void (*)(), 15 + hal::stm32g4::kInterrupts> handlers;
};

/// The table for reset, in flash; startup makes a copy in RAM and uses that.
extern "C" const VectorTable vector_table;

}  // namespace board
