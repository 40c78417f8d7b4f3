#include "hal/devices.hpp"

#include <gtest/gtest.h>

#include <array>

#include "hal/can_port.hpp"
#include "hal/clock.hpp"
#include "hal/non_volatile.hpp"
#include "hal/stm32g4/pins.hpp"
#include "hal/stm32g4/random.hpp"
#include "hal/stm32g4/timers.hpp"
#include "hal/stm32g4/watchdog.hpp"
#include "tests/stm32g4/model/chip.hpp"
#include "tests/stm32g4/model/hal_devices.hpp"

namespace stm32g4_models {
namespace {

using hal::Error;
using hal::stm32g4::Active;
using hal::stm32g4::Pull;

class Pins : public ::testing::Test {
 protected:
  ReadyChip chip;
};

TEST_F(Pins, OutputHasItsLevelBeforeItDrives) {
  hal::stm32g4::OutputPin<Word> pin({chip.gpio_b.registers, 3}, Active::high);
  pin.start(true);
  ASSERT_EQ(chip.gpio_b.driven.size(), 1u);
  EXPECT_EQ(chip.gpio_b.driven[0], std::pair(3u, true));
}

TEST_F(Pins, OutputFollowsItsPolarity) {
  hal::stm32g4::OutputPin<Word> high({chip.gpio_a.registers, 15}, Active::high);
  hal::stm32g4::OutputPin<Word> low({chip.gpio_c.registers, 11}, Active::low);
  high.start(false);
  low.start(false);
  EXPECT_FALSE(chip.gpio_a.drives(15));
  EXPECT_TRUE(chip.gpio_c.drives(11));
  EXPECT_EQ(high.set(true), Error::none);
  EXPECT_EQ(low.set(true), Error::none);
  EXPECT_TRUE(chip.gpio_a.drives(15));
  EXPECT_FALSE(chip.gpio_c.drives(11));
}

TEST_F(Pins, ShortedOutputIsToldOf) {
  hal::stm32g4::OutputPin<Word> pin({chip.gpio_b.registers, 3}, Active::high);
  pin.start(false);
  chip.gpio_b.shorted = 1u << 3;
  EXPECT_EQ(pin.set(false), Error::none);
  EXPECT_EQ(pin.set(true), Error::failed);
  chip.gpio_b.outside = 1u << 3;
  EXPECT_EQ(pin.set(true), Error::none);
  EXPECT_EQ(pin.set(false), Error::failed);
}

TEST_F(Pins, AlternateFunctionGoesIntoItsHalf) {
  hal::stm32g4::make_alternate(hal::stm32g4::Pin<Word>{chip.gpio_a.registers, 11}, 9);
  hal::stm32g4::make_alternate(hal::stm32g4::Pin<Word>{chip.gpio_a.registers, 3}, 7);
  EXPECT_EQ(chip.gpio_a.mode(11), 2u);
  EXPECT_EQ(chip.gpio_a.function(11), 9u);
  EXPECT_EQ(chip.gpio_a.registers.afr[1].held(), 9u << 12);
  EXPECT_EQ(chip.gpio_a.registers.afr[0].held(), 7u << 12);
}

TEST_F(Pins, AnalogHasNoPull) {
  chip.gpio_a.registers.pupdr.hold(0xFFFFFFFF);
  hal::stm32g4::make_analog(hal::stm32g4::Pin<Word>{chip.gpio_a.registers, 1});
  EXPECT_EQ(chip.gpio_a.mode(1), 3u);
  EXPECT_EQ(chip.gpio_a.registers.pupdr.held(), 0xFFFFFFF3u);
}

class Stop : public Pins {
 protected:
  hal::stm32g4::DebouncedInput<Word, 20> input{{chip.gpio_b.registers, 7}, Active::high};
  void level(bool high) { chip.gpio_b.outside = high ? 1u << 7 : 0; }
  void sample(int times) {
    for (int i = 0; i < times; ++i) {
      input.isr_sample();
    }
  }
};

TEST_F(Stop, IsOffBeforeItsStart) {
  EXPECT_EQ(input.asserted().error(), Error::off);
}

TEST_F(Stop, TakesTheLevelAtItsStart) {
  level(true);
  input.start(Pull::up);
  EXPECT_TRUE(*input.asserted());
  EXPECT_EQ(chip.gpio_b.mode(7), 0u);
  EXPECT_EQ(chip.gpio_b.registers.pupdr.held() >> 14 & 3u, 1u);
}

TEST_F(Stop, ChangesAfterTwentyEqualSamples) {
  level(false);
  input.start(Pull::up);
  level(true);
  sample(19);
  EXPECT_FALSE(*input.asserted());
  sample(1);
  EXPECT_TRUE(*input.asserted());
  level(false);
  sample(20);
  EXPECT_FALSE(*input.asserted());
}

TEST_F(Stop, BouncingStartsTheCountAgain) {
  level(false);
  input.start(Pull::up);
  for (int i = 0; i < 50; ++i) {
    level(true);
    sample(19);
    level(false);
    sample(1);
  }
  EXPECT_FALSE(*input.asserted());
}

TEST_F(Pins, ClockCountsAndGoesOnPastItsTurn) {
  const hal::Time first = chip.clock.now();
  const hal::Time second = chip.clock.now();
  EXPECT_GT(second, first);
  chip.tim2.time_us = 0xFFFFFFF0u;
  static_cast<void>(chip.clock.isr_tick());
  const hal::Time before = chip.clock.now();
  EXPECT_EQ(before.us >> 4, 0xFFFFFFFu);
  chip.tim2.time_us = 0x100000005u;
  const hal::Time unseen = chip.clock.now();
  EXPECT_EQ(unseen.us, 0x100000006u) << "the interrupt has not seen the turn yet";
  static_cast<void>(chip.clock.isr_tick());
  EXPECT_EQ(chip.clock.now().us, 0x100000008u);
}

TEST_F(Pins, ClockWaitsAtLeastAsLongAsAsked) {
  const std::uint64_t began_us = chip.tim2.time_us;
  chip.clock.wait_us(20);
  EXPECT_GE(chip.tim2.time_us - began_us, 20u);
}

TEST(Watchdog, TakesItsPeriodAndBitesUnlessFed) {
  WatchdogModel model;
  hal::stm32g4::IndependentWatchdog<Word> watchdog(model.registers);
  ASSERT_EQ(watchdog.start(250), Error::none);
  EXPECT_EQ(model.period_ms(), 250u);
  for (int i = 0; i < 10; ++i) {
    model.pass(249);
    EXPECT_FALSE(model.bitten());
    watchdog.feed();
  }
  model.pass(250);
  EXPECT_TRUE(model.bitten());
}

TEST(Watchdog, RefusesWhatItCannotCount) {
  WatchdogModel model;
  hal::stm32g4::IndependentWatchdog<Word> watchdog(model.registers);
  EXPECT_EQ(watchdog.start(0), Error::out_of_range);
  EXPECT_EQ(watchdog.start(4097), Error::out_of_range);
  EXPECT_FALSE(model.started());
  EXPECT_EQ(watchdog.start(4096), Error::none);
  EXPECT_EQ(model.period_ms(), 4096u);
}

TEST(Watchdog, SaysSoWhereLsiDoesNotRun) {
  WatchdogModel model;
  model.answers = false;
  hal::stm32g4::IndependentWatchdog<Word> watchdog(model.registers);
  EXPECT_EQ(watchdog.start(250), Error::failed);
}

class Random : public ::testing::Test {
 protected:
  ReadyChip chip;
  hal::stm32g4::RandomGenerator<Word> generator{chip.random.registers};
  std::array<std::byte, 6> out{};
  void SetUp() override { generator.start(); }
};

TEST_F(Random, FillsByteByByte) {
  ASSERT_EQ(generator.fill(out), Error::none);
  for (std::size_t i = 0; i < out.size(); ++i) {
    EXPECT_EQ(out[i], static_cast<std::byte>(i + 1));
  }
  ASSERT_EQ(generator.fill(std::span(out).first(1)), Error::none);
  EXPECT_EQ(out[0], std::byte{9}) << "no word is used twice";
}

TEST_F(Random, MendsASeedErrorAndGoesOn) {
  chip.random.break_seed();
  EXPECT_EQ(generator.fill(out), Error::none);
  EXPECT_EQ(out[0], std::byte{1});
}

TEST_F(Random, FailsWithZerosWhileTheSeedIsBroken) {
  chip.random.recovers = false;
  chip.random.break_seed();
  out.fill(std::byte{0xAA});
  EXPECT_EQ(generator.fill(out), Error::failed);
  EXPECT_EQ(out, (std::array<std::byte, 6>{}));
}

TEST_F(Random, FailsWhileItsClockIsTooSlow) {
  chip.random.break_clock();
  out.fill(std::byte{0xAA});
  EXPECT_EQ(generator.fill(out), Error::failed);
  EXPECT_EQ(out, (std::array<std::byte, 6>{}));
}

TEST_F(Random, FailsOnAWordOfZero) {
  chip.random.next = 0;
  EXPECT_EQ(generator.fill(out), Error::failed);
}

TEST(SampleTiming, CountsMissedPeriodsAndJitter) {
  hal::stm32g4::SampleTiming timing;
  EXPECT_EQ(timing.isr_period(0xFFFFFFF0u, 100), 0u) << "the first has none before it";
  EXPECT_EQ(timing.isr_period(0xFFFFFFF0u + 100u, 100), 0u) << "and time may wrap";
  EXPECT_EQ(timing.worst_us(), 0u);
  std::uint32_t now_us = 84;
  EXPECT_EQ(timing.isr_period(now_us += 107, 100), 0u);
  EXPECT_EQ(timing.worst_us(), 7u);
  EXPECT_EQ(timing.isr_period(now_us += 93, 100), 0u);
  EXPECT_EQ(timing.isr_period(now_us += 300, 100), 2u);
  EXPECT_EQ(timing.isr_period(now_us += 149, 100), 0u);
  EXPECT_EQ(timing.worst_us(), 49u);
}

TEST(SampleTiming, InTimeIsOnePeriodAfterTheOneBefore) {
  hal::stm32g4::SampleTiming timing;
  std::uint32_t now_us = 0;
  const auto in_time_after = [&](std::uint32_t elapsed_us) {
    static_cast<void>(timing.isr_period(now_us += elapsed_us, 100));
    return timing.isr_in_time();
  };
  EXPECT_FALSE(in_time_after(100)) << "the first has none before it";
  EXPECT_TRUE(in_time_after(100));
  EXPECT_FALSE(in_time_after(49)) << "an interrupt that comes again at once";
  EXPECT_TRUE(in_time_after(50));
  EXPECT_TRUE(in_time_after(149));
  EXPECT_FALSE(in_time_after(150));
  EXPECT_FALSE(in_time_after(10'000));
}

TEST(SampleTiming, NinetyNineOfAHundred) {
  hal::stm32g4::SampleTiming timing;
  std::uint32_t now_us = 0;
  static_cast<void>(timing.isr_period(now_us, 100));
  for (std::uint32_t i = 0; i < 1000; ++i) {
    static_cast<void>(timing.isr_period(now_us += i % 50 == 0 ? 105u : 102u, 100));
  }
  EXPECT_EQ(timing.p99_us(), 5u) << "one in fifty is 5 us off";
  for (int i = 0; i < 2000; ++i) {
    static_cast<void>(timing.isr_period(now_us += 102, 100));
  }
  EXPECT_EQ(timing.p99_us(), 2u) << "less than one in a hundred";
}

static_assert(hal::CanPort<CanController>);
static_assert(hal::CurrentSensor<CurrentSensor>);
static_assert(hal::DigitalIn<Input>);
static_assert(hal::DigitalOut<OutputPin>);
static_assert(hal::NonVolatile<FlashMemory>);
static_assert(hal::Clock<Clock>);
static_assert(hal::Entropy<RandomGenerator>);
static_assert(hal::Watchdog<IndependentWatchdog>);

TEST(Devices, AllStartWithoutABreachOfTheManual) {
  const HalDevices devices;
  EXPECT_EQ(devices.rcc.core_Hz(), 170'000'000u);
}

}  // namespace
}  // namespace stm32g4_models
