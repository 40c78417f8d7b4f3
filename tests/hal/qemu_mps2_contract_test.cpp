#include "hal/qemu_mps2/memory_flash.hpp"
#include "hal/qemu_mps2/virtual_devices.hpp"
#include "tests/hal/contract/clock.hpp"
#include "tests/hal/contract/digital.hpp"
#include "tests/hal/contract/entropy.hpp"
#include "tests/hal/contract/non_volatile.hpp"
#include "tests/hal/contract/sensor.hpp"

namespace hal_test {
namespace {

namespace qemu = hal::qemu_mps2;

class EmulatedFlash {
 public:
  qemu::MemoryFlash<20>& memory() { return flash_; }
  bool tear(std::uint32_t) { return false; }

 private:
  qemu::NoBacking backing_;
  qemu::MemoryFlash<20> flash_{backing_};
};

class EmulatedClock {
 public:
  const qemu::VirtualClock& clock() { return clock_; }
  void pass(std::uint32_t time_us) { clock_.advance(hal::microseconds(time_us)); }
  bool exact() { return true; }

 private:
  qemu::VirtualClock clock_;
};

class EmulatedIn {
 public:
  qemu::InputLine& line() { return line_; }
  void drive(bool asserted) { line_.drive(asserted); }
  bool break_it() { return false; }

 private:
  qemu::InputLine line_;
};

class EmulatedOut {
 public:
  qemu::OutputLine& line() { return line_; }
  bool seen() { return line_.asserted(); }
  bool break_it() { return false; }

 private:
  qemu::OutputLine line_;
};

class EmulatedEntropy {
 public:
  qemu::SeededEntropy& source() { return source_; }
  bool break_it() { return false; }

 private:
  qemu::SeededEntropy source_{42};
};

class EmulatedSensor {
 public:
  qemu::PlayedSensor<2>& sensor() { return sensor_; }
  std::size_t tendons() { return raw_.size(); }
  lifemodel::MotorCurrent sample(int n) { return lifemodel::MotorCurrent::from_raw(1'000 * n); }
  void measure(std::size_t tendon, int n) {
    raw_[tendon] = sample(n).raw();
    sensor_.put(raw_);
  }
  bool measures_always() { return true; }
  bool break_it() {
    sensor_.set_failed(true);
    return true;
  }

 private:
  std::array<std::int32_t, 2> raw_{qemu::kNoSample, qemu::kNoSample};
  qemu::PlayedSensor<2> sensor_;
};

INSTANTIATE_TYPED_TEST_SUITE_P(QemuMps2, NonVolatileContract, EmulatedFlash);
INSTANTIATE_TYPED_TEST_SUITE_P(QemuMps2, ClockContract, EmulatedClock);
INSTANTIATE_TYPED_TEST_SUITE_P(QemuMps2, DigitalInContract, EmulatedIn);
INSTANTIATE_TYPED_TEST_SUITE_P(QemuMps2, DigitalOutContract, EmulatedOut);
INSTANTIATE_TYPED_TEST_SUITE_P(QemuMps2, EntropyContract, EmulatedEntropy);
INSTANTIATE_TYPED_TEST_SUITE_P(QemuMps2, SensorContract, EmulatedSensor);

}  // namespace
}  // namespace hal_test
