#include "firmware/boards/b_g431b_esc1/startup.hpp"

#include <algorithm>
#include <cstdint>

#include "firmware/boards/b_g431b_esc1/fault.hpp"
#include "firmware/boards/b_g431b_esc1/memory_protection.hpp"
#include "firmware/boards/b_g431b_esc1/registers.hpp"
#include "firmware/boards/b_g431b_esc1/vectors.hpp"

// Defined by the linker script.
extern "C" {
extern std::uint32_t data_begin[], data_end[], bss_begin[], bss_end[];
extern std::uint32_t ram_code_begin[], ram_code_end[];
extern std::uint32_t ram_vectors[];
extern const std::uint32_t data_load[], ram_code_load[];
}

// C++ allows nobody to call main by its own name.
extern "C" int run_program() __asm__("main");

namespace board {
namespace {

void copy(const std::uint32_t* from, std::uint32_t* begin, const std::uint32_t* end) {
  std::copy_n(from, end - begin, begin);
}

}  // namespace

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

}  // namespace board
