#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "hal/can_port.hpp"
#include "tests/hal/contract/frames.hpp"

namespace hal_test {

/// What hal/can_port.hpp states, for every back end. `Rig` puts a back end on a bench with a peer
/// on the same bus:
///   auto& port()                            the port, idle and active
///   std::vector<hal::CanFrame> on_bus()     what has left the port since the last call
///   void peer_sends(const hal::CanFrame&)   a frame that passes the filter of the port
///   hal::CanFrame accepted(std::uint8_t n)  the n-th of some frames that pass the filter
///   bool block(), unblock()                 the queue fills and stays full; drains again
///   bool go_off(), come_back()              the controller goes off the bus; ends a recovery
/// block() and go_off() are false where the back end cannot be brought to it.
template <class Rig>
class CanPortContract : public testing::Test {
 protected:
  std::vector<hal::CanFrame> received() {
    std::vector<hal::CanFrame> frames;
    while (const auto frame = rig_.port().receive()) {
      frames.push_back(*frame);
    }
    return frames;
  }

  Rig rig_;
};

TYPED_TEST_SUITE_P(CanPortContract);

TYPED_TEST_P(CanPortContract, BeginsActiveWithNothingToGive) {
  EXPECT_EQ(this->rig_.port().receive(), std::nullopt);
  EXPECT_EQ(this->rig_.port().status(), hal::CanStatus{});
  EXPECT_TRUE(this->rig_.on_bus().empty());
}

TYPED_TEST_P(CanPortContract, FramesLeaveWholeAndInTheOrderOfTheCalls) {
  std::vector<hal::CanFrame> left;
  for (const hal::CanFrame& frame : all_shapes()) {
    ASSERT_EQ(this->rig_.port().send(frame), hal::Error::none);
    for (const hal::CanFrame& seen : this->rig_.on_bus()) {
      left.push_back(seen);
    }
  }
  EXPECT_EQ(left, all_shapes());
}

TYPED_TEST_P(CanPortContract, LowerIdsDoNotOvertake) {
  // They win the arbitration: a controller that sorts its queue by id gets this wrong.
  const std::vector<hal::CanFrame> frames{frame(0x700, 1, 5), frame(0x100, 2, 6),
                                          frame(0x100, 2, 7)};
  for (const hal::CanFrame& one : frames) {
    ASSERT_EQ(this->rig_.port().send(one), hal::Error::none);
  }
  EXPECT_EQ(this->rig_.on_bus(), frames);
}

TYPED_TEST_P(CanPortContract, GivesTheOldestFrameFirstAndEachOnce) {
  for (std::uint8_t n = 0; n < 3; ++n) {
    this->rig_.peer_sends(this->rig_.accepted(n));
  }
  EXPECT_EQ(this->received(),
            (std::vector<hal::CanFrame>{this->rig_.accepted(0), this->rig_.accepted(1),
                                        this->rig_.accepted(2)}));
  EXPECT_EQ(this->rig_.port().receive(), std::nullopt);
}

TYPED_TEST_P(CanPortContract, DoesNotHearItself) {
  ASSERT_EQ(this->rig_.port().send(this->rig_.accepted(0)), hal::Error::none);
  EXPECT_EQ(this->rig_.on_bus().size(), 1u);
  EXPECT_EQ(this->rig_.port().receive(), std::nullopt);
}

TYPED_TEST_P(CanPortContract, WhereItIsFullNothingHasHappened) {
  if (!this->rig_.block()) {
    GTEST_SKIP() << "this back end cannot be made full";
  }
  std::vector<hal::CanFrame> taken;
  std::optional<hal::CanFrame> refused;
  constexpr std::uint32_t kMore = 10'000;
  for (std::uint32_t i = 0; i < kMore && !refused; ++i) {
    const hal::CanFrame next = frame(i % 0x700, 1, static_cast<std::uint8_t>(i));
    const hal::Error error = this->rig_.port().send(next);
    if (error == hal::Error::none) {
      taken.push_back(next);
    } else {
      ASSERT_EQ(error, hal::Error::full);
      refused = next;
    }
  }
  ASSERT_TRUE(refused) << "the queue has no end";
  EXPECT_EQ(this->rig_.port().send(*refused), hal::Error::full) << "it stays full";
  ASSERT_TRUE(this->rig_.unblock());
  EXPECT_EQ(this->rig_.on_bus(), taken);
  EXPECT_EQ(this->rig_.port().send(*refused), hal::Error::none) << "the same call succeeds later";
  EXPECT_EQ(this->rig_.on_bus(), std::vector<hal::CanFrame>{*refused});
}

TYPED_TEST_P(CanPortContract, RecoveryOfAControllerThatIsNotOffIsDone) {
  EXPECT_EQ(this->rig_.port().recover(), hal::Error::none);
  EXPECT_EQ(this->rig_.port().status(), hal::CanStatus{});
  ASSERT_EQ(this->rig_.port().send(frame(0x123, 2, 1)), hal::Error::none);
  EXPECT_EQ(this->rig_.on_bus().size(), 1u);
}

TYPED_TEST_P(CanPortContract, IsOffUntilItRecovers) {
  if (!this->rig_.go_off()) {
    GTEST_SKIP() << "this back end is never off the bus";
  }
  auto& port = this->rig_.port();
  EXPECT_EQ(port.status().state, hal::CanState::off);
  EXPECT_EQ(port.status().bus_offs, 1u);
  EXPECT_EQ(port.send(frame(0x123, 2, 1)), hal::Error::off);
  EXPECT_TRUE(this->rig_.on_bus().empty());
  EXPECT_EQ(port.status().bus_offs, 1u) << "counted once";

  EXPECT_EQ(port.recover(), hal::Error::none);
  ASSERT_TRUE(this->rig_.come_back());
  EXPECT_NE(port.status().state, hal::CanState::off);
  EXPECT_EQ(port.status().bus_offs, 1u);
  EXPECT_EQ(port.send(frame(0x124, 2, 2)), hal::Error::none);
  EXPECT_EQ(this->rig_.on_bus(), std::vector<hal::CanFrame>{frame(0x124, 2, 2)});

  ASSERT_TRUE(this->rig_.go_off());
  EXPECT_EQ(port.status().bus_offs, 2u);
}

REGISTER_TYPED_TEST_SUITE_P(CanPortContract, BeginsActiveWithNothingToGive,
                            FramesLeaveWholeAndInTheOrderOfTheCalls, LowerIdsDoNotOvertake,
                            GivesTheOldestFrameFirstAndEachOnce, DoesNotHearItself,
                            WhereItIsFullNothingHasHappened,
                            RecoveryOfAControllerThatIsNotOffIsDone, IsOffUntilItRecovers);

}  // namespace hal_test
