#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "host_sim/statistics/goodness_of_fit.hpp"
#include "tests/statistics/samples.hpp"
#include "tests/statistics/simulation.hpp"

namespace host_sim::statistics {
namespace {

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

}  // namespace
}  // namespace host_sim::statistics
