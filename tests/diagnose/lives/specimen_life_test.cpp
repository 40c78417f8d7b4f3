#include "host_sim/diagnose/lives/specimen_life.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace host_sim::diagnose::lives {
namespace {

const double kLn1000 = std::log(1000);
const double kLn4000 = std::log(4000);

TEST(LifeDamage, OfOneBlockIsItsShareOfLife) {
  const std::array blocks{LoadedBlock{kLn1000, 250}};
  const Damage damage = damage_of(blocks, 0.4);
  EXPECT_NEAR(damage.ln, std::log(0.25), 1e-12);
  EXPECT_NEAR(damage.ln_rate, -kLn1000, 1e-12);
}

TEST(LifeDamage, OfBlocksIsMinersSumWithoutSequence) {
  const std::array blocks{LoadedBlock{kLn1000, 250}, LoadedBlock{kLn4000, 3000}};
  const Damage damage = damage_of(blocks, 0);
  EXPECT_NEAR(damage.ln, 0, 1e-12);  // 1/4 + 3/4
  EXPECT_NEAR(damage.ln_rate, -kLn4000, 1e-12);
}

// 0.25^((1/4)^0.4) = 0.25^0.574349 = 0.451031, which leaves 0.548969 of 4,000 cycles.
TEST(LifeDamage, OfMansonHalfordFromHighToLow) {
  const std::array blocks{LoadedBlock{kLn1000, 250}, LoadedBlock{kLn4000, 4000 * 0.548969}};
  EXPECT_NEAR(damage_of(blocks, 0.4).ln, 0, 1e-5);
}

// 0.25^(4^0.4) = 0.25^1.741101 = 0.089492: low loads first leave more.
TEST(LifeDamage, OfMansonHalfordFromLowToHigh) {
  const std::array blocks{LoadedBlock{kLn4000, 1000}, LoadedBlock{kLn1000, 1000 * (1 - 0.089492)}};
  EXPECT_NEAR(damage_of(blocks, 0.4).ln, 0, 1e-5);
}

TEST(LifeDamage, GrowsInTheLastBlockByItsRate) {
  for (const double exponent : {0.0, 0.2, 0.6}) {
    std::vector<LoadedBlock> blocks{{kLn1000, 300}, {kLn4000, 900}, {kLn1000 + 0.3, 200}};
    const Damage damage = damage_of(blocks, exponent);
    constexpr double kStep = 1e-3;
    blocks.back().cycles += kStep;
    const double above = std::exp(damage_of(blocks, exponent).ln);
    EXPECT_NEAR((above - std::exp(damage.ln)) / kStep / std::exp(damage.ln_rate), 1, 1e-4)
        << exponent;
  }
}

TEST(LifeDamage, IsNoneUnderALoadThatDoesNone) {
  const std::array blocks{LoadedBlock{std::numeric_limits<double>::infinity(), 1e6}};
  EXPECT_EQ(damage_of(blocks, 0).ln, -std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace host_sim::diagnose::lives
