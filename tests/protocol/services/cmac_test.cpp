#include "firmware/protocol/authority/cmac.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/protocol/services/bytes.hpp"

namespace protocol::authority {
namespace {

using protocol::testing::Bytes;
using protocol::testing::hex;
using protocol::testing::hex_array;

const Key kRfcKey = hex_array<Key>("2b7e151628aed2a6abf7158809cf4f3c");
constexpr std::string_view kRfcMessage =
    "6bc1bee22e409f96e93d7e117393172a ae2d8a571e03ac9c9eb76fac45af8e51"
    "30c81c46a35ce411e5fbc1191a0a52ef f69f2445df4f9b17ad2b417be66c3710";

Block code(const Key& key, std::span<const std::byte> message) {
  Cmac cmac(key);
  cmac.add(message);
  return cmac.finish();
}

// RFC 4493, section 4.
TEST(Cmac, Rfc4493Subkeys) {
  const Block zero = Aes(kRfcKey).encrypt(Block{});
  EXPECT_EQ(zero, hex_array<Block>("7df76b0c1ab899b33e42f047b91b546f"));
  const Block first = doubled(zero);
  EXPECT_EQ(first, hex_array<Block>("fbeed618357133667c85e08f7236a8de"));
  EXPECT_EQ(doubled(first), hex_array<Block>("f7ddac306ae266ccf90bc11ee46d513b"));
}

TEST(Cmac, Rfc4493Examples) {
  const Bytes message = hex(kRfcMessage);
  const auto first = [&](std::size_t size) { return std::span(message).first(size); };
  EXPECT_EQ(code(kRfcKey, first(0)), hex_array<Block>("bb1d6929e95937287fa37d129b756746"));
  EXPECT_EQ(code(kRfcKey, first(16)), hex_array<Block>("070a16b46b4d4144f79bdd9dd04a287c"));
  EXPECT_EQ(code(kRfcKey, first(40)), hex_array<Block>("dfa66747de9ae63030ca32611497c827"));
  EXPECT_EQ(code(kRfcKey, first(64)), hex_array<Block>("51f0bebf7e3b9d92fc49741779363cfe"));
}

RC_GTEST_PROP(Cmac, PiecesMakeNoDifference, (const std::vector<std::uint8_t>& values)) {
  Bytes message;
  for (const std::uint8_t value : values) {
    message.push_back(std::byte{value});
  }
  const auto cut = *rc::gen::inRange<std::size_t>(0, message.size() + 1);
  Cmac cmac(kRfcKey);
  cmac.add(std::span(message).first(cut));
  cmac.add(std::span(message).subspan(cut));
  RC_ASSERT(cmac.finish() == code(kRfcKey, message));
}

TEST(Equal, TellsEveryBitAndTheLength) {
  const Bytes a = hex("0011223344556677");
  EXPECT_TRUE(equal(a, a));
  EXPECT_TRUE(equal({}, {}));
  EXPECT_FALSE(equal(a, std::span(a).first(7)));
  EXPECT_FALSE(equal(std::span(a).first(7), a));
  for (std::size_t bit = 0; bit < 64; ++bit) {
    Bytes b = a;
    b[bit / 8] ^= std::byte{1} << (bit % 8);
    EXPECT_FALSE(equal(a, b)) << bit;
  }
}

}  // namespace
}  // namespace protocol::authority
