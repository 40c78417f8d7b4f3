#pragma once

#include <string>

#include "firmware/boards/linux/config.hpp"

namespace board {

/// Prepares the process for a control loop in real time: a thread that is started while this is
/// incomplete runs under SCHED_FIFO.
class RealTimeSetup {
 public:
  /// Puts the calling thread under SCHED_FIFO, for the thread that it will start.
  explicit RealTimeSetup(const LoopConfig& loop);

  /// Puts the calling thread back and locks the memory. Warns of what was refused; false where
  /// the configuration requires it.
  [[nodiscard]] bool complete();
  /// Throws hal::linux_os::DeviceError where the configuration requires what was refused.
  void check() const;

 private:
  RealTime wanted_;
  std::string refused_;
};

}  // namespace board
