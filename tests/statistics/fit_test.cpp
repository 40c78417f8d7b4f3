#include "host_sim/statistics/fit.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>

#include "host_sim/statistics/goodness_of_fit.hpp"
#include "tests/statistics/samples.hpp"
#include "tests/statistics/survreg.hpp"

namespace host_sim::statistics {
namespace {

constexpr std::array<Family, 3> kFamilies{Family::normal, Family::lognormal, Family::weibull};

/// Lives around `scale` with at least two different failures; some are suspended.
Sample random_sample(double scale) {
  const auto count = *rc::gen::inRange<std::size_t>(2, 30);
  const auto draw = [&] { return scale * (1 + *rc::gen::inRange(0, 1'000'000)) / 300'000.0; };
  Sample sample = failed({scale * 0.7, scale * 1.3});
  while (sample.size() < count) {
    sample.push_back({.value = draw(), .failed = *rc::gen::inRange(0, 4) != 0});
  }
  return sample;
}

Sample transformed(Sample sample, double factor, double power) {
  for (Observation& seen : sample) {
    seen.value = factor * std::pow(seen.value, power);
  }
  return sample;
}

// With u = beta / 2 the likelihood equation of the lives 1 and e is u tanh(u) = 1, whose root is
// 1.1996786402577338; alpha^beta = (1 + e^beta) / 2.
TEST(Fit, WeibullOfTwoFailures) {
  const Fit found = fit(Family::weibull, failed({1, std::exp(1)}));
  ASSERT_EQ(found.problem, FitProblem::none);
  constexpr double kShape = 2 * 1.1996786402577338;
  EXPECT_NEAR(found.distribution.second, kShape, 1e-13);
  EXPECT_NEAR(found.distribution.first, std::pow((1 + std::exp(kShape)) / 2, 1 / kShape), 1e-13);
}

TEST(Fit, NormalOfFailuresHasTheirMoments) {
  const Fit found = fit(Family::normal, failed({2, 4, 4, 4, 5, 5, 7, 9}));
  ASSERT_EQ(found.problem, FitProblem::none);
  EXPECT_DOUBLE_EQ(found.distribution.first, 5);
  EXPECT_DOUBLE_EQ(found.distribution.second, 2);
  EXPECT_DOUBLE_EQ(found.log_likelihood, -8 * (0.5 * std::log(8 * std::acos(-1.0)) + 0.5));
}

TEST(Fit, NormalTakesNegativeLives) {
  const Fit found = fit(Family::normal, failed({-3, -1, 1, 3}));
  ASSERT_EQ(found.problem, FitProblem::none);
  EXPECT_NEAR(found.distribution.first, 0, 1e-15);
  EXPECT_DOUBLE_EQ(found.distribution.second, std::sqrt(5.0));
}

TEST(Fit, TooFewFailures) {
  for (const Family family : kFamilies) {
    EXPECT_EQ(fit(family, Sample{}).problem, FitProblem::too_few_failures);
    EXPECT_EQ(fit(family, failed({5})).problem, FitProblem::too_few_failures);
    EXPECT_EQ(fit(family, with_suspended({}, {5, 6, 7})).problem, FitProblem::too_few_failures);
    EXPECT_EQ(fit(family, with_suspended({5}, {5, 6})).problem, FitProblem::too_few_failures);
  }
}

// With the scale at the life, the likelihood rises without end as the distribution narrows.
TEST(Fit, FailuresAtOneLife) {
  for (const Family family : kFamilies) {
    EXPECT_EQ(fit(family, failed({5, 5, 5})).problem, FitProblem::no_spread);
    EXPECT_EQ(fit(family, with_suspended({5, 5}, {3, 5})).problem, FitProblem::no_spread);
    EXPECT_EQ(fit(family, failed({0.1, 0.1, 0.1})).problem, FitProblem::no_spread);
  }
}

TEST(Fit, ASuspendedSpecimenBeyondGivesFailuresAtOneLifeASpread) {
  for (const Family family : kFamilies) {
    const Sample sample = with_suspended({5, 5}, {6});
    const Fit found = fit(family, sample);
    ASSERT_EQ(found.problem, FitProblem::none);
    for (const double factor : {0.999, 1.001}) {
      Distribution wider = found.distribution;
      wider.second *= factor;
      EXPECT_LT(log_likelihood(wider, sample), found.log_likelihood);
    }
  }
}

TEST(Fit, ShapesAndLivesOfAnySize) {
  for (const double shape : {0.05, 0.5, 5.0, 500.0}) {
    for (const double scale : {1e-6, 1.0, 1e12}) {
      const Fit found = fit(Family::weibull, ideal_weibull(scale, shape, 1000));
      ASSERT_EQ(found.problem, FitProblem::none);
      EXPECT_NEAR(found.distribution.second / shape, 1, 0.01);
      EXPECT_NEAR(std::log(found.distribution.first / scale) * shape, 0, 0.01);
    }
  }
}

TEST(Fit, FewFailuresAmongManySuspended) {
  Sample sample = failed({90, 110});
  sample.insert(sample.end(), 2000, {.value = 100, .failed = false});
  for (const Family family : kFamilies) {
    const Fit found = fit(family, sample);
    ASSERT_EQ(found.problem, FitProblem::none);
    EXPECT_NEAR(found.log_likelihood, log_likelihood(found.distribution, sample), 1e-9);
  }
}

RC_GTEST_PROP(FitProperty, NoNeighbourIsMoreLikely, ()) {
  const Sample sample = random_sample(1000);
  for (const Family family : kFamilies) {
    const Fit found = fit(family, sample);
    RC_ASSERT(found.problem == FitProblem::none);
    const double rounding = 1e-12 * (1 + std::abs(found.log_likelihood));
    RC_ASSERT(std::abs(log_likelihood(found.distribution, sample) - found.log_likelihood) <=
              rounding);
    for (const double step : {-1e-3, 1e-3}) {
      Distribution shifted = found.distribution;
      shifted.first *= 1 + step;
      RC_ASSERT(log_likelihood(shifted, sample) < found.log_likelihood + rounding);
      Distribution widened = found.distribution;
      widened.second *= 1 + step;
      RC_ASSERT(log_likelihood(widened, sample) < found.log_likelihood + rounding);
    }
  }
}

RC_GTEST_PROP(FitProperty, WeibullScalesWithTheLives, ()) {
  const Sample sample = random_sample(1);
  const double factor = std::pow(10.0, *rc::gen::inRange(-6, 13));
  const Distribution one = fit(Family::weibull, sample).distribution;
  const Distribution scaled = fit(Family::weibull, transformed(sample, factor, 1)).distribution;
  RC_ASSERT(std::abs(scaled.first / (factor * one.first) - 1) < 1e-11);
  RC_ASSERT(std::abs(scaled.second / one.second - 1) < 1e-10);
}

RC_GTEST_PROP(FitProperty, APowerOfTheLivesDividesTheShape, ()) {
  const Sample sample = random_sample(1);
  const double power = *rc::gen::inRange(1, 500) / 50.0;
  const Distribution one = fit(Family::weibull, sample).distribution;
  const Distribution raised = fit(Family::weibull, transformed(sample, 1, power)).distribution;
  RC_ASSERT(std::abs(raised.second * power / one.second - 1) < 1e-9);
  RC_ASSERT(std::abs(std::log(raised.first) - power * std::log(one.first)) < 1e-9 * power);
}

RC_GTEST_PROP(FitProperty, LognormalIsNormalOfTheLogarithms, ()) {
  const Sample sample = random_sample(1000);
  Sample logarithms = sample;
  double jacobian = 0;
  for (Observation& seen : logarithms) {
    seen.value = std::log(seen.value);
    jacobian += seen.failed ? seen.value : 0;
  }
  const Fit lognormal = fit(Family::lognormal, sample);
  const Fit normal = fit(Family::normal, logarithms);
  RC_ASSERT(lognormal.distribution.first == normal.distribution.first);
  RC_ASSERT(lognormal.distribution.second == normal.distribution.second);
  RC_ASSERT(std::abs(lognormal.log_likelihood - (normal.log_likelihood - jacobian)) < 1e-9);
}

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

std::vector<survreg::Row> rows_of(const Sample& sample) {
  std::vector<survreg::Row> rows;
  for (const Observation& seen : sample) {
    rows.push_back({.life = seen.value, .failed = seen.failed});
  }
  return rows;
}

/// Six digits of a number.
double six_digits(double value) {
  return 1e-6 * std::abs(value);
}

/// The same parameters as survreg has: location and scale of the life or of its logarithm.
struct LocationScale {
  double location;
  double scale;
};
LocationScale location_scale(const Distribution& distribution) {
  if (distribution.family == Family::weibull) {
    return {.location = std::log(distribution.first), .scale = 1 / distribution.second};
  }
  return {.location = distribution.first, .scale = distribution.second};
}

void expect_as_survreg(const Sample& sample) {
  const std::array<std::string, 3> names{"gaussian", "lognormal", "weibull"};
  const std::array<Family, 3> families{Family::normal, Family::lognormal, Family::weibull};
  const std::vector<survreg::Fit> theirs = survreg::fit(rows_of(sample), "1", names);
  for (std::size_t i = 0; i < families.size(); ++i) {
    SCOPED_TRACE(names[i]);
    const Fit ours = fit(families[i], sample);
    ASSERT_EQ(ours.problem, FitProblem::none);
    EXPECT_NEAR(ours.log_likelihood, theirs[i].log_likelihood,
                six_digits(theirs[i].log_likelihood));
    const auto [location, scale] = location_scale(ours.distribution);
    EXPECT_NEAR(location, theirs[i].coefficients.at(0), six_digits(location));
    EXPECT_NEAR(scale, theirs[i].scale, six_digits(scale));
  }
}

TEST(Survreg, FindsTheSameMaximum) {
  if (!survreg::available()) {
    GTEST_SKIP() << "Rscript with package survival is not installed (Debian: r-cran-survival)";
  }
  expect_as_survreg(published::ball_bearings());
  expect_as_survreg(published::generator_fans());
  expect_as_survreg(published::nist_units());
  expect_as_survreg(published::shock_absorbers());
  expect_as_survreg(published::alloy_t7987());
}

}  // namespace
}  // namespace host_sim::statistics
