#pragma once

#include <array>
#include <cstddef>
#include <new>
#include <utility>

namespace firmware::qemu_mps2 {

/// Makes the one T of the program, in room of its own and not on the stack. It is never destroyed.
/// Precondition: called once for each T.
template <class T, class... Arguments>
T& place(Arguments&&... arguments) {
  alignas(T) static std::array<std::byte, sizeof(T)> room;
  return *new (room.data()) T(std::forward<Arguments>(arguments)...);
}

}  // namespace firmware::qemu_mps2
