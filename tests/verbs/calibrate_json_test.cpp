#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "host_sim/calibrate/output/output.hpp"
#include "tests/verbs/hand_made_result.hpp"

namespace {

using host_sim_test::hand_made_result;
using host_sim_test::result_without_fits;
using nlohmann::json;

json parsed(const host_sim::calibrate::CalibrateResult& result) {
  return json::parse(host_sim::calibrate::calibrate_json(result));
}

TEST(CalibrateJson, HasTheFieldsOfTheFileFormat) {
  const json all = parsed(hand_made_result());
  const json& level = all["levels"][0];
  EXPECT_EQ(level["bend_angle_deg"], 315);
  EXPECT_EQ(level["effective_tension_N"], 42.5);
  EXPECT_EQ(level["n"], 3);
  EXPECT_EQ(level["failed"], 2);
  EXPECT_EQ(level["suspended"], 1);
  EXPECT_EQ(level["scale"], 854);
  EXPECT_EQ(level["shape"], 4.79);
  EXPECT_EQ(level["mean_life"], 790);
  EXPECT_EQ(level["goodness_of_fit"]["normal"],
            (json{{"ks", 0.11}, {"ks_p", 0.51}, {"ad", 0.21}, {"ad_p", 0.61}}));
  EXPECT_EQ(level["goodness_of_fit"]["weibull"]["ad_p"], 0.63);
  EXPECT_EQ(all["common_shape"]["value"], 5.94);
  EXPECT_EQ(all["common_shape"]["ci95"], (json{5, 7}));
  EXPECT_EQ(all["shape_homogeneity"]["statistic"], 0.5);
  EXPECT_EQ(all["shape_homogeneity"]["df"], 1);
  EXPECT_EQ(all["shape_homogeneity"]["p"], 0.5);
  EXPECT_EQ(all["ipl"]["scale"], 2e5);
  EXPECT_EQ(all["ipl"]["exponent"], 1.5);
  EXPECT_EQ(all["ipl"]["ci95_exponent"], (json{1.25, 1.75}));
  EXPECT_EQ(all["ipl"]["method"], "maximum likelihood");
  EXPECT_EQ(all["validation"][0]["predicted_mean"], 1068);
  EXPECT_EQ(all["validation"][0]["measured_mean"], 993);
  EXPECT_EQ(all["validation"][0]["p"], 0.25);
  EXPECT_EQ(all["validation"][0]["inside_B10_B90"], 2);
  EXPECT_EQ(all["log_likelihood"], -123.456);
  EXPECT_EQ(all["warnings"], (json{"first", "second"}));
}

TEST(CalibrateJson, HasWhatElseWasFound) {
  const json all = parsed(hand_made_result());
  EXPECT_EQ(all["ipl"]["least_squares"],
            (json{{"scale", 1.53e5}, {"exponent", 1.38}, {"shape", 5.94}, {"rmse_cycles", 12.25}}));
  EXPECT_EQ(all["levels"][0]["left_out"], nullptr);
  EXPECT_EQ(all["levels"][2]["left_out"], "its shape is another");
  EXPECT_EQ(all["levels"][3]["role"], "validation");
  EXPECT_EQ(all["levels"][0]["best_family"], "lognormal");
  EXPECT_EQ(all["levels"][0]["lives"][2], (json{{"cycles", 1000}, {"failed", false}}));
  EXPECT_EQ(all["shape_homogeneity"]["odd_levels"][1]["level"], "540 deg, 99.5 N");
  EXPECT_EQ(all["mixes"][0]["by_damage_N"], 45.11);
  EXPECT_EQ(all["mixes"][0]["by_average_of_lives_N"], 44.34);
  EXPECT_EQ(all["use_levels"][0]["next_specimen_95"], (json{495, 1224}));
  EXPECT_EQ(all["seed"], 7);
  EXPECT_EQ(all["bootstraps"], 500);
}

TEST(CalibrateJson, WhatIsInfiniteOrWasNotComputedIsNull) {
  const json all = parsed(hand_made_result());
  EXPECT_EQ(all["ipl"]["ci95_scale"], (json{1e5, nullptr}));
  EXPECT_EQ(all["use_levels"][0]["ci95_B10"], (json{572, nullptr}));
  EXPECT_EQ(all["levels"][0]["probability_plot"]["band"][1]["ci95"], (json{900, nullptr}));
  EXPECT_EQ(all["ipl"]["adequacy"]["against_free_levels"], nullptr);
  EXPECT_EQ(all["ipl"]["adequacy"]["against_curvature"]["p_simulated"], nullptr);
  EXPECT_EQ(all["ipl"]["adequacy"]["against_curvature"]["p"], 0.221);
}

TEST(CalibrateJson, SaysWhyThereIsNoFit) {
  const json all = parsed(result_without_fits());
  EXPECT_EQ(all["common_shape"], nullptr);
  EXPECT_EQ(all["shape_homogeneity"], nullptr);
  EXPECT_EQ(all["ipl"], nullptr);
  EXPECT_EQ(all["log_likelihood"], nullptr);
  EXPECT_EQ(all["levels"][0]["scale"], nullptr);
  EXPECT_EQ(all["levels"][0]["best_family"], nullptr);
  EXPECT_EQ(all["levels"][0]["goodness_of_fit"]["weibull"], nullptr);
  EXPECT_EQ(all["levels"][0]["fits"]["weibull"]["problem"], "fewer than two failures");
  EXPECT_EQ(all["levels"][0]["bend_angle_deg"], nullptr);
  EXPECT_EQ(all["campaign"], "bad \xEF\xBF\xBD name");
}

TEST(CalibrateJson, IsOneLineWhereAsked) {
  const std::string line = host_sim::calibrate::calibrate_json(hand_made_result(), -1);
  EXPECT_EQ(std::count(line.begin(), line.end(), '\n'), 1);
  EXPECT_EQ(json::parse(line), parsed(hand_made_result()));
}

TEST(CalibrateJson, AValidationInBlocksHasNoLevel) {
  auto result = hand_made_result();
  result.validation[0].in_blocks = true;
  result.validation[0].level = result.levels.size();
  const json all = parsed(result);
  EXPECT_EQ(all["validation"][0]["level"], "in blocks");
  EXPECT_FALSE(all["validation"][0].contains("bend_angle_deg"));
}

}  // namespace
