// What the model of the board refuses, without a firmware: one access each that the manual forbids.
#include <gmock/gmock.h>

#include "tests/virtual_g431/board/board.hpp"

namespace virtual_g431 {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class RulesOf : public ::testing::Test {
 protected:
  /// The only rule that was broken since the last call.
  void expect_broken(const char* text) {
    EXPECT_THAT(rules.all(), ElementsAre(HasSubstr(text)));
    rules.forget();
  }
  void expect_none() { EXPECT_THAT(rules.all(), IsEmpty()); }
  void pass(Ticks span) { agenda.advance_to(agenda.now() + span); }

  Agenda agenda;
  Rules rules;
  Clocks clocks{agenda, rules};
};

TEST_F(RulesOf, Clocks) {
  clocks.write(0x08, 3);
  expect_broken("not ready");
  clocks.write(0x08, 1);
  clocks.write(0x00, bit(8) | bit(16));  // HSE
  clocks.write(0x0C, 3 | 1u << 4 | 85u << 8 | bit(24));
  clocks.write(0x00, bit(8) | bit(16) | bit(24));
  expect_broken("PLL on before its source is ready");
  clocks.write(0x00, bit(8) | bit(16));
  pass(3 * kMillisecond);
  clocks.write(0x00, bit(8) | bit(16) | bit(24));
  expect_none();
  clocks.write(0x0C, 3 | 1u << 4 | 80u << 8 | bit(24));
  expect_broken("PLLCFGR written while the PLL is on");
}

TEST_F(RulesOf, TheWayTo170MHz) {
  std::uint32_t states = 4;
  clocks.wait_states = [&] { return states; };
  const auto start_pll = [&] {
    clocks.reset();
    clocks.power.reset();
    clocks.power.write(0x80, 0);
    clocks.write(0x0C, 2 | 3u << 4 | 85u << 8 | bit(24));
    clocks.write(0x00, bit(8) | bit(24));
    pass(50 * kMicrosecond);
  };
  start_pll();
  clocks.write(0x08, 3);
  expect_broken("without 1 us of half of it");
  start_pll();
  clocks.write(0x08, 8u << 4 | 3);
  clocks.write(0x08, 3);
  expect_broken("without 1 us of half of it");
  start_pll();
  clocks.write(0x08, 8u << 4 | 3);
  pass(2 * kMicrosecond);
  clocks.write(0x08, 3);
  expect_none();
  EXPECT_EQ(clocks.hclk(), 8u);
  states = 3;
  start_pll();
  clocks.write(0x08, 8u << 4 | 3);
  pass(2 * kMicrosecond);
  clocks.write(0x08, 3);
  expect_broken("too few wait states");
  states = 8;
  start_pll();
  clocks.power.write(0x80, 0x100);
  pass(30 * kMicrosecond);
  clocks.write(0x08, 8u << 4 | 3);
  pass(2 * kMicrosecond);
  clocks.write(0x08, 3);
  expect_broken("without the voltage");
}

class RulesOfFlash : public RulesOf {
 protected:
  void SetUp() override {
    flash.reset();
    flash.writable_from = 0x1000;
    flash.write(0x00, 4);  // caches off
  }
  void unlock() {
    flash.write(0x08, 0x45670123);
    flash.write(0x08, 0xCDEF89AB);
  }
  void program(std::uint32_t offset, std::uint32_t low, std::uint32_t high) {
    flash.write(0x14, 1);
    flash.store(offset, low, 4);
    flash.store(offset + 4, high, 4);
    pass(kMillisecond);
  }

  FlashContents contents;
  Flash flash{agenda, rules, contents};
};

TEST_F(RulesOfFlash, Lock) {
  flash.write(0x14, 1);
  expect_broken("CR written while it is locked");
  flash.store(0x1000, 0, 4);
  expect_broken("written without PG, locked");
  flash.write(0x08, 0x45670123);
  flash.write(0x08, 0x45670123);
  expect_broken("wrong key");
}

TEST_F(RulesOfFlash, DoubleWords) {
  unlock();
  program(0x1000, 1, 2);
  expect_none();
  EXPECT_EQ(flash.load(0x1000, 4), 1u);
  EXPECT_EQ(flash.load(0x1004, 4), 2u);
  program(0x1000, 1, 0);
  expect_broken("not erased");
  flash.write(0x10, 0xFFFF);
  flash.store(0x1008, 0, 2);
  expect_broken("less than words");
  flash.write(0x10, 0xFFFF);
  flash.store(0x100C, 0, 4);
  expect_broken("a high word without its low word");
  program(0x1008, 0, 0);
  EXPECT_THAT(rules.all(), ElementsAre(HasSubstr("errors in SR")));
  rules.forget();
  flash.write(0x10, 0xFFFF);
  program(0x0FF8, 0, 0);
  EXPECT_THAT(rules.all(), ElementsAre(HasSubstr("no business"), HasSubstr("errors in SR")));
}

TEST_F(RulesOfFlash, Erase) {
  unlock();
  flash.write(0x14, 2 | 3u << 3 | bit(16));
  expect_broken("in the write that chooses it");
  pass(23 * kMillisecond);
  flash.write(0x14, 2 | 3u << 3);
  flash.write(0x14, 2 | 3u << 3 | bit(16));
  EXPECT_TRUE(flash.busy());
  flash.write(0x14, 0);
  expect_broken("CR written while it is busy");
  pass(23 * kMillisecond);
  EXPECT_FALSE(flash.busy());
  flash.write(0x00, 4 | bit(10));
  expect_broken("data cache on with what was there");
}

/// A torn double word raises the NMI until it is told that it was seen.
TEST_F(RulesOfFlash, Damage) {
  contents.damaged.set(0x2000 / 8);
  EXPECT_FALSE(flash.nmi());
  (void)flash.load(0x2004, 4);
  EXPECT_TRUE(flash.nmi());
  flash.write(0x18, bit(31));
  EXPECT_FALSE(flash.nmi());
}

TEST_F(RulesOf, Converters) {
  Amplifiers amplifiers(rules);
  Converters converters(agenda, rules, clocks, amplifiers);
  converters.reset();
  converters.write(0x08, bit(28) | bit(29));
  expect_broken("in deep power down");
  converters.reset();
  converters.write(0x308, 3u << 16);
  converters.write(0x08, 0);
  converters.write(0x08, bit(28));
  converters.write(0x08, bit(28) | bit(31));
  expect_broken("before the regulator is up");
  converters.reset();
  converters.write(0x308, 3u << 16);
  converters.write(0x08, 0);
  converters.write(0x08, bit(28));
  pass(21 * kMicrosecond);
  converters.write(0x08, bit(28) | bit(31));
  expect_none();
  while ((converters.read(0x08) & bit(31)) != 0) {
    pass(clocks.hclk());
  }
  converters.write(0x08, bit(28) | 1);
  expect_broken("within 4 cycles of the calibration");
  pass(2 * kMicrosecond);
  converters.write(0x4C, 8u << 2 | 1u << 7 | 13u << 9);
  converters.write(0x08, bit(28) | bit(3));
  expect_none();
  converters.write(0x04, bit(6));
  expect_broken("written while JADSTART = 1");
  EXPECT_EQ(converters.read(0x04), 0u) << "silicon ignores it";
  converters.write(0x308, 0);
  expect_broken("CCR written while a converter is on");
}

TEST_F(RulesOf, Can) {
  CanController can(agenda, rules, clocks);
  can.reset();
  can.write(0x1C, 0);
  expect_broken("without INIT and CCE");
  clocks.write(0x88, 2u << 24);
  can.write(0x18, 0);
  can.write(0x18, 3);
  expect_broken("CCE set before INIT reads one");
  can.write(0x18, 3);
  can.write(0x80, 1u << 16);
  can.ram.write(0, 0x80000000u | 1u << 27);
  can.write(0x18, 0);
  expect_none();
  can.ram.write(0, 0);
  expect_broken("a filter changed on the bus");
  can.write(0xCC, 2);
  expect_broken("another buffer than the next");
  can.write(0x94, 0);
  expect_broken("not the oldest");
}

TEST_F(RulesOf, WatchdogNeedsItsKey) {
  Watchdog watchdog(agenda, rules);
  watchdog.reset();
  watchdog.write(0x04, 3);
  expect_broken("without its key");
  watchdog.write(0x00, 0x5555);
  watchdog.write(0x04, 3);
  watchdog.write(0x08, 249);
  expect_none();
  bool bitten = false;
  watchdog.on_timeout = [&] { bitten = true; };
  watchdog.write(0x00, 0xCCCC);
  pass(249 * kMillisecond);
  EXPECT_FALSE(bitten);
  pass(2 * kMillisecond);
  EXPECT_TRUE(bitten);
}

/// Identifier 0x555, no data: 44 bits by hand with its CRC, of which none repeats five times, and
/// the intermission.
TEST_F(RulesOf, LengthOfAFrame) {
  // ISO 11898-1: at most 47 + 8 n bits and (34 + 8 n - 1) / 4 stuff bits, at least none of them.
  for (std::uint32_t id = 0; id < 0x800; ++id) {
    const std::uint32_t bits = bits_on_wire({.id = id});
    EXPECT_GE(bits, 47u);
    EXPECT_LE(bits, 47u + 8u);
  }
  EXPECT_LE(bits_on_wire({.id = 0, .extended = true, .length = 8}), 67u + 64 + (54 + 64 - 1) / 4);
  EXPECT_GT(bits_on_wire({.id = 0}), 47u + 2u) << "eleven dominant bits are stuffed";
}

}  // namespace
}  // namespace virtual_g431
