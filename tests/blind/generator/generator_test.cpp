#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "host_sim/synth/plan/plan.hpp"
#include "tests/blind/generator/choice.hpp"
#include "tests/blind/generator/scenario.hpp"

namespace blind::test {
namespace {

using host_sim::synth::parse_synth_plan;

constexpr std::size_t kMany = 4000;

/// Within four binomial standard deviations.
void expect_share(std::size_t count, std::size_t of, double share) {
  const double all = static_cast<double>(of);
  EXPECT_NEAR(static_cast<double>(count), share * all, 4 * std::sqrt(all * share * (1 - share)));
}

TEST(Generator, AScenarioDependsOnItsSeedAlone) {
  const Scenario once = draw_recordings(123);
  static_cast<void>(draw_recordings(124));
  EXPECT_EQ(once.plan, draw_recordings(123).plan);
  EXPECT_NE(once.plan, draw_recordings(124).plan);
  EXPECT_EQ(draw_lives(123, 0).plan, draw_lives(123, 0).plan);
  EXPECT_NE(draw_lives(123, 0).plan, draw_lives(124, 0).plan);
}

TEST(Generator, AttemptsHideTheSame) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Scenario first = draw_lives(seed, 0);
    const Scenario second = draw_lives(seed, 1);
    EXPECT_NE(first.plan, second.plan);
    EXPECT_EQ(first.specimens, second.specimens);
    ASSERT_EQ(first.hidden.size(), second.hidden.size());
    for (std::size_t i = 0; i < first.hidden.size(); ++i) {
      EXPECT_EQ(first.hidden[i].id, second.hidden[i].id);
    }
  }
}

TEST(Generator, KindsAndDesignsHaveTheirShares) {
  std::map<CampaignKind, std::size_t> kinds;
  std::size_t one_pose = 0;
  for (std::uint64_t seed = 1; seed <= kMany; ++seed) {
    const Choice choice = choose(seed);
    ++kinds[choice.kind];
    one_pose += choice.design == Design::one_pose ? 1 : 0;
  }
  expect_share(kinds[CampaignKind::none], kMany, 0.20);
  expect_share(kinds[CampaignKind::one], kMany, 0.45);
  expect_share(kinds[CampaignKind::two], kMany, 0.10);
  expect_share(kinds[CampaignKind::three], kMany, 0.05);
  expect_share(kinds[CampaignKind::outside], kMany, 0.20);
  expect_share(one_pose, kMany, 0.15);
}

TEST(Generator, EachEffectIsAsOftenAloneAsAnyOther) {
  std::map<std::string_view, std::size_t> alone;
  std::map<std::string_view, std::size_t> outside;
  std::size_t ones = 0;
  std::size_t outsides = 0;
  for (std::uint64_t seed = 1; seed <= kMany; ++seed) {
    const Choice choice = choose(seed);
    if (choice.kind == CampaignKind::one) {
      ++alone[choice.effects.front().id];
      ++ones;
    } else if (choice.kind == CampaignKind::outside) {
      ++outside[choice.effects.front().id];
      ++outsides;
    }
  }
  ASSERT_EQ(alone.size(), 15U);
  for (const auto& [id, count] : alone) {
    SCOPED_TRACE(id);
    expect_share(count, ones, 1.0 / 15);
  }
  ASSERT_EQ(outside.size(), 9U);
  for (const auto& [id, count] : outside) {
    SCOPED_TRACE(id);
    expect_share(count, outsides, 1.0 / 9);
  }
}

TEST(Generator, SomeOfWhatIsOutsideIsHeldBackFromTuning) {
  const auto outside = [](auto choose_one, std::uint64_t first, std::uint64_t count) {
    std::set<std::string_view> ids;
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
      const Choice choice = choose_one(seed);
      if (choice.kind == CampaignKind::outside) {
        ids.insert(choice.effects.front().id);
      }
    }
    return ids;
  };
  const auto tuned = outside(choose, kFirstTuningSeed, kLastTuningSeed);
  const auto scored = outside(choose, kFirstScoringSeed, kMany);
  EXPECT_EQ(tuned.size(), 9U);
  EXPECT_EQ(scored.size(), 14U);
  EXPECT_TRUE(std::includes(scored.begin(), scored.end(), tuned.begin(), tuned.end()));
  EXPECT_EQ(outside(choose_two_sided, kFirstTuningSeed, kLastTuningSeed).size(), 2U);
  EXPECT_EQ(outside(choose_two_sided, kFirstScoringSeed, kMany).size(), 3U);
}

TEST(Generator, PlansWithWhatIsHeldBackAreAccepted) {
  for (std::uint64_t seed = kFirstScoringSeed; seed < kFirstScoringSeed + 300; ++seed) {
    EXPECT_EQ(parse_synth_plan(draw_recordings(seed).plan, "plan").departures.size(),
              draw_recordings(seed).hidden.size());
    EXPECT_EQ(parse_synth_plan(draw_two_sided(seed).plan, "plan").departures.size(),
              draw_two_sided(seed).hidden.size());
  }
}

TEST(Generator, SeveralAreDifferentAndSeenByOneSensor) {
  for (std::uint64_t seed = 1; seed <= kMany; ++seed) {
    const Choice choice = choose(seed);
    std::set<std::string_view> ids;
    for (const SizedEffect& effect : choice.effects) {
      ids.insert(effect.id);
    }
    EXPECT_EQ(ids.size(), choice.effects.size());
    if (choice.kind == CampaignKind::two || choice.kind == CampaignKind::three) {
      EXPECT_EQ(ids.size(), choice.kind == CampaignKind::two ? 2U : 3U);
    }
    for (const SizedEffect& effect : choice.effects) {
      EXPECT_FALSE(effect.needs == Needs::motor_current && choice.input == Input::load_cell);
      EXPECT_FALSE(effect.needs == Needs::load_cell && choice.input == Input::motor_current);
    }
  }
}

TEST(Generator, WhatHasToDoWithTemperatureIsHiddenWhereItIsRecorded) {
  for (std::uint64_t seed = 1; seed <= kMany; ++seed) {
    const Choice choice = choose(seed);
    for (const SizedEffect& effect : choice.effects) {
      if (effect.id == "friction_temperature" || effect.id == "torque_gain") {
        EXPECT_TRUE(choice.temperatures) << seed;
      }
    }
  }
}

TEST(Generator, PlansAreAcceptedAndHideWhatTheyShould) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const Scenario scenario = draw_recordings(seed);
    const auto plan = parse_synth_plan(scenario.plan, "plan");
    std::set<std::string> hidden;
    for (const auto& one : plan.departures) {
      hidden.insert(one.id);
      EXPECT_EQ(one.outside, scenario.kind == CampaignKind::outside);
    }
    std::set<std::string> meant;
    for (const HiddenEffect& one : scenario.hidden) {
      meant.insert(one.id);
    }
    EXPECT_EQ(hidden, meant) << seed;
    const std::size_t sessions = settings_of(*plan.recordings, seed).size();
    EXPECT_GE(sessions, 12U);
    EXPECT_LE(sessions, 36U);
    const double samples = plan.recordings->duration_s * plan.recordings->sample_rate_Hz;
    EXPECT_GE(samples, 8 * 100);
    EXPECT_LE(samples, 20 * 200);
  }
}

TEST(Generator, DrivesThatWorkInBothDirectionsHideWhatTheyShould) {
  std::map<std::string, std::size_t> alone;
  std::size_t ones = 0;
  for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
    const Scenario scenario = draw_two_sided(seed);
    const auto plan = parse_synth_plan(scenario.plan, "plan");
    EXPECT_TRUE(plan.two_sided);
    ASSERT_EQ(plan.departures.size(), scenario.hidden.size()) << seed;
    const std::size_t sessions = settings_of(*plan.recordings, seed).size();
    EXPECT_GE(sessions, 12U);
    EXPECT_LE(sessions, 24U);
    if (scenario.kind == CampaignKind::one) {
      ++alone[scenario.hidden.front().id];
      ++ones;
    }
    for (const HiddenEffect& hidden : scenario.hidden) {
      if (hidden.id == "presliding") {
        const double share =
            hidden.numbers.at("length_mm").front() / plan.recordings->travels_mm.front();
        EXPECT_GE(share, 0.02 - 1e-12);
        EXPECT_LE(share, 0.2 + 1e-12);
      }
    }
  }
  ASSERT_EQ(alone.size(), 10U);
  for (const auto& [id, count] : alone) {
    SCOPED_TRACE(id);
    expect_share(count, ones, 1.0 / 10);
  }
}

/// Log-uniform numbers between two bounds have their median at the geometric mean.
void expect_log_uniform(const std::vector<double>& values, double low, double high) {
  std::size_t below = 0;
  for (const double value : values) {
    EXPECT_GE(value, low * (1 - 1e-12));
    EXPECT_LE(value, high * (1 + 1e-12));
    below += value < std::sqrt(low * high) ? 1U : 0U;
  }
  expect_share(below, values.size(), 0.5);
}

// Better at the output, better at the input, alike: a third each. Current has newtons by the drive:
// 0.0125 m / (9 * 0.88 * 0.0325 Nm/A) is 0.048562 A/N.
TEST(Generator, BothEndsHaveNoiseOfTheirOwn) {
  constexpr std::size_t kSome = 1500;
  std::size_t output_better = 0, alike = 0, jittered = 0;
  std::vector<double> output_floors_N, input_floors_N, input_floors_A, jitters_s;
  for (std::uint64_t seed = 1; seed <= kSome; ++seed) {
    const Scenario scenario = draw_recordings(seed);
    const auto noise = parse_synth_plan(scenario.plan, "plan").noise;
    const double output = noise.output.relative_sd;
    const double input = noise.input.relative_sd;
    alike += output == input ? 1 : 0;
    if (output != input) {
      EXPECT_TRUE((output <= 0.01 && input >= 0.005) || (input <= 0.01 && output >= 0.005));
      EXPECT_GE(std::min(output, input), 0.001);
      EXPECT_LE(std::max(output, input), 0.02);
      output_better += output < input ? 1 : 0;
    }
    output_floors_N.push_back(noise.output.absolute_N);
    auto& input_floors = scenario.input == Input::load_cell ? input_floors_N : input_floors_A;
    input_floors.push_back(scenario.input == Input::load_cell ? noise.input.absolute_N
                                                              : noise.input.absolute_A);
    if (noise.jitter_s > 0) {
      jitters_s.push_back(noise.jitter_s);
      ++jittered;
    }
  }
  expect_share(alike, kSome, 1.0 / 3);
  expect_share(output_better, kSome, 1.0 / 3);
  expect_share(jittered, kSome, 1.0 / 3);
  expect_log_uniform(output_floors_N, 0.01, 0.2);
  expect_log_uniform(input_floors_N, 0.01, 0.2);
  expect_log_uniform(input_floors_A, 0.01 * 0.048562, 0.2 * 0.048563);
  expect_log_uniform(jitters_s, 1e-4, 1e-3);
}

TEST(Generator, LivesAreFortyEightOrNinetySix) {
  std::map<std::size_t, std::size_t> counts;
  std::set<std::string> seen;
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    const Scenario scenario = draw_lives(seed, 0);
    const auto plan = parse_synth_plan(scenario.plan, "plan");
    EXPECT_EQ(plan.lives->specimens(), scenario.specimens);
    EXPECT_EQ(plan.departures.size(), scenario.hidden.size());
    ++counts[scenario.specimens];
    for (const HiddenEffect& one : scenario.hidden) {
      seen.insert(one.id);
    }
  }
  ASSERT_EQ(counts.size(), 2U);
  expect_share(counts[48], 500, 0.5);
  expect_share(counts[96], 500, 0.5);
  EXPECT_EQ(seen.size(), 9U);
}

struct Range {
  const char* id;
  const char* parameter;
  double low, high;  ///< of the magnitude
};

const std::vector<HiddenEffect>& all_hidden() {
  static const std::vector<HiddenEffect> all = [] {
    std::vector<HiddenEffect> hidden;
    for (std::uint64_t seed = 1; seed <= kMany; ++seed) {
      for (const HiddenEffect& one : draw_recordings(seed).hidden) {
        hidden.push_back(one);
      }
    }
    return hidden;
  }();
  return all;
}

class SizesTest : public testing::TestWithParam<Range> {};

/// The ranges of the catalogue: of literature and textbooks.
TEST_P(SizesTest, StayWithinPhysics) {
  const Range range = GetParam();
  std::size_t found = 0;
  for (const HiddenEffect& hidden : all_hidden()) {
    if (hidden.id == range.id) {
      const double value = std::abs(hidden.numbers.at(range.parameter).front());
      EXPECT_GE(value, range.low * (1 - 1e-12));
      EXPECT_LE(value, range.high * (1 + 1e-12));
      ++found;
    }
  }
  EXPECT_GT(found, 50U);
}

INSTANTIATE_TEST_SUITE_P(Effects, SizesTest,
                         testing::Values(Range{"friction_wear", "change", 0.1, 1},
                                         Range{"friction_temperature", "slope_1_K", 0.001, 0.005},
                                         Range{"presliding", "length_mm", 0.02 * 15, 0.2 * 45},
                                         Range{"friction_load", "exponent", 0.05, 0.3},
                                         Range{"friction_preload", "force_N", 0.3, 5},
                                         Range{"slack", "dead_zone_mm", 0.1, 2},
                                         Range{"torque_gain", "droop_1_K", 0.0002, 0.002},
                                         Range{"bend_angle", "error_deg", 0, 30},
                                         Range{"filter_lag", "time_constant_ms", 1, 20}),
                         [](const auto& tested) { return std::string(tested.param.id); });

}  // namespace
}  // namespace blind::test
