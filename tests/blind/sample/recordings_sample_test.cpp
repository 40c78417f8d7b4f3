#include <gtest/gtest.h>

#include "tests/blind/running/analyses.hpp"
#include "tests/blind/sample/sample.hpp"

namespace blind::test {
namespace {

constexpr std::size_t kCampaigns = 60;
/// With the truth first: the answers that are right, of all probabilities, in the README's tables.
constexpr Proportion kRightOfMany{904, 1000};
constexpr double kPlain_sigmas = 20;  ///< that must leave something unknown

TEST(BlindRecordings, Sample) {
  const auto scenarios = first_scenarios(draw_recordings, kCampaigns);
  expect_good(run_sample(scenarios, analysis_of_recordings()), kRightOfMany);
}

TEST(BlindRecordings, WithoutAnEffectItsCampaignIsUnknown) {
  expect_unknown_without(draw_recordings, draw_recordings, analysis_of_recordings(),
                         {"friction_wear", "friction_temperature", "friction_position",
                          "friction_preload", "slack", "torque_ripple"},
                         kPlain_sigmas);
}

}  // namespace
}  // namespace blind::test
