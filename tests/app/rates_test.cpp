#include "firmware/app/rates.hpp"

#include <gtest/gtest.h>

#include "wire.hpp"

namespace app {
namespace {

TEST(Rates, NothingIsKnownBeforeAMinuteHasPassed) {
  Rates rates;
  rates.start({});
  for (std::uint32_t s = 1; s < 60; ++s) {
    rates.take(hal::seconds(s), lives(s, 20), s);
    EXPECT_FALSE(rates.known()) << s;
  }
  EXPECT_EQ(rates.remaining_dh({}, {1u << 28}), 0xffff);
  rates.take(hal::seconds(60), lives(60, 20), 60);
  EXPECT_TRUE(rates.known());
  EXPECT_EQ(rates.cycles_per_min(), 60);
}

TEST(Rates, ARateOfLessThanAMinuteIsUnknownRatherThanTooSmall) {
  Rates rates;
  rates.start({});
  EXPECT_EQ(rates.cycles_per_min(), 0xffff);
  for (std::uint32_t s = 1; s < 60; ++s) {
    rates.take(hal::seconds(s), lives(s, 20), 3 * s);
    EXPECT_EQ(rates.cycles_per_min(), 0xffff) << s;
    EXPECT_EQ(rates.damage_ppb_per_h(), 0xffffffffu) << s;
  }
}

TEST(Rates, TellWhatTheLastMinuteDid) {
  Rates rates;
  rates.start({});
  // 2^-20 of a life and three cycles a second; from 300 s on nothing.
  for (std::uint32_t s = 1; s <= 300; ++s) {
    rates.take(hal::seconds(s), lives(s, 20), 3 * s);
  }
  EXPECT_EQ(rates.cycles_per_min(), 180);
  // 3600 * 2^-20 of a life an hour.
  EXPECT_EQ(rates.damage_ppb_per_h(), 3433227u);
  // A whole life of 2^20 s is 291.27 h.
  EXPECT_EQ(rates.remaining_dh({}, {1u << 28}), 2912);
  EXPECT_EQ(rates.remaining_dh(lives(1, 1), {1u << 28}), 1456);
  EXPECT_EQ(rates.remaining_dh(lives(1, 0), {1u << 28}), 0);
  for (std::uint32_t s = 301; s <= 360; ++s) {
    rates.take(hal::seconds(s), lives(300, 20), 900);
  }
  // Without damage longer than the field holds, which is known, and said.
  EXPECT_EQ(rates.cycles_per_min(), 0);
  EXPECT_EQ(rates.remaining_dh({}, {1u << 28}), 0xfffe);
  EXPECT_EQ(rates.remaining_dh(lives(1, 0), {1u << 28}), 0);
}

TEST(Rates, KnowTheHeaviestMinuteAndThePeakOfTheLastOne) {
  Rates rates;
  rates.start({});
  // A cycle a second of 2^-20 of a life, from 70 s to 129 s 2^-19; the peak falls after 120 s.
  std::uint32_t damage = 0;
  for (std::uint32_t s = 1; s <= 200; ++s) {
    damage += s >= 71 && s <= 130 ? 2 : 1;
    EXPECT_EQ(rates.take(hal::seconds(s), lives(damage, 20), s, s <= 120 ? 900 : 500), s % 10 == 0);
    if (s % 10 == 0) {
      EXPECT_EQ(rates.window_over(), s % 60 == 0) << s;
      // The window until 120 s counts until the next is over.
      EXPECT_EQ(rates.peak(), s < 180 ? 900u : 500u) << s;
    }
  }
  EXPECT_EQ(rates.cycles_of_min(), 60u);
  EXPECT_EQ(rates.damage_per_min(), lives(60, 20));
  EXPECT_EQ(rates.heaviest_per_min(), lives(120, 20));
}

TEST(Rates, StopAtTheirHighestValue) {
  Rates rates;
  rates.start({});
  for (std::uint32_t s = 10; s <= 60; s += 10) {
    rates.take(hal::seconds(s), lives(s, 0), std::uint64_t{s} * 1'000'000'000);
  }
  // The highest values stand for unknown.
  EXPECT_EQ(rates.cycles_per_min(), 0xfffe);
  EXPECT_EQ(rates.damage_ppb_per_h(), 0xfffffffeu);
}

// Minutes of 1 and 4 in turns, of log2 0 and 2: a standard deviation of sqrt(20 / 19) over 20 of
// them, 1.96 of which is 2.0109. Rest between them is no operation.
TEST(Rates, KnowHowTheMinutesOfOperationScatter) {
  Rates rates;
  rates.start({});
  std::uint32_t done = 0;
  std::uint32_t second = 0;
  const auto minute = [&](std::uint32_t damage) {
    for (int i = 0; i < 60; ++i) {
      done += i == 0 ? damage : 0;
      ++second;
      rates.take(hal::seconds(second), lives(done, 20), second);
    }
  };
  minute(0);
  for (std::uint32_t n = 1; n <= 20; ++n) {
    EXPECT_EQ(rates.spread_known(), n > 10) << n;
    minute(n % 2 == 0 ? 4 : 1);
    minute(0);
  }
  EXPECT_NEAR(rates.load_spread() * 0x1p-21, 2.0109, 0.02);
}

}  // namespace
}  // namespace app
