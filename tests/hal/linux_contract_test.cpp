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

  void tell(std::uint32_t error_class) {
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
    kernel_.tell(CAN_ERR_BUSOFF);
    return port_.receive() == std::nullopt;
  }
  bool come_back() {
    kernel_.tell(CAN_ERR_RESTARTED);
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

/// A line as libgpiod tells of it.
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
INSTANTIATE_TYPED_TEST_SUITE_P(Linux, EntropyContract, Kernel);

}  // namespace
}  // namespace hal_test
