#include "host_sim/calibrate/use_levels.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/calibrate/campaigns.hpp"

namespace host_sim::calibrate {
namespace {

life_law::LifeData two_levels() {
  life_law::LifeData data;
  for (const double life : test::even_lives(1000, 4, 20)) {
    data.push_back({{{10, life}}, true, 0});
    data.push_back({{{20, life / 4}}, true, 1});
  }
  return data;
}

CalibrateOptions use_level_options() {
  CalibrateOptions options;
  options.bootstraps = 20'000;
  return options;
}

TEST(UseLevel, NextSpecimenOfACertainLawLiesBetweenItsQuantiles) {
  const life_law::LifeData data = two_levels();
  const life_law::LifeFit fit = life_law::fit_life(data);
  const std::vector<LifeLaw> certain(use_level_options().bootstraps, fit.law());
  const UseLevel use = use_level("u", 15, data, fit, certain, 0, use_level_options());
  EXPECT_NEAR(use.next_specimen_95.low / fit.law().quantile(0.025, 15), 1, 0.03);
  EXPECT_NEAR(use.next_specimen_95.high / fit.law().quantile(0.975, 15), 1, 0.01);
}

// Half of the laws say three times the life, half a third: 2.5 % of the mixture is 5 % of one half.
TEST(UseLevel, NextSpecimenOfAnUncertainLawLiesFartherOut) {
  const life_law::LifeData data = two_levels();
  const life_law::LifeFit fit = life_law::fit_life(data);
  std::vector<LifeLaw> uncertain(use_level_options().bootstraps, fit.law());
  for (std::size_t i = 0; i < uncertain.size(); ++i) {
    uncertain[i].scale *= i % 2 == 0 ? 3 : 1.0 / 3;
  }
  const UseLevel use = use_level("u", 15, data, fit, uncertain, 0, use_level_options());
  EXPECT_NEAR(use.next_specimen_95.low / (fit.law().quantile(0.05, 15) / 3), 1, 0.03);
  EXPECT_NEAR(use.next_specimen_95.high / (fit.law().quantile(0.95, 15) * 3), 1, 0.02);
}

TEST(UseLevel, MarksFollowFromTheLaw) {
  const life_law::LifeData data = two_levels();
  const life_law::LifeFit fit = life_law::fit_life(data);
  const std::vector<LifeLaw> certain(100, fit.law());
  const UseLevel use = use_level("u", 10, data, fit, certain, 0, use_level_options());
  const double alpha = fit.law().scale / std::pow(10, fit.law().exponent);
  const double shape = fit.law().shape;
  EXPECT_NEAR(use.mean / (alpha * std::tgamma(1 + 1 / shape)), 1, 1e-12);
  EXPECT_NEAR(use.b10 / (alpha * std::pow(-std::log(0.9), 1 / shape)), 1, 1e-12);
  EXPECT_NEAR(use.b50 / (alpha * std::pow(std::log(2.0), 1 / shape)), 1, 1e-12);
  EXPECT_NEAR(use.b90 / (alpha * std::pow(-std::log(0.1), 1 / shape)), 1, 1e-12);
  EXPECT_LT(use.b10_ci95.low, use.b10);
  EXPECT_GT(use.b10_ci95.high, use.b10);
  EXPECT_LT(use.mean_ci95.low, use.mean);
  EXPECT_GT(use.mean_ci95.high, use.mean);
}

TEST(UseLevel, IntervalsWidenAwayFromTheTestedLevels) {
  const life_law::LifeData data = two_levels();
  const life_law::LifeFit fit = life_law::fit_life(data);
  const std::vector<LifeLaw> certain(100, fit.law());
  const auto width = [&](double tension_N) {
    const UseLevel use = use_level("u", tension_N, data, fit, certain, 0, use_level_options());
    return use.b10_ci95.high / use.b10_ci95.low;
  };
  EXPECT_LT(width(14), width(7));
  EXPECT_LT(width(7), width(4));
}

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
