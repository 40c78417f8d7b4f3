#pragma once

#include <gtest/gtest.h>

#include "hal/devices.hpp"

namespace hal_test {

/// What hal/watchdog.hpp states. `Rig`, with a watchdog that runs:
///   auto& watchdog()
///   void pass(int tenths)   lets tenths of its period go by
///   bool bitten()
template <class Rig>
class WatchdogContract : public testing::Test {
 protected:
  Rig rig_;
};

TYPED_TEST_SUITE_P(WatchdogContract);

TYPED_TEST_P(WatchdogContract, DoesNotBiteWhileItIsFed) {
  for (int i = 0; i < 100; ++i) {
    this->rig_.pass(8);
    this->rig_.watchdog().feed();
    ASSERT_FALSE(this->rig_.bitten()) << i;
  }
}

TYPED_TEST_P(WatchdogContract, BitesWhereItIsNotFed) {
  this->rig_.watchdog().feed();
  this->rig_.pass(8);
  EXPECT_FALSE(this->rig_.bitten());
  this->rig_.pass(4);
  EXPECT_TRUE(this->rig_.bitten());
}

TYPED_TEST_P(WatchdogContract, BitesWhereItIsNeverFed) {
  this->rig_.pass(12);
  EXPECT_TRUE(this->rig_.bitten());
}

REGISTER_TYPED_TEST_SUITE_P(WatchdogContract, DoesNotBiteWhileItIsFed, BitesWhereItIsNotFed,
                            BitesWhereItIsNeverFed);

}  // namespace hal_test
