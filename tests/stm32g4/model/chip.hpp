#pragma once

#include "hal/stm32g4/clock_tree.hpp"
#include "hal/stm32g4/timers.hpp"
#include "tests/stm32g4/model/analog_model.hpp"
#include "tests/stm32g4/model/can_model.hpp"
#include "tests/stm32g4/model/flash_model.hpp"
#include "tests/stm32g4/model/peripheral_models.hpp"
#include "tests/stm32g4/model/rcc_model.hpp"

namespace stm32g4_models {

/// An STM32G431 after reset.
struct Chip {
  Supply supply;
  RccModel rcc{supply};
  PowerModel pwr{supply, rcc};
  FlashModel flash{supply};
  GpioModel gpio_a{rcc, 1u << 0}, gpio_b{rcc, 1u << 1}, gpio_c{rcc, 1u << 2};
  TimerModel tim1{rcc, rcc.registers.apb2enr, 1u << 11};
  TimerModel tim2{rcc, rcc.registers.apb1enr1, 1u << 0};
  OpampModel opamp{rcc};
  AdcCommonModel adc_common;
  AdcModel adc1{rcc, adc_common, tim2, tim1}, adc2{rcc, adc_common, tim2, tim1};
  MessageRamModel message_ram;
  CanModel can{rcc, message_ram};
  WatchdogModel watchdog;
  RandomModel random{rcc};

  Chip() {
    adc2.on_trigger = [this] { trigger(); };
  }

  /// TIM1 reaches its top: both converters take what the amplifiers give.
  void trigger() {
    // RM0440 21.4.11: internal outputs of the amplifiers.
    adc1.trigger([this](std::uint32_t channel) {
      EXPECT_EQ(channel, 13u);
      return amplified(0);
    });
    adc2.trigger([this](std::uint32_t channel) {
      EXPECT_TRUE(channel == 16 || channel == 18);
      return amplified(channel == 16 ? 1 : 2);
    });
  }

 private:
  [[nodiscard]] std::uint32_t amplified(std::size_t i) const {
    EXPECT_TRUE(opamp.ready(i)) << "amplifier " << i + 1 << " is not set up";
    return opamp.output[i];
  }
};

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
