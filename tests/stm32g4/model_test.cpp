#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include "hal/stm32g4/current_sensor.hpp"
#include "tests/stm32g4/model/chip.hpp"

// The models themselves: each has to fail the test that does what RM0440 forbids.
namespace stm32g4_models {
namespace {

/// How many failures the action causes.
template <class Action>
int failures(Action&& action) {
  testing::TestPartResultArray results;
  const testing::ScopedFakeTestPartResultReporter reporter(
      testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &results);
  action();
  return results.size();
}

TEST(Models, NoticeThePllConfiguredWhileOn) {
  ReadyChip chip;
  EXPECT_GT(failures([&] { chip.rcc.registers.pllcfgr.write(0); }), 0);
}

TEST(Models, NoticeWaitStatesAfterTheClock) {
  Chip chip;
  chip.supply.boosted = true;
  auto& rcc = chip.rcc.registers;
  rcc.pllcfgr.write(2 | 3u << 4 | 85u << 8 | 1u << 24);
  rcc.cr.write(rcc.cr.read() | 1u << 24);
  for (int i = 0; i < 10; ++i) {
    static_cast<void>(rcc.cr.read());
  }
  rcc.cfgr.write(8u << 4 | 1);
  EXPECT_EQ(failures([&] { rcc.cfgr.write(8u << 4 | 3); }), 1);
}

TEST(Models, NoticeAShortHalfSpeed) {
  ReadyChip chip;
  auto& rcc = chip.rcc.registers;
  rcc.cfgr.write(3u | 8u << 4);
  rcc.cfgr.write(1u | 8u << 4);
  rcc.cfgr.hold(1u | 1u << 2 | 8u << 4);
  rcc.cfgr.write(3u | 8u << 4);
  for (int i = 0; i < 5; ++i) {
    static_cast<void>(rcc.cfgr.read());
  }
  EXPECT_EQ(failures([&] { rcc.cfgr.write(3u); }), 1);
}

TEST(Models, NoticePeripheralsWithoutClocks) {
  Chip chip;
  EXPECT_GT(failures([&] { chip.gpio_a.registers.moder.write(0); }), 0);
  EXPECT_GT(failures([&] { chip.pwr.registers.cr3.write(0); }), 0);
  EXPECT_GT(failures([&] { static_cast<void>(chip.can.registers.cccr.read()); }), 0);
  EXPECT_GT(failures([&] { static_cast<void>(chip.random.registers.sr.read()); }), 0);
  EXPECT_GT(failures([&] { chip.tim1.registers.arr.write(1); }), 0);
  EXPECT_GT(failures([&] { chip.opamp.registers.csr[0].write(0); }), 0);
}

TEST(Models, NoticeAConverterThatIsHurried) {
  ReadyChip chip;
  chip.adc_common.registers.ccr.write(3u << 16);
  auto& adc = chip.adc1.registers;
  EXPECT_GT(failures([&] { adc.cr.write(1u << 28); }), 0) << "still in deep power-down";
  adc.cr.hold(1u << 29);
  adc.cr.write(0);
  EXPECT_GT(failures([&] { adc.cr.write(1u << 31); }), 0) << "without the regulator";
  adc.cr.hold(0);
  adc.cr.write(1u << 28);
  EXPECT_GT(failures([&] { adc.cr.write(1u << 28 | 1u << 31); }), 0) << "before 20 us";
  adc.cr.hold(1u << 28);
  EXPECT_GT(failures([&] { adc.cr.write(1u << 28 | 1); }), 0) << "not calibrated";
  adc.cr.hold(1u << 28);
  EXPECT_GT(failures([&] { adc.cr.write(1u << 28 | 1u << 3); }), 0) << "not ready";
  adc.cr.hold(1u << 28 | 1u << 3 | 1u);
  EXPECT_EQ(failures([&] { adc.ier.write(1u << 6); }), 1) << "after JADSTART";
}

TEST(Models, NoticeACanControllerConfiguredOnTheBus) {
  ReadyChip chip;
  auto& can = chip.can.registers;
  EXPECT_GT(failures([&] { can.nbtp.write(0); }), 0) << "INIT alone is not enough";
  can.cccr.write(3);
  EXPECT_EQ(failures([&] { can.nbtp.write(0); }), 0);
  can.cccr.write(0);
  EXPECT_GT(failures([&] { can.rxgfc.write(0); }), 0);
}

TEST(Models, NoticeFlashOutOfSequence) {
  ReadyChip chip;
  auto& flash = chip.flash.registers;
  EXPECT_GT(failures([&] { flash.cr.write(1); }), 0) << "locked";
  EXPECT_GT(failures([&] { chip.flash.array.store(0, {1, 2}); }), 0) << "without PG";
  flash.sr.hold(0);
  EXPECT_GT(failures([&] { flash.keyr.write(0xCDEF89AB); }), 0) << "the second key first";
  EXPECT_GT(failures([&] { flash.keyr.write(0x45670123); }), 0) << "locked until reset";
  chip.flash.reset();
  flash.keyr.write(0x45670123);
  flash.keyr.write(0xCDEF89AB);
  EXPECT_GT(failures([&] { flash.cr.write(1u << 16); }), 0) << "STRT without PER";
}

TEST(Models, NoticeAWatchdogThatIsNotUnlocked) {
  WatchdogModel model;
  model.registers.kr.write(0xCCCC);
  EXPECT_GT(failures([&] { model.registers.rlr.write(1); }), 0);
}

}  // namespace
}  // namespace stm32g4_models
