#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>
#include <string>

#include "hal/files/input_file.hpp"
#include "host_sim/replay/replay.hpp"
#include "host_sim/replay/results.hpp"
#include "tests/extension/models.hpp"

namespace host_sim {

using hal::files::memory_source;
using hal::files::ProfileReader;

namespace {

using extension_test::model_with;

/// What the estimator may differ from the equations in damage.
constexpr double kMostError = 2e-6;

/// 20 s at 1 kHz: a sine of 2 Hz over 40 mm while the load goes at another frequency, both ends
/// warming up.
std::string profile(bool current) {
  std::string text = fmt::format(
      "time_s,{},tendon_velocity_m_s,motor_angle_rad,"
      "sheath_temperature_C,winding_temperature_C\n",
      current ? "motor_current_A" : "output_tension_N");
  for (int i = 0; i < 20'000; ++i) {
    const double time_s = i * 1e-3;
    const double angle_rad = 2 * std::numbers::pi * 2 * time_s;
    const double load_N = 40 - 15 * std::cos(2 * std::numbers::pi * 2.3 * time_s);
    text += fmt::format("{},{},{},{},{},{}\n", time_s, current ? load_N / 20.592 : load_N,
                        0.02 * 4 * std::numbers::pi * std::sin(angle_rad),
                        -0.02 * std::cos(angle_rad) * 9 / 0.0125, 20 + time_s, 20 + 3 * time_s);
  }
  return text;
}

ReplayResult replay_of(const std::string& text, const Model& model, std::uint32_t start_cycle = 0) {
  ProfileReader reader(memory_source(text), "profile.csv");
  ReplayOptions options;
  options.can = [](hal::Time, const hal::CanFrame&) {};
  options.start_cycle = start_cycle;
  return replay(reader, model, "model.toml", options);
}

struct Case {
  const char* name;
  const char* table;
  bool current;
};

std::ostream& operator<<(std::ostream& out, const Case& each) {
  return out << each.name;
}

class ExtendedReplay : public testing::TestWithParam<Case> {};

/// The estimator, the whole firmware and the equations agree, and differ from the nominal model.
TEST_P(ExtendedReplay, EvaluatesTheEffectAsItsEquations) {
  const std::string text = profile(GetParam().current);
  const ReplayResult nominal = replay_of(text, model_with(""));
  const ReplayResult result = replay_of(text, model_with(GetParam().table), 3000);
  RecordProperty("relative_error", fmt::format("{}", result.relative_error));
  EXPECT_LT(std::fabs(result.relative_error), kMostError);
  EXPECT_GT(std::fabs(result.damage.total / nominal.damage.total - 1), 1e-3);
  EXPECT_EQ(result.extensions, std::vector<std::string>{GetParam().name});
  EXPECT_TRUE(result.not_evaluated.empty());
  EXPECT_GT(*result.can_frames, 100u);
  EXPECT_NE(result.model_digest, nominal.model_digest);
}

INSTANTIATE_TEST_SUITE_P(
    EachEffect, ExtendedReplay,
    testing::Values(
        Case{"bend_angle",
             "[extension.bend_angle]\nbend_angle_error_rad = [0.2, -0.3]\n"
             "bend_angles_deg = [90, 270]\n",
             false},
        Case{"current_offset", "[extension.current_offset]\ncurrent_offset_A = 0.05\n", true},
        Case{"filter_lag", "[extension.filter_lag]\nlag_s = 0.01\n", false},
        Case{"filter_lag", "[extension.filter_lag]\nlag_s = -0.01\n", true},
        Case{"friction_load", "[extension.friction_load]\nload_exponent = 0.2\n", false},
        Case{"friction_position",
             "[extension.friction_position]\nposition_sine_1 = 0.2\nposition_cosine_1 = 0\n"
             "position_sine_2 = 0.1\nposition_cosine_2 = 0.05\nposition_sine_3 = 0\n"
             "position_cosine_3 = 0.03\nposition_sine_4 = 0\nposition_cosine_4 = 0.02\n"
             "position_sine_5 = 0.01\nposition_cosine_5 = 0\nposition_sine_6 = 0\n"
             "position_cosine_6 = 0.01\nwavelength_m = 0.04\n",
             false},
        Case{"friction_preload", "[extension.friction_preload]\npreload_N = 3\n", false},
        Case{"friction_temperature",
             "[extension.friction_temperature]\ntemperature_coefficient_1_K = 0.01\n", false},
        Case{"friction_velocity",
             "[extension.friction_velocity]\nstribeck_friction = 0.05\n"
             "viscous_friction_s_m = 0.5\nstribeck_velocity_m_s = 0.02\n",
             false},
        Case{"friction_velocity", "[extension.friction_velocity]\nviscous_N_s_m = 20\n", false},
        Case{"load_cell_zero", "[extension.load_cell_zero]\nzero_N = 2\n", false},
        Case{"empirical",
             "[extension.empirical]\nposition_m = [-0.01, 0, 0.01]\npulling_N = [1, 4, 2]\n"
             "letting_go_N = [0, -3, -1]\n",
             false},
        Case{"empirical",
             "[extension.empirical]\ntravel_m = [0, 0.005, 0.02]\npulling_N = [-3, 0, 3]\n"
             "letting_go_N = [4, 0, -2]\n",
             false},
        Case{"presliding", "[extension.presliding]\npresliding_length_m = 0.005\n", false},
        Case{"friction_wear",
             "[extension.friction_wear]\nwear_coefficient = 0.3\nwear_exponent = 0.5\n"
             "run_in_cycles = 0\n",
             false},
        Case{"friction_wear",
             "[extension.friction_wear]\nwear_coefficient = 0.5\nwear_exponent = 0\n"
             "run_in_cycles = 3000\n",
             false},
        Case{"bending_fatigue",
             "[extension.bending_fatigue]\nbending_share = 1\nbending_N = 400\n"
             "wire_to_bend_ratio = 0.02\n",
             false},
        Case{"endurance_limit",
             "[extension.endurance_limit]\nendurance_share = 1\nlimit_log_sd = 0.1\n"
             "limit_of_lowest = 0.5\nlowest_effective_N = 20\n",
             true},
        Case{"mean_stress",
             "[extension.mean_stress]\nmean_stress_share = 1\nwalker_exponent = 0.5\n", true},
        Case{"gear_asymmetry", "[extension.gear_asymmetry]\ngear_asymmetry = 0.03\n", true},
        Case{"torque_gain", "[extension.torque_gain]\ndroop_1_K = 0.002\n", true},
        Case{"torque_ripple",
             "[extension.torque_ripple]\nripple_sine_A = 0.05\nripple_cosine_A = 0.02\n"
             "ripple_harmonic = 6\n",
             true}));

constexpr const char* kOffsetAndLoad =
    "[extension.current_offset]\ncurrent_offset_A = 0.05\n"
    "[extension.friction_load]\nload_exponent = 0.2\n";

TEST(ExtendedReplayResult, WhatDoesNotActIsTold) {
  const ReplayResult result = replay_of(profile(true), model_with(kOffsetAndLoad));
  EXPECT_EQ(result.extensions, std::vector<std::string>{"current_offset"});
  ASSERT_EQ(result.not_evaluated.size(), 1u);
  EXPECT_EQ(result.not_evaluated.front().id, "friction_load");
  const auto json = nlohmann::json::parse(replay_json(result));
  EXPECT_EQ(json["not_evaluated"][0]["why"],
            "acts on an output tension, and the input is a motor current");
  std::ostringstream summary;
  write_summary(summary, result, "p.csv", "m.toml");
  EXPECT_NE(summary.str().find("left out      friction_load: acts on"), std::string::npos);
  EXPECT_NE(summary.str().find("extension     current_offset"), std::string::npos);
  ReplayReport report;
  fill_report(report, result, model_with(kOffsetAndLoad));
  EXPECT_EQ(report.model_constants.back().name, "current_offset_A of current_offset");
  EXPECT_EQ(report.model_constants.back().value, 0.05);
  EXPECT_EQ(
      report.warnings.back(),
      "friction_load is left out: acts on an output tension, and the input is a motor current");
}

TEST(ExtendedReplayResult, ACorrectionIsNoExtensionInWords) {
  const ReplayResult result = replay_of(
      profile(false), model_with("[extension.empirical]\nspeed_m_s = [0, 0.1]\npulling_N = [0, 2]\n"
                                 "letting_go_N = [0, -2]\n"));
  std::ostringstream summary;
  write_summary(summary, result, "p.csv", "m.toml");
  EXPECT_NE(summary.str().find("  correction    empirical\n"), std::string::npos);
  EXPECT_EQ(summary.str().find("extension     empirical"), std::string::npos);
}

TEST(ExtendedReplayResult, ANominalModelSaysNothingOfExtensions) {
  const ReplayResult result = replay_of(profile(false), model_with(""));
  EXPECT_FALSE(nlohmann::json::parse(replay_json(result)).contains("extensions"));
}

TEST(ExtendedReplayResult, AGapLeavesTheFirmwareAndTheEquationsTogether) {
  std::string text = "time_s,output_tension_N,tendon_velocity_m_s\n";
  for (int i = 0; i < 3000; ++i) {
    if (i % 700 < 690) {
      text += fmt::format("{},{},0.1\n", i * 1e-3, 40 + 20 * std::sin(i * 0.02));
    }
  }
  const ReplayResult result = replay_of(text, model_with("[extension.filter_lag]\nlag_s = 0.02\n"));
  EXPECT_EQ(result.missing_samples, 40u);
  EXPECT_LT(std::fabs(result.relative_error), kMostError);
}

}  // namespace
}  // namespace host_sim
