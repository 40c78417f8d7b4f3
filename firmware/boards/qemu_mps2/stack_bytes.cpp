#include "firmware/boards/qemu_mps2/stack_bytes.hpp"

namespace firmware::qemu_mps2 {

/// Paints the free stack, calls function(a, b, c) and returns how much paint is gone.
extern "C" std::uint32_t paint_gone_after(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                          void (*function)());

std::uint32_t stack_bytes(const Call& call) {
  return paint_gone_after(call.arguments[0], call.arguments[1], call.arguments[2], call.function);
}

}  // namespace firmware::qemu_mps2
