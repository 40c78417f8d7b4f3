#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/boards/b_g431b_esc1/application.hpp"
#include "firmware/boards/b_g431b_esc1/interrupts.hpp"
#include "firmware/boards/b_g431b_esc1/node_page.hpp"

namespace boards::b_g431b_esc1 {

extern "C" void isr_settle() {
  static_assert(kTendons == 1, "once for each");
  application().app().settle();
}

Room<Hardware> hardware_room;

namespace {

/// The 96 bits that no other device has (RM0440 48.1).
std::array<std::byte, 12> unique_id() {
  constexpr std::uintptr_t kUniqueId = 0x1FFF7590;
  const auto* bytes = reinterpret_cast<const volatile std::uint8_t*>(kUniqueId);
  std::array<std::byte, 12> id{};
  for (std::size_t i = 0; i < id.size(); ++i) {
    id[i] = static_cast<std::byte>(bytes[i]);
  }
  return id;
}

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
  Hardware& devices = hardware_room.make();
  if (devices.start() != hal::Error::none || devices.start_sensor() != hal::Error::none) {
    fail_safe();
  }
  const NodeSettings settings = read_settings(devices);
  // Without a bus the life is counted all the same.
  (void)devices.start_can(settings.node, settings.terminated);
  App& app = make_application(devices, {settings.node, settings.key, unique_id(), settings.whole});
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
}  // namespace boards::b_g431b_esc1

int main() {
  boards::b_g431b_esc1::run();
}
