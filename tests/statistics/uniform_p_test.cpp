#include <gtest/gtest.h>

#include "host_sim/statistics/common_shape.hpp"
#include "host_sim/statistics/goodness_of_fit.hpp"
#include "tests/statistics/simulation.hpp"

namespace host_sim::statistics {
namespace {

/// Above it are 0.1 % of the distances of uniform values.
constexpr double kUniform = 1.95;

constexpr Distribution kWeibull{.family = Family::weibull, .first = 500, .second = 6};
constexpr double kNoEnd = 1e300;

/// A p-value of each sample of 20 drawn from the family that is tested.
std::vector<double> p_values(const Distribution& truth, double end,
                             double (*choose)(const GoodnessOfFit&)) {
  return simulated(fewer_if_sanitized(300), [&](Random& random) {
    const Sample sample = ended_at(end, drawn_from(truth, 20, random));
    const auto seed = static_cast<std::uint64_t>(random.uniform() * 1e15);
    const BootstrapOptions options{
        .seed = seed, .stream = 1, .replicates = fewer_if_sanitized(200), .threads = 1};
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
  expect_uniform_p(kWeibull);
}

// A third are suspended at the end of the test.
TEST(UniformP, WeibullSamplesOfATestThatEnded) {
  expect_uniform_p(kWeibull, kWeibull.quantile(2.0 / 3));
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
  const auto p = simulated(fewer_if_sanitized(300), [](Random& random) {
    const std::vector<Sample> samples = four_samples(random);
    const auto seed = static_cast<std::uint64_t>(random.uniform() * 1e15);
    return test_common_shape(samples,
                             {.seed = seed, .replicates = fewer_if_sanitized(200), .threads = 1})
        .p_simulated;
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
