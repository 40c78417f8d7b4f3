// What the shipped campaign, rebuilt from the paper's Table 4, gives beside what the paper prints.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

#include "host_sim/calibrate/calibrate.hpp"
#include "tests/support/paper_table.hpp"

namespace host_sim::calibrate {
namespace {

using host_sim::testing::PaperRow;

const CalibrateResult& result() {
  static const CalibrateResult kResult = calibrate(read_campaign(TENDONLIFE_EXAMPLE), {});
  return kResult;
}

const LevelResult& level(double effective_tension_N) {
  for (const LevelResult& level : result().levels) {
    if (std::abs(level.load.effective_tension_N - effective_tension_N) < 0.05) {
      return level;
    }
  }
  throw std::out_of_range("no such level");
}

template <typename Part>
std::vector<double> of_levels(const std::vector<double>& tensions_N, Part part) {
  std::vector<double> values;
  for (const double tension_N : tensions_N) {
    values.push_back(part(level(tension_N)));
  }
  return values;
}

double scale_of(const LevelResult& level) {
  return level.weibull().distribution.first;
}
double shape_of(const LevelResult& level) {
  return level.weibull().distribution.second;
}
double sample_mean(const LevelResult& level) {
  double sum = 0;
  for (const statistics::Observation& life : level.sample) {
    sum += life.value;
  }
  return sum / static_cast<double>(level.sample.size());
}

const ValidationResult& validation(double effective_tension_N) {
  for (const ValidationResult& found : result().validation) {
    if (&result().levels[found.level] == &level(effective_tension_N)) {
      return found;
    }
  }
  throw std::out_of_range("no such validation");
}

const OddLevel& odd_level(double effective_tension_N) {
  for (const OddLevel& odd : result().common_shape->odd_levels) {
    if (&result().levels[odd.level] == &level(effective_tension_N)) {
      return odd;
    }
  }
  throw std::out_of_range("no such odd level");
}

const std::vector<double> kAllLevels_N{35.1, 42.5, 50.7, 60.0, 70.8, 99.4};
const std::vector<double> kWithout540_N{35.1, 42.5, 50.7, 60.0, 70.8};

std::vector<PaperRow> level_rows() {
  return {{"scale of each level (cycles)",
           {1060, 854, 675, 551, 407, 236},
           of_levels(kAllLevels_N, scale_of)},
          {"shape of each level",
           {6.94, 4.79, 7.70, 5.09, 7.64, 3.34},
           of_levels(kAllLevels_N, shape_of)},
          {"mean of each sample up to 450 deg (cycles)",
           {993, 783, 634, 506, 383},
           of_levels(kWithout540_N, sample_mean)}};
}

/// The levels of the life law as the paper's section 3.3 tested them: two specimens more each,
/// whose lives were dropped because they were the lowest and the highest.
double shape_knowing_of_the_dropped() {
  std::vector<statistics::Sample> samples;
  for (const double tension_N : {42.5, 50.7, 60.0, 70.8}) {
    statistics::Sample sample = level(tension_N).sample;
    const auto [lowest, highest] = std::ranges::minmax(sample, {}, &statistics::Observation::value);
    sample.push_back({.value = lowest.value, .failed = true, .from = 0, .trimmed = true});
    sample.push_back({.value = highest.value, .failed = false, .trimmed = true});
    samples.push_back(std::move(sample));
  }
  return statistics::fit_common_shape(samples).shape;
}

std::vector<PaperRow> shape_rows() {
  const CommonShape& shape = *result().common_shape;
  return {{"common shape", {5.94}, {shape.value}},
          {"common shape that knows of the dropped", {5.94}, {shape_knowing_of_the_dropped()}},
          {"likelihood ratio of one shape, 315 to 450 deg", {3.16}, {shape.homogeneity.statistic}},
          {"p of that ratio, chi-square and simulated",
           {},
           {shape.homogeneity.p_chi_square, shape.homogeneity.p_simulated}},
          {"likelihood ratio of 540 deg against the others, and its p by chi-square",
           {},
           {odd_level(99.4).test.statistic, odd_level(99.4).test.p_chi_square}}};
}

std::vector<PaperRow> law_rows() {
  const StressLife& law = *result().stress_life;
  return {{"A, gamma by least squares in alpha",
           {1.53e5, 1.38},
           {law.least_squares->scale, law.least_squares->exponent}},
          {"RMSE of the least squares (cycles)", {12.3}, {law.least_squares_rmse}},
          {"A, gamma, beta by maximum likelihood",
           {1.53e5, 1.38, 5.94},
           {law.law.scale, law.law.exponent, law.law.shape}},
          {"Exo-glove: B10, mean, B90 (cycles)",
           {1190, 1740, 2000},
           {result().use_levels[0].b10, result().use_levels[0].mean, result().use_levels[0].b90}}};
}

std::vector<PaperRow> validation_rows() {
  const ValidationResult& low = validation(35.1);
  const ValidationResult& arm = validation(39.9);
  return {
      {"270 deg: predicted, measured mean (cycles)",
       {1044, 993},
       {low.predicted_mean, low.measured_mean}},
      {"270 deg: p of that difference", {}, {low.p}},
      {"application: predicted, measured mean (cycles)",
       {867, 1000},
       {arm.predicted_mean, arm.measured_mean}},
      {"application: measured above predicted (%)",
       {13.6},
       {100 * (arm.measured_mean / arm.predicted_mean - 1)}},
      {"application: p of that difference", {}, {arm.p}},
      {"application: specimens within B10 and B90", {8}, {static_cast<double>(arm.inside_b10_b90)}},
      {"40 and 50 N in equal parts: by average of lives (N)",
       {44.34},
       {result().mixes.at(0).by_average_of_lives_N}},
      {"40 and 50 N in equal parts: by damage (N)", {}, {result().mixes.at(0).by_damage_N}}};
}

std::vector<PaperRow> rows() {
  std::vector<PaperRow> all;
  for (const auto& part : {level_rows(), shape_rows(), law_rows(), validation_rows()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

/// Half a unit of the third significant digit, as the paper prints.
double half_third_digit(double value) {
  return 0.5 * std::pow(10.0, std::floor(std::log10(value)) - 2);
}

TEST(PaperCampaign, EveryLevelHasThePrintedFit) {
  for (const PaperRow& row : level_rows()) {
    if (row.quantity.starts_with("mean")) {
      continue;
    }
    ASSERT_EQ(row.paper.size(), row.ours.size());
    for (std::size_t i = 0; i < row.paper.size(); ++i) {
      EXPECT_NEAR(row.ours[i], row.paper[i], half_third_digit(row.paper[i])) << row.quantity;
    }
  }
  EXPECT_NEAR(result().common_shape->value, 5.94, 0.005);
}

// Twice 3.16 within what all samples with the fits of Table 4 give.
TEST(PaperCampaign, TheLikelihoodRatioHasItsFactorTwo) {
  EXPECT_GT(result().common_shape->homogeneity.statistic, 5.7);
  EXPECT_LT(result().common_shape->homogeneity.statistic, 6.8);
  EXPECT_NEAR(result().common_shape->homogeneity.p_simulated, 0.12, 0.02);
}

TEST(PaperCampaign, Only540DegreesIsLeftOut) {
  for (const LevelResult& each : result().levels) {
    EXPECT_EQ(each.left_out.empty(), each.load.bend_angle_deg != 540) << each.name();
  }
  EXPECT_NEAR(odd_level(99.4).test.statistic, 9.9, 0.05);
  EXPECT_NEAR(odd_level(99.4).test.p_chi_square, 0.002, 0.0005);
}

TEST(PaperCampaign, TheReadmeShowsWhatIsComputed) {
  std::ifstream in(TENDONLIFE_README);
  if (!in) {
    GTEST_SKIP() << "NOT CHECKED: there is no " << TENDONLIFE_README;
  }
  const std::string readme{std::istreambuf_iterator<char>(in), {}};
  for (const std::string& fault :
       host_sim::testing::faults_of_paper_table(readme, "calibrate-table", rows())) {
    ADD_FAILURE() << fault;
  }
}

}  // namespace
}  // namespace host_sim::calibrate
