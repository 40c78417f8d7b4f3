#pragma once

#include <sys/random.h>
#include <sys/types.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <span>

#include "hal/devices.hpp"
#include "hal/error.hpp"

namespace hal::linux_os {

/// The random source of the kernel, getrandom(2). Does not wait for a source that is not ready.
class KernelEntropy {
 public:
  Error fill(std::span<std::byte> out) {
    std::size_t done = 0;
    while (done < out.size()) {
      const ssize_t count = ::getrandom(out.data() + done, out.size() - done, GRND_NONBLOCK);
      if (count < 0 && errno == EINTR) {
        continue;
      }
      if (count <= 0) {
        std::fill(out.begin(), out.end(), std::byte{0});
        return Error::failed;
      }
      done += static_cast<std::size_t>(count);
    }
    return Error::none;
  }
};
static_assert(Entropy<KernelEntropy>);

}  // namespace hal::linux_os
