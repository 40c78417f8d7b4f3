#include "host_sim/diagnose/force/remainder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "tests/diagnose/force/joint.hpp"

namespace host_sim::diagnose {
namespace {

using ::testing::ElementsAre;

constexpr double kJointFriction = 0.00638;  // exp(mu pi) - 1 = 0.02, of the load

/// The joint, each session of which is changed.
std::vector<effects::ForceRecord> changed(
    unsigned seed, const std::function<void(effects::ForceRecord&, int)>& change) {
  std::vector<effects::ForceRecord> records = measured({.gain_scatter = 0.002}, seed, 16);
  for (int j = 0; j < 16; ++j) {
    change(records[static_cast<std::size_t>(j)], j);
  }
  return records;
}

void scale_input(effects::ForceRecord& record, double factor) {
  for (double& input_N : record.input_N) {
    input_N *= factor;
  }
}

/// What the nominal model leaves of records, after a fit of gain and friction.
ForceRemainder left_of(std::vector<effects::ForceRecord> records) {
  ForceData data(std::move(records));
  const std::vector<ForceCovariate> covariates = force_covariates(data.records());
  std::vector<CovariateBins> bins;
  bins.reserve(covariates.size());
  for (const ForceCovariate& covariate : covariates) {
    bins.emplace_back(data.records(), covariate);
  }
  const ForceFit nominal = data.fit({}, {1, kJointFriction}, 15);
  data.learn_covariance(nominal, nominal, false);
  return remainder_of(data, nominal, nominal, covariates, bins, 1);
}

const Discrepancy& against(const ForceRemainder& remainder, const std::string& covariate) {
  return *std::ranges::find(remainder.discrepancies, covariate, &Discrepancy::covariate);
}

std::vector<std::string> names_of(const std::vector<ForceCovariate>& covariates, bool of_sessions) {
  std::vector<std::string> names;
  for (const ForceCovariate& covariate : covariates) {
    if (covariate.of_sessions == of_sessions) {
      names.emplace_back(covariate.name);
    }
  }
  return names;
}

/// Of twelve sessions four have samples in the first bin, of 1, 1, 1 and a last value; the others,
/// in the last one, have as many above zero as below. A mean of 1 that scatters by nothing counts
/// whole; where it is 1.5 standard errors, as chance puts there once in seven times, not at all.
TEST(BinMeans, CountWhatIsMoreThanChance) {
  const auto square_N2 = [](double last_N) {
    std::vector<effects::ForceRecord> records = measured({}, 1, 12);
    const CovariateBins bins(records, force_covariates(records).front());
    std::vector<std::vector<double>> residuals_N;
    CovariateBins two = bins;
    for (std::size_t j = 0; j < records.size(); ++j) {
      const bool first = j < 4;
      std::ranges::fill(two.places[j], first ? 0 : 2 * CovariateBins::kCount - 1);
      residuals_N.emplace_back(records[j].samples(), first   ? (j == 3 ? last_N : 1.0)
                                                     : j % 2 ? 1e-3
                                                             : -1e-3);
    }
    const ForceData data(std::move(records));
    return BinMeans(data, two, residuals_N, data.covariance()).square_N2();
  };
  EXPECT_NEAR(square_N2(1), 4.0 / 12, 0.03);
  EXPECT_EQ(square_N2(-0.6), 0);
  EXPECT_GT(square_N2(0.5), 0.1);
}

TEST(ForceCovariates, OfSessionsAreThoseThatAllHaveAndThatDiffer) {
  const auto with = [](effects::ForceRecord& record, int session) {
    record.cycle.assign(record.samples(), 100.0 * session);
    record.sheath_temperature_C.assign(record.samples(), 20 + session);
    record.winding_temperature_C.assign(record.samples(), 25);
  };
  EXPECT_THAT(names_of(force_covariates(changed(1, with)), true),
              ElementsAre("cycle", "sheath temperature"));
  EXPECT_EQ(names_of(force_covariates(changed(1, with)), false).size(), 7U);
  std::vector<effects::ForceRecord> one_without = changed(1, with);
  one_without[3].cycle.clear();
  EXPECT_THAT(names_of(force_covariates(one_without), true), ElementsAre("sheath temperature"));
}

/// All alike to the last bit, where a difference of sums would round to less than nothing.
TEST(Remainder, SessionsThatAreCopiesDoNotScatter) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    std::vector<effects::ForceRecord> records = measured({}, seed, 7);
    std::fill(records.begin() + 1, records.end(), records.front());
    const ForceRemainder remainder = left_of(std::move(records));
    const Discrepancy& scatter = against(remainder, "session");
    EXPECT_NEAR(scatter.statistic, 0, 1e-12);
    EXPECT_EQ(scatter.p_after, 1);
  }
}

/// Friction at 10 N is 0.2 N; 1 % of the force for each 1000 cycles goes with the life of the
/// tendon, far above a scatter of 0.2 %.
TEST(Remainder, ATrendOverTheLifeOfTheTendonIsSeenThere) {
  const ForceRemainder remainder =
      left_of(changed(2, [](effects::ForceRecord& record, int session) {
        record.cycle.assign(record.samples(), 1000.0 * ((7 * session) % 16));
        scale_input(record, 1 + 0.002 * ((7 * session) % 16));
      }));
  EXPECT_EQ(remainder.covariate, "cycle");
  EXPECT_EQ(remainder.p, 0.001);  // none of 999 draws as large
  EXPECT_TRUE(remainder.stands);
  EXPECT_GT(against(remainder, "cycle").statistic, 0.9 * 16);
}

/// The same spread in sessions whose cycle goes with nothing: it is scatter, and less than 3 %.
TEST(Remainder, ScatterOfSessionsIsNoTrend) {
  int seen = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 engine(seed);
    std::normal_distribution<double> normal;
    const ForceRemainder remainder =
        left_of(changed(seed, [&](effects::ForceRecord& record, int session) {
          record.cycle.assign(record.samples(), 1000.0 * session);
          scale_input(record, 1 + 0.01 * normal(engine));
        }));
    seen += against(remainder, "cycle").p_after < 0.05 ? 1 : 0;
    EXPECT_GT(against(remainder, "session").p_after, 0.5) << seed;
  }
  EXPECT_LE(seen, 3);  // of 20 with a chance of 5 %, more than that in 1.6 %
}

/// 12 % between sessions that differ in nothing that was recorded: four times what a rig may.
TEST(Remainder, AScatterThatNoRigHasStandsByItself) {
  std::mt19937 engine(3);
  std::normal_distribution<double> normal;
  const ForceRemainder remainder = left_of(changed(3, [&](effects::ForceRecord& record, int) {
    scale_input(record, 1 + 0.12 * normal(engine));
  }));
  EXPECT_EQ(remainder.covariate, kSession);
  EXPECT_LT(remainder.p, 1e-6);
  EXPECT_TRUE(remainder.stands);
}

}  // namespace
}  // namespace host_sim::diagnose
