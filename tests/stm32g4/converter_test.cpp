#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "hal/stm32g4/current_sensor.hpp"
#include "hal/stm32g4/timers.hpp"
#include "tests/stm32g4/model/chip.hpp"

namespace stm32g4_models {
namespace {

using hal::Error;
using hal::stm32g4::PhaseCounts;
using hal::stm32g4::PhaseCurrent;

struct Converted {
  ReadyChip chip;
  hal::stm32g4::SampleTimer<Word> timer{chip.tim1.registers};
  hal::stm32g4::ShuntConverters<Word> converters{chip.opamp.registers, chip.adc1.registers,
                                                 chip.adc2.registers, chip.adc_common.registers};
  hal::stm32g4::CurrentSensor<Word> sensor{converters};

  void start() {
    timer.start(hal::stm32g4::kCore_Hz, 10'000);
    ASSERT_EQ(converters.start(chip.clock), Error::none);
  }
};
class Converters : public ::testing::Test, protected Converted {};

TEST_F(Converters, AreTriggeredAtTenKilohertz) {
  start();
  EXPECT_EQ(chip.tim1.trigger_Hz(), 10'000u);
  // RM0440 28.6.20: MOE is bit 15; no output drives a gate.
  EXPECT_FALSE(chip.tim1.registers.bdtr.has(1u << 15));
  EXPECT_EQ(chip.tim1.registers.ccer.held(), 0u);
}

TEST_F(Converters, ForgetThatTheyWereReadyBefore) {
  chip.adc1.registers.isr.raise(1);
  chip.adc2.registers.isr.raise(1);
  start();
}

TEST_F(Converters, GiveTheThreePhasesInOrder) {
  start();
  chip.adc2.looks_a_trigger = 0;
  chip.opamp.output = {100, 200, 300};
  EXPECT_FALSE(converters.isr_ready());
  chip.trigger();
  ASSERT_TRUE(converters.isr_ready());
  EXPECT_EQ(converters.isr_take(), (PhaseCounts{100, 200, 300}));
  EXPECT_FALSE(converters.isr_ready());
}

TEST_F(Converters, SampleLongEnoughForTheAmplifiers) {
  start();
  // RM0440 21.6.7: 011 is 24.5 cycles; channels 13, 16 and 18 at bits 9, 18 and 24.
  EXPECT_EQ(chip.adc1.registers.smpr[1].held(), 3u << 9);
  EXPECT_EQ(chip.adc2.registers.smpr[1].held(), 3u << 18 | 3u << 24);
}

// The model refuses JEOSIE once JADSTART is set.
TEST_F(Converters, InterruptWhenAllThreeAreConverted) {
  start();
  EXPECT_EQ(chip.adc2.registers.ier.held(), 1u << 6);
  EXPECT_EQ(chip.adc1.registers.ier.held(), 0u);
}

TEST_F(Converters, SaySoWithoutATrigger) {
  EXPECT_EQ(converters.start(chip.clock), Error::failed);
}

TEST_F(Converters, DiscardTheFirstConversionOfEach) {
  for (const std::uint32_t wrong : {0u, 1'777u, 4'095u}) {
    Converted bench;
    bench.chip.adc1.first = wrong;
    bench.chip.adc2.first = wrong;
    bench.chip.opamp.output = {2'100, 1'990, 2'048};
    bench.start();
    EXPECT_FALSE(bench.converters.isr_ready()) << "a first conversion is left";
    ASSERT_EQ(bench.sensor.calibrate_at_rest(), Error::none) << wrong;
    bench.chip.adc2.looks_a_trigger = 0;
    // Phase u 60 counts up, v 60 down: 60 * 2 / sqrt(3) = 69.28 counts of 29.3731 mA. A zero that
    // is wrong by 1/256 of a wrong first conversion would move this by up to 8 counts.
    bench.chip.opamp.output = {2'160, 1'930, 2'048};
    bench.chip.trigger();
    bench.sensor.isr_latch();
    const auto current = bench.sensor.isr_read(0);
    ASSERT_TRUE(current);
    EXPECT_NEAR(std::ldexp(current->raw(), -24), 69.282 * 0.0293731, 0.004) << wrong;
  }
}

TEST_F(Converters, SaySoWhereCalibrationNeverEnds) {
  chip.adc2.calibrates = false;
  timer.start(hal::stm32g4::kCore_Hz, 10'000);
  EXPECT_EQ(converters.start(chip.clock), Error::failed);
}

TEST_F(Converters, SensorTakesZerosAtRest) {
  start();
  chip.opamp.output = {2100, 1990, 2048};
  ASSERT_EQ(sensor.calibrate_at_rest(), Error::none);
  chip.adc2.looks_a_trigger = 0;
  chip.trigger();
  sensor.isr_latch();
  const auto current = sensor.isr_read(0);
  ASSERT_TRUE(current);
  EXPECT_EQ(current->raw(), 0);
}

TEST_F(Converters, SensorFailsWithABrokenAmplifier) {
  start();
  chip.opamp.output = {2048, 1535, 2048};
  EXPECT_EQ(sensor.calibrate_at_rest(), Error::failed);
  chip.trigger();
  sensor.isr_latch();
  EXPECT_EQ(sensor.isr_read(0).error(), Error::failed);
}

TEST_F(Converters, SensorFailsWhereTheTriggerEnds) {
  start();
  chip.adc2.looks_a_trigger = 0;
  EXPECT_EQ(sensor.calibrate_at_rest(), Error::failed);
}

TEST_F(Converters, SensorKnowsOneTendonAndOneSampleATrigger) {
  start();
  ASSERT_EQ(sensor.calibrate_at_rest(), Error::none);
  chip.adc2.looks_a_trigger = 0;
  EXPECT_EQ(sensor.isr_read(1).error(), Error::out_of_range);
  sensor.isr_latch();
  EXPECT_EQ(sensor.isr_read(0).error(), Error::missing) << "before the trigger";
  chip.trigger();
  sensor.isr_latch();
  EXPECT_FALSE(converters.isr_ready()) << "the request would come again";
  EXPECT_TRUE(sensor.isr_read(0));
  EXPECT_EQ(sensor.isr_read(0).error(), Error::missing) << "a sample was used twice";
}

PhaseCurrent calibrated(PhaseCounts zeros = {2048, 2048, 2048}) {
  PhaseCurrent current;
  for (std::uint32_t i = 0; i < PhaseCurrent::kRestSamples; ++i) {
    current.take_rest(zeros);
  }
  EXPECT_EQ(current.finish_rest(), Error::none);
  return current;
}

TEST(PhaseCurrent, IsTheAmplitudeAtEveryAngle) {
  const PhaseCurrent current = calibrated();
  // UM2516: 3 mohm, gain 64/7, 3.3 V over 4096 counts: 20 A are 680.9 counts.
  const double counts = 20.0 * 0.003 * 64 / 7 / 3.3 * 4096;
  for (int degrees = 0; degrees < 360; degrees += 7) {
    PhaseCounts phases{};
    for (std::size_t i = 0; i < 3; ++i) {
      const double angle = (degrees + 120.0 * static_cast<double>(i)) * std::numbers::pi / 180;
      phases[i] = static_cast<std::uint32_t>(std::lround(2048 - counts * std::sin(angle)));
    }
    const auto amplitude = current.isr_amplitude(phases);
    ASSERT_TRUE(amplitude) << degrees;
    // A count is 29.4 mA; rounding of three counts gives at most one.
    EXPECT_NEAR(std::ldexp(amplitude->raw(), -24), 20.0, 0.03) << degrees;
  }
}

TEST(PhaseCurrent, OneCountIsWorth29mA) {
  // Two phases carry 300 counts against each other: amplitude 300 * 2 / sqrt(3) = 346.41 counts.
  const auto amplitude = calibrated().isr_amplitude({2348, 1748, 2048});
  ASSERT_TRUE(amplitude);
  EXPECT_NEAR(std::ldexp(amplitude->raw(), -24), 346.41 * 0.0293731, 0.004);
}

TEST(PhaseCurrent, FailsWhereItIsClippedOrDoesNotAddUp) {
  const PhaseCurrent current = calibrated();
  EXPECT_TRUE(current.isr_amplitude({4087, 1028, 1028}));
  EXPECT_EQ(current.isr_amplitude({4088, 1028, 1028}).error(), Error::failed);
  EXPECT_TRUE(current.isr_amplitude({8, 3068, 3068}));
  EXPECT_EQ(current.isr_amplitude({7, 3068, 3068}).error(), Error::failed);
  EXPECT_TRUE(current.isr_amplitude({2048 + 160, 2048, 2048}));
  EXPECT_EQ(current.isr_amplitude({2048 + 161, 2048, 2048}).error(), Error::failed);
  EXPECT_EQ(current.isr_amplitude({2048, 2048, 2048 - 161}).error(), Error::failed);
}

TEST(PhaseCurrent, FailsUntilItsZerosAreKnown) {
  PhaseCurrent current;
  EXPECT_EQ(current.isr_amplitude({2048, 2048, 2048}).error(), Error::failed);
  current.take_rest({2048, 2048, 2048});
  EXPECT_EQ(current.finish_rest(), Error::failed) << "one sample is not enough";
}

TEST(PhaseCurrent, ZerosHaveToLieNearMidScale) {
  const auto finish = [](std::uint32_t zero) {
    PhaseCurrent current;
    for (int i = 0; i < 256; ++i) {
      current.take_rest({2048, 2048, zero});
    }
    return current.finish_rest();
  };
  EXPECT_EQ(finish(1535), Error::failed);
  EXPECT_EQ(finish(1536), Error::none);
  EXPECT_EQ(finish(2560), Error::none);
  EXPECT_EQ(finish(2561), Error::failed);
}

TEST(SquareRoot, IsTheLargestWhoseSquareFits) {
  using hal::stm32g4::square_root;
  EXPECT_EQ(square_root(0), 0u);
  EXPECT_EQ(square_root(1), 1u);
  EXPECT_EQ(square_root(3), 1u);
  EXPECT_EQ(square_root(4), 2u);
  EXPECT_EQ(square_root(0xFFFFFFFFu), 65535u);
  for (std::uint32_t root = 1; root < 65536; root += 13) {
    EXPECT_EQ(square_root(root * root), root);
    EXPECT_EQ(square_root(root * root - 1), root - 1);
  }
}

}  // namespace
}  // namespace stm32g4_models
