#pragma once

#include "hal/stm32g4/clock_tree.hpp"
#include "hal/stm32g4/timers.hpp"
#include "tests/stm32g4/model/chip.hpp"

namespace stm32g4_models {

/// A chip whose clocks run as the back ends need them.
struct ReadyChip : Chip {
  hal::stm32g4::MicrosecondClock<Word> clock{tim2.registers};

  ReadyChip() {
    hal::stm32g4::ClockTree<Word> tree(rcc.registers, pwr.registers, flash.registers);
    EXPECT_TRUE(tree.start());
    EXPECT_EQ(hal::stm32g4::enable_peripherals(rcc.registers), hal::Error::none);
    clock.start(hal::stm32g4::kCore_Hz);
  }
};

}  // namespace stm32g4_models
