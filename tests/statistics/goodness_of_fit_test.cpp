#include "host_sim/statistics/goodness_of_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "host_sim/statistics/common_shape.hpp"
#include "tests/statistics/samples.hpp"

namespace host_sim::statistics {
namespace {

/// Uniform from 0 to 1 as far as a sample inside can tell: exponential of the survival 1 - x.
constexpr Distribution kUnitExponential{.family = Family::weibull, .first = 1, .second = 1};

double life_at(double p) {
  return -std::log1p(-p);
}

// Heights 0.2 and 0.9 of the distribution against steps 0 - 1/2 - 1: the largest gap is 0.4 below
// the second step.
TEST(KolmogorovSmirnov, LargestGapAtTheSteps) {
  EXPECT_NEAR(kolmogorov_smirnov(kUnitExponential, failed({life_at(0.2), life_at(0.9)})), 0.4,
              1e-15);
  EXPECT_NEAR(kolmogorov_smirnov(kUnitExponential, failed({life_at(0.6), life_at(0.9)})), 0.6,
              1e-15);
  EXPECT_NEAR(kolmogorov_smirnov(kUnitExponential, failed({life_at(0.1), life_at(0.2)})), 0.8,
              1e-15);
}

// The estimate stays at 1/2 up to the suspended specimen, where the distribution is at 0.95.
TEST(KolmogorovSmirnov, UpToTheLastSuspended) {
  const Sample sample = with_suspended({life_at(0.3)}, {life_at(0.95)});
  EXPECT_NEAR(kolmogorov_smirnov(kUnitExponential, sample), 0.45, 1e-15);
}

/// A^2 as Anderson and Darling compute it: -n - sum (2 i - 1) (ln F_i + ln(1 - F_(n+1-i))) / n.
double classical(const std::vector<double>& heights) {
  const std::size_t n = heights.size();
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    sum +=
        static_cast<double>(2 * i + 1) * (std::log(heights[i]) + std::log1p(-heights[n - 1 - i]));
  }
  return -static_cast<double>(n) - sum / static_cast<double>(n);
}

TEST(AndersonDarling, ClassicalWithoutSuspended) {
  EXPECT_NEAR(anderson_darling(kUnitExponential, failed({life_at(0.5)})), 2 * std::numbers::ln2 - 1,
              1e-14);
  EXPECT_NEAR(
      anderson_darling(kUnitExponential, failed({life_at(0.1), life_at(0.35), life_at(0.8)})),
      classical({0.1, 0.35, 0.8}), 1e-13);
  EXPECT_NEAR(
      anderson_darling(kUnitExponential, failed({life_at(0.4), life_at(0.4), life_at(0.8)})),
      classical({0.4, 0.4, 0.8}), 1e-13);
}

/// The integral of the definition by midpoints, where the estimate is 0, 1/3 and 2/3 below the
/// heights 0.2, 0.5 and 0.9.
double integral_by_midpoints() {
  constexpr int kParts = 90'000;
  double sum = 0;
  for (int i = 0; i < kParts; ++i) {
    const double height = (i + 0.5) * 0.9 / kParts;
    const double share = (height > 0.2 ? 1.0 / 3 : 0) + (height > 0.5 ? 1.0 / 3 : 0);
    sum += (share - height) * (share - height) / (height * (1 - height)) * 0.9 / kParts;
  }
  return sum;
}

TEST(AndersonDarling, IntegralUpToTheLastSuspended) {
  const Sample sample = with_suspended({life_at(0.2), life_at(0.5)}, {life_at(0.9)});
  EXPECT_NEAR(anderson_darling(kUnitExponential, sample), 3 * integral_by_midpoints(), 1e-7);
}

TEST(AndersonDarling, InfiniteWhereTheDistributionCannotBe) {
  const Distribution narrow{.family = Family::normal, .first = 1000, .second = 1};
  EXPECT_GT(anderson_darling(narrow, failed({900, 950, 1000})), 1e3);
  EXPECT_FALSE(std::isnan(anderson_darling(narrow, failed({1, 2, 3, 4}))));
}

// Naive tables are for a distribution known beforehand: their 5 % point at n = 20 is 0.29408
// (Massey 1951). Of samples compared with their own fits almost none are as far; their 5 % point
// times sqrt(20) is 0.846 with an error of 0.003, by a simulation in R.
TEST(KolmogorovSmirnov, FitsAreCloserThanNaiveTablesKnow) {
  const std::vector<double> distances = simulated(20'000, [](Random& random) {
    const Sample drawn = drawn_from(kUnitExponential, 20, random);
    return kolmogorov_smirnov(fit(Family::weibull, drawn).distribution, drawn);
  });
  EXPECT_NEAR(quantile_of(distances, 0.95) * std::sqrt(20), 0.846, 0.015);
  const auto naive = std::count_if(distances.begin(), distances.end(),
                                   [](double distance) { return distance > 0.29408; });
  EXPECT_LE(naive, 10);
}

TEST(GoodnessOfFit, RejectsWhatIsNotInTheFamily) {
  const Sample sample = drawn_from({.family = Family::weibull, .first = 1, .second = 0.3}, 60, 5);
  const GoodnessOfFit goodness =
      goodness_of_fit(fit(Family::normal, sample), sample, {.replicates = 999});
  EXPECT_EQ(goodness.ks_p, 0.001);
  EXPECT_EQ(goodness.ad_p, 0.001);
}

TEST(GoodnessOfFit, SameSeedSameAnswerForAnyThreads) {
  const Sample sample = with_suspended({3, 5, 6, 8, 9, 11}, {4, 7, 12});
  const Fit fitted = fit(Family::lognormal, sample);
  const auto run = [&](std::uint64_t seed, unsigned threads) {
    return goodness_of_fit(fitted, sample,
                           {.seed = seed, .stream = 4, .replicates = 333, .threads = threads});
  };
  const GoodnessOfFit alone = run(1, 1);
  const GoodnessOfFit many = run(1, 3);
  EXPECT_EQ(alone.ks_p, many.ks_p);
  EXPECT_EQ(alone.ad_p, many.ad_p);
  EXPECT_NE(alone.ad_p, run(2, 1).ad_p);
}

// With two failures of many suspended, replicates with fewer than two failures are left out.
TEST(GoodnessOfFit, CountsReplicatesThatCouldBeFitted) {
  const Sample sample = with_suspended({3, 5}, {6, 6, 6, 6, 6, 6});
  const GoodnessOfFit goodness =
      goodness_of_fit(fit(Family::weibull, sample), sample, {.replicates = 500});
  EXPECT_GT(goodness.ks_p, 0.01);
  EXPECT_LE(goodness.ks_p, 1);
}

constexpr std::array<double, 3> kShares{0.1, 0.5, 0.9};
constexpr Distribution kTruth{.family = Family::weibull, .first = 500, .second = 6};

QuantileBand band_of(const Sample& sample, BootstrapOptions options) {
  return weibull_quantile_band(fit(Family::weibull, sample), sample, kShares, 0.95, options);
}

TEST(QuantileBand, HoldsTheFit) {
  const Sample sample = with_suspended({310, 420, 450, 520, 600}, {500, 640});
  const Distribution fitted = fit(Family::weibull, sample).distribution;
  const QuantileBand band = band_of(sample, {.replicates = 1000});
  ASSERT_EQ(band.p, std::vector<double>(kShares.begin(), kShares.end()));
  for (std::size_t i = 0; i < kShares.size(); ++i) {
    EXPECT_LT(band.low[i], fitted.quantile(kShares[i]));
    EXPECT_GT(band.high[i], fitted.quantile(kShares[i]));
  }
}

TEST(QuantileBand, ScalesWithTheLives) {
  const QuantileBand band = band_of(failed({3, 4, 5, 7}), {.replicates = 500});
  const QuantileBand scaled = band_of(failed({30, 40, 50, 70}), {.replicates = 500});
  for (std::size_t i = 0; i < kShares.size(); ++i) {
    EXPECT_NEAR(scaled.low[i] / band.low[i], 10, 1e-8);
    EXPECT_NEAR(scaled.high[i] / band.high[i], 10, 1e-8);
  }
}

TEST(QuantileBand, SameSeedSameAnswerForAnyThreads) {
  const Sample sample = with_suspended({310, 420, 450, 520, 600}, {500, 640});
  const QuantileBand alone = band_of(sample, {.replicates = 333, .threads = 1});
  const QuantileBand many = band_of(sample, {.replicates = 333, .threads = 3});
  EXPECT_EQ(alone.low, many.low);
  EXPECT_EQ(alone.high, many.high);
}

/// Share of bands that hold the true quantile; 1 or 0 for each sample of 20.
double coverage(std::size_t share, double end) {
  return mean_of(simulated(400, [&](Random& random) {
    const Sample sample = ended_at(end, drawn_from(kTruth, 20, random));
    const auto seed = static_cast<std::uint64_t>(random.uniform() * 1e15);
    const QuantileBand band = band_of(sample, {.seed = seed, .replicates = 200, .threads = 1});
    const double truth = kTruth.quantile(kShares[share]);
    return band.low[share] <= truth && truth <= band.high[share] ? 1.0 : 0.0;
  }));
}

// The standard error of 400 samples is 1.1 %.
TEST(QuantileBand, HoldsTheTruthAsOftenAsItSays) {
  EXPECT_NEAR(coverage(0, 1e300), 0.95, 0.04);
  EXPECT_NEAR(coverage(2, 1e300), 0.95, 0.04);
  EXPECT_NEAR(coverage(0, kTruth.quantile(0.7)), 0.95, 0.04);
}

TEST(PlottingPositions, MedianRanksOfFailures) {
  const auto positions = plotting_positions(failed({30, 10, 20}));
  EXPECT_EQ(positions[0].specimen, 1U);
  EXPECT_EQ(positions[2].specimen, 0U);
  ASSERT_EQ(positions.size(), 3U);
  EXPECT_EQ(positions[0].life, 10);
  EXPECT_DOUBLE_EQ(positions[0].p, 0.7 / 3.4);
  EXPECT_DOUBLE_EQ(positions[1].p, 0.5);
  EXPECT_EQ(positions[2].life, 30);
  EXPECT_DOUBLE_EQ(positions[2].p, 2.7 / 3.4);
}

// Five specimens, the second suspended: the ranks are 1, then each (6 - 1) / (1 + 3) = 5/4 higher.
TEST(PlottingPositions, RanksAreAdjustedForTheSuspended) {
  const auto positions = plotting_positions(with_suspended({1, 3, 4, 5}, {2}));
  ASSERT_EQ(positions.size(), 4U);
  EXPECT_DOUBLE_EQ(positions[0].p, (1 - 0.3) / 5.4);
  EXPECT_DOUBLE_EQ(positions[1].p, (2.25 - 0.3) / 5.4);
  EXPECT_DOUBLE_EQ(positions[2].p, (3.5 - 0.3) / 5.4);
  EXPECT_DOUBLE_EQ(positions[3].p, (4.75 - 0.3) / 5.4);
}

TEST(PlottingPositions, ASpecimenSuspendedAtALifeOutlivedTheFailureThere) {
  const auto positions = plotting_positions(with_suspended({2, 3}, {2}));
  EXPECT_DOUBLE_EQ(positions[0].p, 0.7 / 3.4);
  EXPECT_DOUBLE_EQ(positions[1].p, (2.5 - 0.3) / 3.4);
}

TEST(PlottingPositions, NoneWithoutFailures) {
  EXPECT_TRUE(plotting_positions(with_suspended({}, {2, 3})).empty());
}

/// Above it are 0.1 % of the distances of uniform values.
constexpr double kUniform = 1.95;

constexpr double kNoEnd = 1e300;

/// A p-value of each sample of 20 drawn from the family that is tested.
std::vector<double> p_values(const Distribution& truth, double end,
                             double (*choose)(const GoodnessOfFit&)) {
  return simulated(300, [&](Random& random) {
    const Sample sample = ended_at(end, drawn_from(truth, 20, random));
    const auto seed = static_cast<std::uint64_t>(random.uniform() * 1e15);
    const BootstrapOptions options{.seed = seed, .stream = 1, .replicates = 200, .threads = 1};
    return choose(goodness_of_fit(fit(truth.family, sample), sample, options));
  });
}

void expect_uniform_p(const Distribution& truth, double end = kNoEnd) {
  const auto ks = p_values(truth, end, [](const GoodnessOfFit& found) { return found.ks_p; });
  const auto ad = p_values(truth, end, [](const GoodnessOfFit& found) { return found.ad_p; });
  EXPECT_LT(distance_from_uniform(ks), kUniform);
  EXPECT_LT(distance_from_uniform(ad), kUniform);
}

TEST(UniformP, NormalSamples) {
  expect_uniform_p({.family = Family::normal, .first = 500, .second = 80});
}

TEST(UniformP, LognormalSamples) {
  expect_uniform_p({.family = Family::lognormal, .first = 6, .second = 0.2});
}

TEST(UniformP, WeibullSamples) {
  expect_uniform_p(kTruth);
}

// A third are suspended at the end of the test.
TEST(UniformP, WeibullSamplesOfATestThatEnded) {
  expect_uniform_p(kTruth, kTruth.quantile(2.0 / 3));
}

std::vector<Sample> four_samples(Random& random) {
  std::vector<Sample> samples;
  for (const double scale : {854.0, 675.0, 551.0, 407.0}) {
    samples.push_back(
        drawn_from({.family = Family::weibull, .first = scale, .second = 6}, 20, random));
  }
  return samples;
}

TEST(UniformP, CommonShape) {
  const auto p = simulated(300, [](Random& random) {
    const std::vector<Sample> samples = four_samples(random);
    const auto seed = static_cast<std::uint64_t>(random.uniform() * 1e15);
    return test_common_shape(samples, {.seed = seed, .replicates = 200, .threads = 1}).p_simulated;
  });
  EXPECT_LT(distance_from_uniform(p), kUniform);
}

// Chi-square with three degrees of freedom has its 5 % point at 7.815; at n = 20 it is larger. The
// point of half the statistic, without the factor 2 of eq. (18), is at half of it.
TEST(UniformP, FivePercentPointOfTheLikelihoodRatio) {
  const auto statistics = simulated(20'000, [](Random& random) {
    return test_common_shape(four_samples(random), {.replicates = 0, .threads = 1}).statistic;
  });
  const double point = quantile_of(statistics, 0.95);
  EXPECT_GT(point, 8.2);
  EXPECT_LT(point, 8.5);
}

}  // namespace
}  // namespace host_sim::statistics
