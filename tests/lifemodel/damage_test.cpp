#include "lifemodel/damage/damage.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "support.hpp"

namespace lifemodel {
namespace {

using pack::to_double;

std::vector<CycleDamage> random_cycles(std::uint32_t seed, int count) {
  std::mt19937 random(seed);
  std::vector<CycleDamage> cycles;
  for (int i = 0; i < count; ++i) {
    cycles.push_back({static_cast<std::uint32_t>(random()) | 0x80000000u,
                      static_cast<std::int32_t>(random() % 105) - 31});
  }
  return cycles;
}

Damage sum_of(const std::vector<CycleDamage>& cycles) {
  Damage sum;
  Flags flags;
  for (const CycleDamage& cycle : cycles) {
    sum.add(cycle, flags);
  }
  EXPECT_TRUE(flags.none());
  return sum;
}

TEST(Damage, SumsAreExactWhateverTheirOrder) {
  auto cycles = random_cycles(3, 20000);
  const Damage forwards = sum_of(cycles);
  std::reverse(cycles.begin(), cycles.end());
  EXPECT_EQ(sum_of(cycles), forwards);
  std::sort(cycles.begin(), cycles.end(),
            [](const auto& a, const auto& b) { return a.position < b.position; });
  EXPECT_EQ(sum_of(cycles), forwards);
}

TEST(Damage, EachCycleAddsItsValue) {
  Flags flags;
  Damage sum;
  sum.add(kWholeLife, flags);
  EXPECT_EQ(to_double(sum), 1);
  sum.add(kWholeLife.half(), flags);
  EXPECT_EQ(to_double(sum), 1.5);
  sum.add({0xffffffffu, -1}, flags);
  EXPECT_EQ(sum.words(), (Damage::Words{0x7fffffffu, 0, 0, 0x180}));
  sum.add({0x80000000u, 1}, flags);
  EXPECT_EQ(sum.words(), (Damage::Words{0x7fffffffu, 1, 0, 0x180}));
}

TEST(Damage, TheSmallestCycleIsTwoStepsAndItsHalfOne) {
  Flags flags;
  Damage sum;
  sum.add(kSmallestCycle, flags);
  EXPECT_EQ(sum.words(), (Damage::Words{2, 0, 0, 0}));
  sum.add(kSmallestCycle.half(), flags);
  EXPECT_EQ(sum.words(), (Damage::Words{3, 0, 0, 0}));
}

TEST(Damage, WhatLiesBelowTheResolutionIsRoundedDown) {
  Flags flags;
  Damage sum;
  sum.add({0xffffffffu, -28}, flags);
  EXPECT_EQ(sum.words(), (Damage::Words{15, 0, 0, 0}));
  sum.add({0xffffffffu, -29}, flags);
  EXPECT_EQ(sum.words(), (Damage::Words{22, 0, 0, 0}));
}

TEST(Damage, CarriesRunThroughAllWords) {
  Flags flags;
  Damage sum = Damage::from_words({0xffffffffu, 0xffffffffu, 0xffffffffu, 0});
  sum.add({0x80000000u, -31}, flags);
  EXPECT_EQ(sum.words(), (Damage::Words{0, 0, 0, 1}));
}

TEST(Damage, SaturatesAfterSixteenMillionLives) {
  Flags flags;
  Damage sum = Damage::from_words({0, 0, 0, 0xffffff00u});
  sum.add(kWholeLife.half(), flags);
  EXPECT_TRUE(flags.none());
  sum.add(kWholeLife, flags);
  EXPECT_TRUE(flags.has(Flag::saturated));
  EXPECT_EQ(sum.words(), (Damage::Words{~0u, ~0u, ~0u, ~0u}));
  sum.add(kWholeLife, flags);
  EXPECT_EQ(sum.words(), (Damage::Words{~0u, ~0u, ~0u, ~0u}));
}

TEST(Damage, AddingSumsSaturatesToo) {
  Flags flags;
  Damage sum = Damage::from_words({5, 0, 0, 0x80000000u});
  sum.add(Damage::from_words({7, 1, 2, 0x7fffffffu}), flags);
  EXPECT_EQ(sum.words(), (Damage::Words{12, 1, 2, 0xffffffffu}));
  EXPECT_TRUE(flags.none());
  sum.add(Damage::from_words({0, 0, 0, 1}), flags);
  EXPECT_TRUE(flags.has(Flag::saturated));
}

TEST(Damage, MultipliedCarriesThroughAllWordsAndSaturates) {
  const Damage d = Damage::from_words({0x80000001u, 0xffffffffu, 0x00000007u, 0u});
  EXPECT_EQ(d.multiplied(0), Damage{});
  EXPECT_EQ(d.multiplied(1), d);
  // 0x7'ffffffff'80000001 * 6 = 0x2f'fffffffd'00000006
  EXPECT_EQ(d.multiplied(6), Damage::from_words({6u, 0xfffffffdu, 0x0000002fu, 0u}));
  EXPECT_EQ(Damage::from_words({0, 0, 0, 1u << 31}).multiplied(2), Damage::highest());
}

TEST(Damage, ADifferenceBorrowsThroughAllWords) {
  const Damage larger = Damage::from_words({0, 0, 0, 1});
  const Damage smaller = Damage::from_words({1, 0, 0, 0});
  constexpr std::uint32_t kAll = 0xffffffffu;
  EXPECT_EQ(Damage::difference(larger, smaller), Damage::from_words({kAll, kAll, kAll, 0}));
  EXPECT_EQ(Damage::difference(larger, larger), Damage{});
}

TEST(Damage, PartsPerBillion) {
  Flags flags;
  Damage sum;
  EXPECT_EQ(sum.parts_per_billion(), 0u);
  sum.add(kWholeLife, flags);
  EXPECT_EQ(sum.parts_per_billion(), 1'000'000'000u);
  sum.add(kWholeLife.half().half(), flags);
  EXPECT_EQ(sum.parts_per_billion(), 1'250'000'000u);
  for (int i = 0; i < 4; ++i) {
    sum.add(kWholeLife, flags);
  }
  EXPECT_EQ(sum.parts_per_billion(), 4294967295u);
}

}  // namespace
}  // namespace lifemodel
