#pragma once

#include <gtest/gtest.h>
#include <linux/can.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <sys/socket.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "hal/linux/can_wire.hpp"
#include "hal/linux/descriptor.hpp"

namespace kernel_test {

/// What the environment says to the tests; throws where it is missing.
inline std::string setting(const char* name) {
  const char* const value = std::getenv(name);
  if (value == nullptr) {
    throw std::runtime_error(std::string(name) + " is not set");
  }
  return value;
}

/// The ends of a vxcan pair.
inline std::string near_end() {
  return setting("TENDONLIFE_NEAR");
}
inline std::string far_end() {
  return setting("TENDONLIFE_FAR");
}

/// Runs a command of the system; throws where it fails.
inline void run(const std::string& command) {
  if (std::system(command.c_str()) != 0) {
    throw std::runtime_error(command + " failed");
  }
}

inline void wait(std::chrono::microseconds time) {
  std::this_thread::sleep_for(time);
}

/// The first true value of `condition` within five seconds, or false.
template <class Condition>
bool eventually(Condition condition) {
  for (int i = 0; i < 500; ++i) {
    if (condition()) {
      return true;
    }
    wait(std::chrono::milliseconds(10));
  }
  return false;
}

/// Every data frame of both kinds.
inline constexpr std::array kEveryFrame{
    hal::linux_os::CanFilter{.id = 0, .mask = 0, .extended = false},
    hal::linux_os::CanFilter{.id = 0, .mask = 0, .extended = true}};

/// Writes a frame as it is, error frames too, which a port does not send.
inline void write_raw(const std::string& interface, const ::can_frame& frame) {
  const hal::linux_os::Descriptor socket(::socket(PF_CAN, SOCK_RAW, CAN_RAW));
  ::sockaddr_can address{};
  address.can_family = AF_CAN;
  address.can_ifindex = static_cast<int>(::if_nametoindex(interface.c_str()));
  if (::bind(socket.get(), reinterpret_cast<const ::sockaddr*>(&address), sizeof address) != 0 ||
      ::send(socket.get(), &frame, sizeof frame, 0) != static_cast<ssize_t>(sizeof frame)) {
    throw std::runtime_error("cannot write to " + interface);
  }
}

/// A line of the simulated chip, from outside.
class WorldLine {
 public:
  explicit WorldLine(unsigned offset)
      : folder_(setting("TENDONLIFE_CHIP_STATE") + "/sim_gpio" + std::to_string(offset)) {}

  void pull(bool up) const { std::ofstream(folder_ + "/pull") << (up ? "pull-up" : "pull-down"); }
  [[nodiscard]] bool value() const {
    int value = -1;
    std::ifstream(folder_ + "/value") >> value;
    return value == 1;
  }

 private:
  std::string folder_;
};

}  // namespace kernel_test
