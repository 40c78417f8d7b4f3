#include "hal/linux/entropy.hpp"

#include <sys/random.h>

#include <algorithm>
#include <cerrno>

namespace hal::linux_os {

Error KernelEntropy::fill(std::span<std::byte> out) {
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

}  // namespace hal::linux_os
