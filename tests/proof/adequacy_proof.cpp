#include <gtest/gtest.h>

#include <array>

#include "host_sim/calibrate/adequacy.hpp"
#include "host_sim/statistics/parallel.hpp"
#include "tests/proof/campaigns.hpp"
#include "tests/proof/uniformity.hpp"

namespace host_sim::proof {
namespace {

constexpr std::size_t kReplicates = 99;

using Tests = std::array<statistics::Test, 3>;

Tests judge(const plan::Design& design, std::size_t number) {
  constexpr std::size_t kShareOfBootstraps = 5;
  const auto data = simulated_campaign(design, truth_under(kTruth, design), 40, number);
  calibrate::CalibrateOptions options;
  options.seed = number;
  options.bootstraps = kReplicates * kShareOfBootstraps;
  options.threads = 1;
  calibrate::StressLife result;
  calibrate::test_adequacy(data, life_law::fit_life(data), options, result);
  return {result.against_free_levels.value(), result.against_curvature.value(),
          result.against_growing_scatter.value()};
}

void prove(const std::string& what, const plan::Design& design) {
  std::vector<Tests> tests(campaigns(1000));
  statistics::parallel_for(tests.size(), [&](std::size_t i) { tests[i] = judge(design, i); });
  const std::array<std::string, 3> names{"free levels", "curvature", "growing scatter"};
  for (std::size_t which = 0; which < names.size(); ++which) {
    std::vector<double> p;
    Share chi_square{0, tests.size()};
    for (const Tests& each : tests) {
      p.push_back(each[which].p_simulated);
      chi_square.holds += each[which].p_chi_square <= 0.05 ? 1U : 0U;
    }
    expect_uniform(what + ", against " + names[which], p, kReplicates);
    tell(what + ", against " + names[which] + ", rejected by chi-square", chi_square);
  }
}

TEST(AdequacyTests, AreUniformUnderTheNull) {
  prove("4 levels of 20", whole_design());
}

TEST(AdequacyTests, AreUniformUnderTheNullAndSuspension) {
  prove("4 levels of 20, suspended", suspended_design());
}

}  // namespace
}  // namespace host_sim::proof
