#include <gtest/gtest.h>

#include "tests/blind/generator/scenario.hpp"
#include "tests/blind/oracle/life_visibility.hpp"
#include "tests/blind/running/analyses.hpp"
#include "tests/blind/sample/sample.hpp"

namespace blind::test {
namespace {

constexpr std::size_t kCampaigns = 60;
/// With the truth first: the answers that are right, of all probabilities, in the README's tables.
constexpr Proportion kRightOfMany{865, 1000};
constexpr double kPlain_sigmas = 6;  ///< that must leave something unknown

TEST(BlindLives, Sample) {
  const auto scenarios = first_scenarios(draw_visible_lives, kCampaigns);
  expect_good(run_sample(scenarios, analysis_of_lives()), kRightOfMany);
}

TEST(BlindLives, WithoutAnEffectItsCampaignIsUnknown) {
  expect_unknown_without([](std::uint64_t seed) { return draw_lives(seed, 0); }, draw_visible_lives,
                         analysis_of_lives(), {"ageing", "load_sequence", "lot_frailty"},
                         kPlain_sigmas);
}

}  // namespace
}  // namespace blind::test
