#include "host_sim/calibrate/mixes.hpp"

#include <gtest/gtest.h>

#include "tests/calibrate/campaigns.hpp"

namespace host_sim::calibrate {
namespace {

constexpr double kPaperExponent = 1.38;

TEST(Mixes, PaperExampleByDamageAndByAverageOfLives) {
  const MixResult result = mix("40 and 50 N", {{40, 0.5}, {50, 0.5}}, kPaperExponent);
  EXPECT_NEAR(result.by_damage_N, 45.11, 0.005);
  EXPECT_NEAR(result.by_average_of_lives_N, 44.34, 0.005);
}

TEST(Mixes, SpecimenInBlocksIsAMixOfItsCycles) {
  test::CampaignBuilder builder;
  builder.level(40, {900, 1000}).specimen({{40, 300}, {50, 100}, {40, 100}});
  const auto found = mixes(builder.campaign(), {1.53e5, kPaperExponent, 5.94});
  ASSERT_EQ(found.size(), 1U);
  ASSERT_EQ(found[0].parts.size(), 3U);
  EXPECT_DOUBLE_EQ(found[0].parts[0].share, 0.6);
  EXPECT_DOUBLE_EQ(found[0].parts[1].share, 0.2);
  EXPECT_DOUBLE_EQ(found[0].parts[2].share, 0.2);
  EXPECT_GT(found[0].by_damage_N, 42);  // the mean is 42 N, the exponent above 1
  EXPECT_LT(found[0].by_average_of_lives_N, 42);
}

}  // namespace
}  // namespace host_sim::calibrate
