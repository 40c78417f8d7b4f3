#pragma once

#include <time.h>

#include <cstdint>

#include "hal/clock.hpp"

namespace hal::linux_os {

/// CLOCK_MONOTONIC in nanoseconds.
inline std::int64_t monotonic_ns() {
  ::timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

/// Time since the machine started.
class MonotonicClock {
 public:
  [[nodiscard]] Time now() const {
    return microseconds(static_cast<std::uint64_t>(monotonic_ns()) / 1'000);
  }
};
static_assert(Clock<MonotonicClock>);

}  // namespace hal::linux_os
