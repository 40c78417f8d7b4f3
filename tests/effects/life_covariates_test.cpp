#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/effects/specimens.hpp"

namespace host_sim::effects::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(LifeCovariates, LevelsRiseWithEffectiveTensionAndForgiveRounding) {
  const std::vector<Campaign::Specimen> specimens{
      specimen("a", 30), specimen("b", 10), specimen("c", 10 * (1 + 1e-13)), specimen("d", 20)};
  const LifeCovariates c = life_covariates_of(specimens, kLife);
  EXPECT_THAT(c.level, ElementsAre(2, 0, 0, 1));
  EXPECT_EQ(c.levels(), 3U);
  EXPECT_EQ(c.lowest_effective_N(), 10);
  EXPECT_NEAR(c.log_effective_N[3], std::log(20.0), 1e-14);
}

TEST(LifeCovariates, BlocksShareTheDamageAndMakeOneEquivalentTension) {
  // lives 1000 and 250: 100 cycles of each are damage 0.1 and 0.4
  const std::vector<Campaign::Specimen> specimens{in_blocks("a", {{10, 100}, {20, 100}})};
  const LifeCovariates c = life_covariates_of(specimens, kLife);
  EXPECT_NEAR(c.blocks[0][0].life_cycles, 1000, 1e-9);
  EXPECT_NEAR(c.blocks[0][1].life_cycles, 250, 1e-9);
  EXPECT_NEAR(c.blocks[0][0].damage_share, 0.2, 1e-15);
  EXPECT_NEAR(c.blocks[0][1].damage_share, 0.8, 1e-15);
  EXPECT_NEAR(c.log_effective_N[0], std::log(250.0) / 2, 1e-14);  // sqrt((100 + 400)/2)
}

TEST(LifeCovariates, LotsAreNumberedByNameAndOptionalColumnsAreAllOrNone) {
  std::vector<Campaign::Specimen> specimens{specimen("a", 10), specimen("b", 20)};
  specimens[0].lot = "south";
  specimens[1].lot = "north";
  specimens[0].days = 3;
  specimens[0].wire_to_bend_ratio = 0.05;
  specimens[1].wire_to_bend_ratio = 0.02;
  const LifeCovariates c = life_covariates_of(specimens, kLife);
  EXPECT_THAT(c.lot, ElementsAre(1, 0));
  EXPECT_EQ(c.lots(), 2U);
  EXPECT_THAT(c.days, IsEmpty());
  EXPECT_THAT(c.wire_to_bend_ratio, ElementsAre(0.05, 0.02));
}

TEST(LifeCovariates, NoSpecimensHaveNoLevelsAndNoLots) {
  const LifeCovariates c = life_covariates_of({}, kLife);
  EXPECT_EQ(c.specimens() + c.levels() + c.lots(), 0U);
}

}  // namespace
}  // namespace host_sim::effects::testing
