#pragma once

#include <cstdint>

#include "firmware/boards/qemu_mps2/call.hpp"

namespace firmware::qemu_mps2 {

/// Bytes of stack that the call used: how far down it overwrote the paint that is laid before it.
/// Space that a frame holds but never writes is not seen.
[[nodiscard]] std::uint32_t stack_bytes(const Call& call);

}  // namespace firmware::qemu_mps2
