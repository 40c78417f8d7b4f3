#pragma once

#include <cstdint>

#include "firmware/boards/qemu_mps2/call.hpp"

namespace firmware::qemu_mps2 {

/// Counts executed instructions, exactly, with SysTick. Instructions are not cycles.
class InstructionCounter {
 public:
  /// The longest count, about 10.4 million.
  static constexpr std::uint32_t kLongest = 0xffffffu * 5 / 8;
  /// In place of a longer one.
  static constexpr std::uint32_t kTooLong = 0xffffffffu;

  /// Sets SysTick up; nobody else may use it.
  InstructionCounter();

  /// Instructions of the call: the branch to the function, all of it, and its return.
  [[nodiscard]] std::uint32_t count(const Call& call) const;
};

}  // namespace firmware::qemu_mps2
