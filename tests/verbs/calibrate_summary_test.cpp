#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <sstream>

#include "host_sim/calibrate/output/output.hpp"
#include "tests/verbs/hand_made_result.hpp"

namespace {

using host_sim::calibrate::cycles_text;
using host_sim::calibrate::figure;
using host_sim::calibrate::found_in;
using host_sim::calibrate::p_text;
using host_sim_test::hand_made_result;
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

}  // namespace
