#include "hal/qemu_mps2/virtual_devices.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include "hal/devices.hpp"

namespace hal::qemu_mps2 {
namespace {

static_assert(DigitalIn<InputLine>);
static_assert(DigitalOut<OutputLine>);
static_assert(Watchdog<CountingWatchdog>);
static_assert(Entropy<SeededEntropy>);
static_assert(CurrentSensor<PlayedSensor<2>>);

TEST(SeededEntropyTest, IsSplitMix64) {
  // The first three words for the seed 1234567, as published with the generator.
  constexpr std::array<std::uint64_t, 3> kWords{6457827717110365317u, 3203168211198807973u,
                                                9817491932198370423u};
  SeededEntropy entropy(1234567);
  std::array<std::byte, 20> bytes{};
  ASSERT_EQ(entropy.fill(bytes), Error::none);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    EXPECT_EQ(bytes[i], static_cast<std::byte>(kWords[i / 8] >> (8 * (i % 8)))) << i;
  }
}

TEST(SeededEntropyTest, NeverGivesTheSameTwice) {
  SeededEntropy entropy(1);
  std::array<std::byte, 8> first{};
  std::array<std::byte, 8> second{};
  ASSERT_EQ(entropy.fill(first), Error::none);
  ASSERT_EQ(entropy.fill(second), Error::none);
  EXPECT_NE(first, second);
}

TEST(PlayedSensorTest, GivesWhatWasPutThere) {
  PlayedSensor<2> sensor;
  sensor.put(std::array<std::int32_t, 2>{5, kNoSample});
  EXPECT_EQ(sensor.isr_read(0)->raw(), 5);
  EXPECT_EQ(sensor.isr_read(1).error(), Error::missing);
  sensor.set_failed(true);
  EXPECT_EQ(sensor.isr_read(0).error(), Error::failed);
  sensor.set_failed(false);
  EXPECT_EQ(sensor.isr_read(0)->raw(), 5);
}

TEST(LinesTest, ShowWhatWasDone) {
  InputLine input;
  EXPECT_FALSE(*input.asserted());
  input.drive(true);
  EXPECT_TRUE(*input.asserted());

  OutputLine output;
  EXPECT_EQ(output.set(true), Error::none);
  EXPECT_EQ(output.set(true), Error::none);
  EXPECT_TRUE(output.asserted());
  EXPECT_EQ(output.set(false), Error::none);
  EXPECT_EQ(output.changes(), 2u);
}

}  // namespace
}  // namespace hal::qemu_mps2
