#include <array>
#include <cstring>
#include <type_traits>

#include "firmware/boards/b_g431b_esc1/control_loop.hpp"
#include "hal/stm32g4/timers.hpp"
#include "tests/hal/contract/can_port.hpp"
#include "tests/hal/contract/clock.hpp"
#include "tests/hal/contract/digital.hpp"
#include "tests/hal/contract/emergency_stop.hpp"
#include "tests/hal/contract/entropy.hpp"
#include "tests/hal/contract/non_volatile.hpp"
#include "tests/hal/contract/sensor.hpp"
#include "tests/hal/contract/watchdog.hpp"
#include "tests/stm32g4/model/hal_devices.hpp"

namespace hal_test {
namespace {

using stm32g4_models::HalDevices;

/// Words of a message as RM0440 44.3.8 lays them out.
struct Message {
  static constexpr std::uint32_t kExtended = 1u << 30;

  static hal::CanFrame frame(const stm32g4_models::CanModel::Sent& sent) {
    hal::CanFrame result;
    result.extended = (sent.header0 & kExtended) != 0;
    result.id = result.extended ? sent.header0 & 0x1fffffffu : sent.header0 >> 18 & 0x7ffu;
    result.length = static_cast<std::uint8_t>(sent.header1 >> 16 & 15u);
    std::array<std::byte, 8> data{};
    std::memcpy(data.data(), &sent.low, 4);
    std::memcpy(data.data() + 4, &sent.high, 4);
    std::copy_n(data.begin(), result.length, result.data.begin());
    return result;
  }
  static std::uint32_t header(const hal::CanFrame& frame) {
    return frame.extended ? kExtended | frame.id : frame.id << 18;
  }
};

class Fdcan {
 public:
  auto& port() { return devices_.can; }
  std::vector<hal::CanFrame> on_bus() {
    std::vector<hal::CanFrame> frames;
    while (const auto sent = devices_.bus.transmit()) {
      frames.push_back(Message::frame(*sent));
    }
    return frames;
  }
  void peer_sends(const hal::CanFrame& frame) {
    std::array<std::uint32_t, 2> words{};
    std::memcpy(words.data(), frame.data.data(), 8);
    devices_.bus.deliver(Message::header(frame), std::uint32_t{frame.length} << 16, words[0],
                         words[1]);
    devices_.can.isr_receive();
  }
  hal::CanFrame accepted(std::uint8_t n) {
    return n % 2 == 0 ? frame(0x205, 8, n) : frame(0x18da05f1, 3, n, true);
  }
  // Nothing leaves the model until somebody looks at the bus.
  bool block() { return true; }
  bool unblock() { return true; }
  bool go_off() {
    devices_.bus.go_bus_off();
    devices_.can.isr_receive();
    return true;
  }
  bool come_back() {
    devices_.bus.idle_bus();
    devices_.can.isr_receive();
    // INIT reads one for a while after it was cleared (RM0440 44.3.2).
    for (int i = 0; i < 3; ++i) {
      static_cast<void>(devices_.bus.registers.cccr.read());
    }
    return true;
  }

 private:
  HalDevices devices_;
};

class Timer {
 public:
  const auto& clock() { return devices_.clock; }
  void pass(std::uint32_t time_us) {
    devices_.tim2.time_us += time_us;
    static_cast<void>(devices_.clock.isr_tick());
  }
  bool exact() { return false; }

 private:
  HalDevices devices_;
};

/// The same, as its 32 bits turn over.
class TurningTimer {
 public:
  TurningTimer() {
    devices_.tim2.time_us = 0xffff'ff00u;
    static_cast<void>(devices_.clock.isr_tick());
  }
  const auto& clock() { return devices_.clock; }
  void pass(std::uint32_t time_us) { devices_.tim2.time_us += time_us; }
  bool exact() { return false; }

 private:
  HalDevices devices_;
};

class DebouncedPin {
 public:
  auto& line() { return devices_.input; }
  void drive(bool asserted) {
    devices_.gpio_b.outside = asserted ? 1u << 7 : 0;
    for (int i = 0; i < 20; ++i) {
      devices_.input.isr_sample();
    }
  }
  bool break_it() { return false; }

 private:
  HalDevices devices_;
};

class Pin {
 public:
  auto& line() { return devices_.output; }
  bool seen() { return devices_.gpio_b.drives(3); }
  bool break_it() {
    devices_.gpio_b.outside = 1u << 3;
    devices_.gpio_b.shorted = 1u << 3;
    return true;
  }

 private:
  HalDevices devices_;
};

/// The control loop of the B-G431B-ESC1. Its store waits for the erase of a page, which the loop
/// interrupts.
class Board {
 public:
  static constexpr std::uint32_t kPeriod_us = 100;
  static constexpr std::uint32_t kPeriodsInTime = 100;
  static constexpr std::uint32_t kShortest_us = 3'000;
  static constexpr std::uint32_t kOffWithin_us = 2'100;
  static_assert(boards::b_g431b_esc1::kLoopPeriod_us == kPeriod_us &&
                boards::b_g431b_esc1::kPeriodsInTime == kPeriodsInTime);
  static_assert(std::is_same_v<stm32g4_models::Input,
                               hal::stm32g4::DebouncedInput<stm32g4_models::Word,
                                                            boards::b_g431b_esc1::kStopSamples>>);

  Board() { EXPECT_EQ(devices_.sensor.calibrate_at_rest(), hal::Error::none); }

  struct Lines {
    stm32g4_models::OutputPin& drive_enable;
    stm32g4_models::OutputPin& brake;
    stm32g4_models::Input& emergency_stop;
  };
  using Lock = boards::Interlock<Lines, kPeriodsInTime>;

  Lock& interlock() { return parts_.interlock; }
  void pull(bool pulled) { devices_.gpio_b.outside = pulled ? 1u << 7 : 0; }
  void period(bool in_time) {
    // One more goes by with the look at the clock.
    devices_.tim2.time_us += (in_time ? 1 : 2) * kPeriod_us - 1;
    boards::b_g431b_esc1::isr_period(parts_, app_);
  }
  void wait(std::uint32_t periods, const std::function<void()>& after) {
    devices_.flash.busy_looks = periods;
    devices_.flash.on_busy = [&] {
      period(true);
      after();
    };
    EXPECT_EQ(devices_.memory.erase(0), hal::Error::none);
    devices_.flash.on_busy = nullptr;
  }
  bool drive() { return devices_.gpio_b.drives(3); }
  bool brake() {
    return (devices_.gpio_a.shorted & kBrakeLine) != 0 || !devices_.gpio_a.drives(15);
  }
  void break_brake(bool broken) { devices_.gpio_a.shorted = broken ? kBrakeLine : 0; }
  bool break_stop() { return false; }

 private:
  static constexpr std::uint32_t kBrakeLine = 1u << 15;

  struct Parts {
    stm32g4_models::Clock& clock;
    stm32g4_models::CurrentSensor& sensor;
    stm32g4_models::CanController& can;
    Lines lines;
    hal::stm32g4::SampleTiming timing{};
    Lock interlock{lines};
  };
  struct NoApp {
    void isr_missed(std::uint32_t) {}
    bool isr_sample() { return false; }
  };

  HalDevices devices_;
  Parts parts_{devices_.clock,
               devices_.sensor,
               devices_.can,
               {devices_.output, devices_.brake, devices_.input}};
  NoApp app_;
};

class RandomNumbers {
 public:
  auto& source() { return devices_.entropy; }
  bool break_it() {
    devices_.random.recovers = false;
    devices_.random.break_seed();
    return true;
  }

 private:
  HalDevices devices_;
};

class Flash {
 public:
  auto& memory() { return devices_.memory; }
  bool tear(std::uint32_t address) {
    devices_.flash.tear_next = true;
    const std::array<std::byte, 8> anything{};
    static_cast<void>(devices_.memory.program(address, anything));
    return true;
  }

 private:
  HalDevices devices_;
};

class Shunts {
 public:
  Shunts() {
    EXPECT_EQ(devices_.sensor.calibrate_at_rest(), hal::Error::none);
    devices_.adc2.looks_a_trigger = 0;
  }
  auto& sensor() { return devices_.sensor; }
  std::size_t tendons() { return 1; }
  /// One phase 60 (n + 1) counts up and one down: the amplitude is 2 / sqrt(3) of that, in eighths
  /// of a count of 29.4 mA, rounded down.
  lifemodel::MotorCurrent sample(int n) {
    constexpr std::array kEighths{554, 1108, 1662, 2217, 2771};
    return lifemodel::MotorCurrent::from_raw(kEighths.at(static_cast<std::size_t>(n)) * 61'600);
  }
  void measure(std::size_t, int n) {
    const auto counts = static_cast<std::uint32_t>(60 * (n + 1));
    devices_.opamp.output = {2048 + counts, 2048 - counts, 2048};
    devices_.trigger();
    devices_.sensor.isr_latch();
  }
  bool measures_always() { return false; }
  bool break_it() {
    devices_.opamp.output = {4095, 1, 2048};
    devices_.trigger();
    devices_.sensor.isr_latch();
    return true;
  }

 private:
  HalDevices devices_;
};

class Guard {
 public:
  Guard() { EXPECT_EQ(devices_.guard.start(100), hal::Error::none); }
  auto& watchdog() { return devices_.guard; }
  void pass(int tenths) { devices_.watchdog.pass(10u * static_cast<unsigned>(tenths)); }
  bool bitten() { return devices_.watchdog.bitten(); }

 private:
  HalDevices devices_;
};

using Timers = testing::Types<Timer, TurningTimer>;
INSTANTIATE_TYPED_TEST_SUITE_P(Stm32g4, CanPortContract, Fdcan);
INSTANTIATE_TYPED_TEST_SUITE_P(Stm32g4, ClockContract, Timers);
INSTANTIATE_TYPED_TEST_SUITE_P(Stm32g4, DigitalInContract, DebouncedPin);
INSTANTIATE_TYPED_TEST_SUITE_P(Stm32g4, DigitalOutContract, Pin);
INSTANTIATE_TYPED_TEST_SUITE_P(Stm32g4, EmergencyStopContract, Board);
INSTANTIATE_TYPED_TEST_SUITE_P(Stm32g4, EntropyContract, RandomNumbers);
INSTANTIATE_TYPED_TEST_SUITE_P(Stm32g4, NonVolatileContract, Flash);
INSTANTIATE_TYPED_TEST_SUITE_P(Stm32g4, SensorContract, Shunts);
INSTANTIATE_TYPED_TEST_SUITE_P(Stm32g4, WatchdogContract, Guard);

}  // namespace
}  // namespace hal_test
