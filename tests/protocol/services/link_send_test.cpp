#include <gtest/gtest.h>

#include "tests/protocol/services/link_fixture.hpp"

namespace protocol::isotp {
namespace {

TEST_F(LinkTest, SendsASingleFrameWithoutPadding) {
  EXPECT_FALSE(link_.ready(now_));
  ASSERT_EQ(link_.send(hex("7e 00")), hal::Error::none);
  EXPECT_TRUE(link_.sending());
  EXPECT_TRUE(link_.ready(now_));
  expect_next("02 7e 00");
  EXPECT_FALSE(link_.sending());
  EXPECT_EQ(link_.counts().sent, 1u);
  expect_silence();
}

TEST_F(LinkTest, SevenBytesAreASingleFrameAndEightAreNot) {
  ASSERT_EQ(link_.send(counting(7)), hal::Error::none);
  expect_next("07 00 01 02 03 04 05 06");
  ASSERT_EQ(link_.send(counting(8)), hal::Error::none);
  expect_next("10 08 00 01 02 03 04 05");
  hear("30 00 00");
  expect_next("21 06 07");
  EXPECT_FALSE(link_.sending());
}

TEST_F(LinkTest, SendsALongMessageAsItIsAllowed) {
  ASSERT_EQ(link_.send(counting(20)), hal::Error::none);
  expect_next("10 14 00 01 02 03 04 05");
  expect_silence();
  hear("30 01 00");
  expect_next("21 06 07 08 09 0a 0b 0c");
  expect_silence();
  hear("30 01 00");
  expect_next("22 0d 0e 0f 10 11 12 13");
  EXPECT_FALSE(link_.sending());
  EXPECT_EQ(link_.counts().sent, 1u);
}

TEST_F(LinkTest, KeepsTheSeparation) {
  ASSERT_EQ(link_.send(counting(20)), hal::Error::none);
  expect_next("10 14 00 01 02 03 04 05");
  hear("30 00 02");
  expect_next("21 06 07 08 09 0a 0b 0c");
  wait(hal::Time{2'319});  // 2 ms behind the end of a frame of 320 us
  EXPECT_FALSE(link_.ready(now_));
  expect_silence();
  wait(hal::Time{1});
  EXPECT_TRUE(link_.ready(now_));
  expect_next("22 0d 0e 0f 10 11 12 13");
}

TEST_F(LinkTest, WithoutSeparationNothingWaits) {
  ASSERT_EQ(link_.send(counting(20)), hal::Error::none);
  expect_next("10 14 00 01 02 03 04 05");
  hear("30 00 00");
  expect_next("21 06 07 08 09 0a 0b 0c");
  expect_next("22 0d 0e 0f 10 11 12 13");
}

TEST_F(LinkTest, SequenceNumbersGoRound) {
  Link<200> link(Address::to_tester(5));
  ASSERT_EQ(link.send(counting(6 + 17 * 7)), hal::Error::none);
  ASSERT_TRUE(link.next_frame(now_));
  link.on_frame(frame(kIn, "30 00 00"), now_);
  for (unsigned i = 1; i <= 17; ++i) {
    const auto sent = link.next_frame(now_);
    ASSERT_TRUE(sent);
    EXPECT_EQ(sent->data[0], static_cast<std::byte>(0x20 | (i % 16))) << i;
  }
}

TEST_F(LinkTest, OneMessageAtATime) {
  ASSERT_EQ(link_.send(counting(8)), hal::Error::none);
  EXPECT_EQ(link_.send(counting(8)), hal::Error::busy);
  EXPECT_EQ(Link<20>(Address::to_tester(5)).send({}), hal::Error::out_of_range);
  EXPECT_EQ(Link<20>(Address::to_tester(5)).send(counting(21)), hal::Error::out_of_range);
  EXPECT_EQ(Link<20>(Address::to_tester(5)).send(counting(20)), hal::Error::none);
}

TEST_F(LinkTest, AReceiverMayRefuse) {
  for (const auto* refusal : {"32 00 00", "33 00 00", "3f 00 00"}) {
    ASSERT_EQ(link_.send(counting(8)), hal::Error::none);
    ASSERT_TRUE(next());
    hear(refusal);
    EXPECT_FALSE(link_.sending());
  }
  EXPECT_EQ(link_.counts().send_refused, 3u);
  EXPECT_EQ(link_.counts().sent, 0u);
  expect_usable();
}

TEST_F(LinkTest, AReceiverMayAskToWaitTenTimes) {
  ASSERT_EQ(link_.send(counting(8)), hal::Error::none);
  ASSERT_TRUE(next());
  for (int i = 0; i < 10; ++i) {
    wait(hal::milliseconds(900));
    hear("31 00 00");
    expect_silence();
  }
  hear("30 00 00");
  expect_next("21 06 07");

  ASSERT_EQ(link_.send(counting(8)), hal::Error::none);
  ASSERT_TRUE(next());
  for (int i = 0; i < 11; ++i) {
    hear("31 00 00");
  }
  EXPECT_FALSE(link_.sending());
  EXPECT_EQ(link_.counts().send_refused, 1u);
}

TEST_F(LinkTest, EachBlockMayWaitTenTimes) {
  ASSERT_EQ(link_.send(counting(20)), hal::Error::none);
  ASSERT_TRUE(next());
  for (const auto* block : {"21 06 07 08 09 0a 0b 0c", "22 0d 0e 0f 10 11 12 13"}) {
    for (int i = 0; i < 10; ++i) {
      hear("31 00 00");
    }
    hear("30 01 00");
    expect_next(block);
  }
  EXPECT_EQ(link_.counts().sent, 1u);
}

TEST_F(LinkTest, WaitsOneSecondForFlowControl) {
  ASSERT_EQ(link_.send(counting(8)), hal::Error::none);
  ASSERT_TRUE(next());
  wait(hal::Time{999'999});
  expect_silence();
  EXPECT_TRUE(link_.sending());
  wait(hal::Time{1});
  expect_silence();
  EXPECT_FALSE(link_.sending());
  EXPECT_EQ(link_.counts().send_timeout, 1u);
  hear("30 00 00");
  expect_silence();
  expect_usable();
}

TEST_F(LinkTest, FlowControlComesBeforeDataAndDirectionsDoNotMix) {
  ASSERT_EQ(link_.send(counting(8)), hal::Error::none);
  hear("10 0a 00 01 02 03 04 05");
  expect_next("30 00 05");
  expect_next("10 08 00 01 02 03 04 05");
  hear("21 06 07 08 09");
  hear("30 00 00");
  expect_next("21 06 07");
  EXPECT_EQ(received(), counting(10));
}

}  // namespace
}  // namespace protocol::isotp
