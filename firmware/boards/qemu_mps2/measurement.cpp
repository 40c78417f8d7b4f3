#include "firmware/boards/qemu_mps2/measurement.hpp"

#include "firmware/boards/qemu_mps2/registers.hpp"

namespace boards::qemu_mps2 {
namespace {

constexpr std::uint32_t kReload = 0xffffff;
constexpr std::uint32_t kEnable = 1u << 0;
constexpr std::uint32_t kProcessorClock = 1u << 2;
constexpr std::uint32_t kWrapped = 1u << 16;

}  // namespace

/// Restarts SysTick, calls function(a, b, c) and returns what SysTick then shows.
extern "C" std::uint32_t systick_after(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                       void (*function)());

InstructionCounter::InstructionCounter() {
  registers::kSysTickReload.write(kReload);
  registers::kSysTickControl.write(kEnable | kProcessorClock);
}

std::uint32_t InstructionCounter::count(const Call& call) const {
  const std::uint32_t left =
      systick_after(call.arguments[0], call.arguments[1], call.arguments[2], call.function);
  if ((registers::kSysTickControl.read() & kWrapped) != 0) {
    return kTooLong;
  }
  // With -icount shift=6 an instruction takes 64 ns, 1.6 ticks of 25 MHz. From the write to the
  // read are n + 1 instructions, and the counter has left its start by t = ceil(1.6 (n + 1)) - 1
  // ticks. Then n = floor(5 t / 8) for every n.
  const std::uint32_t ticks = kReload + 1 - left;
  return ticks * 5 / 8;
}

/// Paints the free stack, calls function(a, b, c) and returns how much paint is gone.
extern "C" std::uint32_t paint_gone_after(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                          void (*function)());

std::uint32_t stack_bytes(const Call& call) {
  return paint_gone_after(call.arguments[0], call.arguments[1], call.arguments[2], call.function);
}

}  // namespace boards::qemu_mps2
