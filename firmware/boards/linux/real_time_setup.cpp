#include "firmware/boards/linux/real_time_setup.hpp"

#include <iostream>

#include "hal/linux/device_error.hpp"
#include "hal/linux/loop.hpp"

namespace board {

RealTimeSetup::RealTimeSetup(const LoopConfig& loop) : wanted_(loop.real_time) {
  if (wanted_ != RealTime::off) {
    refused_ = hal::linux_os::schedule_fifo(loop.priority);
  }
}

bool RealTimeSetup::complete() {
  if (wanted_ == RealTime::off) {
    return true;
  }
  hal::linux_os::schedule_normally();
  const std::string unlocked = hal::linux_os::lock_memory();
  refused_.append(refused_.empty() || unlocked.empty() ? "" : "; ").append(unlocked);
  if (!refused_.empty() && wanted_ == RealTime::prefer) {
    std::cerr << "tendonlife_controller: WARNING: no real time: " << refused_
              << "; deadlines may be missed, and are counted\n";
  }
  return refused_.empty() || wanted_ == RealTime::prefer;
}

void RealTimeSetup::check() const {
  if (!refused_.empty() && wanted_ == RealTime::require) {
    throw hal::linux_os::DeviceError("real time", refused_,
                                     "these rights, or real_time \"prefer\" in [loop]");
  }
}

}  // namespace board
