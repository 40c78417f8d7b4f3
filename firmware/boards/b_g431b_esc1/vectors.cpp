#include "firmware/boards/b_g431b_esc1/vectors.hpp"

#include "firmware/boards/b_g431b_esc1/fault.hpp"
#include "firmware/boards/b_g431b_esc1/interrupts.hpp"
#include "firmware/boards/b_g431b_esc1/registers.hpp"
#include "firmware/boards/b_g431b_esc1/startup.hpp"

// Defined by the linker script.
extern "C" std::uint32_t stack_top[];

namespace board {
namespace {

constexpr std::size_t kNmi = 2;
constexpr std::size_t kPendSv = 14;

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

}  // namespace

extern "C" [[gnu::section(".vectors"), gnu::used]] constinit const VectorTable vector_table =
    make_table();

}  // namespace board
