#include "hal/qemu_mps2/system_timer.hpp"

#include <gtest/gtest.h>

#include <cstdint>

#include "hal/qemu_mps2/virtual_devices.hpp"

namespace hal::qemu_mps2 {
namespace {

struct Word {
  std::uint32_t value = 0;
  std::uint32_t read() const { return value; }
  void write(std::uint32_t written) { value = written; }
};

/// SysTick that counts down by itself, `steps` clocks at each look.
struct Counter {
  std::uint32_t value = 0;
  std::uint32_t step = 0;
  const Word* reload = nullptr;
  std::uint32_t read() {
    const std::uint32_t shown = value;
    for (std::uint32_t i = 0; i < step; ++i) {
      value = value == 0 ? reload->value : value - 1;
    }
    return shown;
  }
  void write(std::uint32_t) { value = 0; }
};

struct Model {
  Word control;
  Word reload;
  Counter current{0, 0, &reload};
};

using Timer = SystemTimer<25, Model>;
static_assert(Clock<Timer>);
static_assert(Clock<VirtualClock>);

TEST(SystemTimer, IsSetUpAsTheManualSays) {
  Model model;
  Timer timer(model);
  ASSERT_EQ(timer.start(1'000), Error::none);
  EXPECT_EQ(model.reload.value, 24'999u);
  EXPECT_EQ(model.control.value, 0b111u);
}

TEST(SystemTimer, RefusesPeriodsThatItCannotCount) {
  Model model;
  Timer timer(model);
  EXPECT_EQ(timer.start(0), Error::out_of_range);
  // 2^24 clocks of 40 ns are 671,088.64 us.
  EXPECT_EQ(timer.start(671'089), Error::out_of_range);
  EXPECT_EQ(timer.start(0xffff'ffff), Error::out_of_range);
  EXPECT_EQ(model.control.value, 0u);
  EXPECT_EQ(timer.start(671'088), Error::none);
}

TEST(SystemTimer, CountsPeriodsAndWhatIsGoneOfTheLast) {
  Model model;
  Timer timer(model);
  ASSERT_EQ(timer.start(1'000), Error::none);
  model.current.value = 24'999;
  EXPECT_EQ(timer.now(), microseconds(0));
  model.current.value = 25'000 - 25;
  EXPECT_EQ(timer.now(), microseconds(1));
  model.current.value = 1;
  EXPECT_EQ(timer.now(), microseconds(999));
  timer.isr_tick();
  timer.isr_tick();
  model.current.value = 12'500;
  EXPECT_EQ(timer.now(), microseconds(2'500));
}

TEST(SystemTimer, APeriodThatIsOverAndNotYetCountedCountsOnce) {
  Model model;
  Timer timer(model);
  ASSERT_EQ(timer.start(1'000), Error::none);
  model.current.value = 0;
  EXPECT_EQ(timer.now(), microseconds(1'000));
  timer.isr_tick();
  model.current.value = 24'999;
  EXPECT_EQ(timer.now(), microseconds(1'000));
}

TEST(SystemTimer, TheOneClockAtZeroDoesNotCount) {
  Model model;
  Timer timer(model);
  ASSERT_EQ(timer.start(1'000), Error::none);
  timer.isr_tick();
  model.current.value = 0;
  model.current.step = 1;
  EXPECT_EQ(timer.now(), microseconds(1'000));
}

TEST(VirtualClockTest, GoesOnWhenToldTo) {
  VirtualClock clock;
  EXPECT_EQ(clock.now(), microseconds(0));
  clock.advance(microseconds(100));
  clock.advance(seconds(5'000));
  EXPECT_EQ(clock.now(), microseconds(5'000'000'100));
}

}  // namespace
}  // namespace hal::qemu_mps2
