#include <gtest/gtest.h>

#include "hal/files/input_error.hpp"
#include "host_sim/calibrate/output/output.hpp"
#include "host_sim/campaign/nominal_model.hpp"
#include "tests/verbs/hand_made_result.hpp"

namespace {

using hal::files::InputError;
using host_sim::Model;
using host_sim::require_nominal_model;
using host_sim::calibrate::model_text;
using host_sim_test::campaign_with_model;
using host_sim_test::hand_made_result;

TEST(CalibrateModel, ReadsBackAsItWasFitted) {
  auto result = hand_made_result();
  result.stress_life->law = {203344.48241327034, 1.4535068691252262, 5.745740530481895};
  const std::string text = model_text(campaign_with_model(), result, "1.2.3");
  const Model model = host_sim::parse_model(text, "model.toml");
  EXPECT_EQ(model.life.ipl_scale, 203344.48241327034);
  EXPECT_EQ(model.life.ipl_exponent, 1.4535068691252262);
  EXPECT_EQ(model.life.weibull_shape, 5.745740530481895);
  EXPECT_EQ(model.cable.ultimate_tension_N, 177.4);
  EXPECT_EQ(model.sheath.bend_angle_deg, 270);
  EXPECT_EQ(model.counting.hysteresis_N, 0.2);
  ASSERT_TRUE(model.drive.has_value());
  EXPECT_EQ(model.drive->current_offset_A, -0.1);
}

TEST(CalibrateModel, SaysWhereItIsFrom) {
  const std::string text = model_text(campaign_with_model(), hand_made_result(), "1.2.3");
  EXPECT_EQ(text.rfind("# Written by host_sim calibrate 1.2.3 from the campaign by hand.\n"
                       "# [life] by maximum likelihood from 6 specimens, 4 failed and 2 "
                       "suspended.\n"
                       "# Without its level 540 deg, 99.5 N: its shape is another.\n",
                       0),
            0U)
      << text;
}

TEST(CalibrateModel, NamesStayInTheirComment) {
  auto result = hand_made_result();
  result.campaign = "a\nschema = 2\n";
  result.levels[2].left_out = "b\n[life]\n";
  EXPECT_NO_THROW(host_sim::parse_model(model_text(campaign_with_model(), result, "1"), "m"));
}

TEST(CalibrateModel, DoesWithoutADrive) {
  auto campaign = campaign_with_model();
  campaign.nominal.drive.reset();
  const std::string text = model_text(campaign, hand_made_result(), "1");
  EXPECT_FALSE(host_sim::parse_model(text, "m").drive.has_value());
}

std::string refusal(const host_sim::Campaign& campaign) {
  try {
    require_nominal_model(campaign);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(CalibrateModel, WhatReplayNeedsIsAskedForBeforeTheWork) {
  EXPECT_EQ(refusal(campaign_with_model()), "");
  auto campaign = campaign_with_model();
  campaign.nominal.counting.reset();
  EXPECT_EQ(refusal(campaign),
            "folder/campaign.toml: no table [model.counting], which --out needs; accepted: "
            "[model.counting] with sample_rate_Hz 0.1..100000, hysteresis_N 0..100");
  campaign = campaign_with_model();
  campaign.nominal.sheath.reset();
  EXPECT_NE(refusal(campaign).find("[model.sheath]"), std::string::npos);
  campaign = campaign_with_model();
  campaign.nominal.cable.reset();
  EXPECT_NE(refusal(campaign).find("[model.cable]"), std::string::npos);
  campaign = campaign_with_model();
  campaign.nominal.cable->ultimate_tension_N = 10;
  campaign.nominal.counting->hysteresis_N = 10;
  EXPECT_NE(refusal(campaign).find("less than ultimate_tension_N"), std::string::npos);
}

TEST(CalibrateModel, ALawThatNoModelCanHoldIsRefused) {
  auto result = hand_made_result();
  result.stress_life->law.exponent = 0.9;  // a model has 1..12
  EXPECT_THROW(model_text(campaign_with_model(), result, "1"), InputError);
  result = hand_made_result();
  result.stress_life->law.shape = 51;  // a model has 0.5..50
  EXPECT_THROW(model_text(campaign_with_model(), result, "1"), InputError);
  EXPECT_THROW(model_text(campaign_with_model(), host_sim_test::result_without_fits(), "1"),
               InputError);
}

}  // namespace
