#include "tests/statistics/published.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/statistics/fit.hpp"
#include "host_sim/statistics/goodness_of_fit.hpp"

namespace host_sim::statistics {
namespace {

constexpr Distribution kSomeWeibull{.family = Family::weibull, .first = 80, .second = 2};

/// Half a unit in the last of the printed digits after the point.
double rounding(int digits) {
  return 0.5 * std::pow(10.0, -digits) + 1e-9;
}

TEST(Published, BallBearings) {
  const Fit bearings = fit(Family::weibull, published::ball_bearings());
  ASSERT_EQ(bearings.problem, FitProblem::none);
  EXPECT_NEAR(bearings.distribution.first, 81.874559, rounding(6));
  EXPECT_NEAR(bearings.distribution.second, 2.1018469, rounding(7));
  EXPECT_NEAR(bearings.log_likelihood, -113.691959, rounding(6));
}

// The p-values are within four standard errors of 20,000 replicates.
TEST(Published, GoodnessOfFitOfTheBallBearings) {
  const Sample sample = published::ball_bearings();
  const GoodnessOfFit goodness =
      goodness_of_fit(fit(Family::weibull, sample), sample, {.replicates = 20'000});
  EXPECT_NEAR(goodness.ks, 0.15104, rounding(5));
  EXPECT_NEAR(goodness.ad, 0.32851, rounding(5));
  EXPECT_NEAR(goodness.ks_p, 0.173, 0.012);
  EXPECT_NEAR(goodness.ad_p, 0.534, 0.016);
}

// SAS/QC User's Guide, The RELIABILITY Procedure, "Analysis of Right-Censored Data from a Single
// Population".
TEST(Published, GeneratorFans) {
  const Fit fans = fit(Family::weibull, published::generator_fans());
  ASSERT_EQ(fans.problem, FitProblem::none);
  EXPECT_NEAR(fans.distribution.first, 26.2968, rounding(4));
  EXPECT_NEAR(fans.distribution.second, 1.0584, rounding(4));
}

// NIST/SEMATECH e-Handbook 8.4.1.3 prints 606.5280, with an error of 4e-4, from R.
TEST(Published, NistUnits) {
  const Fit units = fit(Family::weibull, published::nist_units());
  ASSERT_EQ(units.problem, FitProblem::none);
  EXPECT_NEAR(units.distribution.first, 606.5280, 1e-3);
  EXPECT_NEAR(units.distribution.second, 1.7208, rounding(4));
  EXPECT_NEAR(units.log_likelihood, -75.135, rounding(3));
  EXPECT_NEAR(units.distribution.mean(), 540.737, 1e-3);
}

struct Estimates {
  double location;  ///< of the life (normal) or of its logarithm
  double scale;
  double log_likelihood;
};

/// Estimates agree as far as the other optimiser went, log likelihoods to the printed digits.
void expect_estimates(Family family, const Sample& sample, Estimates printed) {
  const Fit found = fit(family, sample);
  ASSERT_EQ(found.problem, FitProblem::none);
  const bool weibull = family == Family::weibull;
  const double location = weibull ? std::log(found.distribution.first) : found.distribution.first;
  const double scale = weibull ? 1 / found.distribution.second : found.distribution.second;
  constexpr double kConverged = 1e-5;
  EXPECT_NEAR(location, printed.location, kConverged * printed.location);
  EXPECT_NEAR(scale, printed.scale, kConverged * printed.scale);
  EXPECT_NEAR(found.log_likelihood, printed.log_likelihood, rounding(4));
}

// As R package weibulltools 2.1.0 prints them (tests/testthat/_snaps/ml_estimation.md).
TEST(Published, ShockAbsorbers) {
  const Sample sample = published::shock_absorbers();
  expect_estimates(Family::weibull, sample, {10.2298631, 0.3164092, -123.9954});
  expect_estimates(Family::lognormal, sample, {10.1447710, 0.5300683, -124.6085});
  expect_estimates(Family::normal, sample, {24570.874, 8356.317, -124.2301});
}

TEST(Published, AlloyT7987) {
  const Sample sample = published::alloy_t7987();
  expect_estimates(Family::weibull, sample, {5.2885785, 0.3297364, -376.0949});
  expect_estimates(Family::lognormal, sample, {5.1277862, 0.3276406, -367.0069});
  expect_estimates(Family::normal, sample, {176.89252, 60.01635, -376.5348});
}

// What a reader who takes suspended lives for failures would print is far from it.
TEST(Published, SuspendedAreNotFailures) {
  Sample taken_for_failures = published::generator_fans();
  for (Observation& seen : taken_for_failures) {
    seen.failed = true;
  }
  EXPECT_LT(fit(Family::weibull, taken_for_failures).distribution.first, 26.2968 / 4);
  EXPECT_LT(log_likelihood(kSomeWeibull, taken_for_failures),
            log_likelihood(kSomeWeibull, published::generator_fans()) - 100);
}

}  // namespace
}  // namespace host_sim::statistics
