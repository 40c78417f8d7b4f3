#include <linux/can/error.h>

#include <chrono>
#include <deque>
#include <thread>

#include "hal/linux/edge_follower.hpp"
#include "hal/linux/entropy.hpp"
#include "hal/linux/monotonic_clock.hpp"
#include "hal/linux/socketcan.hpp"
#include "tests/hal/contract/can_port.hpp"
#include "tests/hal/contract/clock.hpp"
#include "tests/hal/contract/digital.hpp"
#include "tests/hal/contract/emergency_stop.hpp"
#include "tests/hal/contract/entropy.hpp"

namespace hal_test {
namespace {

namespace linux_os = hal::linux_os;

/// The kernel as SocketCan meets it: an interface queue of ten frames, and error frames.
class KernelCan {
 public:
  void open(const std::string&, std::span<const linux_os::CanFilter>) {}
  int reopen() { return 0; }
  void close() {}
  int send(const ::can_frame& frame) {
    if (full && queued == kQueue) {
      return ENOBUFS;
    }
    queued += full ? 1 : 0;
    sent.push_back(*linux_os::from_kernel(frame));
    return 0;
  }
  linux_os::CanReceipt receive() {
    if (waiting.empty()) {
      linux_os::CanReceipt none;
      none.error = EAGAIN;
      return none;
    }
    linux_os::CanReceipt receipt;
    receipt.frame = waiting.front();
    waiting.pop_front();
    return receipt;
  }
  [[nodiscard]] bool is_up() const { return true; }
  linux_os::CanRestart restart() { return linux_os::CanRestart::asked; }
  [[nodiscard]] hal::Time now() const { return hal::seconds(1); }

  void report(std::uint32_t error_class) {
    ::can_frame frame{};
    frame.can_id = CAN_ERR_FLAG | error_class;
    frame.can_dlc = CAN_ERR_DLC;
    waiting.push_back(frame);
  }

  static constexpr int kQueue = 10;
  bool full = false;
  int queued = 0;
  std::vector<hal::CanFrame> sent;
  std::deque<::can_frame> waiting;
};

class SocketCan {
 public:
  linux_os::BasicSocketCan<KernelCan>& port() { return port_; }
  std::vector<hal::CanFrame> on_bus() { return std::exchange(kernel_.sent, {}); }
  void peer_sends(const hal::CanFrame& frame) {
    kernel_.waiting.push_back(linux_os::to_kernel(frame));
  }
  hal::CanFrame accepted(std::uint8_t n) { return frame(0x205, 8, n); }
  bool block() {
    kernel_.full = true;
    return true;
  }
  bool unblock() {
    kernel_.full = false;
    return true;
  }
  bool go_off() {
    kernel_.report(CAN_ERR_BUSOFF);
    return port_.receive() == std::nullopt;
  }
  bool come_back() {
    kernel_.report(CAN_ERR_RESTARTED);
    return port_.receive() == std::nullopt;
  }

 private:
  KernelCan kernel_;
  linux_os::BasicSocketCan<KernelCan> port_{kernel_, "can0", {}};
};

class Monotonic {
 public:
  const linux_os::MonotonicClock& clock() { return clock_; }
  void pass(std::uint32_t time_us) {
    std::this_thread::sleep_for(std::chrono::microseconds(time_us + 1));
  }
  bool exact() { return false; }

 private:
  linux_os::MonotonicClock clock_;
};

/// A line as libgpiod reports it.
class Edges {
 public:
  hal::Result<std::size_t> read(std::span<linux_os::Edge> out) {
    if (broken) {
      return hal::Error::failed;
    }
    std::size_t count = 0;
    for (; count < out.size() && !waiting.empty(); ++count) {
      out[count] = waiting.front();
      waiting.pop_front();
    }
    return count;
  }
  hal::Result<bool> level() { return broken ? hal::Result<bool>(hal::Error::failed) : now; }

  bool now = false;
  bool broken = false;
  std::deque<linux_os::Edge> waiting;
};

class Followed {
 public:
  linux_os::EdgeFollower<Edges>& line() { return follower_; }
  void drive(bool asserted) {
    if (asserted != edges_.now) {
      ++number_;
      edges_.now = asserted;
      edges_.waiting.push_back({asserted, number_, number_, number_ * std::uint64_t{1'000}});
    }
  }
  bool break_it() { return edges_.broken = true; }

 private:
  Edges edges_;
  std::uint32_t number_ = 0;
  linux_os::EdgeFollower<Edges> follower_{edges_};
};

/// The lines as the controller has them: the kernel debounces for 2 ms, and the control loop is a
/// thread of its own that the application's disk does not hold up.
class Board {
  static constexpr std::uint32_t kDebounce_us = 2'000;

 public:
  static constexpr std::uint32_t kPeriod_us = 1'000;
  static constexpr std::uint32_t kPeriodsInTime = 10;
  static constexpr std::uint32_t kShortest_us = 3'000;
  static constexpr std::uint32_t kOffWithin_us = kDebounce_us + kPeriod_us;

  struct Output {
    hal::Error set(bool on) {
      if (stuck) {
        return hal::Error::failed;
      }
      asserted = on;
      return hal::Error::none;
    }

    bool asserted = false;
    bool stuck = false;
  };
  struct Lines {
    Output drive_enable;
    Output brake;
    linux_os::EdgeFollower<Edges>& emergency_stop;
  };
  using Lock = boards::Interlock<Lines, kPeriodsInTime>;

  Lock& interlock() { return interlock_; }
  void pull(bool pulled) {
    level_ = pulled;
    steady_us_ = 0;
  }
  void period(bool in_time) {
    steady_us_ += kPeriod_us;
    if (steady_us_ >= kDebounce_us && edges_.now != level_) {
      edges_.now = level_;
      ++number_;
      edges_.waiting.push_back({level_, number_, number_, number_ * std::uint64_t{1'000}});
    }
    interlock_.isr_apply(in_time);
  }
  void wait(std::uint32_t periods, const std::function<void()>& after) {
    for (std::uint32_t i = 0; i < periods; ++i) {
      period(true);
      after();
    }
  }
  bool drive() { return lines_.drive_enable.asserted; }
  bool brake() { return lines_.brake.asserted; }
  void break_brake(bool broken) { lines_.brake.stuck = broken; }
  bool break_stop() { return edges_.broken = true; }

 private:
  Edges edges_;
  std::uint32_t number_ = 0;
  std::uint32_t steady_us_ = kDebounce_us;
  bool level_ = false;
  linux_os::EdgeFollower<Edges> follower_{edges_};
  Lines lines_{{}, {.asserted = true}, follower_};
  Lock interlock_{lines_};
};

class Kernel {
 public:
  linux_os::KernelEntropy& source() { return source_; }
  bool break_it() { return false; }

 private:
  linux_os::KernelEntropy source_;
};

// Output lines need a chip of the kernel.
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(DigitalOutContract);
INSTANTIATE_TYPED_TEST_SUITE_P(Linux, CanPortContract, SocketCan);
INSTANTIATE_TYPED_TEST_SUITE_P(Linux, ClockContract, Monotonic);
INSTANTIATE_TYPED_TEST_SUITE_P(Linux, DigitalInContract, Followed);
INSTANTIATE_TYPED_TEST_SUITE_P(Linux, EmergencyStopContract, Board);
INSTANTIATE_TYPED_TEST_SUITE_P(Linux, EntropyContract, Kernel);

}  // namespace
}  // namespace hal_test
