#include "host_sim/diagnose/plan/foresee.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "hal/files/input_error.hpp"

namespace host_sim::diagnose {

using hal::files::InputError;

namespace {

/// Eight short sessions, driven and measured by the motor current unless a load cell is asked for.
std::string plan_text(std::string_view bend_angles_deg, std::string_view input) {
  return fmt::format(
      "schema = 1\n[campaign]\nname = \"planned\"\n"
      "[model.cable]\ndiameter_mm = 0.457\nultimate_tension_N = 177.4\n"
      "[model.sheath]\nfriction_coefficient = 0.128\nbend_angle_deg = 270.0\n"
      "[model.drive]\ntorque_constant_Nm_per_A = 0.0325\ngear_ratio = 9.0\n"
      "gear_efficiency = 0.88\nspool_radius_mm = 12.5\ncurrent_offset_A = 0.0\n"
      "[recordings]\ndesign = \"balanced\"\nsessions = 8\nbend_angles_deg = [{}]\n"
      "output_means_N = [20.0, 35.0]\noutput_amplitudes_N = [5.0, 15.0]\n"
      "frequencies_Hz = [0.5, 2.0]\ntravels_mm = [20.0]\nsheath_ambients_C = [20.0, 45.0]\n"
      "winding_starts_C = [20.0, 80.0]\nstart_cycles = [0.0, 2000.0]\n"
      "load_frequency_ratio = 1.3\nsample_rate_Hz = 100.0\nduration_s = 8.0\n"
      "channels = [\"{}\", \"output_tension_N\", \"tendon_velocity_m_s\", \"bend_angle_deg\", "
      "\"motor_angle_rad\", \"sheath_temperature_C\", \"winding_temperature_C\"]\n"
      "[noise]\nlog_tension_sd = 0.01\nar1 = 0.6\n[scatter]\nlog_gain_sd = 0.01\n"
      "friction_sd = 0.006\n",
      bend_angles_deg, input);
}

Foresight foresight_of(const std::string& text) {
  return foresee(synth::parse_synth_plan(text, "plan.toml"), {});
}

/// One sample of 30 N that leaves 20 N at the output.
/// @param input_N_per_A of the motor of the plan; 0: a load cell
effects::ForceRecord one_sample(double input_N_per_A) {
  effects::ForceRecord record;
  record.input_N_per_A = input_N_per_A;
  record.time_s = {0};
  record.input_N = {30};
  record.output_N = {20};
  return record;
}

// sqrt(2) 0.01 of 30 N at both ends, sqrt(1 - 0.6^2) = 0.8 of it is new in each sample.
constexpr double kMotor_N_per_A = 9 * 0.88 * 0.0325 / 0.0125;

TEST(Foresee, NoiseInProportionPassesOnAsTheForceDoes) {
  const auto plan = synth::parse_synth_plan(plan_text("90.0, 450.0", "motor_current_A"), "p.toml");
  const std::vector records{one_sample(kMotor_N_per_A)};
  const NoiseModel noise = noise_of(plan, records);
  EXPECT_NEAR(noise.sample_sd_N.at(0).at(0), std::sqrt(2.0) * 0.01 * 30 * 0.8, 1e-12);
  EXPECT_NEAR(noise.autocorrelation, 0.6, 1e-12);
  EXPECT_EQ(noise.session_gain_sd, 0.01);
  EXPECT_EQ(noise.session_friction_sd, 0.006);
}

// At the output 0.003 * 20 N and 0.08 N are 0.1 N, 0.15 N at the input end; there 0.008 * 30 N and
// 0.32 N are 0.4 N. Correlated by (0.15^2 0.8 + 0.4^2 0.3) / (0.15^2 + 0.4^2) = 0.361644. The floor
// of the current is 0.32 N by 0.0125 m / (9 * 0.88 * 0.0325 Nm/A) = 0.0155400 A.
TEST(Foresee, NoiseOfEachEndCountsOnItsOwn) {
  const auto with = [](const std::string& input, const std::string& noise) {
    const std::string was = "log_tension_sd = 0.01\nar1 = 0.6\n";
    std::string text = plan_text("90.0, 450.0", input);
    return synth::parse_synth_plan(text.replace(text.find(was), was.size(), noise), "p.toml");
  };
  const std::vector by_load_cell{one_sample(0)};
  const std::vector by_motor{one_sample(kMotor_N_per_A)};
  const double expected = std::sqrt((0.15 * 0.15 + 0.4 * 0.4) * (1 - 0.361644 * 0.361644));
  const NoiseModel by_tension =
      noise_of(with("input_tension_N",
                    "output_relative_sd = 0.003\noutput_absolute_N = 0.08\noutput_ar1 = 0.8\n"
                    "input_relative_sd = 0.008\ninput_absolute_N = 0.32\ninput_absolute_A = 1.0\n"
                    "input_ar1 = 0.3\n"),
               by_load_cell);
  EXPECT_NEAR(by_tension.sample_sd_N.at(0).at(0), expected, 1e-6);
  const NoiseModel by_current =
      noise_of(with("motor_current_A",
                    "output_relative_sd = 0.003\noutput_absolute_N = 0.08\noutput_ar1 = 0.8\n"
                    "input_relative_sd = 0.008\ninput_absolute_A = 0.01554002\n"
                    "input_absolute_N = 1.0\ninput_ar1 = 0.3\n"),
               by_motor);
  EXPECT_NEAR(by_current.sample_sd_N.at(0).at(0), expected, 1e-6);
}

TEST(Foresee, CountsSessionsAndSamples) {
  const Foresight foresight = foresight_of(plan_text("90.0, 450.0", "motor_current_A"));
  EXPECT_EQ(foresight.sessions, 8U);
  EXPECT_GT(foresight.samples, 8U * 500U);
  EXPECT_LE(foresight.samples, 8U * 801U);
}

TEST(Foresee, OnePoseHidesTheAsymmetryOfTheGear) {
  const Foresight one = foresight_of(plan_text("270.0", "motor_current_A"));
  EXPECT_FALSE(one.audit.of("gear_asymmetry").visible());
  EXPECT_FALSE(one.audit.of("bend_angle").visible());
  const Foresight two = foresight_of(plan_text("90.0, 450.0", "motor_current_A"));
  EXPECT_TRUE(two.audit.of("gear_asymmetry").visible());
  EXPECT_TRUE(two.audit.of("friction_load").visible());
}

TEST(Foresee, ALoadCellHidesTheDrive) {
  const Foresight foresight = foresight_of(plan_text("90.0, 450.0", "input_tension_N"));
  EXPECT_EQ(foresight.audit.of("current_offset").verdict, EffectAudit::Verdict::missing_channel);
  EXPECT_TRUE(foresight.audit.of("friction_wear").visible());
}

TEST(Foresee, WhatThePlanHidesChangesNothing) {
  const std::string text = plan_text("90.0, 450.0", "input_tension_N");
  const Foresight without = foresight_of(text);
  const Foresight with = foresight_of(text + "[effects.friction_preload]\nforce_N = 3.0\n");
  ASSERT_EQ(without.audit.effects.size(), with.audit.effects.size());
  for (std::size_t i = 0; i < with.audit.effects.size(); ++i) {
    EXPECT_EQ(without.audit.effects[i].sigmas, with.audit.effects[i].sigmas);
  }
}

TEST(Foresee, APlanOfLivesAloneIsRefused) {
  const std::string text = plan_text("270.0", "motor_current_A");
  synth::SynthPlan plan = synth::parse_synth_plan(text, "plan.toml");
  plan.recordings.reset();
  try {
    foresee(plan, {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("plan.toml"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("[recordings]"), std::string::npos);
  }
}

TEST(Foresee, TellsEachEffectOnceAndInJsonTheSame) {
  const Foresight foresight = foresight_of(plan_text("270.0", "motor_current_A"));
  std::ostringstream out;
  write_foresight(out, foresight);
  const auto json = nlohmann::json::parse(foresight_json(foresight));
  ASSERT_EQ(json.at("effects").size(), foresight.audit.effects.size());
  for (const auto& effect : json.at("effects")) {
    const std::string id = effect.at("id");
    EXPECT_NE(out.str().find("  " + id + " "), std::string::npos) << id;
    const auto& invisible = json.at("invisible");
    EXPECT_EQ(std::count(invisible.begin(), invisible.end(), id),
              effect.at("visible").get<bool>() ? 0 : 1);
  }
  EXPECT_GE(json.at("invisible").size(), 2U);
}

TEST(ScratchFolder, IsGoneWithItsFiles) {
  std::filesystem::path path;
  {
    const ScratchFolder scratch;
    path = scratch.path();
    EXPECT_TRUE(std::filesystem::is_directory(path));
    std::filesystem::create_directory(path / "inside");
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace host_sim::diagnose
