#include "host_sim/extension/acting.hpp"

#include <gtest/gtest.h>

#include <string>

#include "host_sim/extension/model_file.hpp"
#include "tests/extension/models.hpp"

namespace host_sim {

using hal::files::InputKind;
using hal::files::ProfileChannels;

namespace {

using extension_test::model_with;

constexpr std::string_view kOffset = "[extension.current_offset]\ncurrent_offset_A = 0.05\n";
constexpr std::string_view kLoad = "[extension.friction_load]\nload_exponent = 0.2\n";
constexpr std::string_view kTemperature =
    "[extension.friction_temperature]\ntemperature_coefficient_1_K = 0.005\n";

ProfileChannels all_channels() {
  return ProfileChannels{}.set();
}

std::string why_not(std::string_view table, InputKind kind, const ProfileChannels& channels) {
  const Acting acting = acting_extensions(model_with(table), kind, channels);
  EXPECT_EQ(acting.extensions.size() + acting.others.size(), 1u);
  return acting.others.empty() ? "" : acting.others.front().why;
}

TEST(ActingExtensions, TheCurrentShowsTheDriveAndTheOutputTheSheath) {
  EXPECT_EQ(why_not(kOffset, InputKind::kMotorCurrent, {}), "");
  EXPECT_EQ(why_not(kOffset, InputKind::kOutputTension, all_channels()),
            "acts on a motor current, and the input is an output tension");
  EXPECT_EQ(why_not(kLoad, InputKind::kOutputTension, {}), "");
  EXPECT_EQ(why_not(kLoad, InputKind::kMotorCurrent, all_channels()),
            "acts on an output tension, and the input is a motor current");
  EXPECT_EQ(why_not(kLoad, InputKind::kInputTension, all_channels()),
            "acts on an output tension, and the input is an input tension");
}

TEST(ActingExtensions, AChannelThatIsNotThereIsNamed) {
  EXPECT_EQ(why_not(kTemperature, InputKind::kOutputTension, {}), "needs sheath_temperature_C");
  EXPECT_EQ(why_not(kTemperature, InputKind::kOutputTension, all_channels()), "");
}

TEST(ActingExtensions, ACorrectionNeedsWhatItIsWrittenOver) {
  const auto over = [](const std::string& covariate) {
    return "[extension.empirical]\n" + covariate +
           " = [0, 1]\npulling_N = [1, 2]\nletting_go_N = [1, 2]\n";
  };
  ProfileChannels velocity;
  velocity.set(hal::files::kTendonVelocity);
  EXPECT_EQ(why_not(over("travel_m"), InputKind::kOutputTension, velocity), "");
  EXPECT_EQ(why_not(over("position_m"), InputKind::kOutputTension, velocity),
            "needs motor_angle_rad");
  EXPECT_EQ(why_not(over("position_m"), InputKind::kOutputTension, all_channels()), "");
  EXPECT_EQ(why_not(over("speed_m_s"), InputKind::kMotorCurrent, all_channels()),
            "acts on an output tension, and the input is a motor current");
}

TEST(ActingExtensions, TheSignOfALagSaysWhereItIs) {
  constexpr std::string_view kOutput = "[extension.filter_lag]\nlag_s = 0.005\n";
  constexpr std::string_view kInput = "[extension.filter_lag]\nlag_s = -0.005\n";
  EXPECT_EQ(why_not(kOutput, InputKind::kOutputTension, {}), "");
  EXPECT_EQ(why_not(kInput, InputKind::kMotorCurrent, {}), "");
  EXPECT_NE(why_not(kOutput, InputKind::kMotorCurrent, {}), "");
  EXPECT_NE(why_not(kInput, InputKind::kOutputTension, {}), "");
}

TEST(ActingExtensions, WhatNoControllerEvaluatesSaysWhy) {
  EXPECT_EQ(why_not("[extension.ageing]\nageing_1_day = 0.001\n", InputKind::kOutputTension, {}),
            "not evaluated on line: needs a calendar, which a controller does not have");
}

TEST(ActingExtensions, NoEffectOfTheCatalogueIsUnknown) {
  for (const ExtensionKeys& keys : extension_keys()) {
    Model model = model_with("");
    Extension extension{std::string(keys.id), {}};
    for (const effects::TableKey& key : keys.keys) {
      extension.values.push_back({std::string(key.number.name), {key.number.range.maximum}});
    }
    model.extensions.push_back(extension);
    for (const InputKind kind :
         {InputKind::kInputTension, InputKind::kMotorCurrent, InputKind::kOutputTension}) {
      const Acting acting = acting_extensions(model, kind, all_channels());
      EXPECT_EQ(acting.extensions.size() + acting.others.size(), 1u);
      if (!acting.others.empty()) {
        EXPECT_EQ(acting.others.front().why.find("not known"), std::string::npos) << keys.id;
      }
    }
  }
}

}  // namespace
}  // namespace host_sim
