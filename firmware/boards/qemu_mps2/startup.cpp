#include "firmware/boards/qemu_mps2/startup.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "firmware/boards/qemu_mps2/registers.hpp"
#include "firmware/boards/qemu_mps2/semihosting.hpp"

namespace boards::qemu_mps2 {
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

}  // namespace boards::qemu_mps2

// Defined by the linker script.
extern "C" {
extern std::uint32_t stack_top[];
extern std::uint32_t data_begin[], data_end[], bss_begin[], bss_end[];
extern const std::uint32_t data_load[];
}

// C++ allows nobody to call main by its own name.
extern "C" int run_program() __asm__("main");

namespace boards::qemu_mps2 {
namespace {

struct VectorTable {
  std::uint32_t* initial_stack;
  std::array<void (*)(), 15> handlers;
  std::array<void (*)(), 32> interrupts;
};

/// Everything below the SRAM becomes read-only: QEMU would take writes to a null pointer and past
/// the end of the stack in silence.
void protect_memory() {
  constexpr std::uint32_t kEnable = 1u << 0;
  constexpr std::uint32_t kDefaultMapElsewhere = 1u << 2;
  constexpr std::uint32_t kReadOnly = 6u << 24;
  constexpr std::uint32_t kNormalMemory = 1u << 17;
  constexpr std::uint32_t kSize512MB = 28u << 1;
  registers::kMpuRegionNumber.write(0);
  registers::kMpuRegionBase.write(0);
  registers::kMpuRegionAttributes.write(kReadOnly | kNormalMemory | kSize512MB | kEnable);
  registers::kMpuControl.write(kDefaultMapElsewhere | kEnable);
  __asm__ volatile("dsb\n\tisb" ::: "memory");
}

}  // namespace

extern "C" [[noreturn]] void reset() {
  protect_memory();
  const std::uint32_t* from = data_load;
  std::transform(data_begin, data_end, data_begin, [&from](std::uint32_t) { return *from++; });
  std::fill(bss_begin, bss_end, 0u);
  exit(run_program());
}

constexpr std::array<void (*)(), 32> interrupts() {
  std::array<void (*)(), 32> all{};
  all.fill(fault);
  all[0] = uart0_receive;
  return all;
}

// ARMv7-M Architecture Reference Manual (DDI 0403E), B1.5.3. Interrupt 0 of the AN386 image is
// the receive interrupt of UART 0.
extern "C" [[gnu::section(".vectors"), gnu::used]] constinit const VectorTable vector_table{
    stack_top,
    {reset, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault,
     pend_sv, sys_tick},
    interrupts()};

}  // namespace boards::qemu_mps2
