#include "host_sim/diagnose/output/extended_model.hpp"

#include <gtest/gtest.h>

#include "hal/files/input_error.hpp"
#include "host_sim/extension/model_file.hpp"
#include "tests/diagnose/output/hand_made_diagnosis.hpp"

namespace host_sim::diagnose {

using hal::files::InputError;

namespace {

/// With all tables; recordings alone.
Campaign campaign() {
  Campaign campaign;
  campaign.name = "crossed";
  campaign.folder = "folder";
  campaign.nominal = {Model::Cable{0.457, 177.4}, Model::Sheath{0.128, 270},
                      Model::Drive{0.0325, 9, 0.88, 12.5, 0}, Model::Counting{200, 0.2},
                      Model::Life{Model::MeanStress::kGerber, 1.53e5, 1.38, 5.94}};
  return campaign;
}

Diagnosis recordings() {
  Diagnosis diagnosis;
  diagnosis.tension = host_sim_test::wear_in_recordings();
  return diagnosis;
}

Model model_of(const Campaign& from, const Diagnosis& diagnosis, InputFrom input) {
  return parse_extended_model(extended_model_text(from, diagnosis, input, "1.2.3"), "m.toml");
}

std::string refusal(const Campaign& of) {
  try {
    require_extensible_model(of);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(ExtendedModel, HoldsWhatTheRecordingsFitted) {
  const Model model = model_of(campaign(), recordings(), InputFrom::current);
  EXPECT_EQ(model.sheath.friction_coefficient, 0.131);
  EXPECT_NEAR(model.drive->gear_efficiency, 0.88 * 1.02, 1e-15);
  EXPECT_EQ(model.drive->torque_constant_Nm_per_A, 0.0325);
  EXPECT_EQ(model.life.ipl_scale, 1.53e5);
  EXPECT_EQ(model.counting.sample_rate_Hz, 200);
  ASSERT_EQ(model.extensions.size(), 1U);
  EXPECT_EQ(model.extensions[0].id, "friction_wear");
  EXPECT_EQ(model.extensions[0].values[0].values[0], 0.152);
  EXPECT_EQ(model.extensions[0].values[1].values[0], 0.5);
}

TEST(ExtendedModel, ALoadCellLeavesTheDriveAlone) {
  const Model model = model_of(campaign(), recordings(), InputFrom::load_cell);
  EXPECT_EQ(model.drive->gear_efficiency, 0.88);
  EXPECT_EQ(model.sheath.friction_coefficient, 0.131);
}

TEST(ExtendedModel, AGearIsNeverBetterThanWhole) {
  Campaign lossless = campaign();
  lossless.nominal.drive->gear_efficiency = 0.99;
  const Model model = model_of(lossless, recordings(), InputFrom::current);
  EXPECT_EQ(model.drive->gear_efficiency, 1);
  EXPECT_NEAR(model.drive->torque_constant_Nm_per_A * model.drive->gear_efficiency,
              0.0325 * 0.99 * 1.02, 1e-15);
}

TEST(ExtendedModel, HoldsWhatTheLivesFitted) {
  Diagnosis diagnosis;
  diagnosis.lives = host_sim_test::lots_in_lives();
  const Model model = model_of(campaign(), diagnosis, InputFrom::load_cell);
  EXPECT_EQ(model.life.ipl_scale, 2.01e5);
  EXPECT_EQ(model.life.ipl_exponent, 1.45);
  EXPECT_EQ(model.life.weibull_shape, 5.8);
  EXPECT_EQ(model.sheath.friction_coefficient, 0.128);
  ASSERT_EQ(model.extensions.size(), 1U);
  EXPECT_EQ(model.extensions[0].id, "lot_frailty");
}

TEST(ExtendedModel, OfBothHoldsBoth) {
  const Model model = model_of(campaign(), host_sim_test::both_parts(), InputFrom::current);
  EXPECT_EQ(model.extensions.size(), 2U);
  EXPECT_EQ(model.sheath.friction_coefficient, 0.131);
  EXPECT_EQ(model.life.ipl_exponent, 1.45);
}

TEST(ExtendedModel, WithoutAnEffectIsTheRefittedModel) {
  Diagnosis diagnosis = recordings();
  diagnosis.tension->findings.extensions.clear();
  diagnosis.tension->findings.verdict = Verdict::none;
  const Model model =
      parse_model(extended_model_text(campaign(), diagnosis, InputFrom::current, "1"), "m.toml");
  EXPECT_TRUE(model.extensions.empty());
  EXPECT_EQ(model.sheath.friction_coefficient, 0.131);
}

TEST(ExtendedModel, LeavesOutWhatNoModelHas) {
  Diagnosis diagnosis = recordings();
  diagnosis.tension->findings.extensions.push_back(
      host_sim_test::zero_of_rig().findings.extensions.front());
  const Model model = model_of(campaign(), diagnosis, InputFrom::current);
  ASSERT_EQ(model.extensions.size(), 1U);
  EXPECT_EQ(model.extensions[0].id, "friction_wear");
  EXPECT_NE(extended_model_text(campaign(), diagnosis, InputFrom::current, "1")
                .find("# Extended by friction_wear.\n# Outside of the model: zero_of_rig.\n"),
            std::string::npos);
}

TEST(ExtendedModel, ACorrectionIsNoCause) {
  Diagnosis diagnosis = recordings();
  diagnosis.tension->findings.extensions.push_back(
      {"empirical", {{"speed_m_s", {0, 0.1}}, {"pulling_N", {0, 2}}, {"letting_go_N", {0, -2}}}});
  const std::string text = extended_model_text(campaign(), diagnosis, InputFrom::current, "1");
  EXPECT_NE(text.find("# A correction besides, whose cause is not known: empirical.\n"),
            std::string::npos)
      << text;
  EXPECT_EQ(text.find("Extended by empirical"), std::string::npos);
  EXPECT_EQ(parse_extended_model(text, "m.toml").extensions.size(), 2U);
}

TEST(ExtendedModel, SaysWhereItIsFrom) {
  const std::string text =
      extended_model_text(campaign(), host_sim_test::both_parts(), InputFrom::current, "1.2.3");
  EXPECT_EQ(text.rfind("# Written by host_sim diagnose 1.2.3 from the campaign crossed.\n"
                       "# [sheath] friction_coefficient and the gain of [drive] refitted from the "
                       "recordings.\n"
                       "# [life] refitted from the lives.\n"
                       "# Verdict on the recordings: named.\n"
                       "# Extended by friction_wear.\n"
                       "# Verdict on the lives: named.\n"
                       "# Extended by lot_frailty.\n"
                       "schema = 1\n",
                       0),
            0U)
      << text;
}

TEST(ExtendedModel, ANameStaysInItsComment) {
  Campaign hostile = campaign();
  hostile.name = "a\nschema = 2\n";
  EXPECT_NO_THROW(model_of(hostile, recordings(), InputFrom::current));
}

TEST(ExtendedModel, WhatNoModelCanHoldIsRefused) {
  Diagnosis diagnosis = recordings();
  diagnosis.tension->friction_coefficient = -0.1;
  try {
    extended_model_text(campaign(), diagnosis, InputFrom::current, "1");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("the refitted friction_coefficient is -0.1"),
              std::string::npos);
  }
}

TEST(ExtendedModel, AnExtensionThatNoModelCanHoldIsRefused) {
  Diagnosis diagnosis = recordings();
  diagnosis.tension->findings.extensions.push_back({"friction_preload", {{"preload_N", {178}}}});
  try {
    extended_model_text(campaign(), diagnosis, InputFrom::current, "1");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("the extended model of crossed:", 0), 0U)
        << error.what();
    EXPECT_NE(std::string(error.what())
                  .find("preload_N is 178; accepted: up to "
                        "ultimate_tension_N, 177.4"),
              std::string::npos);
  }
}

TEST(ExtendedModel, WhatItNeedsIsAskedForBeforeTheWork) {
  EXPECT_EQ(refusal(campaign()), "");
  Campaign without = campaign();
  without.nominal.life.reset();
  EXPECT_NE(refusal(without).find("no table [model.life], which --out needs"), std::string::npos);
  without.specimens.emplace_back();
  EXPECT_EQ(refusal(without), "");
  without.nominal.counting.reset();
  EXPECT_NE(refusal(without).find("[model.counting]"), std::string::npos);
}

}  // namespace
}  // namespace host_sim::diagnose
