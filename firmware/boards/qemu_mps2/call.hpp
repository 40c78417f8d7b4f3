#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <type_traits>

namespace firmware::qemu_mps2 {

/// A call of a function whose at most three arguments are one register each, to be measured.
struct Call {
  template <class Result, class... Arguments>
  Call(Result (*called)(Arguments...), std::type_identity_t<Arguments>... values)
      : arguments{std::bit_cast<std::uint32_t>(values)...},
        function(reinterpret_cast<void (*)()>(called)) {}

  std::array<std::uint32_t, 3> arguments;
  void (*function)();
};

}  // namespace firmware::qemu_mps2
