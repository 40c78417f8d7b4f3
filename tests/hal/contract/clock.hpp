#pragma once

#include <gtest/gtest.h>

#include <cstdint>

#include "hal/clock.hpp"

namespace hal_test {

/// What hal/clock.hpp states. `Rig`:
///   const auto& clock()
///   void pass(std::uint32_t time_us)   lets at least that time go by; up to 100 ms
///   bool exact()                       time goes by in pass() alone
template <class Rig>
class ClockContract : public testing::Test {
 protected:
  Rig rig_;
};

TYPED_TEST_SUITE_P(ClockContract);

TYPED_TEST_P(ClockContract, NeverRunsBack) {
  hal::Time last = this->rig_.clock().now();
  for (std::uint32_t i = 0; i < 1'000; ++i) {
    if (i % 10 == 0) {
      this->rig_.pass(i % 7);
    }
    const hal::Time now = this->rig_.clock().now();
    ASSERT_GE(now, last);
    last = now;
  }
}

TYPED_TEST_P(ClockContract, CountsMicroseconds) {
  for (const std::uint32_t time_us : {1u, 10u, 999u, 1'000u, 65'536u, 100'000u}) {
    const hal::Time before = this->rig_.clock().now();
    this->rig_.pass(time_us);
    const hal::Time passed = this->rig_.clock().now() - before;
    EXPECT_GE(passed.us, time_us);
    if (this->rig_.exact()) {
      EXPECT_EQ(passed.us, time_us);
    }
  }
}

REGISTER_TYPED_TEST_SUITE_P(ClockContract, NeverRunsBack, CountsMicroseconds);

}  // namespace hal_test
