#pragma once

#include "hal/stm32g4/can_controller.hpp"
#include "hal/stm32g4/current_sensor.hpp"
#include "hal/stm32g4/flash_memory.hpp"
#include "hal/stm32g4/pins.hpp"
#include "hal/stm32g4/random.hpp"
#include "hal/stm32g4/timers.hpp"
#include "hal/stm32g4/watchdog.hpp"
#include "tests/stm32g4/model/chip.hpp"

namespace stm32g4_models {

using CanController = hal::stm32g4::CanController<Word>;
using CurrentSensor = hal::stm32g4::CurrentSensor<Word>;
using Input = hal::stm32g4::DebouncedInput<Word, 20>;
using FlashOperations = hal::stm32g4::FlashOperations<Word, FlashModel::Array>;
using FlashMemory = hal::stm32g4::FlashMemory<FlashOperations>;
using Clock = hal::stm32g4::MicrosecondClock<Word>;
using OutputPin = hal::stm32g4::OutputPin<Word>;
using RandomGenerator = hal::stm32g4::RandomGenerator<Word>;
using IndependentWatchdog = hal::stm32g4::IndependentWatchdog<Word>;

/// Every back end of the device, started, over its model: node 5.
struct HalDevices : ReadyChip {
  static constexpr std::uint32_t kFirstPage = 44;
  static constexpr std::uint32_t kStoragePages = 20;

  CanController can{ReadyChip::can.registers, message_ram.registers};
  hal::stm32g4::ShuntConverters<Word> converters{opamp.registers, adc1.registers, adc2.registers,
                                                 adc_common.registers};
  CurrentSensor sensor{converters};
  FlashOperations operations{flash.registers, flash.array};
  FlashMemory memory{operations, kFirstPage, kStoragePages};
  OutputPin output{{gpio_b.registers, 3}, hal::stm32g4::Active::high};
  OutputPin brake{{gpio_a.registers, 15}, hal::stm32g4::Active::low};
  Input input{{gpio_b.registers, 7}, hal::stm32g4::Active::high};
  RandomGenerator entropy{random.registers};
  IndependentWatchdog guard{watchdog.registers};

  CanModel& bus = ReadyChip::can;

  HalDevices() {
    flash.nmi = [this] { EXPECT_TRUE(operations.isr_ecc_error()); };
    EXPECT_EQ(can.start({0x205, 0x18DA05F1}), hal::Error::none);
    hal::stm32g4::SampleTimer<Word>(tim1.registers).start(hal::stm32g4::kCore_Hz, 10'000);
    EXPECT_EQ(converters.start(clock), hal::Error::none);
    output.start(false);
    brake.start(true);
    input.start(hal::stm32g4::Pull::up);
    entropy.start();
  }
};

}  // namespace stm32g4_models
