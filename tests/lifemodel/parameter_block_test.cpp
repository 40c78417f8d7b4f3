#include "lifemodel/block/parameter_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>

#include "support.hpp"

namespace lifemodel {
namespace {

using lifemodel_test::paper_constants;
using lifemodel_test::parameters_of;

TEST(Crc32, CheckValueOfThePolynomial) {
  // CRC-32/ISO-HDLC of "123456789".
  constexpr std::string_view digits = "123456789";
  std::array<std::byte, 9> bytes{};
  std::transform(digits.begin(), digits.end(), bytes.begin(),
                 [](char c) { return static_cast<std::byte>(c); });
  EXPECT_EQ(crc32(bytes), 0xCBF43926u);
}

TEST(ParameterBlock, ComesBackAsItWas) {
  const Parameters p = parameters_of(paper_constants());
  const ParameterBlock block = encode(p);
  const auto back = decode(block);
  ASSERT_TRUE(back) << to_string(back.error());
  EXPECT_EQ(encode(*back), block);
  EXPECT_EQ(back->model_digest, 0x12345678u);
  EXPECT_EQ(back->sample_period_us, 1000u);
  EXPECT_TRUE(back->has_drive());
}

TEST(ParameterBlock, IsLittleEndianWithTheCrcLast) {
  const ParameterBlock block = encode(parameters_of(paper_constants()));
  EXPECT_EQ(block[0], std::byte{'T'});
  EXPECT_EQ(block[1], std::byte{'L'});
  EXPECT_EQ(block[2], std::byte{'P'});
  EXPECT_EQ(block[3], std::byte{'B'});
  EXPECT_EQ(block[8], std::byte{0x78});
  EXPECT_EQ(ByteReader(std::span(block).last(4)).u32(), crc32(std::span(block).first(80)));
}

TEST(ParameterBlock, EverySingleBitErrorIsRefused) {
  const ParameterBlock block = encode(parameters_of(paper_constants()));
  for (std::size_t bit = 0; bit < 8 * block.size(); ++bit) {
    ParameterBlock damaged = block;
    damaged[bit / 8] ^= std::byte{1} << (bit % 8);
    EXPECT_FALSE(decode(damaged)) << "bit " << bit;
  }
}

TEST(ParameterBlock, OtherSizesAreRefused) {
  const ParameterBlock block = encode(parameters_of(paper_constants()));
  for (std::size_t size = 0; size < block.size(); ++size) {
    const auto result = decode(std::span(block).first(size));
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error(), BlockError::wrong_size);
  }
  std::array<std::byte, kBlockBytes + 1> longer{};
  std::copy(block.begin(), block.end(), longer.begin());
  EXPECT_EQ(decode(longer).error(), BlockError::wrong_size);
}

BlockError error_of(const std::function<void(Parameters&)>& change) {
  Parameters p = parameters_of(paper_constants());
  change(p);
  const auto result = decode(encode(p));
  return result ? BlockError::none : result.error();
}

TEST(ParameterBlock, WhatIsOutOfRangeIsRefusedWithTheReason) {
  EXPECT_EQ(error_of([](Parameters&) {}), BlockError::none);
  EXPECT_EQ(error_of([](Parameters& p) { p.ultimate_mN = 999; }), BlockError::ultimate_tension);
  EXPECT_EQ(error_of([](Parameters& p) { p.ultimate_mN += 1; }), BlockError::ultimate_tension);
  EXPECT_EQ(error_of([](Parameters& p) { ++p.scale.steps_per_mN.shift; }),
            BlockError::ultimate_tension);
  EXPECT_EQ(error_of([](Parameters& p) { p.hysteresis = TensionRange{}; }), BlockError::hysteresis);
  EXPECT_EQ(error_of([](Parameters& p) { p.hysteresis = TensionRange::from_raw(1u << 29); }),
            BlockError::hysteresis);
  EXPECT_EQ(error_of([](Parameters& p) { p.law.exponent = IplExponent::from_raw(13u << 27); }),
            BlockError::ipl_exponent);
  EXPECT_EQ(error_of([](Parameters& p) { p.law.log2_damage_at_ultimate = 501 << 21; }),
            BlockError::ipl_scale);
  EXPECT_EQ(error_of([](Parameters& p) { p.life.shape = WeibullShape::from_raw(1u << 23); }),
            BlockError::weibull_shape);
  EXPECT_EQ(error_of([](Parameters& p) { p.life.b10 = p.life.b90; }), BlockError::life_points);
  EXPECT_EQ(error_of([](Parameters& p) { p.life.mean.raw = 0; }), BlockError::life_points);
  EXPECT_EQ(
      error_of([](Parameters& p) { p.capstan.friction = FrictionExponent::from_raw(1549082006u); }),
      BlockError::friction_coefficient);
  EXPECT_EQ(error_of([](Parameters& p) { p.bend = Angle::from_raw(-1); }), BlockError::bend_angle);
  EXPECT_EQ(error_of([](Parameters& p) { p.drive.gain.shift = 0; }), BlockError::drive);
  EXPECT_EQ(error_of([](Parameters& p) { p.drive.gain.mantissa = -1; }), BlockError::drive);
  EXPECT_EQ(error_of([](Parameters& p) { p.sample_period_us = 0; }), BlockError::sample_period);
}

TEST(ParameterBlock, AnUltimateTensionFinerThanItsWordIsAccepted) {
  for (const double ultimate_N :
       {1.0004999, 5.0005, 44.4822, 177.92886, 99'999.99951, 999'999.99951}) {
    auto constants = paper_constants();
    constants.ultimate_tension_N = ultimate_N;
    EXPECT_TRUE(decode(encode(parameters_of(constants)))) << ultimate_N;
  }
}

// In whole mN it would be 4e-4 and 4e-8 off.
TEST(Pack, TheUltimateTensionOfParametersIsThatOfTheirScale) {
  for (const double ultimate_N : {1.0, 1.0004, 177.4, 9'999.9996, 1e6}) {
    auto constants = paper_constants();
    constants.ultimate_tension_N = ultimate_N;
    EXPECT_NEAR(pack::ultimate_tension_N(parameters_of(constants)), ultimate_N, 1e-9 * ultimate_N);
  }
  EXPECT_EQ(pack::ultimate_tension_N(parameters_of(paper_constants())), 177.4);
}

TEST(ParameterBlock, MagicAndVersionComeFirst) {
  ParameterBlock block = encode(parameters_of(paper_constants()));
  block[0] = std::byte{'X'};
  EXPECT_EQ(decode(block).error(), BlockError::not_a_block);
  block = encode(parameters_of(paper_constants()));
  block[4] = std::byte{3};
  EXPECT_EQ(decode(block).error(), BlockError::unknown_version);
  block[4] = std::byte{2};
  EXPECT_EQ(decode(block).error(), BlockError::wrong_size);
  block = encode(parameters_of(paper_constants()));
  block[40] ^= std::byte{1};
  EXPECT_EQ(decode(block).error(), BlockError::damaged);
}

// Intervals and limits with numbers that fixed point holds exactly.
pack::Constants watched_constants() {
  auto constants = paper_constants();
  constants.ultimate_tension_N = 128;
  constants.ipl_scale = 1 << 20;
  constants.ipl_exponent = 2;
  constants.intervals = {.ipl_exponent = {1.5, 2.25},
                         .weibull_shape = {2, 32},
                         .pivot_tension_N = 32,
                         .life_at_pivot = {512, 2048}};
  constants.watch = {.minimum_tension_N = 1,
                     .broken_tension_N = 4,
                     .broken_travel_mm = 20,
                     .slack_travel_mm = 2.5,
                     .horizon_h = 0.25,
                     .advice_risk = 0.1,
                     .advice_until_h = 2};
  return constants;
}

// By hand: what follows the 80 bytes of version 1 without its CRC. Life 2^9 .. 2^11 is 2^10 *
// 2^+-1; the exponent 1.875 +- 0.375; the shape 2^3 +- 2 in log2; the damage at 32 N 2^10 / 2^20.
// Tensions 1/128 and 4/128 of 2^29; 0.1 is 107374182.4 / 2^30.
TEST(ParameterBlock, OfVersionTwoByItsWords) {
  const ParameterBlock block = encode(parameters_of(watched_constants()));
  ASSERT_EQ(block.size(), 128u);
  ByteReader in(block);
  EXPECT_EQ(in.u32(), 0x42504c54u);
  EXPECT_EQ(in.u32(), 2u);
  auto more = ByteReader(std::span(block).subspan(80));
  EXPECT_EQ(more.u32(), 1u << 21);
  EXPECT_EQ(more.u32(), 3u << 24);
  EXPECT_EQ(more.u32(), 2u << 21);
  EXPECT_EQ(more.i32(), -10 * (1 << 21));
  EXPECT_EQ(more.u32(), 1u << 22);
  EXPECT_EQ(more.u32(), 1u << 24);
  EXPECT_EQ(more.u32(), 20'000u);
  EXPECT_EQ(more.u32(), 2'500u);
  EXPECT_EQ(more.u32(), 900u);
  EXPECT_EQ(more.u32(), 107'374'182u);
  EXPECT_EQ(more.u32(), 7'200u);
  EXPECT_EQ(more.u32(), crc32(std::span(block).first(124)));
}

TEST(ParameterBlock, OfVersionTwoComesBackAsItWas) {
  const Parameters p = parameters_of(watched_constants());
  const ParameterBlock block = encode(p);
  const auto back = decode(block);
  ASSERT_TRUE(back) << to_string(back.error());
  EXPECT_EQ(back->uncertainty, p.uncertainty);
  EXPECT_EQ(back->watch, p.watch);
  EXPECT_EQ(encode(*back), block);
  for (std::size_t bit = 0; bit < 8 * block.size(); ++bit) {
    ParameterBlock damaged = block;
    damaged[bit / 8] ^= std::byte{1} << (bit % 8);
    EXPECT_FALSE(decode(damaged)) << "bit " << bit;
  }
  for (std::size_t size = 0; size < block.size(); ++size) {
    EXPECT_EQ(decode(std::span(block).first(size)).error(), BlockError::wrong_size) << size;
  }
}

// The block of the paper's model as it was before there was a version 2.
TEST(ParameterBlock, OfVersionOneIsWrittenAndReadAsEver) {
  const ParameterBlock block = encode(parameters_of(paper_constants()));
  EXPECT_EQ(block.size(), 84u);
  EXPECT_EQ(ByteReader(std::span(block).last(4)).u32(), 0xb3171fb4u);
  const auto read = decode(block);
  ASSERT_TRUE(read);
  EXPECT_FALSE(read->uncertainty.known());
  EXPECT_EQ(read->watch, WatchLimits{});
  EXPECT_EQ(read->watch.horizon(), 28'800u);
}

TEST(ParameterBlock, EitherOfTheTwoMakesVersionTwo) {
  auto constants = paper_constants();
  constants.watch.horizon_h = 8;
  EXPECT_EQ(encode(parameters_of(constants)).size(), 128u);
  constants = paper_constants();
  constants.intervals = watched_constants().intervals;
  EXPECT_EQ(encode(parameters_of(constants)).size(), 128u);
}

TEST(ParameterBlock, OfVersionTwoOutOfRangeIsRefusedWithTheReason) {
  const auto refused = [](const std::function<void(Parameters&)>& change) {
    Parameters p = parameters_of(watched_constants());
    change(p);
    const auto read = decode(encode(p));
    return read ? BlockError::none : read.error();
  };
  EXPECT_EQ(refused([](Parameters&) {}), BlockError::none);
  EXPECT_EQ(refused([](Parameters& p) { p.watch = {}; }), BlockError::none);
  EXPECT_EQ(refused([](Parameters& p) { p.uncertainty.log2_life = (64u << 21) + 1; }),
            BlockError::uncertainty);
  EXPECT_EQ(refused([](Parameters& p) { p.uncertainty.exponent = (12u << 27) + 1; }),
            BlockError::uncertainty);
  EXPECT_EQ(refused([](Parameters& p) { p.uncertainty.log2_shape = (8u << 21) + 1; }),
            BlockError::uncertainty);
  EXPECT_EQ(refused([](Parameters& p) { p.uncertainty.log2_damage_at_pivot = -(501 << 21); }),
            BlockError::uncertainty);
  EXPECT_EQ(refused([](Parameters& p) { p.watch.minimum = kUltimate; }), BlockError::watch_limits);
  EXPECT_EQ(refused([](Parameters& p) { p.watch.minimum = Tension::from_raw(-1); }),
            BlockError::watch_limits);
  EXPECT_EQ(refused([](Parameters& p) { p.watch.broken = kUltimate; }), BlockError::watch_limits);
  EXPECT_EQ(refused([](Parameters& p) { p.watch.broken = {}; }), BlockError::watch_limits);
  EXPECT_EQ(refused([](Parameters& p) { p.watch.broken_travel_um = 0; }), BlockError::watch_limits);
  EXPECT_EQ(refused([](Parameters& p) { p.watch.minimum = {}; }), BlockError::watch_limits);
  EXPECT_EQ(refused([](Parameters& p) { p.watch.advice_risk = {}; }), BlockError::watch_limits);
  EXPECT_EQ(refused([](Parameters& p) { p.watch.advice_risk = Ratio::highest(); }),
            BlockError::watch_limits);
  EXPECT_EQ(refused([](Parameters& p) { p.watch.advice_until_s = 0; }), BlockError::watch_limits);
}

BlockError packing_error(const std::function<void(pack::Constants&)>& change) {
  auto constants = paper_constants();
  change(constants);
  const auto result = pack::parameters(constants);
  return result ? BlockError::none : result.error();
}

TEST(Pack, WhatIsOutOfRangeIsRefusedWithTheReason) {
  using pack::Constants;
  const double nan = std::nan("");
  EXPECT_EQ(packing_error([](Constants&) {}), BlockError::none);
  for (const double bad : {0.9, 1'000'001.0, nan}) {
    EXPECT_EQ(packing_error([&](Constants& c) { c.ultimate_tension_N = bad; }),
              BlockError::ultimate_tension);
  }
  for (const double bad : {-0.1, 178.0, nan}) {
    EXPECT_EQ(packing_error([&](Constants& c) { c.hysteresis_N = bad; }), BlockError::hysteresis);
  }
  for (const double bad : {0.99, 12.01, nan}) {
    EXPECT_EQ(packing_error([&](Constants& c) { c.ipl_exponent = bad; }), BlockError::ipl_exponent);
  }
  for (const double bad : {0.0, -1.0, 1e-300, nan, 1e300 * 1e10}) {
    EXPECT_EQ(packing_error([&](Constants& c) { c.ipl_scale = bad; }), BlockError::ipl_scale);
  }
  for (const double bad : {0.49, 50.1, nan}) {
    EXPECT_EQ(packing_error([&](Constants& c) { c.weibull_shape = bad; }),
              BlockError::weibull_shape);
  }
  EXPECT_EQ(packing_error([](Constants& c) { c.friction_coefficient = 1.01; }),
            BlockError::friction_coefficient);
  EXPECT_EQ(packing_error([](Constants& c) { c.bend_angle_rad = 31.5; }), BlockError::bend_angle);
  EXPECT_EQ(packing_error([](Constants& c) { c.sample_period_s = 0; }), BlockError::sample_period);
  EXPECT_EQ(packing_error([](Constants& c) { c.tension_per_current_N_A = 0; }), BlockError::drive);
  EXPECT_EQ(packing_error([](Constants& c) { c.current_offset_A = 200; }), BlockError::drive);
}

TEST(Pack, WidestIntervalsStayAsWideAsABlockHolds) {
  auto constants = watched_constants();
  constants.intervals->ipl_exponent = {1e-9, 1e300};
  constants.intervals->weibull_shape = {1e-300, 1e300};
  constants.intervals->life_at_pivot = {1e-300, 1e300};
  const Parameters p = parameters_of(constants);
  EXPECT_EQ(p.uncertainty.log2_life, 64u << 21);
  EXPECT_EQ(p.uncertainty.exponent, 12u << 27);
  EXPECT_EQ(p.uncertainty.log2_shape, 8u << 21);
  EXPECT_TRUE(decode(encode(p)));
}

TEST(Pack, WatchLimitsOutOfRangeAreRefusedWithTheReason) {
  const auto refused = [](const std::function<void(pack::Constants&)>& change) {
    auto constants = watched_constants();
    change(constants);
    const auto packed = pack::parameters(constants);
    return packed ? BlockError::none : packed.error();
  };
  using pack::Constants;
  const double nan = std::nan("");
  EXPECT_EQ(refused([](Constants&) {}), BlockError::none);
  for (const double bad : {128.0, 1e6, nan}) {
    EXPECT_EQ(refused([&](Constants& c) { c.watch.minimum_tension_N = bad; }),
              BlockError::watch_limits);
  }
  for (const double bad : {1.0, nan}) {
    EXPECT_EQ(refused([&](Constants& c) { c.watch.advice_risk = bad; }), BlockError::watch_limits);
  }
  EXPECT_EQ(refused([](Constants& c) { c.watch.advice_until_h = 0; }), BlockError::watch_limits);
  EXPECT_EQ(refused([](Constants& c) { c.watch.broken_travel_mm = 0; }), BlockError::watch_limits);
  for (const double bad : {0.0, nan}) {
    EXPECT_EQ(refused([&](Constants& c) { c.intervals->pivot_tension_N = bad; }),
              BlockError::uncertainty);
  }
}

// A tenth of a micrometre is not no travel, which would be off.
TEST(Pack, WhatIsNotOffIsNotRoundedToOff) {
  auto constants = watched_constants();
  constants.watch = {.minimum_tension_N = 1e-9,
                     .broken_tension_N = 1e-9,
                     .broken_travel_mm = 1e-4,
                     .slack_travel_mm = 1e-4,
                     .horizon_h = 1e-5,
                     .advice_risk = 1e-12,
                     .advice_until_h = 1e-6};
  const WatchLimits limits = parameters_of(constants).watch;
  EXPECT_EQ(limits.minimum.raw(), 1);
  EXPECT_EQ(limits.broken.raw(), 1);
  EXPECT_EQ(limits.broken_travel_um, 1u);
  EXPECT_EQ(limits.slack_travel_um, 1u);
  EXPECT_EQ(limits.horizon_s, 1u);
  EXPECT_EQ(limits.advice_risk.raw(), 1u);
  EXPECT_EQ(limits.advice_until_s, 1u);
}

TEST(Pack, EveryModelWithinTheRangesIsAccepted) {
  for (const double ultimate_N : {1.0, 177.4, 1'000'000.0}) {
    for (const double exponent : {1.0, 1.38, 12.0}) {
      for (const double shape : {0.5, 5.94, 50.0}) {
        auto constants = paper_constants();
        constants.ultimate_tension_N = ultimate_N;
        constants.ipl_exponent = exponent;
        constants.weibull_shape = shape;
        constants.friction_coefficient = 1;
        constants.bend_angle_rad = 10 * M_PI;
        const auto p = pack::parameters(constants);
        ASSERT_TRUE(p) << to_string(p.error());
        EXPECT_TRUE(decode(encode(*p)));
      }
    }
  }
}

}  // namespace
}  // namespace lifemodel
