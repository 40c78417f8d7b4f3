#include "host_sim/calibrate/validation.hpp"

#include <gtest/gtest.h>

#include <boost/math/distributions/gamma.hpp>
#include <cmath>

namespace host_sim::calibrate {
namespace {

// Lives of shape 1 are exponential, so the mean of n of them, times n, has a gamma distribution.
constexpr LifeLaw kExponential{1000, 1, 1};
constexpr double kTension_N = 10;  // alpha = 100 cycles
constexpr std::size_t kReplicates = 20'000;

life_law::LifeData lives(const std::vector<double>& cycles) {
  life_law::LifeData data;
  for (const double life : cycles) {
    data.push_back({{{kTension_N, life}}, true, 0});
  }
  return data;
}

CalibrateOptions validation_options() {
  CalibrateOptions options;
  options.bootstraps = kReplicates;
  return options;
}

TEST(Validation, WithACertainLawThePValueIsThatOfTheGammaDistribution) {
  const std::vector<LifeLaw> certain(kReplicates, kExponential);
  const auto result =
      validate(lives({150, 200, 180, 220, 100}), kExponential, certain, 0, validation_options());
  ASSERT_TRUE(result.has_value());
  EXPECT_DOUBLE_EQ(result->predicted_mean, 1);
  EXPECT_DOUBLE_EQ(result->measured_mean, 1.7);
  const boost::math::gamma_distribution<> sum(5, 1);
  const double expected = 2 * boost::math::cdf(boost::math::complement(sum, 5 * 1.7));
  EXPECT_NEAR(result->p, expected, 4 * 2 * std::sqrt(expected / 2 / kReplicates));
  EXPECT_NEAR(result->ratio_ci95.low, 1.7 / (boost::math::quantile(sum, 0.975) / 5), 0.03);
  EXPECT_NEAR(result->ratio_ci95.high, 1.7 / (boost::math::quantile(sum, 0.025) / 5), 0.15);
}

TEST(Validation, AnUncertainLawRefutesLess) {
  std::vector<LifeLaw> uncertain(kReplicates, kExponential);
  for (std::size_t i = 0; i < uncertain.size(); ++i) {
    uncertain[i].scale *= i % 2 == 0 ? 0.7 : 1.4;
  }
  const std::vector<LifeLaw> certain(kReplicates, kExponential);
  const life_law::LifeData data = lives({150, 200, 180, 220, 100});
  EXPECT_GT(validate(data, kExponential, uncertain, 0, validation_options())->p,
            1.3 * validate(data, kExponential, certain, 0, validation_options())->p);
}

TEST(Validation, CountsFailuresInTheBand) {
  const std::vector<LifeLaw> certain(100, kExponential);
  // B10 is 100 * 0.10536, B90 is 100 * 2.30259.
  const auto result =
      validate(lives({10, 11, 100, 230, 231}), kExponential, certain, 0, validation_options());
  EXPECT_EQ(result->below_b10, 1U);
  EXPECT_EQ(result->inside_b10_b90, 3U);
  EXPECT_EQ(result->above_b90, 1U);
}

TEST(Validation, SaysWhatItCannotSay) {
  const std::vector<LifeLaw> certain(kReplicates, kExponential);
  const auto near = validate(lives({90, 110, 100}), kExponential, certain, 0, validation_options());
  EXPECT_NE(near->words.find("not refuted, and not proved either"), std::string::npos);
  const auto far =
      validate(lives({900, 1100, 1000}), kExponential, certain, 0, validation_options());
  EXPECT_NE(far->words.find("the law is refuted here at 5 %"), std::string::npos);
}

TEST(Validation, NothingWithoutAFailure) {
  life_law::LifeData data = lives({50, 60});
  data[0].failed = data[1].failed = false;
  const std::vector<LifeLaw> certain(100, kExponential);
  EXPECT_FALSE(validate(data, kExponential, certain, 0, validation_options()).has_value());
}

// alpha is 100 cycles at 10 N and 25 at 20 N.
constexpr life_law::LifeLaw kLaw{10'000, 2, 2};

TEST(Damage, AddsTheSharesOfEachBlock) {
  EXPECT_DOUBLE_EQ(damage({{{10, 50}, {20, 5}}, true, 0}, kLaw), 0.5 + 0.2);
}

TEST(Damage, MeanIsTheAverageWhereAllFailed) {
  const life_law::LifeData data{{{{10, 50}}, true, 0}, {{{20, 25}}, true, 0}};
  EXPECT_DOUBLE_EQ(mean_damage(data, kLaw), 0.75);
}

TEST(Damage, MeanWithSuspendedIsByMaximumLikelihood) {
  const life_law::LifeData data{{{{10, 60}}, true, 0}, {{{10, 80}}, false, 0}};
  // scale = sqrt((0.36 + 0.64) / 1), mean = scale * Gamma(1.5) = sqrt(pi) / 2.
  EXPECT_NEAR(mean_damage(data, kLaw), std::sqrt(std::acos(-1.0)) / 2, 1e-15);
}

TEST(Damage, MeanWithoutFailureIsNotANumber) {
  const life_law::LifeData data{{{{10, 60}}, false, 0}};
  EXPECT_TRUE(std::isnan(mean_damage(data, kLaw)));
}

}  // namespace
}  // namespace host_sim::calibrate
