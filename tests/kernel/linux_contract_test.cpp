/// The contract of hal/*.hpp over SocketCAN, GPIO and the rest of a real kernel.
#include <gtest/gtest.h>

#include <chrono>
#include <span>
#include <vector>

#include "hal/linux/entropy.hpp"
#include "hal/linux/gpiod_lines.hpp"
#include "hal/linux/monotonic_clock.hpp"
#include "hal/linux/socketcan.hpp"
#include "tests/hal/contract/can_port.hpp"
#include "tests/hal/contract/clock.hpp"
#include "tests/hal/contract/digital.hpp"
#include "tests/hal/contract/entropy.hpp"
#include "tests/kernel/kernel_rig.hpp"

namespace hal_test {
namespace {

using namespace hal::linux_os;
using namespace std::chrono_literals;

class CableCan {
 public:
  ~CableCan() {
    if (blocked_) {
      unblock();
    }
  }

  SocketCan& port() { return port_; }
  std::vector<hal::CanFrame> on_bus() {
    std::vector<hal::CanFrame> frames;
    for (int quiet = 0; quiet < 5; ++quiet) {
      while (const auto frame = peer_.receive()) {
        frames.push_back(*frame);
        quiet = 0;
      }
      kernel_test::wait(2ms);
    }
    return frames;
  }
  void peer_sends(const hal::CanFrame& frame) {
    ASSERT_EQ(peer_.send(frame), hal::Error::none);
    kernel_test::wait(5ms);
  }
  hal::CanFrame accepted(std::uint8_t n) { return frame(0x201, 8, n); }

  // Ten frames stand in the queue for half a second, and no other fits.
  bool block() {
    kernel_test::run("tc qdisc add dev " + kernel_test::near_end() +
                     " root netem delay 500ms limit 10");
    blocked_ = true;
    return true;
  }
  bool unblock() {
    kernel_test::wait(1s);
    kernel_test::run("tc qdisc delete dev " + kernel_test::near_end() + " root");
    blocked_ = false;
    return true;
  }
  bool go_off() {
    ::can_frame off{};
    off.can_id = CAN_ERR_FLAG | CAN_ERR_BUSOFF;
    off.can_dlc = CAN_ERR_DLC;
    kernel_test::write_raw(kernel_test::far_end(), off);
    return kernel_test::eventually([this] {
      EXPECT_EQ(port_.receive(), std::nullopt);
      return port_.status().state == hal::CanState::off;
    });
  }
  bool come_back() { return true; }

 private:
  static constexpr CanFilter kToPort{.id = 0x201, .mask = 0x7ff, .extended = false};

  CanCalls port_calls_;
  CanCalls peer_calls_;
  SocketCan port_{port_calls_, kernel_test::near_end(), std::span(&kToPort, 1)};
  SocketCan peer_{peer_calls_, kernel_test::far_end(), kernel_test::kEveryFrame};
  bool blocked_ = false;
};

class SimulatedIn {
 public:
  GpioEmergencyStop& line() { return line_; }
  void drive(bool asserted) {
    world_.pull(asserted);
    kernel_test::wait(100ms);
  }
  bool break_it() { return false; }

 private:
  kernel_test::WorldLine world_{0};
  GpioEmergencyStop line_{kernel_test::setting("TENDONLIFE_CHIP"), LineSpec{"0"}, 2ms};
};

class SimulatedOut {
 public:
  GpioOutput& line() { return line_; }
  bool seen() { return world_.value(); }
  bool break_it() { return false; }

 private:
  kernel_test::WorldLine world_{1};
  GpioOutput line_{kernel_test::setting("TENDONLIFE_CHIP"), LineSpec{"1"}};
};

class SimulatedOutActiveLow {
 public:
  GpioOutput& line() { return line_; }
  bool seen() { return !world_.value(); }
  bool break_it() { return false; }

 private:
  kernel_test::WorldLine world_{1};
  GpioOutput line_{kernel_test::setting("TENDONLIFE_CHIP"), LineSpec{"1", true}};
};

class MachineClock {
 public:
  const MonotonicClock& clock() { return clock_; }
  void pass(std::uint32_t time_us) { kernel_test::wait(std::chrono::microseconds(time_us)); }
  bool exact() { return false; }

 private:
  MonotonicClock clock_;
};

class MachineEntropy {
 public:
  KernelEntropy& source() { return source_; }
  bool break_it() { return false; }

 private:
  KernelEntropy source_;
};

INSTANTIATE_TYPED_TEST_SUITE_P(Kernel, CanPortContract, CableCan);
INSTANTIATE_TYPED_TEST_SUITE_P(Kernel, DigitalInContract, SimulatedIn);
INSTANTIATE_TYPED_TEST_SUITE_P(Kernel, DigitalOutContract, SimulatedOut);
INSTANTIATE_TYPED_TEST_SUITE_P(KernelActiveLow, DigitalOutContract, SimulatedOutActiveLow);
INSTANTIATE_TYPED_TEST_SUITE_P(Kernel, ClockContract, MachineClock);
INSTANTIATE_TYPED_TEST_SUITE_P(Kernel, EntropyContract, MachineEntropy);

}  // namespace
}  // namespace hal_test
