#pragma once

#include <concepts>

namespace hal {

/// Resets the controller, or drops its safety line, unless it is fed in time.
template <class T>
concept Watchdog = requires(T& watchdog) {
  { watchdog.feed() } -> std::same_as<void>;
};

}  // namespace hal
