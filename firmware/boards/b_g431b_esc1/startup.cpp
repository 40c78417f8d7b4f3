#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "firmware/boards/b_g431b_esc1/hardware.hpp"
#include "firmware/boards/b_g431b_esc1/interrupts.hpp"
#include "firmware/boards/b_g431b_esc1/registers.hpp"
#include "hal/stm32g4/core.hpp"

// Defined by the linker script.
extern "C" {
extern std::uint32_t stack_top[];
extern std::uint32_t data_begin[], data_end[], bss_begin[], bss_end[];
extern std::uint32_t ram_code_begin[], ram_code_end[];
extern std::uint32_t ram_vectors[];
extern const std::uint32_t data_load[], ram_code_load[];
}

// C++ allows nobody to call main by its own name.
extern "C" int run_program() __asm__("main");

namespace boards::b_g431b_esc1 {
namespace {

constexpr std::size_t kNmi = 2;
constexpr std::size_t kPendSv = 14;

/// DDI 0403E B1.5.3, and RM0440 14.3 for the interrupts of category 2 devices.
struct VectorTable {
  std::uint32_t* initial_stack;
  std::array<void (*)(), 15 + hal::stm32g4::kInterrupts> handlers;
};

constexpr VectorTable make_table() {
  VectorTable table{};
  table.initial_stack = stack_top;
  table.handlers.fill(isr_fault);
  const auto at = [&table](std::size_t exception) -> auto& {
    return table.handlers[exception - 1];
  };
  at(1) = isr_reset;
  at(kNmi) = isr_nmi;
  at(kPendSv) = isr_settle;
  at(16 + hal::stm32g4::kAdc12Interrupt) = isr_control;
  return table;
}

void copy(const std::uint32_t* from, std::uint32_t* begin, const std::uint32_t* end) {
  std::copy_n(from, end - begin, begin);
}

}  // namespace

// The table for reset, in flash; isr_reset() makes a copy in RAM and uses that.
extern "C" [[gnu::section(".vectors"), gnu::used]] constinit const VectorTable vector_table =
    make_table();

extern "C" [[noreturn]] void isr_reset() {
  copy(data_load, data_begin, data_end);
  copy(ram_code_load, ram_code_begin, ram_code_end);
  std::fill(bss_begin, bss_end, 0u);
  copy(reinterpret_cast<const std::uint32_t*>(&vector_table), ram_vectors,
       ram_vectors + sizeof(VectorTable) / sizeof(std::uint32_t));
  registers::system_control().vtor.write(
      static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(ram_vectors)));
  guard_stack();
  __asm__ volatile("dsb\n\tisb" ::: "memory");
  (void)run_program();
  fail_safe();
}

}  // namespace boards::b_g431b_esc1
