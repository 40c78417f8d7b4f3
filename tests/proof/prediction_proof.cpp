#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/calibrate/replicates.hpp"
#include "host_sim/calibrate/use_levels.hpp"
#include "host_sim/statistics/parallel.hpp"
#include "host_sim/statistics/random.hpp"
#include "tests/proof/campaigns.hpp"

namespace host_sim::proof {
namespace {

/// Whether the interval from one campaign holds the life of one more specimen.
bool holds(const plan::Design& design, std::size_t number) {
  constexpr std::uint64_t kStreamOfNext = 1000;
  const auto data = simulated_campaign(design, truth_under(kTruth, design), 30, number);
  const life_law::LifeFit fit = life_law::fit_life(data);
  calibrate::CalibrateOptions options;
  options.seed = number;
  options.bootstraps = 400;
  options.threads = 1;
  const auto refits = calibrate::refitted_laws(data, fit.law(), options);
  const auto use = calibrate::use_level("use", kUseTension_N, data, fit, refits, 0, options);
  statistics::Random random(30, kStreamOfNext, number);
  const double life = kTruth.quantile(random.uniform(), kUseTension_N);
  return use.next_specimen_95.low <= life && life <= use.next_specimen_95.high;
}

void prove(const std::string& what, const plan::Design& design) {
  // Bytes, as threads write side by side.
  std::vector<char> held(campaigns(1000));
  statistics::parallel_for(held.size(), [&](std::size_t i) { held[i] = holds(design, i) ? 1 : 0; });
  Share share{0, held.size()};
  for (const char one : held) {
    share.holds += one != 0 ? 1U : 0U;
  }
  tell(what + ", 95 % prediction interval holds the next life", share);
  EXPECT_NEAR(share.value(), 0.95, std::max(0.02, share.tolerance(0.95, 4)));
}

TEST(PredictionInterval, CoversWithoutSuspension) {
  prove("4 levels of 20", whole_design());
}

TEST(PredictionInterval, CoversUnderSuspension) {
  prove("4 levels of 20, suspended", suspended_design());
}

}  // namespace
}  // namespace host_sim::proof
