#include <gtest/gtest.h>

#include <array>

#include "firmware/protocol/codec.hpp"
#include "firmware/protocol/schema/plan.hpp"
#include "tests/protocol/random_messages.hpp"

namespace protocol::schema {
namespace {

// What the checks must refuse: each plan differs from a sound one in a single thing.
constexpr std::array kOneValue{ValueName{1, "one"}};
constexpr Frame kSoundFrame{
    .name = "Some",
    .base_id = 0x300,
    .length = 8,
    .comment = "text",
    .integrity = Integrity{.crc_byte = 0, .id_list = 0},
    .page = Signal{.name = "Page", .start_bit = 12, .bits = 4, .comment = "p"}};
constexpr Signal kSoundSignal{
    .name = "Value", .start_bit = 16, .bits = 8, .comment = "text", .values = kOneValue};

bool lies_well(const Signal& signal, const Frame& frame = kSoundFrame) {
  return schema::lies_well({.frame = &frame, .page = 0, .name = "P", .signals = {&signal, 1}});
}

TEST(SchemaChecks, SoundPlansPass) {
  EXPECT_TRUE(is_sound(kSoundFrame));
  EXPECT_TRUE(is_sound(kSoundSignal));
  EXPECT_TRUE(lies_well(kSoundSignal));
}

TEST(SchemaChecks, NamesAreThoseThatReadersTake) {
  for (const char* name : {"", "1st", "two words", "under_line", "x-y", "u\xc3\xa4",
                           "ANameOfThirtyThreeLettersIsTooLong"}) {
    Signal signal = kSoundSignal;
    signal.name = name;
    EXPECT_FALSE(is_sound(signal)) << name;
  }
}

TEST(SchemaChecks, TextsStayOnTheirLine) {
  for (const char* text : {"a \"quote\"", "two\nlines", "end;", "back\\slash", "\xc2\xb5", ""}) {
    Signal signal = kSoundSignal;
    signal.comment = text;
    EXPECT_FALSE(is_sound(signal)) << text;
  }
}

TEST(SchemaChecks, FactorsAreDecimals) {
  for (const char* factor : {"", "1e-9", "-1", ".5", "1.", "1.0.0", "1,5"}) {
    Signal signal = kSoundSignal;
    signal.factor = factor;
    EXPECT_FALSE(is_sound(signal)) << factor;
  }
}

TEST(SchemaChecks, ValuesFitAndDiffer) {
  constexpr std::array kTooLarge{ValueName{256, "large"}};
  constexpr std::array kTwice{ValueName{1, "one"}, ValueName{1, "uno"}};
  constexpr std::array kSameName{ValueName{1, "one"}, ValueName{2, "one"}};
  constexpr std::array kBadName{ValueName{1, "One two"}};
  for (const std::span<const ValueName> values :
       {std::span<const ValueName>(kTooLarge), std::span<const ValueName>(kTwice),
        std::span<const ValueName>(kSameName), std::span<const ValueName>(kBadName)}) {
    Signal signal = kSoundSignal;
    signal.values = values;
    EXPECT_FALSE(is_sound(signal)) << values.front().name;
  }
}

TEST(SchemaChecks, SignalsLieInFreeBits) {
  Signal signal = kSoundSignal;
  signal.start_bit = 7;  // of the CRC
  EXPECT_FALSE(lies_well(signal));
  signal.start_bit = 11;  // of the counter
  EXPECT_FALSE(lies_well(signal));
  signal.start_bit = 15;  // of the multiplexor
  EXPECT_FALSE(lies_well(signal));
  signal.start_bit = 57;  // past the end
  EXPECT_FALSE(lies_well(signal));
  signal.start_bit = 56;
  EXPECT_TRUE(lies_well(signal));
  Frame shorter = kSoundFrame;
  shorter.length = 7;
  EXPECT_FALSE(lies_well(signal, shorter));
  signal = kSoundSignal;
  signal.bits = 0;
  EXPECT_FALSE(lies_well(signal));
}

TEST(SchemaChecks, TheMultiplexorComesFirst) {
  Frame late = kSoundFrame;
  late.page->start_bit = 40;
  EXPECT_FALSE(lies_well(kSoundSignal, late));
}

TEST(SchemaChecks, FramesHaveAnIdentifierOfTheirOwn) {
  Frame frame = kSoundFrame;
  frame.base_id = 0x301;
  EXPECT_FALSE(is_sound(frame));
  frame.base_id = 0x800;
  EXPECT_FALSE(is_sound(frame));
  Frame other = kSoundFrame;
  other.name = "Other";
  other.base_id = 0x380;
  EXPECT_FALSE(are_distinct(kSoundFrame, other));  // the same list of data ids
  other.integrity->id_list = 1;
  EXPECT_TRUE(are_distinct(kSoundFrame, other));
  other.base_id = kSoundFrame.base_id;
  EXPECT_FALSE(are_distinct(kSoundFrame, other));
}

TEST(SchemaChecks, PagesDiffer) {
  const MessageView one{
      .frame = &kSoundFrame, .page = 0, .name = "A", .signals = {&kSoundSignal, 1}};
  MessageView other = one;
  other.page = 1;
  EXPECT_FALSE(are_distinct(one, other));  // the same signal name
  other.signals = {};
  EXPECT_TRUE(are_distinct(one, other));
  other.page = 0;
  EXPECT_FALSE(are_distinct(one, other));
  other.page = 16;
  EXPECT_FALSE(has_its_page(other));
  other.page = std::nullopt;
  EXPECT_FALSE(has_its_page(other));
}

// 11-bit identifiers without those of the NMT command, SYNC, TIME, SDO and the other protocols of
// CiA 301 (7.3.3, table 39).
TEST(FramePlan, KeepsToThePredefinedConnectionSet) {
  const std::array<std::uint16_t, 5> wanted{0x700, 0x180, 0x280, 0x080, 0x200};
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_EQ(kFrames[i]->base_id, wanted[i]);
  }
}

TEST(FramePlan, RandomMessagesComeBackFromTheirFrames) {
  test::Random random(1);
  for (int i = 0; i < 20'000; ++i) {
    test::with_random_message(random, [&]<class Message>(const Message& message) {
      const Node node = static_cast<Node>(1 + random() % 127);
      const hal::CanFrame frame = encode(node, message);
      ASSERT_EQ(node_of<Message>(frame), node);
      const auto decoded = decode<Message>(frame);
      ASSERT_TRUE(decoded);
      ASSERT_EQ(*decoded, message);
    });
  }
}

}  // namespace
}  // namespace protocol::schema
