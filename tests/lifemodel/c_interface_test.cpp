#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "c_interface_in_c.h"
#include "lifemodel/extension/extended_block.hpp"
#include "support.hpp"

namespace lifemodel {
namespace {

TEST(CInterface, CountsAsTheEstimatorDoes) {
  const Parameters p = lifemodel_test::parameters_of(lifemodel_test::paper_constants());
  const ParameterBlock block = encode(p);
  const auto signal = lifemodel_test::white_noise(12, 5000, 0, 120);
  std::vector<std::int32_t> raw;
  for (const Tension t : signal) {
    raw.push_back(t.raw());
  }
  lm_reading in_c{};
  ASSERT_EQ(count_in_c(block.data(), block.size(), raw.data(), raw.size(), &in_c), nullptr);

  Estimator<1> estimator({p});
  estimator.replay(0, signal);
  const Reading r = estimator.reading(0);
  EXPECT_EQ(std::memcmp(in_c.total.words, r.total.words().data(), 16), 0);
  EXPECT_EQ(std::memcmp(in_c.closed.words, r.closed.words().data(), 16), 0);
  EXPECT_EQ(in_c.closed_cycles, r.closed_cycles.raw());
  EXPECT_EQ(in_c.open_half_cycles, r.open_half_cycles.raw());
  EXPECT_EQ(in_c.flags, r.flags.bits());
  EXPECT_EQ(in_c.survival_q30, p.life.survival(r.total).raw());
  EXPECT_EQ(in_c.damage_ppb, r.total.parts_per_billion());
}

TEST(CInterface, RefusesADamagedBlockWithTheReason) {
  ParameterBlock block = encode(lifemodel_test::parameters_of(lifemodel_test::paper_constants()));
  block[20] ^= std::byte{4};
  lm_estimator estimator;
  EXPECT_STREQ(lm_init(&estimator, block.data(), block.size()), "damaged: the CRC-32 does not fit");
}

TEST(CInterface, TensionHeldAtTheUltimateOneIsAnOverload) {
  const auto block = encode(lifemodel_test::parameters_of(lifemodel_test::paper_constants()));
  lm_estimator held;
  ASSERT_EQ(lm_init(&held, block.data(), block.size()), nullptr);
  for (int i = 0; i < 100; ++i) {
    lm_push_tension_mN(&held, 180'000);
    EXPECT_FALSE(lm_settle(&held));
  }
  lm_reading reading{};
  lm_read(&held, &reading);
  EXPECT_EQ(reading.flags, std::uint32_t{LM_OVERLOAD});
  EXPECT_EQ(reading.damage_ppb, 500'000'000u);
  EXPECT_EQ(reading.open_half_cycles, 1u);
  EXPECT_NEAR(reading.survival_q30, std::ldexp(0.98384, 30), std::ldexp(1e-5, 30));
}

TEST(CInterface, RefusesABlockWithAnExtension) {
  ExtendedParameters extended{lifemodel_test::parameters_of(lifemodel_test::paper_constants()), {}};
  extended.extension.effects = 1U << 1;  // the current offset
  std::array<std::byte, kMostExtendedBytes> block{};
  const auto whole = encode(extended, block);
  ASSERT_TRUE(decode_extended(whole));
  lm_estimator estimator;
  const char* const why =
      "it has an extension, which the C interface does not evaluate: pack a model without";
  EXPECT_STREQ(lm_init(&estimator, whole.data(), whole.size()), why);
  EXPECT_STREQ(lm_init(&estimator, whole.data(), kBlockBytes + 4), why);
  EXPECT_STREQ(lm_init(&estimator, whole.data(), kBlockBytes + 3),
               "wrong size: a parameter block of version 1 has 84 bytes, of version 2 128");
  EXPECT_STREQ(lm_init(&estimator, whole.data(), kBlockBytes - 1),
               "wrong size: a parameter block of version 1 has 84 bytes, of version 2 128");
  EXPECT_EQ(lm_init(&estimator, whole.data(), kBlockBytes), nullptr);
}

TEST(CInterface, TakesABlockOfVersionTwoAndNotItsExtension) {
  auto constants = lifemodel_test::paper_constants();
  constants.watch.minimum_tension_N = 2;
  ExtendedParameters extended{lifemodel_test::parameters_of(constants), {}};
  extended.extension.effects = 1U << 1;
  std::array<std::byte, kMostExtendedBytes> block{};
  const auto whole = encode(extended, block);
  ASSERT_EQ(whole.size(), 128u + 28u);
  lm_estimator estimator;
  EXPECT_EQ(lm_init(&estimator, whole.data(), LM_PARAMETER_BLOCK_BYTES), nullptr);
  EXPECT_STREQ(
      lm_init(&estimator, whole.data(), LM_PARAMETER_BLOCK_BYTES + 4),
      "it has an extension, which the C interface does not evaluate: pack a model without");
  EXPECT_NE(lm_init(&estimator, whole.data(), 84), nullptr);
}

TEST(CInterface, CurrentAndMillinewtons) {
  const auto block = encode(lifemodel_test::parameters_of(lifemodel_test::paper_constants()));
  lm_estimator by_current;
  lm_estimator by_tension;
  ASSERT_EQ(lm_init(&by_current, block.data(), block.size()), nullptr);
  ASSERT_EQ(lm_init(&by_tension, block.data(), block.size()), nullptr);
  for (int i = 0; i < 11; ++i) {
    // 20.592 N/A: 1 A and 4 A are 20.592 N and 82.368 N.
    lm_push_current_mA(&by_current, i % 2 == 0 ? 1000 : 4000);
    lm_push_tension_mN(&by_tension, i % 2 == 0 ? 20592 : 82368);
  }
  lm_push_missing(&by_current);
  lm_reading current{};
  lm_reading tension{};
  lm_read(&by_current, &current);
  lm_read(&by_tension, &tension);
  EXPECT_EQ(current.closed_cycles, 4u);
  EXPECT_EQ(current.flags, std::uint32_t{LM_GAP});
  EXPECT_NEAR(current.damage_ppb, tension.damage_ppb, 5);
  // 10 half cycles of T_a 30.888, T_m 51.48: T_eff 33.727, 1.53e5 / 33.727^1.38 = 1191.3
  EXPECT_NEAR(tension.damage_ppb, 5 / 1191.3 * 1e9, 2e3);
  const lm_damage nothing{};
  // D at B10 is 0.684648: 0.684648 / (5 / 1191.3) = 163.1
  EXPECT_EQ(lm_repeats_to_b10(&by_tension, &nothing, &tension.total), 163u);
}

// 0.684648 is B10 of the paper's shape, 0.0847407 the damage from there to 10 % risk; in steps of
// 0.02 that is 4.2 of them. See conditional_test.cpp.
TEST(CInterface, GivenSurvival) {
  const auto block = encode(lifemodel_test::parameters_of(lifemodel_test::paper_constants()));
  lm_estimator estimator;
  ASSERT_EQ(lm_init(&estimator, block.data(), block.size()), nullptr);
  const auto in_c = [](double value) {
    lm_damage damage{};
    const Damage words = lifemodel_test::damage_of(value);
    std::copy(words.words().begin(), words.words().end(), damage.words);
    return damage;
  };
  const lm_damage used = in_c(0.684648495);
  const lm_damage each = in_c(0.02);
  const std::uint32_t tenth = (1u << 30) / 10;
  lm_damage further{};
  lm_further_damage(&estimator, &used, tenth, &further);
  EXPECT_NEAR(std::ldexp(further.words[3], -8) + std::ldexp(further.words[2], -40), 0.0847407,
              3e-7);
  EXPECT_NEAR(std::ldexp(lm_break_risk_q30(&estimator, &used, &further), -30), 0.1, 1e-6);
  EXPECT_EQ(lm_repeats_to_risk(&estimator, &used, &each, tenth), 4u);
  EXPECT_EQ(lm_repeats_to_risk(&estimator, &used, &each, 0), 0u);
  EXPECT_NEAR(lm_repeats_to_risk(&estimator, &used, &each, 0xffffffffu), 0x1p24 / 0.02, 400);
  EXPECT_EQ(lm_repeats_to_b10(&estimator, &used, &each), 0u);
}

}  // namespace
}  // namespace lifemodel
