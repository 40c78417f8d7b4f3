#pragma once

#include <cstdint>

#include "firmware/boards/b_g431b_esc1/board_flash.hpp"
#include "firmware/boards/b_g431b_esc1/control_loop.hpp"
#include "firmware/boards/b_g431b_esc1/interrupts.hpp"
#include "firmware/boards/b_g431b_esc1/pins.hpp"
#include "firmware/boards/interlock.hpp"
#include "firmware/storage/slot.hpp"
#include "hal/stm32g4/can_controller.hpp"
#include "hal/stm32g4/current_sensor.hpp"
#include "hal/stm32g4/flash_memory.hpp"
#include "hal/stm32g4/pins.hpp"
#include "hal/stm32g4/random.hpp"
#include "hal/stm32g4/timers.hpp"
#include "hal/stm32g4/watchdog.hpp"

namespace boards::b_g431b_esc1 {

/// Pages of 2 KiB from the start of the flash: 43 of code, one with the node's own settings, 20 of
/// the store. The linker script has the first.
inline constexpr std::uint32_t kFlashPages = 64;
inline constexpr std::uint32_t kNodePage = 43;
inline constexpr std::uint32_t kStorePage = 44;
inline constexpr storage::FlashLayout kStoreLayout{};
inline constexpr std::uint32_t kStorePages = kStoreLayout.log.end();
static_assert(kStorePage + kStorePages == kFlashPages);

/// The lines that keep people safe; of the control loop alone.
struct SafetyLines {
  using Output = hal::stm32g4::OutputPin<registers::Register>;

  Output drive_enable{pins::drive_enable(), hal::stm32g4::Active::high};
  /// Asserted, the brake holds: the coil that opens it is without current.
  Output brake{pins::brake_release(), hal::stm32g4::Active::low};
  /// A contact to ground that opens: a broken wire stops too.
  hal::stm32g4::DebouncedInput<registers::Register, kStopSamples> emergency_stop{
      pins::emergency_stop(), hal::stm32g4::Active::high};
};

/// The devices of the board.
struct Hardware {
  using Register = registers::Register;
  using Memory = hal::stm32g4::FlashMemory<BoardFlash>;
  using Lock = Interlock<SafetyLines, kPeriodsInTime>;

  hal::stm32g4::MicrosecondClock<Register> clock{registers::tim2()};
  hal::stm32g4::ShuntConverters<Register> converters{registers::opamp(), registers::adc1(),
                                                     registers::adc2(), registers::adc12_common()};
  hal::stm32g4::CurrentSensor<Register> sensor{converters};
  hal::stm32g4::CanController<Register> can{registers::fdcan1(), registers::message_ram()};
  SafetyLines lines;
  Lock interlock{lines};
  Lock::Drive drive_enable{interlock};
  Lock::Brake brake{interlock};
  Lock::Stop emergency_stop{interlock};
  hal::stm32g4::OutputPin<Register> status_light{pins::status_light(), hal::stm32g4::Active::high};
  hal::stm32g4::IndependentWatchdog<Register> watchdog{registers::iwdg()};
  hal::stm32g4::RandomGenerator<Register> entropy{registers::rng()};
  BoardFlash flash;
  Memory node_memory{flash, kNodePage, 1};
  Memory store_memory{flash, kStorePage, kStorePages};
  SettleHold hold;
  hal::stm32g4::SampleTiming timing;

  /// Clocks, safety lines and watchdog; failed, where the board cannot run.
  hal::Error start();
  /// Current measurement and with it the trigger of the control loop, while the drive is off;
  /// failed, where it does not come.
  hal::Error start_sensor();
  /// Joins the bus, with its 120 ohm where it is `terminated` here.
  hal::Error start_can(std::uint8_t node, bool terminated);
};

/// Makes the lowest bytes of the stack, which lies lowest in its memory, fault.
void guard_stack();

}  // namespace boards::b_g431b_esc1
