#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/boards/b_g431b_esc1/fault.hpp"
#include "firmware/boards/b_g431b_esc1/node_page.hpp"
#include "firmware/boards/b_g431b_esc1/places.hpp"
#include "firmware/boards/b_g431b_esc1/unique_id.hpp"

namespace board {

Place<Hardware> hardware_place;

namespace {

NodeSettings read_settings(Hardware& devices) {
  std::array<std::byte, kNodeBytes> bytes{};
  if (devices.node_memory.read(0, bytes) != hal::Error::none) {
    return kNoSettings;
  }
  return decode_node(bytes).value_or(kNoSettings);
}

/// RM0440 14.3; the control loop is never kept away. Its first interrupt is of a trigger yet to
/// come.
void enable_interrupts(Hardware& devices) {
  auto& system = registers::system_control();
  hal::stm32g4::replace_bits(system.shpr[2], 0xFFu << hal::stm32g4::core::kPendSvShift,
                             kSettlePriority << hal::stm32g4::core::kPendSvShift);
  constexpr unsigned kLoop = hal::stm32g4::kAdc12Interrupt;
  constexpr unsigned kShift = 8 * (kLoop % 4);
  hal::stm32g4::replace_bits(registers::interrupts().ipr[kLoop / 4], 0xFFu << kShift,
                             kLoopPriority << kShift);
  (void)devices.converters.isr_take();
  registers::interrupts().icpr[kLoop / 32].write(hal::stm32g4::bit(kLoop % 32));
  registers::interrupts().iser[kLoop / 32].write(hal::stm32g4::bit(kLoop % 32));
}

/// What the timing page of the bus shows.
protocol::detail::Timing timing_of(const hal::stm32g4::SampleTiming& timing) {
  const auto stopped = [](std::uint32_t value) {
    return static_cast<std::uint16_t>(value < 0xFFFF ? value : 0xFFFF);
  };
  return {stopped(timing.worst_us()), stopped(timing.p99_us()), stopped(timing.missed())};
}

[[noreturn]] void run() {
  Hardware& devices = hardware_place.make();
  if (devices.start() != hal::Error::none || devices.start_sensor() != hal::Error::none) {
    fail_safe();
  }
  const NodeSettings settings = read_settings(devices);
  // Without a bus the life is counted all the same.
  (void)devices.start_can(settings.node);
  App& app = make_application(devices, {settings.node, settings.key, unique_id()});
  devices.interlock.isr_apply(false);
  app.start();
  enable_interrupts(devices);
  while (true) {
    app.timing(timing_of(devices.timing));
    app.poll();
    __asm__ volatile("wfi" ::: "memory");
  }
}

}  // namespace
}  // namespace board

int main() {
  board::run();
}
