#include <gtest/gtest.h>

#include "tests/protocol/services/link_fixture.hpp"

namespace protocol::isotp {
namespace {

TEST_F(LinkTest, TakesASingleFrame) {
  EXPECT_TRUE(received().empty());
  hear("02 3e 00");
  EXPECT_EQ(received(), hex("3e 00"));
  EXPECT_EQ(link_.counts().received, 1u);
  expect_silence();
  link_.clear();
  EXPECT_TRUE(received().empty());
}

TEST_F(LinkTest, TakesALongMessage) {
  hear("10 14 00 01 02 03 04 05");
  EXPECT_TRUE(received().empty());
  expect_next("30 00 05");
  expect_silence();
  hear("21 06 07 08 09 0a 0b 0c");
  EXPECT_TRUE(received().empty());
  hear("22 0d 0e 0f 10 11 12 13");
  EXPECT_EQ(received(), counting(20));
  expect_silence();
}

TEST_F(LinkTest, LeavesPaddingOut) {
  hear("10 0a 00 01 02 03 04 05");
  expect_next("30 00 05");
  hear("21 06 07 08 09 cc cc cc");
  EXPECT_EQ(received(), counting(10));
}

TEST_F(LinkTest, LeavesOtherAddressesAlone) {
  for (const std::uint32_t id : {0x18DA06F1u, 0x18DA05F2u, 0x18DAF105u, 0x18DB33F1u}) {
    link_.on_frame(frame(id, "02 3e 00"), now_);
  }
  hal::CanFrame short_id = frame(0x5F1, "02 3e 00");
  short_id.extended = false;
  link_.on_frame(short_id, now_);
  EXPECT_TRUE(received().empty());
  EXPECT_EQ(link_.counts(), Counts{});
}

TEST_F(LinkTest, AsksForEachBlock) {
  Link<20> link(Address::to_tester(5), {.block_size = 1, .st_min = 0xf5});
  link.on_frame(frame(kIn, "10 14 00 01 02 03 04 05"), now_);
  EXPECT_EQ(link.next_frame(now_), frame(kOut, "30 01 f5"));
  link.on_frame(frame(kIn, "21 06 07 08 09 0a 0b 0c"), now_);
  EXPECT_EQ(link.next_frame(now_), frame(kOut, "30 01 f5"));
  link.on_frame(frame(kIn, "22 0d 0e 0f 10 11 12 13"), now_);
  EXPECT_EQ(to_bytes(link.received()), counting(20));
  EXPECT_EQ(link.next_frame(now_), std::nullopt);
}

TEST_F(LinkTest, RefusesWhatIsTooLong) {
  for (const auto* first : {"10 15 00 01 02 03 04 05", "1f ff 00 01 02 03 04 05",
                            "10 00 00 00 10 00 04 05", "10 00 ff ff ff ff 04 05"}) {
    hear(first);
    expect_next("32 00 05");
    hear("21 06 07 08 09 0a 0b 0c");
    EXPECT_TRUE(received().empty());
  }
  EXPECT_EQ(link_.counts().oversized, 4u);
  EXPECT_EQ(link_.counts().unexpected, 4u);
  expect_usable();
}

TEST_F(LinkTest, AWrongSequenceEndsTheMessage) {
  hear("10 14 00 01 02 03 04 05");
  expect_next("30 00 05");
  hear("22 0d 0e 0f 10 11 12 13");
  EXPECT_EQ(link_.counts().wrong_sequence, 1u);
  hear("21 06 07 08 09 0a 0b 0c");
  EXPECT_EQ(link_.counts().unexpected, 1u);
  EXPECT_TRUE(received().empty());
  expect_usable();
}

TEST_F(LinkTest, AShortConsecutiveFrameIsNone) {
  hear("10 14 00 01 02 03 04 05");
  expect_next("30 00 05");
  hear("21 06 07 08 09 0a 0b");
  EXPECT_EQ(link_.counts().malformed, 1u);
  hear("21 06 07 08 09 0a 0b 0c");
  hear("22 0d 0e 0f 10 11 12");
  EXPECT_EQ(link_.counts().malformed, 2u);
  EXPECT_TRUE(received().empty());
  hear("22 0d 0e 0f 10 11 12 13");
  EXPECT_EQ(received(), counting(20));
}

TEST_F(LinkTest, CountsWhatNobodyAskedFor) {
  hear("21 06 07");
  hear("30 00 00");
  hear("32 00 00");
  EXPECT_EQ(link_.counts().unexpected, 3u);
  hear("10 14 00 01 02 03 04 05");
  hear("21 06 07 08 09 0a 0b 0c");  // before the flow control
  EXPECT_EQ(link_.counts().unexpected, 4u);
  expect_next("30 00 05");
  hear("21 06 07 08 09 0a 0b 0c");
  hear("22 0d 0e 0f 10 11 12 13");
  EXPECT_EQ(received(), counting(20));
}

TEST_F(LinkTest, CountsWhatIsMalformed) {
  for (const auto* data : {"00", "08 00", "10 07 00 00 00 00 00 00", "40", "30"}) {
    hear(data);
  }
  link_.on_frame(hal::CanFrame{.id = kIn, .extended = true}, now_);
  EXPECT_EQ(link_.counts().malformed, 6u);
  expect_usable();
}

TEST_F(LinkTest, ANewMessageEndsTheOldOne) {
  hear("10 14 00 01 02 03 04 05");
  expect_next("30 00 05");
  hear("02 3e 00");
  EXPECT_EQ(received(), hex("3e 00"));
  EXPECT_EQ(link_.counts().interrupted, 1u);
  link_.clear();
  hear("10 14 00 01 02 03 04 05");
  hear("10 0a 00 01 02 03 04 05");
  EXPECT_EQ(link_.counts().interrupted, 2u);
  expect_next("30 00 05");
  hear("21 06 07 08 09");
  EXPECT_EQ(received(), counting(10));
}

TEST_F(LinkTest, TheFlowControlOfAMessageThatEndedIsNotSent) {
  hear("10 14 00 01 02 03 04 05");
  hear("02 3e 00");
  expect_silence();
}

TEST_F(LinkTest, AWholeMessageStaysUntilItIsTaken) {
  hear("02 3e 00");
  hear("02 3e 80");
  EXPECT_EQ(received(), hex("3e 00"));
  hear("10 14 00 01 02 03 04 05");
  expect_next("32 00 05");
  EXPECT_EQ(received(), hex("3e 00"));
  EXPECT_EQ(link_.counts().not_taken, 2u);
  expect_usable();
}

TEST_F(LinkTest, WaitsOneSecondForTheRest) {
  hear("10 14 00 01 02 03 04 05");
  expect_next("30 00 05");
  wait(hal::Time{999'999});
  hear("21 06 07 08 09 0a 0b 0c");
  wait(hal::milliseconds(1000));
  hear("22 0d 0e 0f 10 11 12 13");
  EXPECT_TRUE(received().empty());
  EXPECT_EQ(link_.counts().receive_timeout, 1u);
  expect_usable();
}

TEST_F(LinkTest, EachFrameGivesTimeForTheNext) {
  hear("10 14 00 01 02 03 04 05");
  expect_next("30 00 05");
  wait(hal::Time{999'999});
  hear("21 06 07 08 09 0a 0b 0c");
  wait(hal::Time{999'999});
  hear("22 0d 0e 0f 10 11 12 13");
  EXPECT_EQ(received(), counting(20));
}

TEST_F(LinkTest, TheTimeForTheRestBeginsWithTheFlowControl) {
  hear("10 0a 00 01 02 03 04 05");
  wait(hal::seconds(5));
  expect_next("30 00 05");
  wait(hal::Time{999'999});
  hear("21 06 07 08 09");
  EXPECT_EQ(received(), counting(10));
}

}  // namespace
}  // namespace protocol::isotp
