#include "firmware/protocol/authority/aes.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/protocol/services/bytes.hpp"

namespace protocol::authority {
namespace {

using protocol::testing::hex_array;

Block encrypted(std::string_view key, std::string_view plain) {
  return Aes(hex_array<Key>(key)).encrypt(hex_array<Block>(plain));
}

// FIPS 197, 4.2: {57} {83} = {c1}; 4.2.1: {57} times 02, 04, 08, 10 and 13.
TEST(Bytes4, ProductsOfTheStandard) {
  EXPECT_EQ(bytes4::product(0x57, 0x83), 0xc1u);
  EXPECT_EQ(bytes4::doubled(0x57), 0xaeu);
  EXPECT_EQ(bytes4::product(0x57, 0x04), 0x47u);
  EXPECT_EQ(bytes4::product(0x57, 0x08), 0x8eu);
  EXPECT_EQ(bytes4::product(0x57, 0x10), 0x07u);
  EXPECT_EQ(bytes4::product(0x57, 0x13), 0xfeu);
}

TEST(Bytes4, FourAtATimeDoNotTouchEachOther) {
  EXPECT_EQ(bytes4::product(0x57'00'57'01, 0x83'ff'13'01), 0xc1'00'fe'01u);
  EXPECT_EQ(bytes4::doubled(0x80'7f'57'00), 0x1b'fe'ae'00u);
}

// FIPS 197, figure 7 (the corners, its example {53} and some between).
TEST(Bytes4, SubstitutionBox) {
  EXPECT_EQ(bytes4::substituted(0x00'01'0f'10), 0x63'7c'76'cau);
  EXPECT_EQ(bytes4::substituted(0x53'9a'f0'ff), 0xed'b8'8c'16u);
}

TEST(Bytes4, SubstitutionIsOneToOneInEachPlace) {
  for (int shift = 0; shift < 32; shift += 8) {
    std::set<std::uint32_t> seen;
    for (std::uint32_t value = 0; value < 256; ++value) {
      seen.insert(bytes4::substituted(value << shift) >> shift & 0xff);
    }
    EXPECT_EQ(seen.size(), 256u);
  }
}

TEST(Aes, Fips197AppendixB) {
  EXPECT_EQ(encrypted("2b7e151628aed2a6abf7158809cf4f3c", "3243f6a8885a308d313198a2e0370734"),
            hex_array<Block>("3925841d02dc09fbdc118597196a0b32"));
}

TEST(Aes, Fips197AppendixC1) {
  EXPECT_EQ(encrypted("000102030405060708090a0b0c0d0e0f", "00112233445566778899aabbccddeeff"),
            hex_array<Block>("69c4e0d86a7b0430d8cdb78070b4c55a"));
}

// NIST AES Algorithm Validation Suite, appendices B, D and E: first vectors.
TEST(Aes, KnownAnswersOfTheValidationSuite) {
  constexpr std::string_view kZero = "00000000000000000000000000000000";
  constexpr std::string_view kTop = "80000000000000000000000000000000";
  EXPECT_EQ(encrypted(kZero, "f34481ec3cc627bacd5dc3fb08f273e6"),
            hex_array<Block>("0336763e966d92595a567cc9ce537f5e"));
  EXPECT_EQ(encrypted(kZero, kTop), hex_array<Block>("3ad78e726c1ec02b7ebfe92b23d9ec34"));
  EXPECT_EQ(encrypted(kTop, kZero), hex_array<Block>("0edd33d3c621e546455bd8ba1418bec8"));
}

}  // namespace
}  // namespace protocol::authority
