#include "host_sim/statistics/goodness_of_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tests/statistics/samples.hpp"
#include "tests/statistics/simulation.hpp"

namespace host_sim::statistics {
namespace {

/// Uniform from 0 to 1 as far as a sample inside can tell: exponential of the survival 1 - x.
constexpr Distribution kExponential{.family = Family::weibull, .first = 1, .second = 1};

double life_at(double p) {
  return -std::log1p(-p);
}

// Heights 0.2 and 0.9 of the distribution against steps 0 - 1/2 - 1: the largest gap is 0.4 below
// the second step.
TEST(KolmogorovSmirnov, LargestGapAtTheSteps) {
  EXPECT_NEAR(kolmogorov_smirnov(kExponential, failed({life_at(0.2), life_at(0.9)})), 0.4, 1e-15);
  EXPECT_NEAR(kolmogorov_smirnov(kExponential, failed({life_at(0.6), life_at(0.9)})), 0.6, 1e-15);
  EXPECT_NEAR(kolmogorov_smirnov(kExponential, failed({life_at(0.1), life_at(0.2)})), 0.8, 1e-15);
}

// The estimate stays at 1/2 up to the suspended specimen, where the distribution is at 0.95.
TEST(KolmogorovSmirnov, UpToTheLastSuspended) {
  const Sample sample = with_suspended({life_at(0.3)}, {life_at(0.95)});
  EXPECT_NEAR(kolmogorov_smirnov(kExponential, sample), 0.45, 1e-15);
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
  EXPECT_NEAR(anderson_darling(kExponential, failed({life_at(0.5)})), 2 * std::numbers::ln2 - 1,
              1e-14);
  EXPECT_NEAR(anderson_darling(kExponential, failed({life_at(0.1), life_at(0.35), life_at(0.8)})),
              classical({0.1, 0.35, 0.8}), 1e-13);
  EXPECT_NEAR(anderson_darling(kExponential, failed({life_at(0.4), life_at(0.4), life_at(0.8)})),
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
  EXPECT_NEAR(anderson_darling(kExponential, sample), 3 * integral_by_midpoints(), 1e-7);
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
    const Sample drawn = drawn_from(kExponential, 20, random);
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

}  // namespace
}  // namespace host_sim::statistics
