#pragma once

#include "hal/clock.hpp"

namespace hal::qemu_mps2 {

/// Time that goes on only when it is told to.
class VirtualClock {
 public:
  void advance(Time by) { now_ = now_ + by; }
  [[nodiscard]] Time now() const { return now_; }

 private:
  Time now_{};
};

}  // namespace hal::qemu_mps2
