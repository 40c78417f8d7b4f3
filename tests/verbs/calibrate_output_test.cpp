#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "hal/files/input_error.hpp"
#include "host_sim/calibrate/output/output.hpp"
#include "host_sim/campaign/nominal_model.hpp"
#include "tests/verbs/hand_made_result.hpp"

namespace {

using host_sim::calibrate::cycles_text;
using host_sim::calibrate::figure;
using host_sim::calibrate::found_in;
using host_sim::calibrate::p_text;
using host_sim_test::hand_made_result;
using namespace host_sim::calibrate;
using hal::files::InputError;
using host_sim::Model;
using host_sim::require_nominal_model;
using host_sim::calibrate::model_text;
using host_sim_test::campaign_with_model;
using host_sim_test::result_without_fits;
using nlohmann::json;
using Names = std::vector<std::string>;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::string summary(const host_sim::calibrate::CalibrateResult& result) {
  std::ostringstream text;
  host_sim::calibrate::write_summary(text, result);
  return text.str();
}

testing::AssertionResult has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos ? testing::AssertionSuccess()
                                              : testing::AssertionFailure()
                                                    << "no '" << part << "' in\n"
                                                    << text;
}

TEST(CalibrateSummary, TellsLevelsLawUseValidationAndMixes) {
  const std::string text = summary(hand_made_result());
  EXPECT_TRUE(has(text, "by hand: 9 specimens, 6 failed, 3 suspended, 1 loaded in blocks\n"));
  EXPECT_TRUE(has(text, "\n  315 deg, 42.5 N               3       2          1    854   4.79"));
  EXPECT_TRUE(has(text, "left out: 540 deg, 99.5 N: its shape is another"));
  EXPECT_TRUE(has(text, "(validation)"));
  EXPECT_TRUE(has(text, "5.94  (95 %: 5 .. 7; without its bias 5.7)"));
  EXPECT_TRUE(has(text, "not rejected: statistic 0.5, 1 df, p 0.500 simulated, 0.479 chi-square"));
  EXPECT_TRUE(has(text, "rejected: statistic 9.9, 2 df, p 0.010 simulated, 0.007 chi-square"));
  EXPECT_TRUE(has(text, "540 deg, 99.5 N: p 0.009 for its own shape, looked for in 2 levels"));
  EXPECT_TRUE(has(text, "A 2e+05  (95 %: 1e+05 .. no limit)"));
  EXPECT_TRUE(has(text, "gamma 1.38, beta 5.94, RMSE 12.25 cycles; the paper's way"));
  EXPECT_TRUE(has(text, "no curvature    not rejected: statistic 1.5, 1 df, p - simulated, 0.221"));
  EXPECT_TRUE(has(text, "arm, upper  39.90 N   885  816 .. 961  647  572 .. no limit"));
  EXPECT_TRUE(has(text, "1068 predicted, 993 measured; 1 below B10, 2 within, 0 above B90"));
  EXPECT_TRUE(has(text, "not refuted"));
  EXPECT_TRUE(has(text, "45.11 N"));
  EXPECT_TRUE(has(text, "44.34 N"));
  EXPECT_TRUE(text.ends_with("warning: first\nwarning: second\n")) << text;
}

TEST(CalibrateSummary, TellsWhatCouldNotBeFitted) {
  const std::string text = summary(host_sim_test::result_without_fits());
  EXPECT_TRUE(has(text, "bad \\xff name: 2 specimens"));
  EXPECT_TRUE(has(text, "fewer than two failures"));
  EXPECT_TRUE(has(text, "warning: there is no life law"));
  EXPECT_EQ(text.find("life law  "), std::string::npos);
}

TEST(CalibrateSummary, KeepsControlCharactersOut) {
  auto result = hand_made_result();
  result.campaign = result.levels[2].left_out = result.use_levels[0].name = "\x1b[2J";
  result.validation[0].words = result.mixes[0].name = result.warnings[0] = "\x1b[2J";
  EXPECT_EQ(summary(result).find('\x1b'), std::string::npos);
}

TEST(CalibrateNumbers, HaveFourDigitsAndWordsForTheRest) {
  EXPECT_EQ(figure(1.45351), "1.454");
  EXPECT_EQ(figure(153000.0), "1.53e+05");
  EXPECT_EQ(figure(kInfinite), "no limit");
  EXPECT_EQ(figure(kNone), "-");
  EXPECT_EQ(cycles_text(99.96), "99.96");
  EXPECT_EQ(cycles_text(1045.5), "1046");
  EXPECT_EQ(cycles_text(1234567.0), "1.235e+06");
  EXPECT_EQ(cycles_text({500, kInfinite}), "500 .. no limit");
  EXPECT_EQ(p_text(0.0416), "0.042");
  EXPECT_EQ(p_text(0.00012), "1e-04");
  EXPECT_EQ(p_text(kNone), "-");
}

TEST(CalibrateFindings, AreWhatSpeaksAgainstTheModel) {
  auto result = hand_made_result();
  EXPECT_EQ(found_in(result), Names{"left-out"});
  result.levels[2].left_out.clear();
  EXPECT_EQ(found_in(result), Names{});
  result.common_shape->homogeneity.p_simulated = 0.049;
  EXPECT_EQ(found_in(result), Names{"shape"});
  result.common_shape->homogeneity.p_simulated = 0.05;
  result.validation[0].p = 0.049;
  EXPECT_EQ(found_in(result), Names{"validation"});
  result.validation[0].p = 0.05;
  result.stress_life->against_growing_scatter = {9, 1, 0.003, 0.004};
  EXPECT_EQ(found_in(result), Names{"fit"});
  EXPECT_EQ(found_in(host_sim_test::result_without_fits()), Names{"fit"});
}

TEST(CalibrateFindings, TakeTheSimulatedPBeforeTheChiSquare) {
  auto result = hand_made_result();
  result.levels[2].left_out.clear();
  result.common_shape->homogeneity.p_chi_square = 0.01;
  EXPECT_EQ(found_in(result), Names{});
  result.common_shape->homogeneity.p_simulated = kNone;
  EXPECT_EQ(found_in(result), Names{"shape"});
}

TEST(CalibrateTable, HasWhatWasFitted) {
  EXPECT_EQ(table_row("one", host_sim_test::hand_made_result()),
            "one,9,6,3,5.94,5,7,0.5,200000,100000,inf,1.5,1.25,1.75,6,5,7,-123.456,0.25,1,"
            "left-out,2,\n");
}

TEST(CalibrateTable, LeavesEmptyWhatWasNotFitted) {
  EXPECT_EQ(table_row("two", host_sim_test::result_without_fits()),
            "two,2,1,1,,,,,,,,,,,,,,,,0,fit,1,\n");
}

TEST(CalibrateTable, SaysWhyACampaignWasRefused) {
  EXPECT_EQ(refused_row("a,b", "x.csv:3: \"y\", z"),
            "\"a,b\",,,,,,,,,,,,,,,,,,,,,,"
            "\"x.csv:3: \"\"y\"\", z\"\n");
}

TEST(CalibrateTable, RowsHaveTheColumnsOfTheHead) {
  const auto commas = [](const std::string& line) {
    return std::count(line.begin(), line.end(), ',');
  };
  EXPECT_EQ(commas(table_head()), 22);
  EXPECT_EQ(commas(table_row("a", host_sim_test::hand_made_result())), 22);
  EXPECT_EQ(commas(refused_row("a", "b")), 22);
}

TEST(CalibrateTable, NamesStayInTheirField) {
  EXPECT_EQ(refused_row("a\nb", "c"), "a\\nb,,,,,,,,,,,,,,,,,,,,,,c\n");
}

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
  EXPECT_EQ(all["ipl"]["pivot_tension_N"], 50);
  EXPECT_EQ(all["ipl"]["ci95_life_at_pivot"], (json{500, 640}));
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

TEST(CalibrateModel, HoldsTheIntervalsOfTheFit) {
  auto result = hand_made_result();
  result.stress_life->scale_ci95 = {1e5, 4e5};
  const auto life =
      host_sim::parse_model(model_text(campaign_with_model(), result, "1"), "m").life.interval;
  ASSERT_TRUE(life.has_value());
  EXPECT_EQ(life->level, 0.95);
  EXPECT_EQ(life->ipl_scale.low, 1e5);
  EXPECT_EQ(life->ipl_scale.high, 4e5);
  EXPECT_EQ(life->ipl_exponent.low, 1.25);
  EXPECT_EQ(life->ipl_exponent.high, 1.75);
  EXPECT_EQ(life->weibull_shape.low, 5);
  EXPECT_EQ(life->weibull_shape.high, 7);
  EXPECT_EQ(life->pivot_tension_N, 50);
  EXPECT_EQ(life->life_at_pivot.low, 500);
  EXPECT_EQ(life->life_at_pivot.high, 640);
}

TEST(CalibrateModel, HasNoIntervalsWhereOneHasNoEnd) {
  auto result = hand_made_result();  // its scale has no upper end
  const std::string text = model_text(campaign_with_model(), result, "1");
  EXPECT_FALSE(host_sim::parse_model(text, "m").life.interval.has_value());
  EXPECT_TRUE(has(text, "# No [life.interval]: it has ends above 0 on both sides.\n"));
  result.stress_life->scale_ci95 = {1e5, 4e5};
  result.stress_life->exponent_ci95 = {-0.1, 1.75};
  EXPECT_TRUE(has(model_text(campaign_with_model(), result, "1"), "# No [life.interval]"));
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
            "[model.counting] with sample_rate_Hz 0.1..100000, hysteresis_N 0..100000");
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
