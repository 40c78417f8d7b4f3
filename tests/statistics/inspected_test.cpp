#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "host_sim/statistics/bootstrap.hpp"
#include "host_sim/statistics/common_shape.hpp"
#include "host_sim/statistics/fit.hpp"
#include "host_sim/statistics/goodness_of_fit.hpp"

namespace host_sim::statistics {
namespace {

Observation broke_between(double from, double to) {
  return {.value = to, .failed = true, .from = from};
}

Observation suspended(double at) {
  return {.value = at, .failed = false};
}

/// A sample of seven of which the lowest and the highest were dropped.
Sample trimmed_sample() {
  return {{.value = 80, .failed = true, .from = 0, .trimmed = true},
          {.value = 80},
          {.value = 90},
          {.value = 100},
          {.value = 115},
          {.value = 120},
          {.value = 120, .failed = false, .trimmed = true}};
}

Sample inspected_sample() {
  return {broke_between(0, 100),   broke_between(100, 200), broke_between(100, 200),
          broke_between(200, 300), {.value = 240},          broke_between(300, 400),
          suspended(300)};
}

// A Weibull life of scale 100 and shape 2 breaks between 50 and 100 with exp(-1/4) - exp(-1), and
// by 50 with 1 - exp(-1/4).
TEST(LifeBetween, AddsTheProbabilityToBreakThere) {
  const Distribution weibull{.family = Family::weibull, .first = 100, .second = 2};
  EXPECT_NEAR(log_likelihood(weibull, Sample{broke_between(50, 100)}),
              std::log(std::exp(-0.25) - std::exp(-1)), 1e-14);
  EXPECT_NEAR(log_likelihood(weibull, Sample{broke_between(0, 50)}), std::log(1 - std::exp(-0.25)),
              1e-14);
}

// Two of five by 10, two between 10 and 20, one longer: F is 2/5 at 10 and 4/5 at 20, which two
// parameters reach: beta = log2(ln 5 / ln(5/3)).
TEST(LifeBetween, AWeibullFitGoesThroughTheSharesAtTwoInspections) {
  const Sample sample{broke_between(0, 10), broke_between(0, 10), broke_between(10, 20),
                      broke_between(10, 20), suspended(20)};
  const double shape = std::log2(std::log(5.0) / std::log(5.0 / 3));
  const Fit found = fit(Family::weibull, sample);
  ASSERT_EQ(found.problem, FitProblem::none);
  EXPECT_NEAR(found.distribution.second, shape, 1e-10);
  EXPECT_NEAR(found.distribution.first, 10 * std::pow(std::log(5.0 / 3), -1 / shape), 1e-9);
  EXPECT_NEAR(found.log_likelihood, 4 * std::log(0.4) + std::log(0.2), 1e-12);
}

// The same shares under a normal distribution: deviates -0.2533471 and 0.8416212 at 10 and 20.
TEST(LifeBetween, ANormalFitGoesThroughTheSharesAtTwoInspections) {
  const Sample sample{broke_between(0, 10), broke_between(0, 10), broke_between(10, 20),
                      broke_between(10, 20), suspended(20)};
  const Fit found = fit(Family::normal, sample);
  ASSERT_EQ(found.problem, FitProblem::none);
  const double sd = 10 / (0.8416212 + 0.2533471);
  EXPECT_NEAR(found.distribution.second, sd, 1e-5);
  EXPECT_NEAR(found.distribution.first, 10 + 0.2533471 * sd, 1e-5);
}

class EveryFamily : public ::testing::TestWithParam<Family> {};

/// The largest of the likelihoods a little beside a distribution, less that of it.
double gain_beside(const Distribution& at, const Sample& sample) {
  double most = -HUGE_VAL;
  for (const double first : {0.999, 1.0, 1.001}) {
    for (const double second : {0.99, 1.0, 1.01}) {
      Distribution beside = at;
      beside.first *= first;
      beside.second *= second;
      if (first != 1 || second != 1) {
        most = std::max(most, log_likelihood(beside, sample) - log_likelihood(at, sample));
      }
    }
  }
  return most;
}

TEST_P(EveryFamily, NothingBesideTheFitIsMoreLikely) {
  for (const Sample& sample : {trimmed_sample(), inspected_sample()}) {
    const Fit found = fit(GetParam(), sample);
    ASSERT_EQ(found.problem, FitProblem::none);
    EXPECT_NEAR(found.log_likelihood, log_likelihood(found.distribution, sample), 1e-9);
    EXPECT_LT(gain_beside(found.distribution, sample), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Families, EveryFamily,
                         ::testing::Values(Family::normal, Family::lognormal, Family::weibull));

// Ends so close that the life is known: the same fit, and the likelihood less ln of the width.
TEST(LifeBetween, NarrowEndsAreAKnownLife) {
  constexpr double kWidth = 1e-4;
  const std::vector<double> lives{70, 85, 100, 104, 131};
  Sample known;
  Sample between;
  for (const double life : lives) {
    known.push_back({.value = life});
    between.push_back(broke_between(life - kWidth / 2, life + kWidth / 2));
  }
  for (const Family family : {Family::normal, Family::lognormal, Family::weibull}) {
    const Fit one = fit(family, known);
    const Fit other = fit(family, between);
    ASSERT_EQ(other.problem, FitProblem::none);
    EXPECT_NEAR(other.distribution.first / one.distribution.first, 1, 1e-6);
    EXPECT_NEAR(other.distribution.second / one.distribution.second, 1, 1e-6);
    EXPECT_NEAR(other.log_likelihood, one.log_likelihood + 5 * std::log(kWidth), 1e-5);
  }
}

TEST(LifeBetween, AllInOneIntervalHaveNoSpread) {
  const Sample sample{broke_between(100, 200), broke_between(50, 150), suspended(100)};
  EXPECT_EQ(fit(Family::weibull, sample).problem, FitProblem::no_spread);
  EXPECT_EQ(fit(Family::weibull, Sample{broke_between(0, 9), broke_between(0, 8)}).problem,
            FitProblem::no_spread);
}

// One shape for two samples of which one is twice the other is that of one, with twice the scale.
TEST(LifeBetween, SamplesShareAShape) {
  const Sample sample = inspected_sample();
  Sample doubled = sample;
  for (Observation& seen : doubled) {
    seen.value *= 2;
    seen.from = seen.from ? std::optional<double>(2 * *seen.from) : std::nullopt;
  }
  const Fit alone = fit(Family::weibull, sample);
  const std::vector<Sample> both{sample, doubled};
  const CommonShapeFit shared = fit_common_shape(both);
  ASSERT_EQ(shared.problem, FitProblem::none);
  EXPECT_NEAR(shared.shape, alone.distribution.second, 1e-8);
  EXPECT_NEAR(shared.scales[1] / shared.scales[0], 2, 1e-8);
  EXPECT_NEAR(shared.log_likelihood, 2 * alone.log_likelihood - std::log(2), 1e-8);
}

// Five kept of seven: density of the 2nd to 6th order statistic, 7!/(1! 1!) F(80) S(120) prod f.
TEST(Trimmed, HasTheDensityOfTheKeptOrderStatistics) {
  const Distribution weibull{.family = Family::weibull, .first = 110, .second = 6};
  double expected = std::log(weibull.cdf(80)) + weibull.log_survival(120);
  for (const double life : {80.0, 90.0, 100.0, 115.0, 120.0}) {
    expected += weibull.log_density(life);
  }
  EXPECT_NEAR(log_likelihood(weibull, trimmed_sample()), expected, 1e-12);
}

TEST(Trimmed, SamplesLikeItAreTrimmedAgain) {
  const Sample sample = trimmed_sample();
  const CensoringPlan plan(sample);
  Sample seen;
  Random random(1, 1, 1);
  plan.observe(std::vector<double>{5, 4, 9, 8, 1, 2, 7}, random, seen);
  const auto is = [&](std::size_t i, double value, bool failed, bool trimmed) {
    EXPECT_EQ(seen[i].value, value) << i;
    EXPECT_EQ(seen[i].failed, failed) << i;
    EXPECT_EQ(seen[i].trimmed, trimmed) << i;
  };
  is(4, 2, true, true);
  EXPECT_EQ(seen[4].from, 0.0);
  is(2, 8, false, true);
  is(0, 5, true, false);
  is(3, 8, true, false);
  EXPECT_TRUE(seen[3].exact());
}

// Median ranks of n = 7 without the first and the last; see Benard.
TEST(Trimmed, PlacesKeepTheirRanks) {
  const auto positions = plotting_positions(trimmed_sample());
  ASSERT_EQ(positions.size(), 5U);
  EXPECT_NEAR(positions[0].p, 1.7 / 7.4, 1e-12);
  EXPECT_EQ(positions[0].life, 80);
  EXPECT_NEAR(positions[4].p, 5.7 / 7.4, 1e-12);
}

// F = x / 140 against shares 1/7 .. 6/7 of the seven: largest at 80, where 4/7 stand against 1/7.
TEST(Trimmed, DistancesBeginAtTheFirstThatWasKept) {
  const Distribution steep{.family = Family::weibull, .first = 1, .second = 1};
  EXPECT_NEAR(kolmogorov_smirnov(steep, trimmed_sample()), 6.0 / 7, 1e-12);
  const Distribution late{.family = Family::weibull, .first = 1e9, .second = 1};
  EXPECT_NEAR(kolmogorov_smirnov(late, trimmed_sample()), 6.0 / 7, 1e-6);
  // Nothing says that the share below 80 is 0: a distribution of 1/7 there is as near as can be.
  const Distribution through{
      .family = Family::weibull, .first = 80 / std::pow(-std::log(6.0 / 7), 0.1), .second = 10};
  EXPECT_LT(kolmogorov_smirnov(through, trimmed_sample()), 0.5);
}

// Inspections every 100 from 100 on; a life of 520 was not broken at 500 and was at 600.
TEST(Inspections, GoOnAsTheyWere) {
  const CensoringPlan plan(inspected_sample());
  Sample seen;
  Random random(1, 1, 1);
  plan.observe(std::vector<double>{30, 150, 520, 200, 333.3, 290, 100}, random, seen);
  EXPECT_EQ(seen[0].from, 0.0);
  EXPECT_EQ(seen[0].value, 100);
  EXPECT_EQ(seen[1].from, 100.0);
  EXPECT_EQ(seen[1].value, 200);
  EXPECT_EQ(seen[3].from, 100.0);
  EXPECT_EQ(seen[6].from, 0.0);
  EXPECT_EQ(seen[6].value, 100);
}

TEST(Inspections, WereThereBeforeTheFirstThatFoundOneBroken) {
  const Sample sample{broke_between(300, 400), broke_between(600, 700)};
  const CensoringPlan plan(sample);
  Sample seen;
  Random random(1, 1, 1);
  plan.observe(std::vector<double>{150, 450}, random, seen);
  EXPECT_EQ(seen[0].from, 100.0);
  EXPECT_EQ(seen[0].value, 200);
  EXPECT_EQ(seen[1].from, 400.0);
  EXPECT_EQ(seen[1].value, 500);
}

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) {
    sum += value / static_cast<double>(values.size());
  }
  return sum;
}

// Of 22 lives of shape 5 the lowest and highest are dropped. The mean of the shape in a simulation
// by another program: 1.30 times the truth by a fit that does not know of it, 1.09 by one that
// does.
TEST(Trimmed, AFitThatKnowsOfItIsNearTheTruth) {
  constexpr std::size_t kDraws = 3000;
  Sample like(20, Observation{.value = 100});
  like.push_back({.value = 100, .failed = true, .from = 0, .trimmed = true});
  like.push_back({.value = 100, .failed = false, .trimmed = true});
  const CensoringPlan plan(like);
  const Distribution truth{.family = Family::weibull, .first = 1000, .second = 5};
  std::vector<double> knowing;
  std::vector<double> ignoring;
  Random random(1, 2, 3);
  Sample drawn;
  for (std::size_t i = 0; i < kDraws; ++i) {
    plan.draw(truth, random, drawn);
    knowing.push_back(fit(Family::weibull, drawn).distribution.second / 5);
    std::erase_if(drawn, [](const Observation& seen) { return seen.trimmed; });
    ignoring.push_back(fit(Family::weibull, drawn).distribution.second / 5);
  }
  EXPECT_NEAR(mean_of(knowing), 1.09, 0.02);
  EXPECT_NEAR(mean_of(ignoring), 1.30, 0.02);
}

}  // namespace
}  // namespace host_sim::statistics
