#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "host_sim/campaign/campaign.hpp"
#include "host_sim/statistics/common_shape.hpp"
#include "host_sim/statistics/fit.hpp"
#include "host_sim/statistics/goodness_of_fit.hpp"

namespace host_sim {
namespace {

using statistics::Family;
using statistics::Fit;
using statistics::Sample;

/// The paper's Table 4, and the mean lives of its Figure 10 (none at 540 deg), as printed.
struct Printed {
  double bend_angle_deg;
  std::string effective_tension_N;
  std::string scale;
  std::string shape;
  std::string mean;
};
const std::array<Printed, 6> kPrinted{{
    {270, "35.1", "1.06e+03", "6.94", "993"},
    {315, "42.5", "8.54e+02", "4.79", "783"},
    {360, "50.7", "6.75e+02", "7.70", "634"},
    {405, "60.0", "5.51e+02", "5.09", "506"},
    {450, "70.8", "4.07e+02", "7.64", "383"},
    {540, "99.4", "2.36e+02", "3.34", ""},
}};

class TendonAlt : public testing::Test {
 protected:
  static const Level& level(double bend_angle_deg, double output_amplitude_N = 0) {
    const auto found = std::find_if(levels().begin(), levels().end(), [&](const Level& one) {
      const bool constant_output = one.specimens.size() == 20;
      return *one.load.bend_angle_deg == bend_angle_deg &&
             constant_output == (output_amplitude_N == 0);
    });
    return *found;
  }

  static Sample sample(const Level& level) {
    Sample sample;
    for (const Campaign::Specimen* const specimen : level.specimens) {
      sample.push_back({specimen->cycles(), specimen->status == Campaign::Status::failed});
    }
    return sample;
  }

  static std::vector<Sample> samples(std::initializer_list<double> angles_deg) {
    std::vector<Sample> all;
    for (const double angle_deg : angles_deg) {
      all.push_back(sample(level(angle_deg)));
    }
    return all;
  }

  static double mean(const Sample& sample) {
    double sum = 0;
    for (const statistics::Observation& one : sample) {
      sum += one.value;
    }
    return sum / static_cast<double>(sample.size());
  }

  static const Campaign& campaign() {
    static const Campaign campaign =
        read_campaign(std::filesystem::path(TENDONLIFE_EXAMPLES) / "tendon_alt");
    return campaign;
  }

  static const std::vector<Level>& levels() {
    static const std::vector<Level> levels = levels_of(campaign());
    return levels;
  }
};

TEST_F(TendonAlt, HasTheLevelsOfThePaper) {
  ASSERT_EQ(levels().size(), 7U);
  for (const Printed& printed : kPrinted) {
    SCOPED_TRACE(printed.bend_angle_deg);
    const Level& one = level(printed.bend_angle_deg);
    EXPECT_EQ(one.specimens.size(), 20U);
    EXPECT_EQ(one.role,
              printed.bend_angle_deg == 270 ? Campaign::Role::validation : Campaign::Role::fit);
    EXPECT_EQ(fmt::format("{:.1f}", one.load.effective_tension_N), printed.effective_tension_N);
    for (const statistics::Observation& life : sample(one)) {
      EXPECT_TRUE(life.failed);
      EXPECT_EQ(life.value, std::floor(life.value));
    }
  }
}

TEST_F(TendonAlt, FitsEqualThePrintedOnes) {
  for (const Printed& printed : kPrinted) {
    SCOPED_TRACE(printed.bend_angle_deg);
    const Sample lives = sample(level(printed.bend_angle_deg));
    const Fit fit = statistics::fit(Family::weibull, lives);
    ASSERT_EQ(fit.problem, statistics::FitProblem::none);
    EXPECT_EQ(fmt::format("{:.2e}", fit.distribution.first), printed.scale);
    EXPECT_EQ(fmt::format("{:.2f}", fit.distribution.second), printed.shape);
    if (!printed.mean.empty()) {
      EXPECT_EQ(fmt::format("{:.0f}", mean(lives)), printed.mean);
    }
  }
}

// The printed ratio 3.16 lacks its factor 2: samples with the printed fits give 5.7 .. 6.8.
TEST_F(TendonAlt, SharesTheShapeOfThePaper) {
  const std::vector<Sample> four = samples({315, 360, 405, 450});
  EXPECT_EQ(fmt::format("{:.2f}", statistics::fit_common_shape(four).shape), "5.94");
  const double ratio = statistics::test_common_shape(four, {.replicates = 0}).statistic;
  EXPECT_GT(ratio, 5.7);
  EXPECT_LT(ratio, 6.8);
}

TEST_F(TendonAlt, ShapeOfTheLastLevelBreaksTheOthers) {
  const std::vector<Sample> five = samples({315, 360, 405, 450, 540});
  const statistics::Test test =
      statistics::test_shapes(five, {.replicates = 0}).one_against_rest[4];
  EXPECT_EQ(fmt::format("{:.1f}", test.statistic), "9.9");
  EXPECT_EQ(fmt::format("{:.3f}", test.p_chi_square), "0.002");
}

// As in the paper's Table 3 no family is refused at any level.
TEST_F(TendonAlt, LooksLikeEachFamily) {
  for (const Printed& printed : kPrinted) {
    const Sample lives = sample(level(printed.bend_angle_deg));
    for (const Family family : {Family::normal, Family::lognormal, Family::weibull}) {
      SCOPED_TRACE(
          fmt::format("{} deg, family {}", printed.bend_angle_deg, static_cast<int>(family)));
      const statistics::GoodnessOfFit goodness =
          statistics::goodness_of_fit(statistics::fit(family, lives), lives, {.replicates = 500});
      EXPECT_GT(goodness.ks_p, 0.05);
      EXPECT_GT(goodness.ad_p, 0.05);
    }
  }
}

// Section 4.1: 39.9 N, mean 1.00e3, of which the predicted 867 cycles are 13.6 % short; eight of
// ten between B10 and B90 of A 1.53e5, gamma 1.38, beta 5.94 (647 and 1088 cycles), two above.
TEST_F(TendonAlt, HasTheUpperArmApplication) {
  const Level& one = level(270, 10);
  EXPECT_EQ(one.role, Campaign::Role::validation);
  EXPECT_EQ(fmt::format("{:.1f}", one.load.effective_tension_N), "39.9");
  const Sample lives = sample(one);
  ASSERT_EQ(lives.size(), 10U);
  EXPECT_EQ(fmt::format("{:.2e}", mean(lives)), "1.00e+03");
  EXPECT_EQ(fmt::format("{:.1f}", 100 * (1 - 867 / mean(lives))), "13.6");
  const auto between = [&](double low, double high) {
    return std::count_if(lives.begin(), lives.end(), [&](const statistics::Observation& life) {
      return life.value > low && life.value < high;
    });
  };
  EXPECT_EQ(between(647, 1088), 8);
  EXPECT_EQ(between(1088, HUGE_VAL), 2);
}

TEST_F(TendonAlt, HasTheUsesOfThePaper) {
  const std::vector<Campaign::Use>& uses = campaign().uses;
  ASSERT_EQ(uses.size(), 4U);
  const std::array<std::string, 3> printed_N{"25.5", "25.0", "39.9"};
  for (std::size_t i = 0; i < printed_N.size(); ++i) {
    ASSERT_EQ(uses[i].parts.size(), 1U);
    EXPECT_EQ(fmt::format("{:.1f}", uses[i].parts[0].load.effective_tension_N), printed_N[i]);
  }
  ASSERT_EQ(uses[3].parts.size(), 2U);
  EXPECT_EQ(uses[3].parts[0].load.effective_tension_N, 40.0);
  EXPECT_EQ(uses[3].parts[1].load.effective_tension_N, 50.0);
  EXPECT_EQ(uses[3].parts[0].share, 0.5);
}

}  // namespace
}  // namespace host_sim
