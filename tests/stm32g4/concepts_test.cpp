#include <gtest/gtest.h>

#include "hal/can_port.hpp"
#include "hal/clock.hpp"
#include "hal/devices.hpp"
#include "hal/non_volatile.hpp"
#include "tests/stm32g4/model/hal_devices.hpp"

namespace stm32g4_models {
namespace {

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
