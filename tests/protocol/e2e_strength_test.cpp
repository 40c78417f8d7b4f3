#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <numeric>
#include <vector>

#include "firmware/protocol/codec.hpp"
#include "firmware/protocol/e2e.hpp"
#include "firmware/protocol/schema/plan.hpp"
#include "tests/protocol/frames.hpp"

// What the protection finds, by trying everything.
namespace protocol::e2e {
namespace {

using test::flipped;

std::vector<const schema::Frame*> protected_frames() {
  std::vector<const schema::Frame*> frames;
  for (const schema::Frame* frame : schema::kFrames) {
    if (frame->integrity) {
      frames.push_back(frame);
    }
  }
  return frames;
}

/// Some frame of the stream with this counter and the CRC that it ought to have.
hal::CanFrame genuine(const Stream& stream, std::uint8_t counter) {
  hal::CanFrame frame{.id = stream.id, .length = stream.length};
  for (std::size_t i = 0; i < frame.length; ++i) {
    frame.data[i] = static_cast<std::byte>(37 * i + 11);
  }
  frame.data[stream.crc_byte + 1u] = std::byte{counter};
  frame.data[stream.crc_byte] = std::byte{crc_of(stream, frame)};
  return frame;
}

bool passes(const Stream& stream, const hal::CanFrame& frame) {
  return frame.data[stream.crc_byte] == std::byte{crc_of(stream, frame)};
}

std::size_t undetected(const Stream& stream, const hal::CanFrame& frame) {
  std::size_t count = 0;
  for (std::size_t a = 0; a < 64; ++a) {
    const hal::CanFrame one = flipped(frame, a);
    count += passes(stream, one) ? 1u : 0u;
    for (std::size_t b = a + 1; b < 64; ++b) {
      const hal::CanFrame two = flipped(one, b);
      count += passes(stream, two) ? 1u : 0u;
      for (std::size_t c = b + 1; c < 64; ++c) {
        count += passes(stream, flipped(two, c)) ? 1u : 0u;
      }
    }
  }
  return count;
}

TEST(Strength, EveryErrorOfUpTo3BitsIsFound) {
  ASSERT_EQ(protected_frames().size(), 4u);
  for (const schema::Frame* frame : protected_frames()) {
    for (const std::uint8_t counter : std::initializer_list<std::uint8_t>{0, 5, 10, 15}) {
      const Stream stream = stream_of(*frame, 93);
      ASSERT_TRUE(passes(stream, genuine(stream, counter)));
      EXPECT_EQ(undetected(stream, genuine(stream, counter)), 0u) << frame->name;
    }
  }
}

/// How many errors of 3 bits in 56 bits and their CRC of this polynomial leave no remainder.
std::size_t missed(std::uint8_t polynomial) {
  std::array<std::uint8_t, 64> remainder{};
  for (std::size_t bit = 0; bit < 64; ++bit) {
    std::uint32_t value = 1;
    for (std::size_t step = 0; step < bit; ++step) {
      value = (value << 1) ^ ((value & 0x80) != 0 ? 0x100u + polynomial : 0u);
    }
    remainder[bit] = static_cast<std::uint8_t>(value);
  }
  std::size_t count = 0;
  for (std::size_t a = 0; a < 64; ++a) {
    for (std::size_t b = a + 1; b < 64; ++b) {
      for (std::size_t c = b + 1; c < 64; ++c) {
        count += (remainder[a] ^ remainder[b] ^ remainder[c]) == 0 ? 1u : 0u;
      }
    }
  }
  return count;
}

TEST(Strength, ThePolynomialIsBetterThanThatOfSaeJ1850) {
  EXPECT_EQ(missed(0x2f), 0u);
  EXPECT_EQ(missed(0x1d), 198u);
}

std::array<std::uint8_t, kCounters> list_of(const DataIds& ids) {
  std::array<std::uint8_t, kCounters> list{};
  for (std::uint8_t counter = 0; counter < kCounters; ++counter) {
    list[counter] = ids.at(counter);
  }
  return list;
}

TEST(Strength, AnyTwoListsShareOnePositionAtMost) {
  std::vector<std::array<std::uint8_t, kCounters>> lists;
  for (const schema::Frame* frame : protected_frames()) {
    for (Node node = 1; node <= 127; ++node) {
      lists.push_back(list_of(stream_of(*frame, node).data_ids));
    }
  }
  ASSERT_EQ(lists.size(), 508u);
  std::ptrdiff_t worst = 0;
  for (std::size_t i = 0; i < lists.size(); ++i) {
    for (std::size_t k = i + 1; k < lists.size(); ++k) {
      const auto shared = std::inner_product(lists[i].begin(), lists[i].end(), lists[k].begin(),
                                             std::ptrdiff_t{0}, std::plus<>{}, std::equal_to<>{});
      worst = std::max(worst, shared);
    }
  }
  EXPECT_EQ(worst, 1);
}

TEST(Strength, AListHasNoIdTwice) {
  for (const schema::Frame* frame : protected_frames()) {
    auto list = list_of(stream_of(*frame, 1).data_ids);
    std::sort(list.begin(), list.end());
    EXPECT_EQ(std::adjacent_find(list.begin(), list.end()), list.end());
  }
}

// The lists of the rule, by hand: list 1, node 2 is k = 130; list 2, node 127 is k = 383.
TEST(Strength, ListsAreTheDocumentedOnes) {
  EXPECT_EQ(list_of(DataIds(1, 2)),
            (std::array<std::uint8_t, 16>{0x82, 0x84, 0x8e, 0x88, 0x9a, 0x9c, 0x96, 0x90, 0xb2,
                                          0xb4, 0xbe, 0xb8, 0xaa, 0xac, 0xa6, 0xa0}));
  EXPECT_EQ(DataIds(2, 127).at(0), 0x7f);
  EXPECT_EQ(DataIds(2, 127).at(1), 0x73);
  EXPECT_EQ(DataIds(3, 127).at(1), 0xf3);
}

// A frame of one stream under the identifier of another, with the same position of the header.
TEST(Strength, AFrameOfAnotherStreamNeverPassesTwiceRunning) {
  for (Node node = 2; node <= 127; ++node) {
    const Stream mine = stream_of<LifeStatus>(1);
    for (const Stream& other : {stream_of<LifeStatus>(node), stream_of<Command>(node)}) {
      unsigned passed = 0;
      for (std::uint8_t counter = 0; counter < kCounters; ++counter) {
        passed += passes(mine, genuine(other, counter)) ? 1u : 0u;
      }
      EXPECT_LE(passed, 1u) << int{node};
    }
  }
}

}  // namespace
}  // namespace protocol::e2e
