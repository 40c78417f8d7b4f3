#include "host_sim/calibrate/calibrate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "hal/files/input_error.hpp"
#include "tests/calibrate/campaigns.hpp"

namespace host_sim::calibrate {

using hal::files::InputError;

namespace {

using test::CampaignBuilder;
using test::even_lives;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

CalibrateOptions quick() {
  CalibrateOptions options;
  options.bootstraps = 500;
  return options;
}

/// alpha = 1e6 / T^2.
CampaignBuilder square_law(double shape) {
  CampaignBuilder builder;
  builder.level(20, even_lives(2500, shape, 20))
      .level(40, even_lives(625, shape, 20))
      .level(50, even_lives(400, shape, 20));
  return builder;
}

TEST(Calibrate, FindsTheLawOfLivesThatFollowIt) {
  const CalibrateResult result = calibrate(square_law(6).campaign(), quick());
  ASSERT_TRUE(result.stress_life.has_value());
  EXPECT_NEAR(result.stress_life->law.exponent, 2, 1e-6);
  ASSERT_TRUE(result.common_shape.has_value());
  EXPECT_NEAR(result.stress_life->law.shape, result.common_shape->value, 1e-6);
  EXPECT_NEAR(result.common_shape->homogeneity.statistic, 0, 1e-6);
  EXPECT_NEAR(result.stress_life->against_free_levels->statistic, 0, 1e-6);
  EXPECT_EQ(result.stress_life->against_free_levels->degrees_of_freedom, 1);
  ASSERT_TRUE(result.stress_life->least_squares.has_value());
  EXPECT_NEAR(result.stress_life->least_squares->exponent, 2, 1e-6);
  EXPECT_THAT(result.warnings, IsEmpty());
}

TEST(Calibrate, WarnsOfFewSpecimens) {
  CampaignBuilder builder;
  builder.level(20, even_lives(2500, 6, 6)).level(40, even_lives(625, 6, 5));
  EXPECT_THAT(calibrate(builder.campaign(), quick()).warnings,
              testing::Contains(HasSubstr("11 specimens are few")));
  builder.level(50, {400});
  EXPECT_THAT(calibrate(builder.campaign(), quick()).warnings,
              testing::Contains(HasSubstr("specimens are few")).Times(0));
}

TEST(Calibrate, TheBandReachesOverAllUseLevels) {
  CampaignBuilder builder = square_law(6);
  builder.use("light", 5).use("heavy", 90).use("between", 30);
  const StressLife law = *calibrate(builder.campaign(), quick()).stress_life;
  // Tested from 20 to 50 N with a quarter beside; 5 N and 90 N are beyond.
  EXPECT_NEAR(law.tested_N.low, 16, 1e-9);
  EXPECT_NEAR(law.tested_N.high, 62.5, 1e-9);
  EXPECT_LT(law.band_tension_N.front(), 5);
  EXPECT_GT(law.band_tension_N.back(), 90);
  EXPECT_TRUE(std::ranges::is_sorted(law.band_tension_N));
  ASSERT_EQ(law.band_mean.size(), law.band_tension_N.size());
  EXPECT_LT(law.band_mean.front().low, law.law.mean_life(law.band_tension_N.front()));
  EXPECT_GT(law.band_mean.front().high, law.law.mean_life(law.band_tension_N.front()));
}

TEST(Calibrate, LeavesOutTheLevelThatBreaksTheShapeAndSaysWhy) {
  CampaignBuilder builder = square_law(6);
  builder.level(80, even_lives(156.25, 2, 20));
  const CalibrateResult result = calibrate(builder.campaign(), quick());
  EXPECT_THAT(result.levels[3].left_out, HasSubstr("differs from that of the other levels"));
  EXPECT_THAT(result.levels[0].left_out, IsEmpty());
  ASSERT_TRUE(result.common_shape->with_all_levels.has_value());
  EXPECT_GT(result.common_shape->with_all_levels->statistic, 7.82);
  EXPECT_NEAR(result.common_shape->homogeneity.statistic, 0, 1e-6);
  EXPECT_NEAR(result.stress_life->law.exponent, 2, 1e-6);
  EXPECT_THAT(result.warnings, ElementsAre(HasSubstr("level 80.0 N is left out")));
}

TEST(Calibrate, TellsThePOfALevelWithTheCostOfLookingAtEach) {
  CampaignBuilder builder = square_law(6);
  builder.level(80, even_lives(156.25, 3.6, 20));
  const CalibrateResult result = calibrate(builder.campaign(), quick());
  const std::vector<OddLevel>& odd = result.common_shape->odd_levels;
  ASSERT_EQ(odd.size(), 4U);
  EXPECT_LT(odd[3].p_corrected, 1);
  EXPECT_DOUBLE_EQ(odd[3].p_corrected, 4 * odd[3].test.p_simulated);
  EXPECT_EQ(odd[0].p_corrected, 1);
}

// Two levels of shape 4 and two of 7.3: the likelihood ratio for one shape is about 11.8, and each
// alone is off from the other three by 3.9, p 0.05, which four looks make 0.2.
TEST(Calibrate, NoLevelIsLeftOutWhereNoneAloneBreaksTheShape) {
  CampaignBuilder builder;
  builder.level(20, even_lives(2500, 4, 20))
      .level(40, even_lives(625, 7.3, 20))
      .level(50, even_lives(400, 4, 20))
      .level(80, even_lives(156.25, 7.3, 20));
  const CalibrateResult result = calibrate(builder.campaign(), quick());
  EXPECT_LT(result.common_shape->homogeneity.p_simulated, 0.05);
  EXPECT_FALSE(result.common_shape->with_all_levels.has_value());
  for (const LevelResult& level : result.levels) {
    EXPECT_THAT(level.left_out, IsEmpty());
  }
  EXPECT_THAT(result.warnings,
              testing::Contains(HasSubstr("one shape for all levels is rejected")));
}

TEST(Calibrate, KeepsAllLevelsWhenAsked) {
  CampaignBuilder builder = square_law(6);
  builder.level(80, even_lives(156.25, 2, 20));
  CalibrateOptions options = quick();
  options.keep_all_levels = true;
  const CalibrateResult result = calibrate(builder.campaign(), options);
  EXPECT_THAT(result.levels[3].left_out, IsEmpty());
  EXPECT_FALSE(result.common_shape->with_all_levels.has_value());
  EXPECT_THAT(result.warnings,
              testing::Contains(HasSubstr("one shape for all levels is rejected")));
}

TEST(Calibrate, OfTwoLevelsNoneIsTheOddOne) {
  CampaignBuilder builder;
  builder.level(20, even_lives(2500, 8, 20)).level(40, even_lives(625, 2, 20));
  const CalibrateResult result = calibrate(builder.campaign(), quick());
  EXPECT_THAT(result.levels[0].left_out, IsEmpty());
  EXPECT_THAT(result.levels[1].left_out, IsEmpty());
  EXPECT_THAT(result.warnings,
              testing::Contains(HasSubstr("one shape for all levels is rejected")));
}

TEST(Calibrate, DoesNotDependOnTheNumberOfThreads) {
  CampaignBuilder builder = square_law(6);
  builder.suspended(20, {2000, 2600})
      .use("u", 30)
      .level(30, {1000, 1200, 900}, Campaign::Role::validation);
  CalibrateOptions options = quick();
  options.threads = 1;
  const CalibrateResult one = calibrate(builder.campaign(), options);
  options.threads = 3;
  const CalibrateResult three = calibrate(builder.campaign(), options);
  for (std::size_t i = 0; i < one.levels.size(); ++i) {
    EXPECT_EQ(one.levels[i].goodness[2]->ad_p, three.levels[i].goodness[2]->ad_p);
    EXPECT_EQ(one.levels[i].band.low, three.levels[i].band.low);
    EXPECT_EQ(one.levels[i].shape_unbiased, three.levels[i].shape_unbiased);
  }
  EXPECT_EQ(one.common_shape->homogeneity.p_simulated, three.common_shape->homogeneity.p_simulated);
  EXPECT_EQ(one.stress_life->against_curvature->p_simulated,
            three.stress_life->against_curvature->p_simulated);
  EXPECT_EQ(one.validation[0].p, three.validation[0].p);
  EXPECT_EQ(one.use_levels[0].next_specimen_95.low, three.use_levels[0].next_specimen_95.low);
}

TEST(Calibrate, AnotherSeedGivesOtherPValues) {
  CalibrateOptions options = quick();
  const CalibrateResult one = calibrate(square_law(6).campaign(), options);
  options.seed = 2;
  const CalibrateResult two = calibrate(square_law(6).campaign(), options);
  EXPECT_NE(one.levels[0].shape_unbiased, two.levels[0].shape_unbiased);
}

TEST(Calibrate, ALevelWithOneFailureIsNamedWithItsLineAndStillCounts) {
  CampaignBuilder builder = square_law(6);
  builder.level(10, {9000}).suspended(10, {9500, 9900});
  const CalibrateResult result = calibrate(builder.campaign(), quick());
  EXPECT_THAT(result.warnings,
              testing::Contains(AllOf(HasSubstr("specimens.csv:62: level 10.0 N: 1 failed of 3"),
                                      HasSubstr("needs at least 2 failures"))));
  EXPECT_LT(result.stress_life->band_tension_N.front(), 10);
  EXPECT_NE(result.stress_life->law.exponent, 2);
}

TEST(Calibrate, ManyLevelsWithFewFailuresAreToldTogether) {
  CampaignBuilder builder = square_law(6);
  builder.level(10, {9000}).level(11, {8000}).level(12, {7000});
  EXPECT_THAT(calibrate(builder.campaign(), quick()).warnings,
              testing::Contains(HasSubstr("1 failed of 1")).Times(3));
  builder.level(13, {6000});
  const CalibrateResult result = calibrate(builder.campaign(), quick());
  EXPECT_THAT(result.warnings, testing::Contains(HasSubstr("1 failed of 1")).Times(0));
  EXPECT_THAT(result.warnings,
              testing::Contains(HasSubstr("specimens.csv: 4 levels have fewer than 2 failures")));
  EXPECT_THAT(result.warnings, testing::Contains(HasSubstr("at lines 62, 63, 64, 65")));
}

TEST(Calibrate, ALevelWithAllSuspendedIsNamed) {
  CampaignBuilder builder = square_law(6);
  builder.suspended(10, {9500, 9900});
  const CalibrateResult result = calibrate(builder.campaign(), quick());
  EXPECT_THAT(result.warnings, testing::Contains(HasSubstr("level 10.0 N: 0 failed of 2")));
}

TEST(Calibrate, LivesWithoutScatterAreOnTheBoundary) {
  CampaignBuilder builder = square_law(6);
  builder.level(10, {10'000, 10'000, 10'000});
  const CalibrateResult result = calibrate(builder.campaign(), quick());
  EXPECT_THAT(result.warnings, testing::Contains(HasSubstr("boundary, at infinity")));
  EXPECT_EQ(result.levels[0].weibull().problem, statistics::FitProblem::no_spread);
}

TEST(Calibrate, OneTensionHasNoLaw) {
  CampaignBuilder builder;
  builder.level(20, even_lives(2500, 6, 20));
  const CalibrateResult result = calibrate(builder.campaign(), quick());
  EXPECT_FALSE(result.stress_life.has_value());
  EXPECT_FALSE(result.common_shape.has_value());
  EXPECT_THAT(result.warnings, ElementsAre(HasSubstr("there is no life law")));
}

TEST(Calibrate, FewerThanTwoFailuresAreRefused) {
  CampaignBuilder builder;
  builder.suspended(20, {100, 200}).level(40, {50}).level(50, {30, 40}, Campaign::Role::validation);
  try {
    calibrate(builder.campaign(), quick());
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "built/specimens.csv: 1 failed of 3 specimens of role fit; accepted: at least 2 failed");
  }
}

TEST(Calibrate, SpecimensInBlocksTakePartInTheLaw) {
  CampaignBuilder with;
  with.level(20, even_lives(2500, 6, 20)).level(40, even_lives(625, 6, 20));
  const CalibrateResult without = calibrate(with.campaign(), quick());
  for (const double life : even_lives(1, 6, 20)) {
    with.specimen({{20, 500}, {40, 625 * life}});
  }
  const CalibrateResult result = calibrate(with.campaign(), quick());
  EXPECT_EQ(result.in_blocks, 20U);
  EXPECT_EQ(result.levels.size(), 2U);
  EXPECT_EQ(result.mixes.size(), 20U);
  EXPECT_NE(result.stress_life->law.scale, without.stress_life->law.scale);
}

TEST(Calibrate, ValidationInBlocksIsComparedInDamage) {
  CampaignBuilder builder = square_law(6);
  for (const double life : even_lives(1, 6, 10)) {
    builder.specimen({{20, 1250 * life}, {40, 312.5 * life}}, Campaign::Status::failed,
                     Campaign::Role::validation);
  }
  const CalibrateResult result = calibrate(builder.campaign(), quick());
  ASSERT_EQ(result.validation.size(), 1U);
  EXPECT_TRUE(result.validation[0].in_blocks);
  EXPECT_NEAR(result.validation[0].measured_mean / result.validation[0].predicted_mean, 1, 0.02);
  EXPECT_GT(result.validation[0].p, 0.5);
}

TEST(Calibrate, ValidationNeverMovesTheFit) {
  CampaignBuilder builder = square_law(6);
  const CalibrateResult without = calibrate(builder.campaign(), quick());
  builder.level(30, even_lives(3000, 3, 20), Campaign::Role::validation);
  const CalibrateResult with = calibrate(builder.campaign(), quick());
  EXPECT_EQ(with.stress_life->law.scale, without.stress_life->law.scale);
  EXPECT_EQ(with.common_shape->value, without.common_shape->value);
  EXPECT_LT(with.validation[0].p, 0.01);
  EXPECT_THAT(with.warnings, testing::Contains(HasSubstr("validation 30.0 N")));
}

TEST(Calibrate, AUseLevelOutsideTheTestedOnesIsCalledExtrapolation) {
  CampaignBuilder builder = square_law(6);
  builder.use("glove", 10);
  const CalibrateResult result = calibrate(builder.campaign(), quick());
  EXPECT_THAT(
      result.warnings,
      ElementsAre(HasSubstr("use level glove: 10.0 N lies outside of the tested 20.0 to 50.0 N")));
}

}  // namespace
}  // namespace host_sim::calibrate
