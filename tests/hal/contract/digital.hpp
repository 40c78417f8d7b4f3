#pragma once

#include <gtest/gtest.h>

#include "hal/devices.hpp"

namespace hal_test {

/// What hal/digital.hpp states of an input. `Rig`:
///   auto& line()
///   void drive(bool asserted)   the world asserts the line or not, for longer than any debouncing
///   bool break_it()             from now on it cannot be read; false where that cannot be
template <class Rig>
class DigitalInContract : public testing::Test {
 protected:
  Rig rig_;
};

TYPED_TEST_SUITE_P(DigitalInContract);

TYPED_TEST_P(DigitalInContract, TellsWhatTheWorldDoes) {
  for (const bool asserted : {false, true, true, false, true, false}) {
    this->rig_.drive(asserted);
    for (int i = 0; i < 3; ++i) {
      const auto seen = this->rig_.line().asserted();
      ASSERT_TRUE(seen) << hal::to_string(seen.error());
      EXPECT_EQ(*seen, asserted);
    }
  }
}

TYPED_TEST_P(DigitalInContract, TellsThatItCannotBeRead) {
  this->rig_.drive(true);
  if (!this->rig_.break_it()) {
    GTEST_SKIP() << "this back end cannot fail";
  }
  const auto seen = this->rig_.line().asserted();
  ASSERT_FALSE(seen);
  EXPECT_NE(seen.error(), hal::Error::none);
}

REGISTER_TYPED_TEST_SUITE_P(DigitalInContract, TellsWhatTheWorldDoes, TellsThatItCannotBeRead);

/// What hal/digital.hpp states of an output. `Rig`:
///   auto& line()
///   bool seen()       what the world sees
///   bool break_it()   from now on it cannot be set; false where that cannot be
template <class Rig>
class DigitalOutContract : public testing::Test {
 protected:
  Rig rig_;
};

TYPED_TEST_SUITE_P(DigitalOutContract);

TYPED_TEST_P(DigitalOutContract, BeginsNotAsserted) {
  EXPECT_FALSE(this->rig_.seen());
}

TYPED_TEST_P(DigitalOutContract, TheWorldSeesWhatWasSet) {
  for (const bool asserted : {true, true, false, true, false, false}) {
    EXPECT_EQ(this->rig_.line().set(asserted), hal::Error::none);
    EXPECT_EQ(this->rig_.seen(), asserted);
  }
}

TYPED_TEST_P(DigitalOutContract, TellsThatItCannotBeSet) {
  ASSERT_EQ(this->rig_.line().set(true), hal::Error::none);
  if (!this->rig_.break_it()) {
    GTEST_SKIP() << "this back end cannot fail";
  }
  EXPECT_NE(this->rig_.line().set(false), hal::Error::none);
}

REGISTER_TYPED_TEST_SUITE_P(DigitalOutContract, BeginsNotAsserted, TheWorldSeesWhatWasSet,
                            TellsThatItCannotBeSet);

}  // namespace hal_test
