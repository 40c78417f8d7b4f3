#include "host_sim/diagnose/lives/discrepancy.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "host_sim/diagnose/lives/fit.hpp"
#include "tests/diagnose/lives/scenario.hpp"

namespace host_sim::diagnose::lives {
namespace {

constexpr OmnibusOptions kQuick{.seed = 3, .threads = 0, .replicates = 200};

LifeSample hidden(const std::string& id, std::uint64_t seed) {
  return sample_of(host_sim::test::simulated({96, id, seed}), Campaign::Role::fit);
}

const CovariateTest& test_of(const Omnibus& omnibus, const std::string& covariate) {
  return *std::ranges::find(omnibus.tests, covariate, &CovariateTest::covariate);
}

TEST(LifeLooks, WeighExcessByGroup) {
  LifeSample sample = hidden("none", 20005);
  const std::vector<CovariateStatistic> statistics = covariate_statistics(sample);
  const auto group = std::ranges::find(statistics, "group", &CovariateStatistic::covariate);
  ASSERT_NE(group, statistics.end());
  std::vector<CoxSnell> residuals(sample.size(), {1, true});
  EXPECT_NEAR(group->statistic(residuals), 0, 1e-12);
  // The 64 of rig 1, two of three rounds of lots, with an excess of 1/2: 64 (1/2)^2.
  for (std::size_t i = 0; i < sample.size(); ++i) {
    residuals[i].value = sample.specimens[i].group == 0 ? 0.5 : 1;
  }
  EXPECT_NEAR(group->statistic(residuals), 16, 1e-9);
}

// Of campaigns with nothing hidden few are below 5 %: the chance of five or more of 20 is 0.003.
TEST(LifeOmnibus, IsSeldomSmallWhereNothingIsHidden) {
  int small = 0;
  for (std::uint64_t seed = 20010; seed < 20030; ++seed) {
    small += omnibus_test(hidden("none", seed), kQuick).p < 0.05 ? 1 : 0;
  }
  EXPECT_LT(small, 5);
}

TEST(LifeOmnibus, LooksAtWhatIsHidden) {
  EXPECT_LT(test_of(omnibus_test(hidden("rig_bias", 20006), kQuick), "group").p, 0.01);
  EXPECT_LT(test_of(omnibus_test(hidden("lot_frailty", 20006), kQuick), "lot").p, 0.01);
  EXPECT_LT(test_of(omnibus_test(hidden("ageing", 20006), kQuick), "days").p, 0.01);
}

// The least p is that of one campaign, the observed one, among 201.
TEST(LifeOmnibus, IsNeverZero) {
  const Omnibus omnibus = omnibus_test(hidden("lot_frailty", 20006), kQuick);
  EXPECT_GE(omnibus.p, 1.0 / 201);
  EXPECT_LT(omnibus.p, 0.02);
}

TEST(LifeOmnibus, DoesNotDependOnThreads) {
  const LifeSample sample = hidden("none", 20007);
  OmnibusOptions one = kQuick;
  one.threads = 1;
  OmnibusOptions four = kQuick;
  four.threads = 4;
  EXPECT_EQ(omnibus_test(sample, one).p, omnibus_test(sample, four).p);
}

TEST(LifeOmnibus, LivesWithoutEffectsHaveTheResidualsGiven) {
  const LifeSample sample = hidden("none", 20008);
  std::vector<double> cox_snell(sample.size(), 0.7);
  const LifeSample plain = without_effects(sample, cox_snell);
  const NominalFit nominal = fit_nominal(sample);
  const LifeSample::Block& block = plain.specimens.front().last();
  const double ln_life = nominal.ln_life_at_centre -
                         nominal.exponent * (std::log(block.effective_N) - nominal.centre_ln_N);
  EXPECT_NEAR(std::pow(block.cycles / std::exp(ln_life), nominal.shape), 0.7, 1e-9);
}

}  // namespace
}  // namespace host_sim::diagnose::lives
