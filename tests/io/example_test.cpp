#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <vector>

#include "hal/files/profile.hpp"
#include "host_sim/model/model.hpp"
#include "tests/io/support.hpp"

namespace host_sim {

using hal::files::InputKind;
using hal::files::open_source;
using hal::files::ProfileReader;
using hal::files::ProfileRow;

namespace {

const std::filesystem::path kExamples = TENDONLIFE_EXAMPLES;

constexpr double kPi = 3.14159265358979323846;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNoise_N = 0.1;  // five standard deviations of the example's noise

std::vector<ProfileRow> example_rows() {
  return test::rows_of(open_source(kExamples / "upper_arm.csv", ""));
}

TEST(UpperArmExample, IsAnOutputTensionProfileOfTwentyTurns) {
  const ProfileReader reader(kExamples / "upper_arm.csv");
  EXPECT_EQ(reader.kind(), InputKind::kOutputTension);
  EXPECT_TRUE(reader.has_bend_angle());
  EXPECT_LT(reader.bytes_total(), 1'000'000U);
  const auto rows = example_rows();
  ASSERT_EQ(rows.size(), 20U * 600U + 1U);
  EXPECT_EQ(rows.front().time_s, 0.0);
  EXPECT_EQ(rows.back().time_s, 60.0);
}

TEST(UpperArmExample, HasTheModelOfThePaper) {
  const Model model = read_model(kExamples / "upper_arm.toml");
  EXPECT_EQ(model.cable.diameter_mm, 0.457);
  EXPECT_EQ(model.cable.ultimate_tension_N, 177.4);
  EXPECT_EQ(model.sheath.friction_coefficient, 0.128);
  EXPECT_EQ(model.sheath.bend_angle_deg, 270.0);
  EXPECT_EQ(model.life.ipl_scale, 1.53e5);
  EXPECT_EQ(model.life.ipl_exponent, 1.38);
  EXPECT_EQ(model.life.weibull_shape, 5.94);
  EXPECT_EQ(model.counting.sample_rate_Hz, 200.0);
  EXPECT_TRUE(model.drive.has_value());
}

TEST(UpperArmExample, FollowsTheStrokeOfThePaper) {
  const double velocity_amplitude_m_s = 0.025 * 2.0 * kPi / 3.0;
  for (const ProfileRow& row : example_rows()) {
    const double angle = 2.0 * kPi * row.time_s / 3.0;
    ASSERT_NEAR(row.value, 38.5 - 10.0 * std::cos(angle), kNoise_N) << row.time_s;
    ASSERT_NEAR(row.tendon_velocity_m_s, velocity_amplitude_m_s * std::sin(angle), 1e-6);
    ASSERT_EQ(row.bend_angle_deg, 270.0);
  }
}

TEST(UpperArmExample, GivesTheEffectiveTensionOfThePaper) {
  const Model model = read_model(kExamples / "upper_arm.toml");
  const double efficiency = std::exp(-0.128 * 1.5 * kPi);  // eq. (14)
  double highest_N = -kInfinity;
  double lowest_N = kInfinity;
  ProfileRow at_highest{};
  ProfileRow at_lowest{};
  bool pulling = true;
  for (const ProfileRow& row : example_rows()) {
    if (row.tendon_velocity_m_s != 0.0) {
      pulling = row.tendon_velocity_m_s > 0.0;
    }
    const double input_N = pulling ? row.value / efficiency : row.value * efficiency;
    if (input_N > highest_N) {
      highest_N = input_N;
      at_highest = row;
    }
    if (input_N < lowest_N) {
      lowest_N = input_N;
      at_lowest = row;
    }
  }
  EXPECT_NEAR(at_highest.value, 48.5, kNoise_N);
  EXPECT_GE(at_highest.tendon_velocity_m_s, 0.0);
  EXPECT_NEAR(at_lowest.value, 28.5, kNoise_N);
  EXPECT_LE(at_lowest.tendon_velocity_m_s, 0.0);

  // eqs. (12), (13) with T_out,m = 38.5 N and T_out,a = 10.0 N
  const double sum = (1.0 / efficiency + efficiency) / 2.0;
  const double difference = (1.0 / efficiency - efficiency) / 2.0;
  const double mean_N = (highest_N + lowest_N) / 2.0;
  const double amplitude_N = (highest_N - lowest_N) / 2.0;
  EXPECT_NEAR(mean_N, sum * 38.5 + difference * 10.0, 2.0 * kNoise_N);
  EXPECT_NEAR(amplitude_N, difference * 38.5 + sum * 10.0, 2.0 * kNoise_N);
  const double ratio = mean_N / model.cable.ultimate_tension_N;
  EXPECT_NEAR(amplitude_N / (1.0 - ratio * ratio), 39.9, 0.4);  // eq. (11), section 4.1
}

}  // namespace
}  // namespace host_sim
