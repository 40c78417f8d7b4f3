#include "host_sim/monitor/fleet/wire_lives.hpp"

#include <gtest/gtest.h>

namespace host_sim::monitor {
namespace {

namespace detail = protocol::detail;

constexpr std::uint32_t kDamage_ppb = 640'000'000;
constexpr std::int64_t kTime_ns = 5'000'000'000;

/// Hears `tendons` tendons in turn, whole, and all their cycles.
WireLives heard(std::uint8_t tendons, std::uint32_t cycles) {
  WireLives wires;
  for (int turn = 0; turn < 2; ++turn) {
    for (std::uint8_t tendon = 0; tendon < tendons; ++tendon) {
      wires.take(detail::TendonDamage{.tendon = tendon});
      wires.take(detail::WireHistory{.tendon = tendon}, kDamage_ppb, 0);
    }
  }
  wires.take(detail::Cycles{.cycles = cycles});
  return wires;
}

void breaks(WireLives& wires, std::uint8_t tendon) {
  wires.take(detail::WireHistory{.tendon = tendon, .broken = true}, kDamage_ppb, kTime_ns);
}

detail::RainflowBin bin(std::uint8_t tendon, std::uint8_t range, std::uint32_t cycles,
                        std::uint8_t half_cycles = 0) {
  return {.tendon = tendon,
          .range_class = range,
          .mean_class = 1,
          .half_cycles = half_cycles,
          .cycles = cycles};
}

TEST(WireLives, OfTheOnlyTendonArePageCycles) {
  WireLives wires = heard(1, 1200);
  EXPECT_TRUE(wires.ended().empty());
  breaks(wires, 0);
  breaks(wires, 0);
  ASSERT_EQ(wires.ended().size(), 1U);
  EXPECT_EQ(wires.ended()[0].cycles, 1200);
  EXPECT_TRUE(wires.ended()[0].broken);
  EXPECT_EQ(wires.ended()[0].damage_ppb, kDamage_ppb);
  EXPECT_EQ(wires.ended()[0].time_ns, kTime_ns);
  wires.take(detail::Cycles{.cycles = 1300});
  EXPECT_EQ(wires.ended()[0].cycles, 1200);
}

// 700 + 100 + 400 are the 1,200 of all; half of an open half cycle counts besides.
TEST(WireLives, OfSeveralTendonsAreTheBinsThatHoldAllCycles) {
  WireLives wires = heard(2, 1200);
  wires.take(bin(0, 3, 700));
  wires.take(bin(1, 3, 400));
  breaks(wires, 0);
  EXPECT_FALSE(wires.ended()[0].cycles);
  wires.take(bin(0, 4, 100, 1));
  EXPECT_EQ(wires.ended()[0].cycles, 800.5);
}

TEST(WireLives, AreNotKnownFromBinsOfTheLastStartAlone) {
  WireLives wires = heard(2, 5000);
  wires.take(bin(0, 3, 700));
  wires.take(bin(1, 3, 4300));
  wires.restarted();
  wires.take(detail::Cycles{.cycles = 5010});
  wires.take(bin(0, 3, 10));
  breaks(wires, 0);
  ASSERT_EQ(wires.ended().size(), 1U);
  EXPECT_FALSE(wires.ended()[0].cycles);
  // Its new epoch tells: of 5,010 cycles 1,700 are left, those of the other.
  wires.take(detail::Cycles{.cycles = 1700});
  wires.epoch_opened(0, kDamage_ppb + 1, 2 * kTime_ns);
  ASSERT_EQ(wires.ended().size(), 1U);
  EXPECT_EQ(wires.ended()[0].cycles, 3310);
  EXPECT_EQ(wires.ended()[0].damage_ppb, kDamage_ppb);
}

TEST(WireLives, EndWholeWithANewEpoch) {
  WireLives wires = heard(2, 5000);
  wires.take(detail::Cycles{.cycles = 1700});
  wires.epoch_opened(1, kDamage_ppb, kTime_ns);
  ASSERT_EQ(wires.ended().size(), 1U);
  EXPECT_FALSE(wires.ended()[0].broken);
  EXPECT_EQ(wires.ended()[0].tendon, 1);
  EXPECT_EQ(wires.ended()[0].cycles, 3300);
  EXPECT_EQ(wires.ended()[0].damage_ppb, kDamage_ppb);
  // And the new one breaks.
  wires.take(detail::Cycles{.cycles = 1800});
  wires.take(bin(0, 3, 1700));
  wires.take(bin(1, 3, 100));
  breaks(wires, 1);
  ASSERT_EQ(wires.ended().size(), 2U);
  EXPECT_EQ(wires.ended()[1].cycles, 100);
}

TEST(WireLives, AreNotKnownWhereSeveralEndAtOnceOrTheNodeStarts) {
  WireLives two = heard(2, 5000);
  two.take(detail::Cycles{.cycles = 1700});
  two.take(detail::Cycles{.cycles = 3});
  two.epoch_opened(0, kDamage_ppb, kTime_ns);
  two.epoch_opened(1, kDamage_ppb, kTime_ns);
  ASSERT_EQ(two.ended().size(), 2U);
  EXPECT_FALSE(two.ended()[0].cycles);
  EXPECT_FALSE(two.ended()[1].cycles);

  WireLives started = heard(2, 5000);
  started.restarted();
  started.take(detail::Cycles{.cycles = 1700});
  started.epoch_opened(0, kDamage_ppb, kTime_ns);
  EXPECT_FALSE(started.ended().at(0).cycles);
}

TEST(WireLives, AreNoneOfAWireThatWasBrokenBefore) {
  WireLives wires;
  wires.take(detail::Cycles{.cycles = 5000});
  breaks(wires, 0);
  EXPECT_TRUE(wires.ended().empty());
  wires.take(detail::Cycles{.cycles = 1});
  wires.take(detail::WireHistory{.tendon = 0}, 0, kTime_ns);
  wires.epoch_opened(0, kDamage_ppb, kTime_ns);
  EXPECT_TRUE(wires.ended().empty());
}

TEST(WireLives, AreNotKnownAtTheEndOfTheRange) {
  WireLives wires = heard(1, 0xffffffff);
  breaks(wires, 0);
  ASSERT_EQ(wires.ended().size(), 1U);
  EXPECT_FALSE(wires.ended()[0].cycles);
}

}  // namespace
}  // namespace host_sim::monitor
