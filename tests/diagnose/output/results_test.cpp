#include "host_sim/diagnose/output/results.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "tests/diagnose/output/hand_made_diagnosis.hpp"

namespace host_sim::diagnose {
namespace {

using nlohmann::json;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

json json_of(const Diagnosis& diagnosis) {
  return json::parse(diagnosis_json(diagnosis, {"crossed", "extended.toml", 7}));
}

TEST(DiagnosisJson, HasTheFieldsOfTheFileFormat) {
  const json result = json_of(host_sim_test::both_parts());
  EXPECT_EQ(result["campaign"], "crossed");
  EXPECT_EQ(result["verdict"], "named");
  const json& effect = result["effects"][0];
  EXPECT_EQ(effect["id"], "friction_wear");
  EXPECT_EQ(effect["probability"], 0.987);
  EXPECT_EQ(effect["parameters"]["wear_coefficient"],
            json::parse(R"({"value": 0.152, "ci95": [0.139, 0.166], "unit": "1"})"));
  EXPECT_EQ(result["candidates"][1], json::parse(R"({"id": "none", "probability": 0.013})"));
  EXPECT_EQ(result["equivalent_sets"], json::parse(R"([["compliance", "filter_lag"]])"));
  EXPECT_EQ(result["invisible"], json::parse(R"(["torque_ripple", "bending_fatigue"])"));
  EXPECT_EQ(result["invisible_because"][1]["why"], "test two diameters");
  EXPECT_EQ(result["next_experiment"], "sweep the frequency; test more lots");
  EXPECT_EQ(result["gain"]["held_out_by"], "session, level");
  EXPECT_EQ(result["gain"]["rmse_N"], json::parse(R"({"before": 1.5, "after": 0.5})"));
  EXPECT_EQ(result["discrepancy"][0],
            json::parse(R"({"covariate": "cycle", "statistic": 9.8, "p": 0.0002,
                            "p_after": 0.41})"));
  EXPECT_EQ(result["extended_model"], "extended.toml");
  EXPECT_EQ(result["extensions"]["friction_wear"]["wear_exponent"], 0.5);
  EXPECT_EQ(result["warnings"], json::parse(R"(["session s4: saturated"])"));
  EXPECT_EQ(result["seed"], 7);
}

TEST(DiagnosisJson, HasThePartsByThemselves) {
  const json result = json_of(host_sim_test::both_parts());
  EXPECT_EQ(result["tension"]["effects"].size(), 1U);
  EXPECT_EQ(result["tension"]["damage_ratio"], 0.8);
  EXPECT_EQ(result["tension"]["friction_coefficient"], 0.131);
  EXPECT_EQ(result["lives"]["gain"]["log_predictive_density"]["after"], 0.1);
  EXPECT_EQ(result["lives"]["b10_ratio"], 1.25);
  EXPECT_EQ(result["lives"]["ipl_exponent"], 1.45);
  EXPECT_EQ(result["lives"]["residual_shape"]["before"], 3.9);
}

TEST(DiagnosisJson, HasTheRemainderOfTheRecordings) {
  Diagnosis diagnosis = host_sim_test::both_parts();
  EXPECT_TRUE(json_of(diagnosis)["remainder"].is_null());
  diagnosis.tension->findings.remainder = host_sim_test::left_over_position();
  const json remainder = json::parse(R"({"share": 0.12, "input_rmse_N": 2.4, "output_rmse_N": 1.1,
                                         "covariate": "position", "p": 0.005})");
  const json result = json_of(diagnosis);
  EXPECT_EQ(result["remainder"], remainder);
  EXPECT_EQ(result["tension"]["remainder"], remainder);
  EXPECT_FALSE(result["lives"].contains("remainder"));
  diagnosis.tension->findings.remainder = Remainder{kNone, kNone, kInfinity, "", kNone};
  EXPECT_EQ(json_of(diagnosis)["remainder"],
            json::parse(R"({"share": null, "input_rmse_N": null, "output_rmse_N": null,
                            "covariate": null, "p": null})"));
}

TEST(DiagnosisJson, AnEffectOutsideOfTheCatalogueHasItsOwnTerm) {
  Diagnosis diagnosis;
  diagnosis.tension = host_sim_test::zero_of_rig();
  const json effect = json_of(diagnosis)["effects"][0];
  EXPECT_EQ(effect["id"], "zero_of_rig");
  EXPECT_EQ(effect["term"], "zero of the rig");
  EXPECT_EQ(effect["equation"], "T_out + b");
  EXPECT_EQ(effect["life_consequence"], "none");
}

TEST(DiagnosisJson, WhatIsNotThereIsNull) {
  Diagnosis diagnosis;
  diagnosis.lives.emplace();
  const json result = json::parse(diagnosis_json(diagnosis, {"few lives", "", 1}));
  EXPECT_EQ(result["verdict"], "none");
  EXPECT_TRUE(result["tension"].is_null());
  EXPECT_TRUE(result["extended_model"].is_null());
  EXPECT_TRUE(result["gain"]["held_out_by"].is_null());
  EXPECT_EQ(result["gain"].size(), 1U);
  EXPECT_EQ(result["effects"], json::array());
  EXPECT_EQ(result["extensions"], json::object());
}

TEST(DiagnosisJson, WhatIsNotFiniteIsNull) {
  Diagnosis diagnosis = host_sim_test::both_parts();
  Findings& findings = diagnosis.tension->findings;
  findings.effects[0].parameters[0] = {"wear_coefficient", "1", kNone, -kInfinity, kInfinity};
  findings.effects[0].probability = kNone;
  findings.candidates[0].probability = kNone;
  findings.gain.metrics[0] = {"rmse_N", kNone, kInfinity};
  findings.discrepancies[0] = {"cycle", kNone, kNone, kNone};
  diagnosis.tension->damage_ratio = kNone;
  diagnosis.lives->b10_ratio = kInfinity;
  const std::string text = diagnosis_json(diagnosis, {"c", "", 1});
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(text.find("inf"), std::string::npos);
  const json result = json::parse(text);
  EXPECT_EQ(result["effects"][0]["parameters"]["wear_coefficient"]["ci95"],
            json::parse("[null, null]"));
  EXPECT_TRUE(result["candidates"][0]["probability"].is_null());
  EXPECT_TRUE(result["lives"]["b10_ratio"].is_null());
}

TEST(DiagnosisJson, NoValueIsLostToAnEqualName) {
  Diagnosis diagnosis;
  diagnosis.tension = host_sim_test::wear_in_recordings();
  diagnosis.tension->findings.effects[0].parameters = {
      {"bend_angle_error_rad", "rad", 0.1, 0, 0.2}, {"bend_angle_error_rad", "rad", 0.3, 0, 0.4}};
  const json parameters = json_of(diagnosis)["effects"][0]["parameters"];
  EXPECT_EQ(parameters["bend_angle_error_rad"]["value"], 0.1);
  EXPECT_EQ(parameters["bend_angle_error_rad_2"]["value"], 0.3);
}

TEST(DiagnosisJson, AnExtensionOfSeveralPosesIsAList) {
  Diagnosis diagnosis;
  diagnosis.tension = host_sim_test::wear_in_recordings();
  diagnosis.tension->findings.extensions = {
      {"bend_angle", {{"bend_angle_error_rad", {0.1, 0.2}}, {"bend_angles_deg", {90, 180}}}}};
  EXPECT_EQ(json_of(diagnosis)["extensions"]["bend_angle"],
            json::parse(R"({"bend_angle_error_rad": [0.1, 0.2], "bend_angles_deg": [90, 180]})"));
}

TEST(DiagnosisJson, SurvivesBytesThatAreNoText) {
  Diagnosis diagnosis;
  diagnosis.warnings = {"\xff\"\n"};
  EXPECT_EQ(json_of(diagnosis)["warnings"][0], "\xEF\xBF\xBD\"\n");
}

}  // namespace
}  // namespace host_sim::diagnose
