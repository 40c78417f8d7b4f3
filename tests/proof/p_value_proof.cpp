#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "host_sim/calibrate/levels.hpp"
#include "host_sim/calibrate/stress_life.hpp"
#include "host_sim/calibrate/validation.hpp"
#include "host_sim/life_law/life_fit.hpp"
#include "host_sim/statistics/parallel.hpp"
#include "tests/proof/campaigns.hpp"

namespace host_sim::proof {
namespace {

constexpr std::size_t kAdequacyReplicates = 99;

using Tests = std::array<statistics::Test, 3>;

Tests adequacy_tests(const plan::Design& design, std::size_t number) {
  constexpr std::size_t kShareOfBootstraps = 5;
  const auto data = simulated_campaign(design, truth_under(kTruth, design), 40, number);
  calibrate::CalibrateOptions options;
  options.seed = number;
  options.bootstraps = kAdequacyReplicates * kShareOfBootstraps;
  options.threads = 1;
  calibrate::StressLife result;
  calibrate::test_adequacy(data, life_law::fit_life(data), options, result);
  return {result.against_free_levels.value(), result.against_curvature.value(),
          result.against_growing_scatter.value()};
}

void prove_adequacy(const std::string& what, const plan::Design& design) {
  std::vector<Tests> tests(campaigns(1000));
  statistics::parallel_for(tests.size(),
                           [&](std::size_t i) { tests[i] = adequacy_tests(design, i); });
  const std::array<std::string, 3> names{"free levels", "curvature", "growing scatter"};
  for (std::size_t which = 0; which < names.size(); ++which) {
    std::vector<double> p;
    Share chi_square{0, tests.size()};
    for (const Tests& each : tests) {
      p.push_back(each[which].p_simulated);
      chi_square.holds += each[which].p_chi_square <= 0.05 ? 1U : 0U;
    }
    expect_uniform(what + ", against " + names[which], p, kAdequacyReplicates);
    report(what + ", against " + names[which] + ", rejected by chi-square", chi_square);
  }
}

TEST(AdequacyTests, AreUniformUnderTheNull) {
  prove_adequacy("4 levels of 20", whole_design());
}

TEST(AdequacyTests, AreUniformUnderTheNullAndSuspension) {
  prove_adequacy("4 levels of 20, suspended", suspended_design());
}

// p is two-sided: twice the smaller tail, so that it moves in steps of two.
constexpr std::size_t kValidationReplicates = 199;

double validation_p(const plan::Design& design, std::size_t number) {
  const plan::Design more{{{35.1, 20}}};
  const auto data = simulated_campaign(design, truth_under(kTruth, design), 50, number);
  const auto validation = simulated_campaign(more, truth_under(kTruth, more), 51, number);
  calibrate::CalibrateOptions options;
  options.seed = number;
  options.bootstraps = kValidationReplicates;
  options.threads = 1;
  const life_law::LifeLaw law = life_law::fit_life(data).law();
  const auto refits = calibrate::refitted_laws(data, law, options);
  return calibrate::validate(validation, law, refits, 0, options).value().p;
}

void prove_validation(const std::string& what, const plan::Design& design) {
  std::vector<double> p(campaigns(1000));
  statistics::parallel_for(p.size(), [&](std::size_t i) { p[i] = validation_p(design, i); });
  expect_uniform(what + ", validation", p, kValidationReplicates / 2);
}

TEST(ValidationTest, IsUniformUnderTheNull) {
  prove_validation("4 levels of 20", whole_design());
}

TEST(ValidationTest, IsUniformUnderTheNullAndSuspension) {
  prove_validation("4 levels of 20, suspended", suspended_design());
}

constexpr std::size_t kOddLevel = 3;

std::vector<calibrate::LevelResult> levels_of(std::size_t number, double odd_shape) {
  std::vector<calibrate::LevelResult> levels;
  for (std::size_t i = 0; i < 4; ++i) {
    const plan::Design design{{{50, 20}}};
    const plan::Truth truth{{1000}, i == kOddLevel ? odd_shape : 6.0};
    calibrate::LevelResult level;
    for (const auto& datum : simulated_campaign(design, truth, 60 + i, number)) {
      level.sample.push_back({datum.blocks.front().cycles, datum.failed});
    }
    level.fits[static_cast<std::size_t>(statistics::Family::weibull)] =
        statistics::fit(statistics::Family::weibull, level.sample);
    levels.push_back(level);
  }
  return levels;
}

/// What is left out of one campaign: whether the odd level, whether another.
struct LeftOut {
  bool odd = false;
  bool other = false;
};

LeftOut left_out_of(std::size_t number, double odd_shape) {
  auto levels = levels_of(number, odd_shape);
  calibrate::CalibrateOptions options;
  options.seed = number;
  options.bootstraps = 199;
  options.threads = 1;
  calibrate::common_shape(levels, options);
  LeftOut found;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    (i == kOddLevel ? found.odd : found.other) |= !levels[i].left_out.empty();
  }
  return found;
}

struct Shares {
  Share odd;
  Share other;
};

Shares judge_all(double odd_shape) {
  std::vector<LeftOut> found(campaigns(500));
  statistics::parallel_for(found.size(),
                           [&](std::size_t i) { found[i] = left_out_of(i, odd_shape); });
  Shares shares{{0, found.size()}, {0, found.size()}};
  for (const LeftOut& one : found) {
    shares.odd.holds += one.odd ? 1U : 0U;
    shares.other.holds += one.other ? 1U : 0U;
  }
  return shares;
}

TEST(OddShape, IsNamed) {
  const Shares shares = judge_all(2.0);
  report("4 levels of 20, shape 2 against 6, the odd level is named", shares.odd);
  report("4 levels of 20, shape 2 against 6, another is named", shares.other);
  constexpr double kMeasured = 0.982;  // over 500 campaigns
  EXPECT_GE(shares.odd.value(), kMeasured - shares.odd.tolerance(kMeasured, 3));
}

TEST(OddShape, IsRarelySeenWhereThereIsNone) {
  const Shares shares = judge_all(6.0);
  const Share any{shares.odd.holds + shares.other.holds, shares.odd.campaigns};
  report("4 levels of 20 of one shape, a level is named", any);
  EXPECT_LE(any.value(), 0.05 + any.tolerance(0.05, 3));
}

}  // namespace
}  // namespace host_sim::proof
