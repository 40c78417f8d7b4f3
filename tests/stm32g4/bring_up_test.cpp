#include <gtest/gtest.h>

#include "hal/stm32g4/clock_tree.hpp"
#include "tests/stm32g4/model/chip.hpp"

namespace stm32g4_models {
namespace {

using hal::stm32g4::Oscillator;

class BringUp : public ::testing::Test {
 protected:
  Chip chip;
  hal::stm32g4::ClockTree<Word> tree{chip.rcc.registers, chip.pwr.registers, chip.flash.registers};
};

TEST_F(BringUp, RunsAt170MHzFromTheCrystal) {
  const auto oscillator = tree.start();
  ASSERT_TRUE(oscillator);
  EXPECT_EQ(*oscillator, Oscillator::crystal_8MHz);
  EXPECT_EQ(chip.rcc.core_Hz(), 170'000'000u);
  EXPECT_TRUE(chip.supply.boosted);
  EXPECT_EQ(chip.supply.wait_states, 4u);
  // RM0440 7.4.1: CSSON is bit 19.
  EXPECT_TRUE(chip.rcc.registers.cr.has(1u << 19));
  // RM0440 5.7.1: prefetch and both caches.
  EXPECT_TRUE(chip.flash.registers.acr.has(0x700));
}

TEST_F(BringUp, TakesTheInternalOscillatorWhereNoCrystalStarts) {
  chip.rcc.crystal = false;
  const auto oscillator = tree.start();
  ASSERT_TRUE(oscillator);
  EXPECT_EQ(*oscillator, Oscillator::internal_16MHz);
  EXPECT_EQ(chip.rcc.core_Hz(), 170'000'000u);
  EXPECT_FALSE(chip.rcc.registers.cr.has(1u << 16)) << "HSE stays on for nothing";
  EXPECT_FALSE(chip.rcc.registers.cr.has(1u << 19)) << "nothing to watch";
}

TEST_F(BringUp, SaysSoWhereThePllDoesNotLock) {
  chip.rcc.pll_locks = false;
  const auto oscillator = tree.start();
  ASSERT_FALSE(oscillator);
  EXPECT_EQ(oscillator.error(), hal::Error::failed);
  EXPECT_EQ(chip.rcc.core_Hz(), 16'000'000u);
}

TEST_F(BringUp, RunsAgainAfterASoftwareStart) {
  ASSERT_TRUE(tree.start());
  chip.rcc.break_crystal();
  const auto oscillator = tree.start();
  ASSERT_TRUE(oscillator);
  EXPECT_EQ(*oscillator, Oscillator::internal_16MHz);
  EXPECT_EQ(chip.rcc.core_Hz(), 170'000'000u);
}

TEST_F(BringUp, RunsAgainWhereABootLoaderLeftThePllInUse) {
  ASSERT_TRUE(tree.start());
  chip.rcc.crystal = false;
  chip.rcc.registers.cr.drop(1u << 17);
  const auto oscillator = tree.start();
  ASSERT_TRUE(oscillator);
  EXPECT_EQ(chip.rcc.core_Hz(), 170'000'000u);
}

TEST_F(BringUp, GivesPeripheralsTheirClocks) {
  ASSERT_TRUE(tree.start());
  ASSERT_EQ(hal::stm32g4::enable_peripherals(chip.rcc.registers), hal::Error::none);
  const auto& rcc = chip.rcc.registers;
  // RM0440 7.4.14, 7.4.16, 7.4.18 and 7.4.26.
  EXPECT_EQ(rcc.ahb2enr.held(), 1u << 0 | 1u << 1 | 1u << 2 | 1u << 13 | 1u << 26);
  EXPECT_EQ(rcc.apb1enr1.held(), 1u << 0 | 1u << 25 | 1u << 28);
  EXPECT_EQ(rcc.apb2enr.held(), 1u << 0 | 1u << 11);
  EXPECT_EQ(rcc.ccipr.held() >> 24 & 3u, 2u);
  EXPECT_EQ(rcc.ccipr.held() >> 26 & 3u, 0u);
}

TEST_F(BringUp, LeavesThePinsOfTypeCAlone) {
  ASSERT_TRUE(tree.start());
  EXPECT_TRUE(chip.pwr.registers.cr3.has(1u << 14));
}

}  // namespace
}  // namespace stm32g4_models
