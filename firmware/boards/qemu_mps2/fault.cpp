#include "firmware/boards/qemu_mps2/fault.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

#include "firmware/boards/qemu_mps2/registers.hpp"
#include "firmware/boards/qemu_mps2/semihosting.hpp"

namespace firmware::qemu_mps2 {
namespace {

void write_hex(const char* label, std::uint32_t value) {
  std::array<char, 12> text{"0x"};
  for (std::size_t i = 0; i < 8; ++i) {
    text[2 + i] = "0123456789abcdef"[(value >> (28 - 4 * i)) & 15u];
  }
  text[10] = '\n';
  write(label);
  write(text.data());
}

}  // namespace

extern "C" [[noreturn, gnu::used]] void report_fault(const std::uint32_t* frame) {
  // The frame is unreadable where the stack itself ran over.
  constexpr std::uint32_t kStackingErrors = (1u << 12) | (1u << 4);
  const std::uint32_t status = registers::kConfigurableFaultStatus.read();
  write("fault\n");
  write_hex("  exception    ", registers::kInterruptControlState.read() & 0x1ffu);
  write_hex("  fault status ", status);
  if ((status & kStackingErrors) == 0) {
    write_hex("  instruction  ", frame[6]);
  }
  exit(kFaultExitCode);
}

extern "C" [[gnu::naked]] void fault() noexcept {
  __asm__ volatile(
      "mrs r0, msp\n"
      "ldr r1, =fault_stack_top\n"
      "mov sp, r1\n"
      "b report_fault\n");
}

extern "C" [[gnu::weak, gnu::alias("fault")]] void pend_sv() noexcept;
extern "C" [[gnu::weak, gnu::alias("fault")]] void sys_tick() noexcept;
extern "C" [[gnu::weak, gnu::alias("fault")]] void uart0_receive() noexcept;

}  // namespace firmware::qemu_mps2
