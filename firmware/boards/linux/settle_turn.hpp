#pragma once

#include <mutex>

#include "hal/devices.hpp"

namespace board {

/// Whose turn it is with what has been counted: the control loop's, which settles and never waits,
/// or the application's, which reads.
class SettleTurn {
 public:
  /// Of the application.
  void hold() { mutex_.lock(); }
  void release() { mutex_.unlock(); }

  /// Of the control loop: calls `settle` while it gives true, at most `most` times, unless the
  /// application reads; then what waits is settled in a later period.
  template <class Settle>
  void isr_settle(int most, Settle&& settle) {
    const std::unique_lock turn(mutex_, std::try_to_lock);
    for (int i = 0; turn && i < most && settle(); ++i) {
    }
  }

 private:
  std::mutex mutex_;
};
static_assert(hal::Hold<SettleTurn>);

}  // namespace board
