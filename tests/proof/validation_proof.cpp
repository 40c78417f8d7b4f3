#include <gtest/gtest.h>

#include "host_sim/calibrate/replicates.hpp"
#include "host_sim/calibrate/validation.hpp"
#include "host_sim/life_law/life_fit.hpp"
#include "host_sim/statistics/parallel.hpp"
#include "tests/proof/campaigns.hpp"
#include "tests/proof/uniformity.hpp"

namespace host_sim::proof {
namespace {

// p is two-sided: twice the smaller tail, so that it moves in steps of two.
constexpr std::size_t kReplicates = 199;

double p_of(const plan::Design& design, std::size_t number) {
  const plan::Design more{{{35.1, 20}}};
  const auto data = simulated_campaign(design, truth_under(kTruth, design), 50, number);
  const auto validation = simulated_campaign(more, truth_under(kTruth, more), 51, number);
  calibrate::CalibrateOptions options;
  options.seed = number;
  options.bootstraps = kReplicates;
  options.threads = 1;
  const life_law::LifeLaw law = life_law::fit_life(data).law();
  const auto refits = calibrate::refitted_laws(data, law, options);
  return calibrate::validate(validation, law, refits, 0, options).value().p;
}

void prove(const std::string& what, const plan::Design& design) {
  std::vector<double> p(campaigns(1000));
  statistics::parallel_for(p.size(), [&](std::size_t i) { p[i] = p_of(design, i); });
  expect_uniform(what + ", validation", p, kReplicates / 2);
}

TEST(ValidationTest, IsUniformUnderTheNull) {
  prove("4 levels of 20", whole_design());
}

TEST(ValidationTest, IsUniformUnderTheNullAndSuspension) {
  prove("4 levels of 20, suspended", suspended_design());
}

}  // namespace
}  // namespace host_sim::proof
