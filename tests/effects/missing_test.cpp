#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/effects/trace.hpp"

namespace host_sim::effects::testing {
namespace {

using ::testing::HasSubstr;

using Channel = std::vector<double> recording::Covariates::*;

std::string missing_without(std::string_view id, Channel channel) {
  recording::Covariates c = trace();
  (c.*channel).clear();
  return effect(id).missing(c);
}

TEST(Missing, NothingWhereEveryChannelIsThere) {
  for (const auto& effect : tension_effects()) {
    EXPECT_EQ(effect->missing(trace()), "") << effect->id();
  }
}

TEST(Missing, TheChannelThatASignatureReads) {
  struct Case {
    std::string_view id;
    Channel channel;
    std::string_view column;
  };
  const Case cases[] = {
      {"friction_wear", &recording::Covariates::cycle, "start_cycle"},
      {"friction_temperature", &recording::Covariates::sheath_temperature_C,
       "sheath_temperature_C"},
      {"friction_velocity", &recording::Covariates::velocity_m_s, "tendon_velocity_m_s"},
      {"friction_position", &recording::Covariates::position_m, "motor_angle_rad"},
      {"presliding", &recording::Covariates::travel_m, "tendon_velocity_m_s"},
      {"slack", &recording::Covariates::travel_m, "tendon_velocity_m_s"},
      {"compliance", &recording::Covariates::position_m, "tendon_velocity_m_s"},
      {"compliance", &recording::Covariates::log_output_rate_1_s, "output_tension_N"},
      {"filter_lag", &recording::Covariates::velocity_m_s, "tendon_velocity_m_s"},
      {"filter_lag", &recording::Covariates::log_output_rate_1_s, "output_tension_N"},
      {"current_offset", &recording::Covariates::current_A, "motor_current_A"},
      {"gear_asymmetry", &recording::Covariates::current_A, "motor_current_A"},
      {"torque_gain", &recording::Covariates::winding_temperature_C, "winding_temperature_C"},
      {"torque_ripple", &recording::Covariates::motor_angle_rad, "motor_angle_rad"},
  };
  for (const Case& one : cases) {
    EXPECT_THAT(missing_without(one.id, one.channel), HasSubstr(std::string(one.column))) << one.id;
  }
}

TEST(Missing, AnEffectDoesNotAskForMoreThanItReads) {
  EXPECT_EQ(missing_without("friction_wear", &recording::Covariates::sheath_temperature_C), "");
  EXPECT_EQ(missing_without("friction_temperature", &recording::Covariates::motor_angle_rad), "");
  EXPECT_EQ(missing_without("friction_preload", &recording::Covariates::current_A), "");
  EXPECT_EQ(missing_without("compliance", &recording::Covariates::log_tension_rate_1_s), "");
  EXPECT_EQ(missing_without("filter_lag", &recording::Covariates::log_tension_rate_1_s), "");
}

TEST(Missing, WhatTheResidualNeedsIsNeededByAll) {
  for (const auto& effect : tension_effects()) {
    const std::string_view id = effect->id();
    EXPECT_THAT(missing_without(id, &recording::Covariates::current_tension_N),
                HasSubstr("input tension"))
        << id;
    EXPECT_THAT(missing_without(id, &recording::Covariates::output_tension_N),
                HasSubstr("output_tension_N"))
        << id;
    EXPECT_THAT(missing_without(id, &recording::Covariates::direction), HasSubstr("direction"))
        << id;
    EXPECT_THAT(missing_without(id, &recording::Covariates::bend_angle_rad),
                HasSubstr("bend_angle_deg"))
        << id;
  }
}

TEST(Missing, ALoadCellHidesWhatTheDriveDoes) {
  const recording::Covariates c = trace_with_load_cell();
  for (const auto& effect : tension_effects()) {
    const std::string_view id = effect->id();
    const bool of_drive = id == "current_offset" || id == "torque_gain" || id == "gear_asymmetry" ||
                          id == "torque_ripple";
    EXPECT_EQ(effect->missing(c).find("load cell") != std::string::npos, of_drive) << id;
    EXPECT_EQ(effect->missing(c).empty(), !of_drive) << id;
  }
}

}  // namespace
}  // namespace host_sim::effects::testing
