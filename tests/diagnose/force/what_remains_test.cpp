#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "host_sim/diagnose/force/diagnose_forces.hpp"
#include "tests/diagnose/force/findings.hpp"
#include "tests/diagnose/force/joint.hpp"

namespace host_sim::diagnose {
namespace {

using testing::AnyOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// What is left is surely more than noise, and shows most against this.
void expect_remainder(const Findings& findings, const testing::Matcher<std::string>& covariate) {
  ASSERT_TRUE(findings.remainder);
  EXPECT_THAT(findings.remainder->covariate, covariate);
  EXPECT_LT(findings.remainder->p, 0.01);
}

TEST(DiagnoseForces, WhatRemainsIsDrawnByDirectionForBothModels) {
  const TensionDiagnosis diagnosis =
      diagnose_forces(measured({.preload_N = 12, .viscous_N_s_m = 150}, 3), nominal(), kWire, {});
  ASSERT_EQ(diagnosis.remainders.size(), 6U);  // friction shows against all of them
  EXPECT_EQ(diagnosis.remainders[0].covariate, diagnosis.findings.remainder->covariate);
  EXPECT_EQ(diagnosis.remainders[1].covariate, diagnosis.remainders[0].covariate);
  EXPECT_NE(diagnosis.remainders[2].covariate, diagnosis.remainders[0].covariate);
  const auto mean = [](const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) {
      sum += value;
    }
    return sum / static_cast<double>(values.size());
  };
  for (const RemainderPicture& picture : diagnosis.remainders) {
    ASSERT_GE(picture.centre.size(), 4U);
    EXPECT_TRUE(std::ranges::is_sorted(picture.centre));
    for (std::size_t i = 0; i < picture.centre.size(); ++i) {
      EXPECT_LT(std::abs(picture.after_N[i]), 12.0 / 20) << picture.centre[i];
      EXPECT_GT(picture.after_sd_N[i], 0);
    }
  }
  EXPECT_EQ(diagnosis.remainders[0].direction, 1);
  EXPECT_EQ(diagnosis.remainders[1].direction, -1);
  // Friction that the nominal model lacks is against the motion, a fifth of it at the least.
  EXPECT_LT(mean(diagnosis.remainders[0].before_N) * mean(diagnosis.remainders[1].before_N),
            -std::pow(12.0 / 5, 2));
}

TEST(DiagnoseForces, WhatIsOutsideTheCatalogueIsNoneOfItsCauses) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Findings findings = findings_of(measured({.cogging_N = 6}, seed));
    EXPECT_NE(findings.verdict, Verdict::named) << findings.prose;
  }
}

TEST(DiagnoseForces, ACauseIsNamedAlthoughMoreIsWrong) {
  const Findings findings = findings_of(measured({.preload_N = 12, .cogging_N = 3}, 4));
  EXPECT_EQ(findings.verdict, Verdict::named) << findings.prose;
  EXPECT_THAT(ids_of(findings), Contains("friction_preload"));
  expect_remainder(findings, "position");
}

TEST(DiagnoseForces, WhatDriftsInEverySessionRemainsAgainstTime) {
  const Findings findings = findings_of(measured({.gain_scatter = 0.02, .drift_N = 0.5}, 6));
  EXPECT_EQ(findings.verdict, Verdict::unknown) << findings.prose;
  expect_remainder(findings, "time");
}

/// 1.4 N at the fastest of twelve sessions, 0.06 N at the slowest, and in each in proportion to the
/// position.
TEST(DiagnoseForces, AMassThatIsMovedRemainsAgainstAccelerationOrPosition) {
  const Findings findings = findings_of(measured({.noise_N = 0.3, .moved_kg = 0.35}, 7));
  EXPECT_EQ(findings.verdict, Verdict::unknown) << findings.prose;
  expect_remainder(findings, AnyOf("acceleration", "position"));
}

/// At a chance of 1 % for each, more than two of 40 have one of 0.7 %.
TEST(DiagnoseForces, GainsThatScatterLeaveNoRemainder) {
  int alarms = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    alarms +=
        findings_of(measured({.gain_scatter = 0.02}, seed)).verdict == Verdict::unknown ? 1 : 0;
  }
  EXPECT_LE(alarms, 2);
}

/// The force beside the cause is 6 N x/0.05 m, whichever way the motion goes.
TEST(DiagnoseForces, WhatRepeatsBesideACauseIsACorrectionAndNoCause) {
  const Findings findings = findings_of(measured({.preload_N = 12, .spring_N = 6}, 8));
  EXPECT_EQ(findings.verdict, Verdict::named) << findings.prose;
  ASSERT_TRUE(findings.correction) << findings.prose;
  EXPECT_EQ(findings.correction->covariate, "position");
  // Uniform in time the position of a sine has a mean square of a half: 6 N / sqrt(2), and the
  // noise of both ends.
  EXPECT_NEAR(findings.correction->before_N, std::hypot(6 / std::sqrt(2), 0.7), 0.6);
  EXPECT_LT(findings.correction->after_N, 1.1);
  EXPECT_DOUBLE_EQ(metric(findings, "input_rmse_N", true), findings.correction->after_N);
  EXPECT_EQ(findings.extensions.back().id, "empirical");
  EXPECT_THAT(ids_of(findings), Not(Contains("empirical")));
  EXPECT_THAT(findings.candidates.front().id, Not(HasSubstr("empirical")));
  EXPECT_THAT(findings.prose, HasSubstr("which is no cause"));
}

TEST(DiagnoseForces, WhatHasNoCauseAndRepeatsIsCorrectedAndStaysUnknown) {
  const Findings findings = findings_of(measured({.spring_N = 6}, 8));
  EXPECT_EQ(findings.verdict, Verdict::unknown) << findings.prose;
  EXPECT_THAT(ids_of(findings), IsEmpty());
  ASSERT_TRUE(findings.correction) << findings.prose;
  ASSERT_EQ(findings.extensions.size(), 1U);
  EXPECT_EQ(findings.extensions[0].id, "empirical");
  // 6 N / sqrt(2), and the noise of both ends.
  EXPECT_NEAR(findings.correction->before_N, std::hypot(6 / std::sqrt(2), 0.7), 0.6);
  EXPECT_LT(findings.correction->after_N, 1.1);
  EXPECT_DOUBLE_EQ(metric(findings, "input_rmse_N", false), findings.correction->before_N);
}

/// The sheath warms by 10 K in the course of each session, in which the input rises by 3 %: what
/// else could do that is said unless more than one effect would have to stand for it.
TEST(DiagnoseForces, AnInputThatSettlesInEachSessionIsNoFrictionByTemperature) {
  constexpr unsigned kTimes = 4;
  int said = 0;
  for (unsigned seed = 12; seed < 12 + kTimes; ++seed) {
    std::vector<effects::ForceRecord> records = measured(
        {.friction = 0.3, .load_N = 15, .still_N = 40, .noise_N = 0.1, .gain_scatter = 0.002},
        seed);
    std::mt19937 engine(seed);
    std::normal_distribution<double> noise_C(0, 0.1);
    for (effects::ForceRecord& record : records) {
      record.pulls_alone = true;
      for (std::size_t i = 0; i < record.samples(); ++i) {
        const double settled = 1 - std::exp(-record.time_s[i] / 1.5);
        record.sheath_temperature_C.push_back(20 + 10 * settled + noise_C(engine));
        record.input_N[i] *= 1 + 0.03 * settled;
      }
    }
    const Findings findings = diagnose_forces(records, nominal(), kWire, {}).findings;
    EXPECT_THAT(ids_of(findings), Not(Contains("friction_temperature"))) << findings.prose;
    EXPECT_EQ(findings.verdict, Verdict::unknown);
    said += findings.prose.find("settles in the course of each session") != std::string::npos;
  }
  EXPECT_GE(said, 1);
}

/// The cogging that the catalogue does not have is a cause of its own by 30 %.
TEST(DiagnoseForces, WhatStandsBesideCausesLeavesThemAPartOfTheProbabilityToBeAll) {
  const Findings findings = findings_of(measured({.preload_N = 12, .cogging_N = 3}, 4));
  ASSERT_GE(findings.candidates.size(), 2U);
  EXPECT_THAT(findings.candidates[0].id, HasSubstr("friction_preload"));
  EXPECT_NEAR(findings.candidates[0].probability, 0.7, 0.01);
  EXPECT_EQ(findings.candidates[1].id, findings.candidates[0].id + "+unknown");
  EXPECT_NEAR(findings.candidates[1].probability, 0.3, 0.01);
  EXPECT_GT(findings.effects.front().probability, 0.99);
}

/// With a force of samples more, on for 1.2 s in 2.5 s, in each session later by some.
template <typename Force>
std::vector<effects::ForceRecord> in_bursts(std::vector<effects::ForceRecord> records,
                                            double later_s, const Force& force_N) {
  double begun_s = 0;
  for (effects::ForceRecord& record : records) {
    begun_s += later_s;
    for (std::size_t i = 0; i < record.samples(); ++i) {
      const bool on = std::fmod(record.time_s[i] + begun_s, 2.5) < 1.2;
      record.input_N[i] += on ? force_N(record, i) : 0;
    }
  }
  return records;
}

/// Chatter of 2 N at 9 Hz, on for 1.2 s in 2.5 s, at times of its own in each session.
TEST(DiagnoseForces, WhatComesInBurstsIsUnknown) {
  const auto chattering = [](double size_N) {
    std::vector<effects::ForceRecord> records =
        measured({.friction = 0.2, .still_N = 60, .noise_N = 0.3, .gain_scatter = 0.002}, 10);
    for (effects::ForceRecord& record : records) {
      record.pulls_alone = true;
    }
    return findings_of(in_bursts(std::move(records), 0.6, [&](const auto& record, std::size_t i) {
      return size_N * std::sin(2 * std::numbers::pi * 9 * record.time_s[i]);
    }));
  };
  EXPECT_EQ(chattering(0).verdict, Verdict::none);
  const Findings findings = chattering(2);
  EXPECT_EQ(findings.verdict, Verdict::unknown)
      << findings.discrepancies.back().statistic << ' ' << findings.discrepancies.back().p_after;
  EXPECT_EQ(findings.remainder.value().covariate, "time");
}

/// A quarter more friction for 1.2 s at times of each session's own: as often against the
/// force as with it, and as large in one session as in another.
TEST(DiagnoseForces, FrictionThatStaysForAWhileIsUnknown) {
  const auto sticking = [](double share) {
    const Joint joint{.friction = 0.02, .preload_N = 8, .noise_N = 0.3, .gain_scatter = 0.002};
    return findings_of(in_bursts(measured(joint, 10), 0.7, [&](const auto& record, std::size_t i) {
      return share * 8 * std::tanh(record.velocity_m_s[i] / 1e-3);
    }));
  };
  const double chance = sticking(0).discrepancies.back().p_after;
  EXPECT_GT(chance, 0.01);
  const Findings findings = sticking(0.25);
  EXPECT_EQ(findings.remainder.value().covariate, "time");
  EXPECT_THAT(ids_of(findings), ElementsAre("friction_preload"));
}

/// Eight that all agree: of 2^8 ways to turn them over two are as large, whatever the seed.
TEST(DiagnoseForces, FewSessionsAreTurnedOverInAllWays) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    DiagnoseOptions options;
    options.seed = seed;
    const Findings findings =
        diagnose_forces(measured({.spring_N = 6}, 3, 8), nominal(), kWire, options).findings;
    const auto position =
        std::ranges::find(findings.discrepancies, "position", &Discrepancy::covariate);
    ASSERT_NE(position, findings.discrepancies.end());
    EXPECT_EQ(position->p, 2.0 / 256);
  }
}

}  // namespace
}  // namespace host_sim::diagnose
