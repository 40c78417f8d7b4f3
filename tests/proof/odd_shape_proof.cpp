#include <gtest/gtest.h>

#include <algorithm>

#include "host_sim/calibrate/shape.hpp"
#include "host_sim/statistics/parallel.hpp"
#include "tests/proof/campaigns.hpp"

namespace host_sim::proof {
namespace {

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

LeftOut judge(std::size_t number, double odd_shape) {
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
  statistics::parallel_for(found.size(), [&](std::size_t i) { found[i] = judge(i, odd_shape); });
  Shares shares{{0, found.size()}, {0, found.size()}};
  for (const LeftOut& one : found) {
    shares.odd.holds += one.odd ? 1U : 0U;
    shares.other.holds += one.other ? 1U : 0U;
  }
  return shares;
}

TEST(OddShape, IsNamed) {
  const Shares shares = judge_all(2.0);
  tell("4 levels of 20, shape 2 against 6, the odd level is named", shares.odd);
  tell("4 levels of 20, shape 2 against 6, another is named", shares.other);
  constexpr double kMeasured = 0.982;  // over 500 campaigns
  EXPECT_GE(shares.odd.value(), kMeasured - shares.odd.tolerance(kMeasured, 3));
}

TEST(OddShape, IsRarelySeenWhereThereIsNone) {
  const Shares shares = judge_all(6.0);
  const Share any{shares.odd.holds + shares.other.holds, shares.odd.campaigns};
  tell("4 levels of 20 of one shape, a level is named", any);
  EXPECT_LE(any.value(), 0.05 + any.tolerance(0.05, 3));
}

}  // namespace
}  // namespace host_sim::proof
