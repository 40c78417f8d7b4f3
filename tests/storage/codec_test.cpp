#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "firmware/storage/flash_store.hpp"
#include "firmware/storage/life_record.hpp"
#include "firmware/storage/log_entry.hpp"
#include "tests/storage/lives.hpp"

namespace storage_test {
namespace {

using storage::RecordError;

template <class... T>
constexpr std::array<std::byte, sizeof...(T)> bytes_of(T... values) {
  return {static_cast<std::byte>(values)...};
}

// Written by hand; the last four are CRC-32/ISO-HDLC of the rest, by zlib.
constexpr std::array<std::byte, 64> kFormerRecord = bytes_of(
    0x54, 0x4c, 0x4c, 0x52, 0x01, 0x03, 0x21, 0x01, 0x04, 0x03, 0x02, 0x01, 0x06, 0x05, 0, 0,  //
    1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0, 4, 0, 0, 0,                                            //
    0x11, 0, 0, 0, 0x12, 0, 0, 0, 0x13, 0, 0, 0, 0x14, 0, 0, 0,                                //
    0x18, 0x17, 0x16, 0x15, 0x14, 0x13, 0x12, 0x11, 0xa4, 0xa3, 0xa2, 0xa1, 0x95, 0xf1, 0x83, 0x78);
constexpr storage::RecordBytes kRecord = bytes_of(
    0x54, 0x4c, 0x4c, 0x52, 0x02, 0x03, 0x21, 0x03, 0x04, 0x03, 0x02, 0x01, 0x06, 0x05, 0x22,
    0x11,                                                        //
    1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0, 4, 0, 0, 0,              //
    0x11, 0, 0, 0, 0x12, 0, 0, 0, 0x13, 0, 0, 0, 0x14, 0, 0, 0,  //
    0x18, 0x17, 0x16, 0x15, 0x14, 0x13, 0x12, 0x11, 0xa4, 0xa3, 0xa2, 0xa1, 0x09, 0x0a, 0x0b, 0x0c,
    0x31, 0, 0, 0, 0x21, 0, 0, 0, 0x11, 0, 0, 0, 0x44, 0x43, 0x42, 0x41, 0x54, 0x53, 0x52, 0x51,
    0x6f, 0x4d, 0xc8, 0xbc);

storage::LifeRecord record() {
  storage::LifeRecord record;
  record.sequence = 0x01020304;
  record.tendon = 3;
  record.flags = 0x21;
  record.epoch = 0x0506;
  record.epoch_damage = lifemodel::Damage::from_words({1, 2, 3, 4});
  record.lifetime_damage = lifemodel::Damage::from_words({0x11, 0x12, 0x13, 0x14});
  record.epoch_cycles = 0x1112131415161718;
  record.configuration = 0xa1a2a3a4;
  record.past_lost = true;
  record.history = {.peak = 0x0c0b0a09,
                    .above_50 = 0x31,
                    .above_70 = 0x21,
                    .above_90 = 0x11,
                    .below_minimum_s = 0x41424344,
                    .operated_s = 0x51525354,
                    .slack_events = 0x1122,
                    .broken = true};
  return record;
}

/// `bytes` with one word replaced and the CRC made to fit.
storage::RecordBytes with_word(std::size_t at, std::uint32_t word) {
  storage::RecordBytes bytes = kRecord;
  lifemodel::ByteWriter(std::span(bytes).subspan(at)).u32(word);
  lifemodel::ByteWriter(std::span(bytes).last(4)).u32(lifemodel::crc32(std::span(bytes).first(84)));
  return bytes;
}

TEST(RecordCodec, IsAsWrittenByHand) {
  EXPECT_EQ(storage::encode(record()), kRecord);
  const auto decoded = storage::decode(kRecord);
  ASSERT_TRUE(decoded);
  EXPECT_EQ(*decoded, record());
}

TEST(RecordCodec, OfSchema1HasNoHistory) {
  auto without = record();
  without.history = {};
  const auto decoded = storage::decode(kFormerRecord);
  ASSERT_TRUE(decoded) << to_string(decoded.error());
  EXPECT_EQ(*decoded, without);
  EXPECT_EQ(former_bytes(without), kFormerRecord);
  for (std::size_t bit = 0; bit < 8 * kFormerRecord.size(); ++bit) {
    auto bytes = kFormerRecord;
    bytes[bit / 8] ^= static_cast<std::byte>(1u << (bit % 8));
    EXPECT_FALSE(storage::decode(bytes)) << "bit " << bit;
  }
  const auto refused = [](std::size_t at, std::uint32_t word) {
    auto bytes = kFormerRecord;
    lifemodel::ByteWriter(std::span(bytes).subspan(at)).u32(word);
    lifemodel::ByteWriter(std::span(bytes).last(4))
        .u32(lifemodel::crc32(std::span(bytes).first(60)));
    return storage::decode(bytes).error();
  };
  EXPECT_EQ(refused(4, 0x01210302), RecordError::unknown_schema);
  EXPECT_EQ(refused(4, 0x03210301), RecordError::implausible);  // broken, which it cannot know
  EXPECT_EQ(refused(12, 0x10506), RecordError::implausible);    // slack events, the same
}

TEST(RecordCodec, SlackEventsStopAtTheEndOfTheirRange) {
  auto many = record();
  many.history.slack_events = 0x10000;
  const auto decoded = storage::decode(storage::encode(many));
  ASSERT_TRUE(decoded);
  EXPECT_EQ(decoded->history.slack_events, 0xffffu);
  EXPECT_EQ(decoded->epoch, 0x0506);
}

TEST(RecordCodec, EveryFlippedBitIsNoticed) {
  for (std::size_t bit = 0; bit < 8 * kRecord.size(); ++bit) {
    auto bytes = kRecord;
    bytes[bit / 8] ^= static_cast<std::byte>(1u << (bit % 8));
    EXPECT_FALSE(storage::decode(bytes)) << "bit " << bit;
  }
}

TEST(RecordCodec, TellsWhyItRefuses) {
  EXPECT_EQ(storage::decode(std::span(kRecord).first(87)).error(), RecordError::wrong_size);
  EXPECT_EQ(storage::decode(with_word(0, 0x524c4c55)).error(), RecordError::not_a_record);
  EXPECT_EQ(storage::decode(with_word(4, 0x01210301)).error(), RecordError::unknown_schema);
  auto damaged = kRecord;
  damaged[20] ^= std::byte{1};
  EXPECT_EQ(storage::decode(damaged).error(), RecordError::damaged);
  EXPECT_EQ(storage::decode(with_word(4, 0x01400302)).error(), RecordError::implausible);  // flags
  EXPECT_EQ(storage::decode(with_word(4, 0x04210302)).error(), RecordError::implausible);  // notes
  EXPECT_EQ(storage::decode(with_word(28, 0x15)).error(), RecordError::implausible);       // damage
  EXPECT_TRUE(storage::decode(with_word(28, 0x13)));
  EXPECT_EQ(to_string(RecordError::wrong_size),
            std::string("wrong size: a life record has 88 bytes, of schema 1 64"));
}

TEST(EntryCodec, IsAsWrittenByHand) {
  constexpr storage::EntryBytes kEntry =
      bytes_of(0x54, 0x4c, 0x4c, 0x45, 7, 0, 0, 0, 4, 3, 2, 1, 2, 3, 6, 5, 0xa4, 0xa3, 0xa2, 0xa1,
               0x3c, 0x37, 0x6b, 0x0b);
  const storage::LogEntry entry{7, 0x01020304, storage::Event::parameters_loaded,
                                3, 0x0506,     0xa1a2a3a4};
  EXPECT_EQ(storage::encode(entry), kEntry);
  EXPECT_EQ(storage::decode_entry(kEntry), entry);
  for (std::size_t bit = 0; bit < 8 * kEntry.size(); ++bit) {
    auto bytes = kEntry;
    bytes[bit / 8] ^= static_cast<std::byte>(1u << (bit % 8));
    EXPECT_FALSE(storage::decode_entry(bytes)) << "bit " << bit;
  }
}

TEST(ParameterSlot, OfSchema2IsAsWrittenByHand) {
  using Slot = storage::ParameterSlot<128>::Former;
  const auto slot = Slot::make({3, 0x01020304}, block_of(5).bytes());
  constexpr auto kHead = bytes_of(0x54, 0x4c, 0x50, 0x53, 2, 3, 0, 0, 4, 3, 2, 1, 84, 0, 0, 0);
  constexpr auto kTail = bytes_of(0x2a, 0x78, 0x28, 0x94);
  EXPECT_EQ(slot.size(), 104u);
  EXPECT_TRUE(std::ranges::equal(std::span(slot).first(16), kHead));
  EXPECT_TRUE(std::ranges::equal(std::span(slot).subspan(16, 84), block_of(5).bytes()));
  EXPECT_TRUE(std::ranges::equal(std::span(slot).last(4), kTail));
  EXPECT_EQ(Slot::name(slot), (storage::SlotName{3, 0x01020304}));
  EXPECT_EQ(Slot::block(slot), block_of(5));
  for (std::size_t bit = 0; bit < 8 * slot.size(); ++bit) {
    auto bytes = slot;
    bytes[bit / 8] ^= static_cast<std::byte>(1u << (bit % 8));
    EXPECT_FALSE(Slot::name(bytes)) << "bit " << bit;
  }
}

TEST(ParameterSlot, OfSchema2IsRenewedWithItsBlock) {
  using Slot = storage::ParameterSlot<128>;
  const auto former = Slot::Former::make({3, 0x01020304}, block_of(5).bytes());
  Slot::Bytes slot;
  slot.fill(std::byte{0xaa});
  std::ranges::copy(former, slot.begin());
  Slot::renew(slot);
  EXPECT_EQ(slot, Slot::make({3, 0x01020304}, block_of(5).bytes()));
  constexpr auto kHead = bytes_of(0x54, 0x4c, 0x50, 0x53, 3, 3, 0, 0, 4, 3, 2, 1, 84, 0, 0, 0);
  EXPECT_EQ(slot.size(), 148u);
  EXPECT_TRUE(std::ranges::equal(std::span(slot).first(16), kHead));
  EXPECT_EQ(Slot::name(slot), (storage::SlotName{3, 0x01020304}));
  EXPECT_EQ(Slot::block(slot), block_of(5));
}

TEST(ParameterSlot, HasRoomBehindAShorterBlock) {
  using Slot = storage::ParameterSlot<172>::Former;
  const auto slot = Slot::make({3, 0x01020304}, block_of(5, 100).bytes());
  constexpr auto kTail = bytes_of(0x08, 0x45, 0xd1, 0x33);
  EXPECT_EQ(Slot::block(slot), block_of(5, 100));
  EXPECT_TRUE(std::ranges::equal(std::span(slot).last(4), kTail));
  // A size beyond the room, with a CRC that fits.
  auto longer = slot;
  longer[12] = std::byte{129};
  lifemodel::ByteWriter(std::span(longer).last(4))
      .u32(lifemodel::crc32(std::span(longer).first(longer.size() - 4)));
  EXPECT_FALSE(Slot::name(longer));
}

TEST(Succession, OfOneWireTheHistoryNeverFalls) {
  using storage::WireHistory;
  auto last = record();
  EXPECT_TRUE(storage::may_follow(last, last));
  for (const auto count :
       {&WireHistory::peak, &WireHistory::above_50, &WireHistory::above_70, &WireHistory::above_90,
        &WireHistory::below_minimum_s, &WireHistory::operated_s, &WireHistory::slack_events}) {
    auto next = record();
    next.history.*count -= 1;
    EXPECT_FALSE(storage::may_follow(next, last));
    EXPECT_TRUE(storage::may_follow(last, next));
    next.epoch += 1;
    EXPECT_TRUE(storage::may_follow(next, last));
  }
  auto whole = record();
  whole.history.broken = false;
  EXPECT_FALSE(storage::may_follow(whole, last));
  whole.epoch += 1;
  EXPECT_TRUE(storage::may_follow(whole, last));
}

TEST(Succession, OfOneWireNothingFalls) {
  const auto last = record_of(0, 10, 2);
  EXPECT_TRUE(storage::may_follow(last, last));
  EXPECT_TRUE(storage::may_follow(record_of(0, 11, 2), last));
  EXPECT_FALSE(storage::may_follow(record_of(0, 9, 2), last));

  auto fewer_cycles = last;
  --fewer_cycles.epoch_cycles;
  EXPECT_FALSE(storage::may_follow(fewer_cycles, last));
  auto less_of_the_wire = record_of(0, 11, 2, 2);
  EXPECT_FALSE(storage::may_follow(less_of_the_wire, last));
}

TEST(Succession, ANewWireBeginsAnewAndTheLifetimeGoesOn) {
  const auto last = record_of(0, 10, 2);
  EXPECT_TRUE(storage::may_follow(record_of(0, 10, 3, 10), last));
  EXPECT_FALSE(storage::may_follow(record_of(0, 9, 3, 9), last));
  EXPECT_FALSE(storage::may_follow(record_of(0, 11, 1), last));
}

}  // namespace
}  // namespace storage_test
