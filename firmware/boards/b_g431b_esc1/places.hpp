#pragma once

#include <array>
#include <cstddef>
#include <new>
#include <utility>

#include "firmware/boards/b_g431b_esc1/application.hpp"
#include "firmware/boards/b_g431b_esc1/hardware.hpp"

namespace board {

/// Room for an object that interrupts reach and main() makes, so that nothing is made before main()
/// and nothing is ever destroyed.
template <class T>
class Place {
 public:
  template <class... Arguments>
  T& make(Arguments&&... arguments) {
    return *new (room_.data()) T(std::forward<Arguments>(arguments)...);
  }
  /// Precondition: make() was called.
  [[nodiscard]] T& get() { return *std::launder(reinterpret_cast<T*>(room_.data())); }

 private:
  alignas(T) std::array<std::byte, sizeof(T)> room_;
};

extern Place<Hardware> hardware_place;
extern Place<Application> application_place;

inline Hardware& hardware() {
  return hardware_place.get();
}
inline Application& application() {
  return application_place.get();
}

}  // namespace board
