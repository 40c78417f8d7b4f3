#pragma once

#include <concepts>
#include <cstddef>
#include <span>

#include "hal/error.hpp"

namespace hal {

/// Random bytes that nobody can foretell. failed, and nothing usable, where the source is broken.
template <class T>
concept Entropy = requires(T& source, std::span<std::byte> out) {
  { source.fill(out) } -> std::same_as<Error>;
};

}  // namespace hal
