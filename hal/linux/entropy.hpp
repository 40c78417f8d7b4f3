#pragma once

#include <cstddef>
#include <span>

#include "hal/entropy.hpp"
#include "hal/error.hpp"

namespace hal::linux_os {

/// The random source of the kernel, getrandom(2). Does not wait for a source that is not ready.
class KernelEntropy {
 public:
  Error fill(std::span<std::byte> out);
};
static_assert(Entropy<KernelEntropy>);

}  // namespace hal::linux_os
