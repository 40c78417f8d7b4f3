#include "firmware/protocol/isotp/pdu.hpp"

#include <gtest/gtest.h>

#include "tests/protocol/services/bytes.hpp"

namespace protocol::isotp {
namespace {

using protocol::testing::frame;
using protocol::testing::hex;
using protocol::testing::to_bytes;

constexpr std::uint32_t kId = 0x18DA05F1;

std::optional<Pdu> pdu_of(std::string_view data) {
  static hal::CanFrame kept;
  kept = frame(kId, data);
  return read(kept);
}

TEST(Counts, EachStopsAtItsHighest) {
  std::uint32_t counter = 0;
  count(counter);
  EXPECT_EQ(counter, 1u);
  counter = 0xfffffffe;
  count(counter);
  EXPECT_EQ(counter, 0xffffffffu);
  count(counter);
  EXPECT_EQ(counter, 0xffffffffu);
}

TEST(Address, IdsOfTheFramePlan) {
  EXPECT_EQ(Address::to_node(5).id(), 0x18DA05F1u);
  EXPECT_EQ(Address::to_tester(5).id(), 0x18DAF105u);
  EXPECT_EQ(Address::to_node(127).reversed(), Address::to_tester(127));
}

TEST(Address, OnlyOfItsOwnFrames) {
  hal::CanFrame candidate = frame(0x18DA7FF1, "00");
  EXPECT_EQ(Address::of(candidate), Address::to_node(127));
  candidate.extended = false;
  EXPECT_EQ(Address::of(candidate), std::nullopt);
  // Functional addressing, another priority, another protocol.
  for (const std::uint32_t id : {0x18DB33F1u, 0x14DA05F1u, 0x18EA05F1u, 0x08DA05F1u}) {
    EXPECT_EQ(Address::of(frame(id, "00")), std::nullopt) << id;
  }
}

TEST(Separation, AsTheStandardCodesIt) {
  EXPECT_EQ(separation(0x00), hal::Time{});
  EXPECT_EQ(separation(0x01), hal::milliseconds(1));
  EXPECT_EQ(separation(0x7f), hal::milliseconds(127));
  EXPECT_EQ(separation(0xf1), hal::microseconds(100));
  EXPECT_EQ(separation(0xf9), hal::microseconds(900));
  for (const unsigned reserved : {0x80u, 0xf0u, 0xfau, 0xffu}) {
    EXPECT_EQ(separation(static_cast<std::uint8_t>(reserved)), hal::milliseconds(127)) << reserved;
  }
}

TEST(Pdu, SingleFrames) {
  const auto pdu = pdu_of("02 3e 00");
  ASSERT_TRUE(pdu);
  EXPECT_EQ(pdu->type, PduType::single);
  EXPECT_EQ(pdu->length, 2u);
  EXPECT_EQ(to_bytes(pdu->data), hex("3e 00"));
  const auto padded = pdu_of("02 3e 00 cc cc cc cc cc");
  ASSERT_TRUE(padded);
  EXPECT_EQ(to_bytes(padded->data), hex("3e 00"));
  EXPECT_TRUE(pdu_of("07 01 02 03 04 05 06 07"));
}

TEST(Pdu, SingleFramesThatContradictThemselves) {
  for (const auto* data : {"00", "00 01", "01", "07 01 02 03 04 05 06", "08 01 02 03 04 05 06 07",
                           "0f 01 02 03 04 05 06 07"}) {
    EXPECT_FALSE(pdu_of(data)) << data;
  }
  EXPECT_FALSE(read(hal::CanFrame{.id = kId, .extended = true}));
}

TEST(Pdu, FirstFrames) {
  const auto pdu = pdu_of("10 08 01 02 03 04 05 06");
  ASSERT_TRUE(pdu);
  EXPECT_EQ(pdu->type, PduType::first);
  EXPECT_EQ(pdu->length, 8u);
  EXPECT_EQ(to_bytes(pdu->data), hex("01 02 03 04 05 06"));
  EXPECT_EQ(pdu_of("1f ff 01 02 03 04 05 06")->length, 4095u);
  // The long form.
  EXPECT_EQ(pdu_of("10 00 00 00 10 00 01 02")->length, 4096u);
  EXPECT_EQ(pdu_of("10 00 ff ff ff ff 01 02")->length, 0xffff'ffffu);
}

TEST(Pdu, FirstFramesThatContradictThemselves) {
  for (const auto* data :
       {"10 08 01 02 03 04 05", "10", "10 07 01 02 03 04 05 06", "10 01 01 02 03 04 05 06",
        "10 00 00 00 0f ff 01 02", "10 00 00 00 00 00 01 02"}) {
    EXPECT_FALSE(pdu_of(data)) << data;
  }
}

TEST(Pdu, ConsecutiveFrames) {
  const auto pdu = pdu_of("2f 01 02");
  ASSERT_TRUE(pdu);
  EXPECT_EQ(pdu->type, PduType::consecutive);
  EXPECT_EQ(pdu->sequence, 15);
  EXPECT_EQ(to_bytes(pdu->data), hex("01 02"));
  EXPECT_FALSE(pdu_of("21"));
}

TEST(Pdu, FlowControl) {
  const auto pdu = pdu_of("30 08 f1");
  ASSERT_TRUE(pdu);
  EXPECT_EQ(pdu->type, PduType::flow_control);
  EXPECT_EQ(pdu->status, FlowStatus::continue_to_send);
  EXPECT_EQ(pdu->block_size, 8);
  EXPECT_EQ(pdu->st_min, 0xf1);
  EXPECT_EQ(pdu_of("31 00 00")->status, FlowStatus::wait);
  EXPECT_EQ(pdu_of("32 00 00")->status, FlowStatus::overflow);
  EXPECT_EQ(pdu_of("33 00 00")->status, FlowStatus::invalid);
  EXPECT_EQ(pdu_of("3f 00 00")->status, FlowStatus::invalid);
  EXPECT_FALSE(pdu_of("30 08"));
}

TEST(Pdu, OtherTypesAreNone) {
  for (const auto* data : {"40 00 00", "80 00 00", "f0 00 00"}) {
    EXPECT_FALSE(pdu_of(data)) << data;
  }
}

}  // namespace
}  // namespace protocol::isotp
