#include "firmware/boards/b_g431b_esc1/node_page.hpp"

#include <gtest/gtest.h>

namespace {

using Bytes = std::array<std::byte, boards::b_g431b_esc1::kNodeBytes>;

/// Node 5, key 00 01 .. 0f; the CRC-32 by zlib.
constexpr std::array<std::uint8_t, boards::b_g431b_esc1::kNodeBytes> kPage{
    0x54, 0x4C, 0x4E, 0x44, 1, 0, 0,  0,  5,  0,  0,  0,  0,    1,    2,    3,
    4,    5,    6,    7,    8, 9, 10, 11, 12, 13, 14, 15, 0x1E, 0x59, 0x80, 0x97};

Bytes page() {
  Bytes bytes{};
  std::transform(kPage.begin(), kPage.end(), bytes.begin(),
                 [](std::uint8_t byte) { return std::byte{byte}; });
  return bytes;
}

/// With the CRC-32 of what is in it now.
Bytes sealed(Bytes bytes) {
  const std::uint32_t crc = lifemodel::crc32(std::span(bytes).first<28>());
  for (std::size_t i = 0; i < 4; ++i) {
    bytes[28 + i] = static_cast<std::byte>(crc >> (8 * i));
  }
  return bytes;
}

TEST(NodePage, IsRead) {
  const auto settings = boards::b_g431b_esc1::decode_node(page());
  ASSERT_TRUE(settings);
  EXPECT_EQ(settings->node, 5);
  EXPECT_TRUE(settings->terminated);
  EXPECT_TRUE(settings->whole);
  EXPECT_FALSE(boards::b_g431b_esc1::kNoSettings.whole);
  for (std::size_t i = 0; i < 16; ++i) {
    EXPECT_EQ(settings->key[i], static_cast<std::byte>(i));
  }
}

TEST(NodePage, LeavesTheTerminationOpenByItsBit) {
  Bytes bytes = page();
  bytes[9] = std::byte{1};
  const auto settings = boards::b_g431b_esc1::decode_node(sealed(bytes));
  ASSERT_TRUE(settings);
  EXPECT_EQ(settings->node, 5);
  EXPECT_FALSE(settings->terminated);
}

TEST(NodePage, IsRefusedWithAnyBitWrong) {
  for (std::size_t bit = 0; bit < 8 * boards::b_g431b_esc1::kNodeBytes; ++bit) {
    Bytes bytes = page();
    bytes[bit / 8] ^= std::byte{1} << static_cast<int>(bit % 8);
    EXPECT_FALSE(boards::b_g431b_esc1::decode_node(bytes)) << bit;
  }
}

TEST(NodePage, IsRefusedWhileErased) {
  Bytes bytes{};
  bytes.fill(std::byte{0xFF});
  EXPECT_FALSE(boards::b_g431b_esc1::decode_node(bytes));
  EXPECT_FALSE(boards::b_g431b_esc1::decode_node(Bytes{}));
}

TEST(NodePage, KnowsItsVersionAndTheRangeOfNodes) {
  for (const auto& [node, accepted] : {std::pair{0, false}, {1, true}, {127, true}, {128, false}}) {
    Bytes bytes = page();
    bytes[8] = static_cast<std::byte>(node);
    EXPECT_EQ(boards::b_g431b_esc1::decode_node(sealed(bytes)).has_value(), accepted) << node;
  }
  Bytes high = page();
  high[9] = std::byte{2};
  EXPECT_FALSE(boards::b_g431b_esc1::decode_node(sealed(high))) << "node 517";
  Bytes other = page();
  other[4] = std::byte{2};
  EXPECT_FALSE(boards::b_g431b_esc1::decode_node(sealed(other))) << "version 2";
}

}  // namespace
