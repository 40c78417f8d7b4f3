#include "host_sim/statistics/distribution.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "tests/statistics/samples.hpp"

namespace host_sim::statistics {
namespace {

constexpr Distribution kExponential{.family = Family::weibull, .first = 2, .second = 1};
constexpr Distribution kWeibull{.family = Family::weibull, .first = 850, .second = 6};
constexpr Distribution kNormal{.family = Family::normal, .first = 10, .second = 2};
constexpr Distribution kLognormal{.family = Family::lognormal, .first = 1, .second = 0.5};

TEST(Distribution, WeibullOfShapeOneIsExponential) {
  EXPECT_DOUBLE_EQ(kExponential.cdf(2), 1 - std::exp(-1));
  EXPECT_DOUBLE_EQ(kExponential.log_density(3), -std::numbers::ln2 - 1.5);
  EXPECT_DOUBLE_EQ(kExponential.log_survival(3), -1.5);
  EXPECT_DOUBLE_EQ(kExponential.quantile(0.75), 4 * std::numbers::ln2);
  EXPECT_DOUBLE_EQ(kExponential.mean(), 2);
}

TEST(Distribution, WeibullAtItsScale) {
  EXPECT_DOUBLE_EQ(kWeibull.cdf(850), 1 - std::exp(-1));
  EXPECT_DOUBLE_EQ(kWeibull.log_density(850), std::log(6.0 / 850) - 1);
}

// Gamma(3/2) = sqrt(pi) / 2.
TEST(Distribution, MeanOfARayleighLife) {
  const Distribution rayleigh{.family = Family::weibull, .first = 4, .second = 2};
  EXPECT_DOUBLE_EQ(rayleigh.mean(), 2 * std::sqrt(std::numbers::pi));
}

// 1.2815515655446008 is the 90 % point of the standard normal distribution.
TEST(Distribution, NormalQuantiles) {
  EXPECT_DOUBLE_EQ(kNormal.quantile(0.5), 10);
  EXPECT_NEAR(kNormal.quantile(0.9), 10 + 2 * 1.2815515655446008, 1e-14);
  EXPECT_NEAR(kNormal.quantile(1e-10), 10 - 2 * 6.3613409024040557, 1e-13);
  EXPECT_DOUBLE_EQ(kNormal.cdf(10), 0.5);
  EXPECT_DOUBLE_EQ(kNormal.mean(), 10);
}

TEST(Distribution, LognormalIsNormalInTheLogarithm) {
  EXPECT_DOUBLE_EQ(kLognormal.quantile(0.5), std::numbers::e);
  EXPECT_DOUBLE_EQ(kLognormal.cdf(std::numbers::e), 0.5);
  EXPECT_DOUBLE_EQ(kLognormal.mean(), std::exp(1.125));
  const Distribution of_log{.family = Family::normal, .first = 1, .second = 0.5};
  EXPECT_DOUBLE_EQ(kLognormal.log_density(7), of_log.log_density(std::log(7)) - std::log(7));
}

TEST(Distribution, NothingFailsAtOrBelowZeroUnlessNormal) {
  for (const Distribution& positive : {kWeibull, kLognormal}) {
    for (const double life : {0.0, -5.0}) {
      EXPECT_EQ(positive.cdf(life), 0);
      EXPECT_EQ(positive.log_survival(life), 0);
      EXPECT_EQ(positive.log_density(life), -kInfinity);
    }
  }
  EXPECT_GT(kNormal.cdf(-5), 0);
}

TEST(Distribution, EndsOfTheQuantiles) {
  EXPECT_EQ(kWeibull.quantile(0), 0);
  EXPECT_EQ(kWeibull.quantile(1), kInfinity);
  EXPECT_EQ(kLognormal.quantile(0), 0);
  EXPECT_EQ(kNormal.quantile(0), -kInfinity);
  EXPECT_EQ(kNormal.quantile(1), kInfinity);
}

TEST(Distribution, QuantilesInvertTheDistribution) {
  for (const Distribution& distribution : {kExponential, kWeibull, kNormal, kLognormal}) {
    for (const double p : {1e-12, 1e-3, 0.1, 0.5, 0.9, 0.999}) {
      EXPECT_NEAR(distribution.cdf(distribution.quantile(p)) / p, 1, 1e-11);
    }
  }
}

// A hazard of 1e-18 is lost in 1 - exp(-H), and a survival of exp(-1000) underflows.
TEST(Distribution, TailsKeepTheirDigits) {
  const Distribution cubic{.family = Family::weibull, .first = 1, .second = 3};
  EXPECT_NEAR(cubic.cdf(1e-6) / 1e-18, 1, 1e-12);
  EXPECT_NEAR(cubic.log_survival(10), -1000, 1e-10);
  EXPECT_NEAR(cubic.quantile(1e-18), 1e-6, 1e-18);
}

// ln Q(z) from R: pnorm(z, lower.tail = FALSE, log.p = TRUE).
TEST(NormalTail, LogarithmOfTheUpperTail) {
  struct Point {
    double z;
    double log_survival;
  };
  constexpr std::array<Point, 4> kPoints{{{40, -804.6084420137538},
                                          {12, -75.410673001568796},
                                          {1.5, -2.7059444008238898},
                                          {-8, -6.2209605742717868e-16}}};
  for (const Point& point : kPoints) {
    EXPECT_NEAR(log_normal_survival(point.z) / point.log_survival, 1, 1e-13) << point.z;
  }
  EXPECT_DOUBLE_EQ(log_normal_survival(0), -std::numbers::ln2);
}

TEST(NormalTail, NoStepWhereTheMethodChanges) {
  constexpr double kBelow = 10 - 1e-12;
  EXPECT_NEAR(log_normal_survival(kBelow), log_normal_survival(10), 1e-10);
  EXPECT_NEAR(normal_hazard(kBelow), normal_hazard(10), 1e-11);
}

// phi(0) / Q(0) = sqrt(2 / pi); far out the hazard is z + 1/z - 2/z^3 + ...
TEST(NormalTail, Hazard) {
  EXPECT_DOUBLE_EQ(normal_hazard(0), std::sqrt(2 / std::numbers::pi));
  EXPECT_NEAR(normal_hazard(1000), 1000 + 1e-3 - 2e-9, 1e-10);
  EXPECT_EQ(normal_hazard(-50), 0);
}

TEST(LogLikelihood, AddsDensitiesOfFailuresAndSurvivalOfTheSuspended) {
  const Sample sample{{.value = 3, .failed = true}, {.value = 5, .failed = false}};
  EXPECT_DOUBLE_EQ(log_likelihood(kExponential, sample), -std::numbers::ln2 - 1.5 - 2.5);
}

KaplanMeier estimate_of(const Sample& sample) {
  KaplanMeier estimate;
  estimate.assign(sample);
  return estimate;
}

// Maintained group of acute myelogenous leukaemia: Miller, Survival Analysis (1981), p. 49; R
// package survival prints these survivals for its data set aml.
TEST(KaplanMeier, MaintainedLeukaemia) {
  const KaplanMeier estimate =
      estimate_of(with_suspended({9, 13, 18, 23, 31, 34, 48}, {13, 28, 45, 161}));
  constexpr std::array<double, 7> kSurvival{0.909, 0.818, 0.716, 0.614, 0.491, 0.368, 0.184};
  ASSERT_EQ(estimate.steps().size(), kSurvival.size());
  double before = 0;
  for (std::size_t i = 0; i < kSurvival.size(); ++i) {
    EXPECT_NEAR(1 - estimate.steps()[i].after, kSurvival[i], 0.0005);
    EXPECT_DOUBLE_EQ(estimate.steps()[i].before, before);
    before = estimate.steps()[i].after;
  }
  EXPECT_EQ(estimate.last(), 161);
  EXPECT_FALSE(estimate.complete());
}

TEST(KaplanMeier, FailuresAloneAreTheirEmpiricalDistribution) {
  const KaplanMeier estimate = estimate_of(failed({3, 1, 2, 2}));
  ASSERT_EQ(estimate.steps().size(), 3U);
  EXPECT_EQ(estimate.steps()[1].value, 2);
  EXPECT_DOUBLE_EQ(estimate.steps()[1].before, 0.25);
  EXPECT_DOUBLE_EQ(estimate.steps()[1].after, 0.75);
  EXPECT_TRUE(estimate.complete());
}

// Of the three at risk at 2 one fails; the one suspended there was still at risk.
TEST(KaplanMeier, SuspendedAtALifeAreAtRiskForFailuresThere) {
  const KaplanMeier estimate = estimate_of(with_suspended({1, 2}, {2, 3}));
  EXPECT_DOUBLE_EQ(estimate.steps()[1].after, 0.5);
}

TEST(KaplanMeier, ForgetsTheSampleBefore) {
  KaplanMeier estimate = estimate_of(failed({3, 1, 2, 2}));
  estimate.assign(with_suspended({}, {7}));
  EXPECT_TRUE(estimate.steps().empty());
  EXPECT_EQ(estimate.size(), 1);
  EXPECT_EQ(estimate.last(), 7);
}

/// From tables of t at 0.975.
TEST(Student95, IsAsInTables) {
  EXPECT_NEAR(student95(1), 12.706, 5e-4);
  EXPECT_NEAR(student95(9), 2.262, 5e-4);
  EXPECT_NEAR(student95(1e6), kNormal95, 1e-5);
}

/// A median of 2 is that of a standard deviation of 2 / 0.67449.
TEST(OutlierLimit, IsFourStandardDeviationsWhateverIsFarOff) {
  EXPECT_NEAR(outlier_limit({3, 1, 2}), 4 * 2 / 0.67449, 1e-3);
  EXPECT_EQ(outlier_limit({1e9, 1, 2}), outlier_limit({3, 1, 2}));
}

}  // namespace
}  // namespace host_sim::statistics
