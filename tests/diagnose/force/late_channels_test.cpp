#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

#include "host_sim/diagnose/force/diagnose_forces.hpp"
#include "host_sim/diagnose/force/smoothing.hpp"
#include "tests/diagnose/force/findings.hpp"
#include "tests/diagnose/force/joint.hpp"

namespace host_sim::diagnose {
namespace {

using testing::AnyOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

/// The friction turns over at once, and shows three samples later: a lag would bring it on slowly.
TEST(DiagnoseForces, AChannelThatIsLateIsNoLag) {
  std::vector<effects::ForceRecord> records = measured({.preload_N = 12, .noise_N = 0.2}, 5);
  for (effects::ForceRecord& record : records) {
    std::rotate(record.input_N.begin(), record.input_N.end() - 3, record.input_N.end());
    std::fill_n(record.used.begin(), 3, false);
  }
  const Findings findings = findings_of(records);
  EXPECT_EQ(findings.verdict, Verdict::named) << findings.prose;
  EXPECT_THAT(ids_of(findings), UnorderedElementsAre("friction_preload", "channel_delay"));
  EXPECT_NEAR(estimate(findings, "delay_s").value, -0.03, 0.005);  // half a sample
}

/// Friction follows the motion through filters that both forces have, and load and motion are as
/// they are: nothing keeps friction back, and no channel is late beside the other.
TEST(DiagnoseForces, FilteredForcesHideNothing) {
  const Findings findings =
      findings_of(measured({.preload_N = 12, .noise_N = 0.1, .late_s = 0.008}, 5));
  EXPECT_EQ(findings.verdict, Verdict::named) << findings.prose;
  EXPECT_THAT(ids_of(findings), ElementsAre("friction_preload")) << findings.prose;
  ASSERT_EQ(findings.doubts.size(), 1U);
  EXPECT_EQ(findings.doubts.front().column, "tendon_velocity_m_s");
  EXPECT_FALSE(findings.doubts.front().spoils);
  EXPECT_THAT(findings.doubts.front().words, HasSubstr("turns over"));
}

/// A joint with an input that is read as `read` says of its course at 4000 Hz, and kept at 200 Hz.
std::vector<effects::ForceRecord> read_late(
    const std::function<void(std::vector<double>& input_N, double step_s)>& read) {
  constexpr std::size_t kEach = 20;
  std::vector<effects::ForceRecord> records =
      measured({.preload_N = 12, .noise_N = 0.2, .samples = 40000}, 5);
  for (effects::ForceRecord& record : records) {
    read(record.input_N, record.time_s[1]);
    thin(record, record.samples() / kEach);
  }
  return records;
}

/// 6 ms, of records of which every second sample is kept: 10 ms apart.
TEST(DiagnoseForces, ALagOfTheInputIsToldFromADelayBetweenTheSamplesThatAreKept) {
  const Findings behind = findings_of(read_late([](std::vector<double>& input_N, double step_s) {
    double reads_N = input_N.front();
    for (double& value_N : input_N) {
      reads_N += (1 - std::exp(-step_s / 0.006)) * (value_N - reads_N);
      value_N = reads_N;
    }
  }));
  EXPECT_THAT(ids_of(behind), UnorderedElementsAre("friction_preload", "filter_lag"))
      << behind.prose;
  EXPECT_NEAR(estimate(behind, "lag_s").value, -0.006, 0.0005);
  const Findings late = findings_of(read_late([](std::vector<double>& input_N, double step_s) {
    std::shift_right(input_N.begin(), input_N.end(), std::lround(0.006 / step_s));
  }));
  EXPECT_THAT(ids_of(late), UnorderedElementsAre("friction_preload", "channel_delay"))
      << late.prose;
  EXPECT_NEAR(estimate(late, "delay_s").value, -0.006, 0.0005);
}

/// The input is read with a lag of 40 ms.
std::vector<effects::ForceRecord> lagging(std::vector<effects::ForceRecord> records) {
  const double share = 1 - std::exp(-0.01 / 0.04);
  for (effects::ForceRecord& record : records) {
    double reads_N = record.input_N.front();
    for (double& input_N : record.input_N) {
      reads_N += share * (input_N - reads_N);
      input_N = reads_N;
    }
  }
  return records;
}

/// Friction that is larger one way, which a zero would be as well, takes nothing from a lag that
/// may be a delay: one of the two is there.
TEST(DiagnoseForces, WhatMayBeOutsideTheCatalogueIsNoDoubtOfTheOthers) {
  const Findings findings = findings_of(lagging(
      measured({.friction = 0.1, .turn_over_m_s = 0.05, .one_way = 0.4, .noise_N = 0.2}, 1)));
  EXPECT_EQ(findings.verdict, Verdict::ambiguous) << findings.prose;
  EXPECT_THAT(ids_of(findings), ElementsAre(AnyOf("filter_lag", "channel_delay")));
  EXPECT_THAT(findings.prose, HasSubstr("looks like zero of the output sensor"));
}

/// Of the smooth load, 40 N at 0.7 Hz, a delay takes off all but (0.04 * 2 pi * 0.7/2)^2 = 0.8 %:
/// too little to say that it is none.
TEST(DiagnoseForces, OfASmoothForceALagIsAsLikelyAsADelay) {
  const Findings findings = findings_of(lagging(measured({.friction = 0, .noise_N = 0.2}, 8)));
  EXPECT_EQ(findings.verdict, Verdict::ambiguous) << findings.prose;
  EXPECT_THAT(findings.equivalent_sets,
              ElementsAre(UnorderedElementsAre("filter_lag", "channel_delay")));
  ASSERT_GE(findings.candidates.size(), 2U);
  EXPECT_THAT(findings.candidates[0].id, AnyOf("filter_lag", "channel_delay"));
  EXPECT_NEAR(findings.candidates[0].probability, findings.candidates[1].probability, 0.01);
  double of_either = 0;
  for (const Candidate& candidate : findings.candidates) {
    const std::vector<std::string_view> ids = effects_in(candidate.id);
    const bool either = std::ranges::any_of(
        ids, [](std::string_view id) { return id == "filter_lag" || id == "channel_delay"; });
    of_either += either ? candidate.probability : 0;
  }
  EXPECT_GT(of_either, 0.95);
}

/// A drive that has no friction, whose output is read half a sample late.
TEST(DiagnoseForces, WithoutFrictionAnOutputThatIsLateIsSeen) {
  std::vector<effects::ForceRecord> records = measured({.friction = 0}, 3);
  for (effects::ForceRecord& record : records) {
    for (std::size_t i = 0; i < record.samples(); ++i) {
      record.output_N[i] -= 0.005 * record.output_rate_N_s[i];
    }
  }
  const Findings findings = findings_of(records);
  EXPECT_EQ(findings.verdict, Verdict::ambiguous) << findings.prose;
  EXPECT_THAT(findings.equivalent_sets,
              ElementsAre(UnorderedElementsAre("filter_lag", "channel_delay")));
}

}  // namespace
}  // namespace host_sim::diagnose
