#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <type_traits>

namespace boards::qemu_mps2 {

/// A call of a function whose at most three arguments are one register each, to be measured.
struct Call {
  template <class Result, class... Arguments>
  Call(Result (*called)(Arguments...), std::type_identity_t<Arguments>... values)
      : arguments{std::bit_cast<std::uint32_t>(values)...},
        function(reinterpret_cast<void (*)()>(called)) {}

  std::array<std::uint32_t, 3> arguments;
  void (*function)();
};

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

/// Bytes of stack that the call used: how far down it overwrote the paint that is laid before it.
/// Space that a frame holds but never writes is not seen.
[[nodiscard]] std::uint32_t stack_bytes(const Call& call);

}  // namespace boards::qemu_mps2
