#include "firmware/protocol/isotp/link.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string_view>

#include "tests/protocol/services/bytes.hpp"

namespace protocol::isotp {
namespace {

using protocol::testing::Bytes;
using protocol::testing::counting;
using protocol::testing::frame;
using protocol::testing::hex;
using protocol::testing::to_bytes;

constexpr std::uint32_t kIn = 0x18DA05F1;
constexpr std::uint32_t kOut = 0x18DAF105;

/// The link of node 5; the tester is played by hand.
class LinkTest : public ::testing::Test {
 protected:
  void hear(std::string_view data) { link_.on_frame(frame(kIn, data), now_); }
  std::optional<hal::CanFrame> next() { return link_.next_frame(now_); }
  void expect_next(std::string_view data) { EXPECT_EQ(next(), frame(kOut, data)); }
  void expect_silence() { EXPECT_EQ(next(), std::nullopt); }
  void wait(hal::Time time) { now_ = now_ + time; }
  Bytes received() const { return to_bytes(link_.received()); }
  /// That the link still does its work.
  void expect_usable() {
    link_.clear();
    hear("10 0a 00 01 02 03 04 05");
    expect_next("30 00 05");
    hear("21 06 07 08 09");
    EXPECT_EQ(received(), counting(10));
  }

  hal::Time now_ = hal::seconds(7);
  Link<20> link_{Address::to_tester(5)};
};

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
