#include "firmware/boards/b_g431b_esc1/hardware.hpp"

#include "firmware/protocol/isotp/pdu.hpp"
#include "firmware/protocol/schema/frames.hpp"
#include "hal/stm32g4/clock_tree.hpp"
#include "hal/stm32g4/core.hpp"
#include "hal/stm32g4/timers.hpp"

// Defined by the linker script.
extern "C" std::uint32_t stack_guard[];

namespace boards::b_g431b_esc1 {

hal::Error Hardware::start() {
  hal::stm32g4::ClockTree<Register> tree(registers::rcc(), registers::pwr(), registers::flash());
  if (!tree.start() || hal::stm32g4::enable_peripherals(registers::rcc()) != hal::Error::none) {
    return hal::Error::failed;
  }
  lines.drive_enable.start(false);
  lines.brake.start(true);
  lines.emergency_stop.start(hal::stm32g4::Pull::up);
  status_light.start(false);
  clock.start(hal::stm32g4::kCore_Hz);
  entropy.start();
  constexpr std::uint32_t kWatchdog_ms = 250;
  return watchdog.start(kWatchdog_ms);
}

hal::Error Hardware::start_sensor() {
  // UM2516: inputs and outputs of the three shunt amplifiers.
  for (const unsigned line : {1u, 2u, 3u, 5u, 6u, 7u}) {
    hal::stm32g4::make_analog(pins::Pin{registers::gpio_a(), line});
  }
  for (const unsigned line : {0u, 1u, 2u}) {
    hal::stm32g4::make_analog(pins::Pin{registers::gpio_b(), line});
  }
  hal::stm32g4::SampleTimer<Register> timer(registers::tim1());
  timer.start(hal::stm32g4::kCore_Hz, kLoop_Hz);
  if (converters.start(clock) != hal::Error::none) {
    return hal::Error::failed;
  }
  // Broken amplifiers leave a sensor that fails, which the application reports.
  (void)sensor.calibrate_at_rest();
  return hal::Error::none;
}

hal::Error Hardware::start_can(std::uint8_t node, bool terminated) {
  using hal::stm32g4::Level;
  hal::stm32g4::make_output(pins::can_termination(), terminated ? Level::high : Level::low);
  hal::stm32g4::make_output(pins::can_shutdown(), Level::low);
  hal::stm32g4::make_alternate(pins::can_receive(), pins::kCanFunction);
  hal::stm32g4::make_alternate(pins::can_transmit(), pins::kCanFunction);
  return can.start({std::uint32_t{protocol::schema::kCommandFrame.base_id} + node,
                    protocol::isotp::Address::to_node(node).id()});
}

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

}  // namespace boards::b_g431b_esc1
