#include "firmware/protocol/e2e.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string_view>

#include "firmware/protocol/codec.hpp"
#include "tests/protocol/frames.hpp"

namespace protocol::e2e {
namespace {

using test::flipped;
using test::frame;

std::uint8_t crc_of_text(std::string_view text) {
  Crc8h2f crc;
  for (const char c : text) {
    crc.add(static_cast<std::uint8_t>(c));
  }
  return crc.value();
}

// AUTOSAR CP SWS CRC Library, 7.2.1.2, table of CRC8H2F: data in hexadecimal, then the CRC.
TEST(Crc8h2f, MatchesThePublishedTable) {
  using namespace std::string_view_literals;
  EXPECT_EQ(crc_of_text("\x00\x00\x00\x00"sv), 0x12);
  EXPECT_EQ(crc_of_text("\xf2\x01\x83"sv), 0xc2);
  EXPECT_EQ(crc_of_text("\x0f\xaa\x00\x55"sv), 0xc6);
  EXPECT_EQ(crc_of_text("\x00\xff\x55\x11"sv), 0x77);
  EXPECT_EQ(crc_of_text("\x33\x22\x55\xaa\xbb\xcc\xdd\xee\xff"sv), 0x11);
  EXPECT_EQ(crc_of_text("\x92\x6b\x55"sv), 0x33);
  EXPECT_EQ(crc_of_text("\xff\xff\xff\xff"sv), 0x6c);
  EXPECT_EQ(crc_of_text("123456789"), 0xdf);
}

// The example of AUTOSAR FO PRS E2E Protocol for Profile 22: zeros, data ids 0x01 .. 0x10, header
// at byte 0 of 8 and at byte 8 of 16. The CRC at each counter as the Rust crate autosar-e2e
// publishes it (test_profile22_basic_example, test_profile22_offset_example).
TEST(Profile22, MatchesThePublishedExample) {
  constexpr std::array<std::uint8_t, kCounters> kPublished{0x0e, 0x1b, 0x98, 0x31, 0x0d, 0x18,
                                                           0x9b, 0x65, 0x08, 0x1d, 0x9e, 0x37,
                                                           0x0b, 0x1e, 0x9d, 0xcd};
  for (std::uint8_t counter = 0; counter < kCounters; ++counter) {
    std::array<std::byte, 8> data{};
    data[1] = std::byte{counter};
    EXPECT_EQ(crc_over(data, 0, static_cast<std::uint8_t>(counter + 1)), kPublished[counter])
        << int{counter};
  }
  std::array<std::byte, 16> with_offset{};
  EXPECT_EQ(crc_over(with_offset, 8, 0x01), 0x01);
  with_offset[9] = std::byte{1};
  EXPECT_EQ(crc_over(with_offset, 8, 0x02), 0x14);
}

// Node 1 has the data id 0x01 for its LifeStatus with counter 0, as the example has.
TEST(Profile22, AFrameIsProtectedAsTheExampleIs) {
  hal::CanFrame status = encode(1, LifeStatus{});
  Protector protector(stream_of<LifeStatus>(1));
  protector.protect(status);
  EXPECT_EQ(status, frame(0x181, {0x0e, 0x00, 0, 0, 0, 0, 0, 0}));
}

// With the header at byte 3 the CRC goes over bytes 0, 1, 2, 4 .. 7 and the data id: computed by an
// independent bitwise division.
std::uint8_t divided(std::initializer_list<std::uint8_t> bytes) {
  std::uint32_t remainder = 0xff;
  for (const std::uint8_t byte : bytes) {
    remainder ^= byte;
    for (int bit = 0; bit < 8; ++bit) {
      remainder = (remainder << 1) ^ ((remainder & 0x80) != 0 ? 0x12f : 0);
    }
  }
  return static_cast<std::uint8_t>(~remainder);
}

TEST(Profile22, TheHeaderMayLieInside) {
  Protector protector(stream_of<Emergency>(3));
  hal::CanFrame emergency = encode(
      3, Emergency{.code = EmergencyCode::sensor, .error_register = 1, .damage_ppm = 0x010203});
  protector.protect(emergency);
  EXPECT_EQ(emergency, frame(0x083, {0x30, 0xff, 0x01,
                                     divided({0x30, 0xff, 0x01, 0x00, 0x03, 0x02, 0x01, 0x03}),
                                     0x00, 0x03, 0x02, 0x01}));
  protector.protect(emergency);
  EXPECT_EQ(emergency, frame(0x083, {0x30, 0xff, 0x01,
                                     divided({0x30, 0xff, 0x01, 0x01, 0x03, 0x02, 0x01, 0x0f}),
                                     0x01, 0x03, 0x02, 0x01}));
}

TEST(Protector, CountsTo15AndKeepsTheRestOfTheByte) {
  Protector protector(stream_of<LifeStatus>(1));
  hal::CanFrame status = encode(1, LifeStatus{.state = LifeState::worn});
  for (unsigned i = 0; i < 33; ++i) {
    protector.protect(status);
    EXPECT_EQ(std::to_integer<unsigned>(status.data[1]), 0x40 + i % 16);
  }
}

TEST(Protector, AFrameThatDidNotLeaveLeavesNoGap) {
  Protector protector(stream_of<LifeStatus>(1));
  hal::CanFrame status = encode(1, LifeStatus{});
  protector.withdraw();
  protector.protect(status);
  EXPECT_EQ(status.data[1], std::byte{15});
  protector.withdraw();
  protector.protect(status);
  EXPECT_EQ(status.data[1], std::byte{15});
  protector.protect(status);
  EXPECT_EQ(status.data[1], std::byte{0});
}

class Link {
 public:
  /// The next frame of the sender.
  hal::CanFrame sent() {
    hal::CanFrame frame = encode(1, LifeStatus{.state = LifeState::normal, .damage_ppb = 7});
    protector_.protect(frame);
    return frame;
  }
  void lose(int frames) {
    for (int i = 0; i < frames; ++i) {
      sent();
    }
  }
  Status arrives() { return checker.check(sent()); }

  Checker checker{stream_of<LifeStatus>(1)};

 private:
  Protector protector_{stream_of<LifeStatus>(1)};
};

TEST(Checker, FollowsASender) {
  Link link;
  link.lose(9);
  EXPECT_EQ(link.arrives(), Status::initial);
  for (int i = 0; i < 40; ++i) {
    EXPECT_EQ(link.arrives(), Status::ok);
  }
  EXPECT_EQ(link.checker.counts(), (Counts{.good = 41}));
}

TEST(Checker, TellsHowMuchWasLost) {
  Link link;
  EXPECT_EQ(link.arrives(), Status::initial);
  link.lose(1);
  EXPECT_EQ(link.arrives(), Status::ok_some_lost);
  link.lose(2);
  EXPECT_EQ(link.arrives(), Status::ok_some_lost);
  EXPECT_EQ(link.checker.counts(), (Counts{.good = 3, .lost = 3}));
  link.lose(3);
  EXPECT_EQ(link.arrives(), Status::wrong_sequence);
  EXPECT_EQ(link.arrives(), Status::ok);
  EXPECT_EQ(link.checker.counts(), (Counts{.good = 4, .lost = 3, .wrong_sequence = 1}));
}

TEST(Checker, TellsRepetitionsAndReordering) {
  Link link;
  const hal::CanFrame first = link.sent();
  const hal::CanFrame second = link.sent();
  const hal::CanFrame third = link.sent();
  EXPECT_EQ(link.checker.check(first), Status::initial);
  EXPECT_EQ(link.checker.check(first), Status::repeated);
  EXPECT_EQ(link.checker.check(third), Status::ok_some_lost);
  EXPECT_EQ(link.checker.check(second), Status::wrong_sequence);
  EXPECT_EQ(link.checker.check(third), Status::ok);
  EXPECT_EQ(link.checker.counts(),
            (Counts{.good = 3, .lost = 1, .repeated = 1, .wrong_sequence = 1}));
}

TEST(Checker, TakesTheLargestDeltaThatItIsGiven) {
  const Stream stream = stream_of<LifeStatus>(1);
  for (std::uint8_t most = 1; most <= 14; ++most) {
    for (int lost = 0; lost < 15; ++lost) {
      Link link;
      Checker checker(stream, most);
      EXPECT_EQ(checker.check(link.sent()), Status::initial);
      link.lose(lost);
      const Status expected = lost == 0     ? Status::ok
                              : lost < most ? Status::ok_some_lost
                                            : Status::wrong_sequence;
      EXPECT_EQ(checker.check(link.sent()), expected) << int{most} << ' ' << lost;
    }
  }
}

TEST(Checker, DamagedFramesLeaveNoTrace) {
  Link link;
  EXPECT_EQ(link.arrives(), Status::initial);
  const hal::CanFrame next = link.sent();
  for (std::size_t bit = 0; bit < 64; ++bit) {
    EXPECT_EQ(link.checker.check(flipped(next, bit)), Status::wrong_crc) << bit;
  }
  hal::CanFrame shorter = next;
  shorter.length = 7;
  EXPECT_EQ(link.checker.check(shorter), Status::wrong_length);
  EXPECT_EQ(link.checker.check(next), Status::ok);
  EXPECT_EQ(link.checker.counts(), (Counts{.good = 2, .damaged = 65}));
}

TEST(Checker, OtherFramesAreNotCounted) {
  Link link;
  hal::CanFrame other = link.sent();
  other.extended = true;
  EXPECT_EQ(link.checker.check(other), Status::other_frame);
  EXPECT_EQ(link.checker.check(frame(0x182, {0, 0, 0, 0, 0, 0, 0, 0})), Status::other_frame);
  EXPECT_EQ(link.checker.counts(), Counts{});
}

TEST(Checker, SaysWhatMayBeUsed) {
  EXPECT_TRUE(is_usable(Status::initial));
  EXPECT_TRUE(is_usable(Status::ok));
  EXPECT_TRUE(is_usable(Status::ok_some_lost));
  EXPECT_FALSE(is_usable(Status::repeated));
  EXPECT_FALSE(is_usable(Status::wrong_sequence));
  EXPECT_FALSE(is_usable(Status::wrong_crc));
  EXPECT_FALSE(is_usable(Status::wrong_length));
  EXPECT_FALSE(is_usable(Status::other_frame));
}

}  // namespace
}  // namespace protocol::e2e
