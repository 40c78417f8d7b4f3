#include "host_sim/statistics/fit.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>

#include "tests/statistics/samples.hpp"

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

}  // namespace
}  // namespace host_sim::statistics
