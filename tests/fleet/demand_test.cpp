#include "host_sim/fleet/demand.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "host_sim/statistics/random.hpp"

namespace {

using host_sim::fleet::Demand;
using host_sim::fleet::mixture;
using host_sim::fleet::poisson_binomial;
using host_sim::fleet::together;

double probability(const Demand& demand, std::size_t count) {
  return count < demand.first || count >= demand.first + demand.probability.size()
             ? 0
             : demand.probability[count - demand.first];
}

TEST(FleetDemand, OfThreeTendonsByHand) {
  const Demand demand = poisson_binomial(std::vector<double>{0.1, 0.2, 0.3});
  EXPECT_NEAR(probability(demand, 0), 0.504, 1e-15);  // 0.9 0.8 0.7
  EXPECT_NEAR(probability(demand, 1), 0.398, 1e-15);  // 0.056 + 0.126 + 0.216
  EXPECT_NEAR(probability(demand, 2), 0.092, 1e-15);  // 0.014 + 0.024 + 0.054
  EXPECT_NEAR(probability(demand, 3), 0.006, 1e-15);
  EXPECT_NEAR(demand.mean(), 0.6, 1e-15);
  EXPECT_EQ(demand.quantile(0.5), 0U);
  EXPECT_EQ(demand.quantile(0.51), 1U);
  EXPECT_EQ(demand.quantile(0.9), 1U);
  EXPECT_EQ(demand.quantile(0.95), 2U);
  EXPECT_EQ(demand.quantile(0.995), 3U);
  EXPECT_NEAR(demand.at_most(1), 0.902, 1e-15);
  EXPECT_EQ(demand.at_most(7), 1);
}

TEST(FleetDemand, ServiceThatIsMetExactlyIsMet) {
  const std::vector<double> tenths(1, 0.1);
  EXPECT_EQ(poisson_binomial(tenths).quantile(0.9), 0U);
  const Demand demand = poisson_binomial(std::vector<double>{0.1, 0.2, 0.3});
  EXPECT_EQ(demand.quantile(0.504), 0U);
  EXPECT_EQ(demand.quantile(0.902), 1U);
}

TEST(FleetDemand, OfNoTendonAndOfSureOnes) {
  EXPECT_EQ(poisson_binomial({}).quantile(0.999), 0U);
  const Demand sure = poisson_binomial(std::vector<double>{1, 0, 1, 1, 0});
  EXPECT_EQ(sure.quantile(0.001), 3U);
  EXPECT_EQ(sure.quantile(0.999), 3U);
  EXPECT_EQ(probability(sure, 3), 1);
}

TEST(FleetDemand, OfEqualTendonsIsBinomial) {
  constexpr int kTendons = 10'000;
  for (const double p : {1e-4, 0.03, 0.5, 0.97}) {
    const Demand demand = poisson_binomial(std::vector<double>(kTendons, p));
    for (const double off : {-4.0, -1.0, 0.0, 2.0, 6.0}) {
      const double count = std::floor(kTendons * p + off * std::sqrt(kTendons * p * (1 - p)));
      if (count < 0) {
        continue;
      }
      const double log_binomial = std::lgamma(kTendons + 1.0) - std::lgamma(count + 1) -
                                  std::lgamma(kTendons - count + 1) + count * std::log(p) +
                                  (kTendons - count) * std::log1p(-p);
      EXPECT_NEAR(probability(demand, static_cast<std::size_t>(count)) / std::exp(log_binomial), 1,
                  1e-8)
          << p << ' ' << count;
    }
    EXPECT_NEAR(demand.mean(), kTendons * p, 1e-8);
    EXPECT_NEAR(demand.at_most(kTendons), 1, 1e-12);
  }
}

TEST(FleetDemand, IsWhatSimulationCounts) {
  std::vector<double> risks;
  for (double i = 1; i <= 60; ++i) {
    risks.push_back(0.4 * i / 60 * i / 60);
  }
  const Demand demand = poisson_binomial(risks);
  constexpr int kRuns = 40'000;
  std::vector<int> seen(risks.size() + 1, 0);
  for (int run = 0; run < kRuns; ++run) {
    host_sim::statistics::Random random(1, 0, static_cast<std::uint64_t>(run));
    std::size_t breaks = 0;
    for (const double risk : risks) {
      breaks += random.uniform() < risk ? 1U : 0U;
    }
    ++seen[breaks];
  }
  for (std::size_t count = 0; count < seen.size(); ++count) {
    const double p = probability(demand, count);
    EXPECT_NEAR(static_cast<double>(seen[count]) / kRuns, p,
                4.5 * std::sqrt(p * (1 - p) / kRuns) + 1e-4)
        << count;
  }
}

TEST(FleetDemand, OfTwoFleetsByHand) {
  const Demand one = poisson_binomial(std::vector<double>{0.5});
  const Demand two = poisson_binomial(std::vector<double>{0.5, 1});
  const Demand both = together(one, two);
  EXPECT_EQ(both.first, 1U);
  EXPECT_EQ(both.probability, (std::vector<double>{0.25, 0.5, 0.25}));
  // One of the two is true, three times as likely the first.
  const std::vector<Demand> either{one, two};
  const Demand mixed = mixture(either, std::vector<double>{0.75, 0.25});
  EXPECT_EQ(mixed.first, 0U);
  EXPECT_EQ(mixed.probability, (std::vector<double>{0.375, 0.5, 0.125}));
}

}  // namespace
