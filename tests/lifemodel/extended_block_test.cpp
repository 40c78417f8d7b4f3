#include "lifemodel/extension/extended_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "tests/lifemodel/support.hpp"

namespace lifemodel {
namespace {

using extension::Effect;
using lifemodel_test::paper_constants;
using lifemodel_test::parameters_of;
using Bytes = std::vector<std::byte>;

Bytes encoded(const ExtendedParameters& parameters) {
  Bytes bytes(kMostExtendedBytes);
  bytes.resize(encode(parameters, bytes).size());
  return bytes;
}

ExtendedParameters with_offset_and_load() {
  ExtendedParameters p{parameters_of(paper_constants()), {}};
  p.extension.current_offset.offset = 838861;  // 0.05 A
  p.extension.add(Effect::current_offset);
  p.extension.friction_load.exponent = 53687091;
  p.extension.friction_load.log2_reference = -5;
  p.extension.add(Effect::friction_load);
  return p;
}

/// The reason for which bytes are refused; empty where they are not.
std::string refusal(const Bytes& bytes) {
  const auto decoded = decode_extended(bytes);
  return decoded ? "" : to_string(decoded.error());
}

/// The same after a change of the section, with a CRC that fits.
std::string refusal_with(Bytes bytes, std::size_t word, std::uint32_t value) {
  ByteWriter(std::span(bytes).subspan(kBlockBytes + 4 * word)).u32(value);
  const auto section = std::span(bytes).subspan(kBlockBytes);
  ByteWriter(section.last(4)).u32(crc32(section.first(section.size() - 4)));
  return refusal(bytes);
}

TEST(ExtendedBlock, WithoutEffectsItIsTheBlockOfToday) {
  const ExtendedParameters p{parameters_of(paper_constants()), {}};
  const ParameterBlock block = encode(p.nominal);
  EXPECT_EQ(encoded(p), Bytes(block.begin(), block.end()));
  const auto decoded = decode_extended(block);
  ASSERT_TRUE(decoded);
  EXPECT_EQ(decoded->extension.effects, 0u);
  EXPECT_EQ(encode(decoded->nominal), block);
}

TEST(ExtendedBlock, ComesBackAsItWas) {
  const ExtendedParameters p = with_offset_and_load();
  const Bytes bytes = encoded(p);
  // Five words of a head, one of the offset, four of the load, the CRC.
  EXPECT_EQ(bytes.size(), kBlockBytes + 4 * 11);
  const auto decoded = decode_extended(bytes);
  ASSERT_TRUE(decoded);
  EXPECT_EQ(decoded->extension.current_offset.offset, 838861);
  EXPECT_EQ(decoded->extension.friction_load.exponent, 53687091);
  EXPECT_EQ(decoded->extension.friction_load.log2_reference, -5);
  EXPECT_EQ(encoded(*decoded), bytes);
}

TEST(ExtendedBlock, WhoReadsNoExtensionsRefusesIt) {
  const Bytes bytes = encoded(with_offset_and_load());
  const auto decoded = decode(bytes);
  ASSERT_FALSE(decoded);
  EXPECT_EQ(decoded.error(), BlockError::wrong_size);
}

TEST(ExtendedBlock, EverySingleBitErrorIsRefused) {
  const Bytes bytes = encoded(with_offset_and_load());
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    Bytes damaged = bytes;
    damaged[bit / 8] ^= static_cast<std::byte>(1u << bit % 8);
    EXPECT_NE(refusal(damaged), "") << bit;
  }
}

TEST(ExtendedBlock, EveryOtherSizeIsRefused) {
  Bytes bytes = encoded(with_offset_and_load());
  bytes.push_back(std::byte{0});
  EXPECT_NE(refusal(bytes), "");
  for (std::size_t size = 0; size < bytes.size() - 1; ++size) {
    const Bytes shorter(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_EQ(refusal(shorter) == "", size == kBlockBytes) << size;
  }
}

TEST(ExtendedBlock, SaysWhatIsWrong) {
  const Bytes bytes = encoded(with_offset_and_load());
  EXPECT_EQ(refusal_with(bytes, 0, 1), "extension damaged: its size, magic or CRC-32 does not fit");
  EXPECT_EQ(refusal_with(bytes, 1, 2),
            "extension of unknown version: this library reads version 1");
  EXPECT_EQ(refusal_with(bytes, 2, 40),
            "extension damaged: its size, magic or CRC-32 does not fit");
  EXPECT_EQ(refusal_with(bytes, 3, 7), "extension of another parameter block");
  EXPECT_EQ(refusal_with(bytes, 4, 0), "extension with an unknown effect");
  EXPECT_EQ(refusal_with(bytes, 4, 1u << 31), "extension with an unknown effect");
  EXPECT_EQ(refusal_with(bytes, 4, 1u << 1),
            "extension damaged: its size, magic or CRC-32 does not fit");
  EXPECT_EQ(refusal_with(bytes, 5, 1u << 30), "extension with a value out of range");
  EXPECT_EQ(refusal_with(bytes, 5, 1u << 20), "");
}

TEST(ExtendedBlock, ACorrectionWhoseKnotsDoNotRiseIsRefused) {
  ExtendedParameters p{parameters_of(paper_constants()), {}};
  p.extension.empirical.knots = 3;
  p.extension.empirical.knot[0] = {-5, 1, -1};
  p.extension.empirical.knot[1] = {7, 2, -2};
  p.extension.empirical.knot[2] = {8, 3, -3};
  p.extension.add(Effect::empirical);
  const Bytes bytes = encoded(p);
  EXPECT_EQ(refusal(bytes), "");
  // Words: five of the head, covariate and count, then three for each knot.
  EXPECT_EQ(refusal_with(bytes, 10, 8), "extension with a value out of range");
  EXPECT_EQ(refusal_with(bytes, 6, 17), "extension with a value out of range");
  EXPECT_EQ(refusal_with(bytes, 5, 4), "extension with a value out of range");
  EXPECT_EQ(refusal_with(bytes, 8, (1u << 29) + 1), "extension with a value out of range");
}

TEST(ExtendedBlock, AnExtensionOfAnotherBlockIsRefused) {
  Bytes bytes = encoded(with_offset_and_load());
  auto constants = paper_constants();
  constants.weibull_shape = 4;
  const ParameterBlock other = encode(parameters_of(constants));
  std::ranges::copy(other, bytes.begin());
  EXPECT_EQ(refusal(bytes), "extension of another parameter block");
}

TEST(ExtendedBlock, ASectionFollowsABlockOfVersionTwo) {
  ExtendedParameters p = with_offset_and_load();
  p.nominal.watch.horizon_s = 60;
  const Bytes bytes = encoded(p);
  EXPECT_EQ(bytes.size(), 128u + 4 * 11);
  const auto decoded = decode_extended(bytes);
  ASSERT_TRUE(decoded);
  EXPECT_EQ(decoded->nominal.watch.horizon_s, 60u);
  EXPECT_EQ(decoded->extension.current_offset.offset, 838861);
  EXPECT_EQ(encoded(*decoded), bytes);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const Bytes shorter(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_EQ(refusal(shorter) == "", size == 128) << size;
  }
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    Bytes damaged = bytes;
    damaged[bit / 8] ^= static_cast<std::byte>(1u << bit % 8);
    EXPECT_NE(refusal(damaged), "") << bit;
  }
}

TEST(ExtendedBlock, OfAnUnknownVersionIsSaidToBeThat) {
  Bytes bytes = encoded(with_offset_and_load());
  bytes[4] = std::byte{3};
  EXPECT_EQ(refusal(bytes), "unknown version: this library reads versions 1 and 2");
  bytes[0] = std::byte{'X'};
  EXPECT_EQ(refusal(bytes), "not a parameter block");
}

TEST(ExtendedBlock, AllEffectsFitIntoTheLargest) {
  ExtendedParameters p = with_offset_and_load();
  p.nominal.watch.horizon_s = 60;
  p.extension.effects = (1u << extension::kEffects) - 1;
  p.extension.bend_angle.poses = 1;
  p.extension.friction_position.waves_a_turn = 1;
  p.extension.friction_velocity.log2_a_speed = 1;
  p.extension.friction_wear.exponent = 1;
  p.extension.torque_ripple.harmonic = 1;
  EXPECT_EQ(encoded(p).size(), kMostExtendedBytes);
  EXPECT_EQ(refusal(encoded(p)), "");
}

}  // namespace
}  // namespace lifemodel
