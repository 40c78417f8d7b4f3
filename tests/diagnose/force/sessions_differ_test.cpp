#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "host_sim/diagnose/force/judgement.hpp"
#include "tests/diagnose/force/findings.hpp"
#include "tests/diagnose/force/joint.hpp"

/// Causes by which sessions differ as wholes, beside what they scatter by.
namespace host_sim::diagnose {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;
using testing::UnorderedElementsAre;

/// 12 N of friction at 20 C, 0.6 % more with each kelvin, of sessions at 20 to 42 C that scatter by
/// 1 %.
TEST(SessionsDiffer, WhatSessionsDifferInIsNoScatter) {
  std::mt19937 engine(4);
  std::normal_distribution<double> scatter(1, 0.01);
  std::vector<effects::ForceRecord> records;
  for (unsigned j = 0; j < 12; ++j) {
    const double temperature_C = 20 + 2 * (5 * j % 12);
    const double preload_N = 12 * (1 + 0.006 * (temperature_C - 20)) * scatter(engine);
    records.push_back(measured_at(temperature_C, {.preload_N = preload_N, .noise_N = 0.2}, 20 + j));
  }
  const Findings findings = findings_of(records);
  EXPECT_THAT(ids_of(findings), UnorderedElementsAre("friction_preload", "friction_temperature"))
      << findings.prose;
  EXPECT_NEAR(estimate(findings, "temperature_coefficient_1_K").value, 0.006, 0.001);
}

/// Friction of 18 sessions that scatters by 4 %, and their gain by 2 %, which is as much of the
/// force: 15 of them at 20 and three at 60 C.
std::vector<effects::ForceRecord> warm_sessions(double of_temperature_1_K, unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> scatter(1, 0.04);
  std::vector<effects::ForceRecord> records;
  for (unsigned j = 0; j < 18; ++j) {
    const double temperature_C = j % 6 == 3 ? 60 : 20;
    const double friction = 0.1 * (1 + of_temperature_1_K * (temperature_C - 20)) * scatter(engine);
    records.push_back(measured_at(
        temperature_C,
        {.friction = friction, .load_N = 20, .still_N = 50, .noise_N = 0.3, .gain_scatter = 0.02},
        100 * seed + j));
  }
  return records;
}

/// Friction of a sheath that follows the air of the room, which turns once in the campaign.
TEST(SessionsDiffer, TheAirOfARoomIsNoWear) {
  const auto sessions = [](double by_air, double by_cycle) {
    std::mt19937 engine(4);
    std::normal_distribution<double> scatter(0, 0.005);
    std::vector<effects::ForceRecord> records;
    for (unsigned j = 0; j < 16; ++j) {
      const double place = (j - 7.5) / 7.5;
      const double friction =
          0.2 * (1 + by_air * (std::sin(2.5 * place) + 0.4 * std::cos(5 * place)) +
                 by_cycle * j / 15 + scatter(engine));
      records.push_back(measured({.friction = friction, .noise_N = 0.2}, 20 + j, 1).front());
      records.back().session = "s" + std::to_string(10 + j);
      records.back().cycle.assign(records.back().samples(), 400.0 * j);
    }
    return findings_of(records);
  };
  const Findings of_air = sessions(0.2, 0);
  EXPECT_THAT(ids_of(of_air), Not(Contains("friction_wear"))) << of_air.prose;
  EXPECT_EQ(of_air.remainder.value().covariate, "order of sessions");
  EXPECT_THAT(ids_of(sessions(0, 0.4)), Contains("friction_wear"));
}

TEST(SessionsDiffer, WhatMovesSessionsIsNamedBesideTheirScatter) {
  for (const unsigned seed : {5U, 6U, 7U}) {
    const Findings findings = findings_of(warm_sessions(0.005, seed));
    EXPECT_THAT(ids_of(findings), ElementsAre("friction_temperature")) << findings.prose;
    EXPECT_THAT(ids_of(findings_of(warm_sessions(0, seed))), IsEmpty());
  }
}

/// What shifts friction of whole sessions of a tendon by direction.
struct Shifted {
  double gear_asymmetry = 0;
  std::array<double, 3> pose_errors_deg{};
  double friction_scatter = 0.03;
  double noise_N = 0.2;  ///< of the input
};

/// Sessions of a motor current at 80, 200 and 340 degrees in turn, friction coefficient 0.1.
std::vector<effects::ForceRecord> shifted(const Shifted& shift, unsigned seed) {
  constexpr std::array kPoses_deg{80.0, 200.0, 340.0};
  constexpr double kRadPerDeg = std::numbers::pi / 180;
  std::vector<effects::ForceRecord> records =
      measured({.load_N = 15, .still_N = 40, .noise_N = 0.1}, seed, 18);
  std::mt19937 engine(seed);
  std::normal_distribution<double> noise(0, shift.noise_N);
  std::normal_distribution<double> scatter(1, shift.friction_scatter);
  for (std::size_t j = 0; j < records.size(); ++j) {
    effects::ForceRecord& record = records[j];
    record.pulls_alone = true;
    record.input_N_per_A = 20;
    const double pose_deg = kPoses_deg[j % 3];
    record.bend_angle_rad.assign(record.samples(), pose_deg * kRadPerDeg);
    const double log_ratio =
        0.1 * scatter(engine) * (pose_deg + shift.pose_errors_deg[j % 3]) * kRadPerDeg;
    for (std::size_t i = 0; i < record.samples(); ++i) {
      const double slip = std::tanh(record.velocity_m_s[i] / 1e-3);
      record.input_N[i] =
          record.output_N[i] * std::exp(log_ratio * slip) / (1 + shift.gear_asymmetry * slip) +
          noise(engine);
    }
  }
  return records;
}

/// An asymmetry of 3 % is as much at each pose, and a gear has one number where poses have two.
/// Errors of 12 degrees either way lie on no line.
TEST(SessionsDiffer, AnAsymmetryOfTheGearIsToldFromErrorsOfThePose) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Findings of_gear = findings_of(shifted({.gear_asymmetry = 0.03}, seed));
    ASSERT_FALSE(of_gear.candidates.empty());
    EXPECT_EQ(of_gear.candidates.front().id, "gear_asymmetry") << of_gear.prose;
    EXPECT_THAT(ids_of(of_gear), ElementsAre("gear_asymmetry")) << of_gear.prose;
    EXPECT_NEAR(estimate(of_gear, "gear_asymmetry").value, 0.03, 0.008);
    const Findings of_pose = findings_of(shifted({.pose_errors_deg = {12, -12, 0}}, seed));
    EXPECT_THAT(ids_of(of_pose), ElementsAre("bend_angle")) << of_pose.prose;
  }
}

/// 0.15 N beside noise of 1 N: 2 % of the squared error, and the same in every session. Errors of
/// the pose come near to it by chance in some campaigns.
TEST(SessionsDiffer, AnAsymmetryBelowTheNoiseIsNoStructureWithoutACause) {
  constexpr unsigned kTimes = 6;
  int first = 0;
  for (unsigned seed = 1; seed <= kTimes; ++seed) {
    const Findings findings = findings_of(
        shifted({.gear_asymmetry = 0.0035, .friction_scatter = 0.002, .noise_N = 1}, seed));
    EXPECT_TRUE(findings.verdict == Verdict::named || findings.verdict == Verdict::ambiguous)
        << findings.prose;
    ASSERT_FALSE(findings.candidates.empty());
    first += findings.candidates.front().id == "gear_asymmetry" ? 1 : 0;
  }
  EXPECT_GE(first, 4);
}

/// Errors of 24 degrees: beside the largest pose, which is taken to be right, of 41 at another one.
TEST(SessionsDiffer, PosesMayAllBeOff) {
  const Findings findings = findings_of(shifted({.pose_errors_deg = {-24, 24, -24}}, 4));
  EXPECT_THAT(ids_of(findings), ElementsAre("bend_angle")) << findings.prose;
  constexpr double kDegPerRad = 180 / std::numbers::pi;
  EXPECT_NEAR(estimate(findings, "bend_angle_error_rad_at_80_deg").value * kDegPerRad,
              (80 - 24) * 340.0 / (340 - 24) - 80, 5);
  EXPECT_NEAR(estimate(findings, "bend_angle_error_rad_at_200_deg").value * kDegPerRad,
              (200 + 24) * 340.0 / (340 - 24) - 200, 5);
}

/// Eight units of ln likelihood are four standard errors.
TEST(SessionsDiffer, LawsOfOneEffectAreToldApartByHowSessionsScatter) {
  using enum effects::ForceTerm;
  EXPECT_DOUBLE_EQ(seen_as_better(run_in, {.z = 1, .of_sessions = 8}), 4);
  EXPECT_DOUBLE_EQ(seen_as_better(run_in, {.z = 1, .of_sessions = -8}), -4);
  EXPECT_DOUBLE_EQ(seen_as_better(velocity, {.z = 1, .of_sessions = 8}), 1);
}

/// 3.2 standard errors are 5.12 units; sessions as wholes say more of a sensor, once it is seen.
TEST(SessionsDiffer, ASensorThatShiftsThemIsSeenByHowTheyScatter) {
  const auto evidence = [](double z, double within_N2) {
    return evidence_of(effects::ForceTerm::gear_asymmetry,
                       {.z = z, .of_sessions = 12, .moved_N2 = 1, .within_N2 = within_N2});
  };
  EXPECT_DOUBLE_EQ(evidence(3.2, 0.001), 12);
  EXPECT_DOUBLE_EQ(evidence(3.2, 0.5), 5.12);
  EXPECT_DOUBLE_EQ(evidence(2, 0.001), 2);
}

/// Within sessions, five standard errors are 12.5 units: nothing of a shift that leaves three times
/// as much there as it says, nor of one of three standard errors.
TEST(SessionsDiffer, WhatAShiftLeavesWithinThemCountsWhereItIsClearAndAsLargeAsItSays) {
  const auto evidence = [](double z, double slope) {
    return evidence_of(effects::ForceTerm::bend_angle, {.of_sessions = 1,
                                                        .moved_N2 = 1,
                                                        .within_N2 = 0.001,
                                                        .z_within = z,
                                                        .slope_within = slope,
                                                        .error_within = slope / z});
  };
  EXPECT_DOUBLE_EQ(evidence(5, 1.0), 13.5);
  EXPECT_DOUBLE_EQ(evidence(5, 0.7), 13.5);
  EXPECT_DOUBLE_EQ(evidence(5, 3.0), 1);
  EXPECT_DOUBLE_EQ(evidence(3, 1.0), 1);
}

/// A sheath at 1 and 3 rad that sways by 0.25 rad and is bent by 0.15 rad more than is known at
/// the first of them: 0.15 more friction, where sessions scatter by 0.1 of it.
TEST(SessionsDiffer, APoseThatSwaysShowsHowFarItIsOff) {
  std::mt19937 engine(5);
  std::normal_distribution<double> scatter(0.1, 0.01);
  std::normal_distribution<double> noise(0, 0.1);
  std::vector<effects::ForceRecord> records;
  for (unsigned j = 0; j < 16; ++j) {
    effects::ForceRecord record =
        measured({.friction = 0, .load_N = 20, .still_N = 50, .noise_N = 0.1, .samples = 250},
                 70 + j, 1)
            .front();
    record.session = "s" + std::to_string(10 + j);
    const double friction = scatter(engine);
    const double pose_rad = j % 2 == 0 ? 1 : 3;
    const double off_rad = j % 2 == 0 ? 0.15 : 0;
    for (std::size_t i = 0; i < record.samples(); ++i) {
      const double bend_rad = pose_rad + 0.25 * std::sin(9 * record.time_s[i]);
      const double slip = std::tanh(record.velocity_m_s[i] / 1e-3);
      record.bend_angle_rad[i] = bend_rad;
      record.input_N[i] =
          record.output_N[i] * std::exp(slip * friction * (bend_rad + off_rad)) + noise(engine);
    }
    records.push_back(record);
  }
  const Findings findings = findings_of(records);
  EXPECT_THAT(ids_of(findings), ElementsAre("bend_angle")) << findings.prose;
}

/// Friction that falls by a third in the first 500 cycles is no wear, whose power of the cycles
/// takes most of that off, too.
TEST(SessionsDiffer, FrictionThatRunsInIsToldFromWear) {
  std::mt19937 engine(8);
  std::normal_distribution<double> scatter(1, 0.01);
  std::vector<effects::ForceRecord> records;
  for (unsigned j = 0; j < 16; ++j) {
    constexpr std::array kCycles{0.0, 300.0, 1200.0, 9500.0};
    const double cycle = kCycles[j % 4];
    records.push_back(
        measured({.friction = 0.1 * (1 + 0.5 * std::exp(-cycle / 500)) * scatter(engine),
                  .noise_N = 0.3},
                 40 + j, 1)
            .front());
    records.back().session = "s" + std::to_string(10 + j);
    records.back().cycle.assign(records.back().samples(), cycle);
  }
  const Findings findings = findings_of(records);
  ASSERT_THAT(ids_of(findings), ElementsAre("friction_wear")) << findings.prose;
  EXPECT_EQ(findings.effects.front().term, "run-in of the sheath");
  EXPECT_NEAR(estimate(findings, "wear_coefficient").value, 0.5, 0.1);
  EXPECT_NEAR(estimate(findings, "run_in_cycles").value, 500, 150);
}

/// Friction of sessions that differ by a third for no reason that was recorded, where by chance the
/// temperature takes off much of that, and less than still scatters.
TEST(SessionsDiffer, WhatLeavesThemScatteringByMoreIsNoCause) {
  for (const unsigned seed : {6U, 21U}) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> scatter(0.65, 1.35);
    std::vector<effects::ForceRecord> records;
    for (unsigned j = 0; j < 12; ++j) {
      records.push_back(
          measured({.friction = 0.2 * scatter(engine), .noise_N = 0.3}, 60 * seed + j, 1).front());
      records.back().session = "s" + std::to_string(10 + j);
      records.back().cycle.assign(records.back().samples(), 700.0 * (j * 5 % 4));
      records.back().sheath_temperature_C.assign(records.back().samples(), 20.0 + 15 * (j * 7 % 3));
    }
    const Findings findings = findings_of(records);
    EXPECT_EQ(findings.verdict, Verdict::unknown) << findings.prose;
  }
}

}  // namespace
}  // namespace host_sim::diagnose
