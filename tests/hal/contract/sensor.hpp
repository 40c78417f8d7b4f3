#pragma once

#include <gtest/gtest.h>

#include <cstddef>

#include "hal/devices.hpp"

namespace hal_test {

/// What hal/sensor.hpp states. `Rig`:
///   auto& sensor()
///   std::size_t tendons()
///   Sample sample(int n)                        the n-th of some samples, all different
///   void measure(std::size_t tendon, int n)     that sample is the newest
///   bool measures_always()                      each read measures, so that nothing is missing
///   bool break_it()                             from now on the sensor reports a fault; false
///   where
///                                               that cannot be
template <class Rig>
class SensorContract : public testing::Test {
 protected:
  Rig rig_;
};

TYPED_TEST_SUITE_P(SensorContract);

TYPED_TEST_P(SensorContract, GivesTheNewestSampleOfEachTendon) {
  auto& sensor = this->rig_.sensor();
  for (int n = 0; n < 5; ++n) {
    for (std::size_t tendon = 0; tendon < this->rig_.tendons(); ++tendon) {
      this->rig_.measure(tendon, n + static_cast<int>(tendon));
    }
    for (std::size_t tendon = 0; tendon < this->rig_.tendons(); ++tendon) {
      const auto read = sensor.isr_read(tendon);
      ASSERT_TRUE(read) << hal::to_string(read.error());
      EXPECT_EQ(*read, this->rig_.sample(n + static_cast<int>(tendon)));
    }
  }
}

TYPED_TEST_P(SensorContract, GivesEachSampleOnce) {
  if (this->rig_.measures_always()) {
    GTEST_SKIP() << "each read of this back end is a measurement";
  }
  auto& sensor = this->rig_.sensor();
  EXPECT_EQ(sensor.isr_read(0).error(), hal::Error::missing);
  this->rig_.measure(0, 1);
  ASSERT_TRUE(sensor.isr_read(0));
  for (int i = 0; i < 3; ++i) {
    const auto again = sensor.isr_read(0);
    ASSERT_FALSE(again);
    EXPECT_EQ(again.error(), hal::Error::missing);
  }
}

TYPED_TEST_P(SensorContract, TellsThatItIsFaulty) {
  if (!this->rig_.break_it()) {
    GTEST_SKIP() << "this back end cannot fail";
  }
  const auto read = this->rig_.sensor().isr_read(0);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error(), hal::Error::failed);
}

REGISTER_TYPED_TEST_SUITE_P(SensorContract, GivesTheNewestSampleOfEachTendon, GivesEachSampleOnce,
                            TellsThatItIsFaulty);

}  // namespace hal_test
