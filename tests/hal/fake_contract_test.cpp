#include "hal/fake/can_port.hpp"
#include "hal/fake/clock.hpp"
#include "hal/fake/devices.hpp"
#include "hal/fake/flash.hpp"
#include "tests/hal/contract/can_port.hpp"
#include "tests/hal/contract/clock.hpp"
#include "tests/hal/contract/digital.hpp"
#include "tests/hal/contract/entropy.hpp"
#include "tests/hal/contract/non_volatile.hpp"
#include "tests/hal/contract/sensor.hpp"
#include "tests/hal/contract/watchdog.hpp"

namespace hal_test {
namespace {

namespace fake = hal::fake;

constexpr hal::Time kEver{~std::uint64_t{0}};

class FakeCan {
 public:
  fake::CanPort& port() { return port_; }
  std::vector<hal::CanFrame> on_bus() {
    std::vector<hal::CanFrame> frames;
    while (const auto frame = peer_.receive()) {
      frames.push_back(*frame);
    }
    return frames;
  }
  void peer_sends(const hal::CanFrame& frame) { ASSERT_EQ(peer_.send(frame), hal::Error::none); }
  hal::CanFrame accepted(std::uint8_t n) { return frame(0x201, 8, n); }
  bool block() {
    port_.faults.on_calls(port_.faults.calls() + 5, 1'000'000, fake::SendFault::full);
    return true;
  }
  bool unblock() {
    port_.faults.clear();
    return true;
  }
  bool go_off() {
    port_.go_off();
    return true;
  }
  bool come_back() {
    clock_.advance(port_.recovery);
    return true;
  }

 private:
  fake::Clock clock_;
  fake::CanBus bus_{clock_};
  fake::CanPort port_{bus_};
  fake::CanPort peer_{bus_};
};

class FakeClock {
 public:
  const fake::Clock& clock() { return clock_; }
  void pass(std::uint32_t time_us) { clock_.advance(hal::microseconds(time_us)); }
  bool exact() { return true; }

 private:
  fake::Clock clock_;
};

class FakeIn {
 public:
  fake::DigitalIn& line() { return line_; }
  void drive(bool asserted) { line_.set(asserted); }
  bool break_it() {
    line_.faults.during({}, kEver, hal::Error::failed);
    return true;
  }

 private:
  fake::Clock clock_;
  fake::DigitalIn line_{clock_};
};

class FakeOut {
 public:
  fake::DigitalOut& line() { return line_; }
  bool seen() { return line_.asserted(); }
  bool break_it() {
    line_.faults.during({}, kEver, hal::Error::failed);
    return true;
  }

 private:
  fake::Clock clock_;
  fake::DigitalOut line_{clock_};
};

class FakeEntropy {
 public:
  fake::Entropy& source() { return source_; }
  bool break_it() {
    source_.faults.during({}, kEver, hal::Error::failed);
    return true;
  }

 private:
  fake::Clock clock_;
  fake::Entropy source_{clock_, 42};
};

class FakeSensor {
 public:
  fake::Sensor<lifemodel::MotorCurrent, 3>& sensor() { return sensor_; }
  std::size_t tendons() { return 3; }
  lifemodel::MotorCurrent sample(int n) { return lifemodel::MotorCurrent::from_raw(1'000 * n); }
  void measure(std::size_t tendon, int n) { sensor_.give(tendon, sample(n)); }
  bool measures_always() { return false; }
  bool break_it() {
    sensor_.faults.during({}, kEver, hal::Error::failed);
    return true;
  }

 private:
  fake::Clock clock_;
  fake::Sensor<lifemodel::MotorCurrent, 3> sensor_{clock_};
};

class FakeWatchdog {
 public:
  fake::Watchdog& watchdog() { return watchdog_; }
  void pass(int tenths) { clock_.advance(hal::milliseconds(10u * static_cast<unsigned>(tenths))); }
  bool bitten() { return watchdog_.bitten(); }

 private:
  fake::Clock clock_;
  fake::Watchdog watchdog_{clock_, hal::milliseconds(100)};
};

INSTANTIATE_TYPED_TEST_SUITE_P(Fake, CanPortContract, FakeCan);
INSTANTIATE_TYPED_TEST_SUITE_P(Fake, ClockContract, FakeClock);
INSTANTIATE_TYPED_TEST_SUITE_P(Fake, DigitalInContract, FakeIn);
INSTANTIATE_TYPED_TEST_SUITE_P(Fake, DigitalOutContract, FakeOut);
INSTANTIATE_TYPED_TEST_SUITE_P(Fake, EntropyContract, FakeEntropy);
INSTANTIATE_TYPED_TEST_SUITE_P(Fake, SensorContract, FakeSensor);
INSTANTIATE_TYPED_TEST_SUITE_P(Fake, WatchdogContract, FakeWatchdog);

}  // namespace
namespace {

template <class Flash>
class FakeFlash {
 public:
  Flash& memory() { return flash_; }
  bool tear(std::uint32_t address) {
    flash_.spoil(address);
    return true;
  }

 private:
  Flash flash_;
};

using Geometries =
    testing::Types<FakeFlash<hal::fake::Flash<>>, FakeFlash<hal::fake::Flash<2, 64, 16>>,
                   FakeFlash<hal::fake::Flash<3, 256, 4>>>;
INSTANTIATE_TYPED_TEST_SUITE_P(FakeFlash, NonVolatileContract, Geometries);

}  // namespace
}  // namespace hal_test
