#include "host_sim/campaign/load.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/campaign/support.hpp"

namespace host_sim {

using hal::files::InputError;

namespace {

Campaign::Load load_of(const std::string& load_columns, const std::string& load) {
  const Campaign campaign = test::campaign_of(
      {std::string(test::kPaperCampaign),
       fmt::format("specimen,lot,cycles,status,{}\na,1,1,failed,{}\n", load_columns, load), ""});
  return campaign.specimens.at(0).blocks.at(0).load;
}

Campaign::Load output_load(double bend_angle_deg, double mean_N, double amplitude_N) {
  return load_of("bend_angle_deg,output_tension_mean_N,output_tension_amplitude_N",
                 fmt::format("{},{},{}", bend_angle_deg, mean_N, amplitude_N));
}

// 49 N over 270 deg with mu 0.128: eta = exp(-0.128 * 3 pi / 2) = 0.547066, so 89.5687 N pulling
// and 26.8062 N releasing; Gerber (11) of mean 58.18747 and amplitude 31.38124 is 35.16440 N.
TEST(Load, OfOutputTensionGoesThroughTheSheath) {
  const Campaign::Load load = output_load(270, 49, 0);
  ASSERT_TRUE(load.bend_angle_deg.has_value());
  EXPECT_EQ(*load.bend_angle_deg, 270.0);
  EXPECT_NEAR(load.input_tension_mean_N, 58.18747, 5e-6);
  EXPECT_NEAR(load.input_tension_amplitude_N, 31.38124, 5e-6);
  EXPECT_NEAR(load.effective_tension_N, 35.16440, 5e-6);
}

// Straight, the output tension is the input tension.
TEST(Load, WithoutBendIsUnchanged) {
  const Campaign::Load load = output_load(0, 50, 20);
  EXPECT_EQ(load.input_tension_mean_N, 50.0);
  EXPECT_EQ(load.input_tension_amplitude_N, 20.0);
}

// The paper, section 4.2.1: 25.5 N for 25 N around 25 N; by hand 25 / (1 - (25 / 177.4)^2).
TEST(Load, OfInputTensionNeedsNoSheath) {
  const Campaign::Load load = load_of("input_tension_mean_N,input_tension_amplitude_N", "25,25");
  EXPECT_FALSE(load.bend_angle_deg.has_value());
  EXPECT_EQ(load.input_tension_mean_N, 25.0);
  EXPECT_EQ(load.input_tension_amplitude_N, 25.0);
  EXPECT_NEAR(load.effective_tension_N, 25.506553, 1e-6);
}

TEST(Load, MayReachUpToTheUltimateTension) {
  const std::string columns = "input_tension_mean_N,input_tension_amplitude_N";
  EXPECT_NO_THROW(load_of(columns, "100,77.3999"));
  EXPECT_THROW(load_of(columns, "100,77.4"), InputError);
  EXPECT_THROW(load_of(columns, "177.4,1"), InputError);
  EXPECT_THROW(load_of(columns, "200,1"), InputError);
  EXPECT_NO_THROW(load_of(columns, "0,0.001"));
  EXPECT_THROW(load_of(columns, "0,0.000999"), InputError);
}

TEST(Load, SaysWhereTheModelIsNeeded) {
  const auto complaint = [](const std::string& campaign) {
    return test::campaign_complaint(
        {campaign,
         "specimen,lot,cycles,status,bend_angle_deg,output_tension_mean_N,"
         "output_tension_amplitude_N\n# two\na,1,1,failed,270,49,0\n",
         ""});
  };
  EXPECT_EQ(complaint("[campaign]\nname = 'x'\n"),
            "c.toml: no table [model.cable]; accepted: [model.cable] with ultimate_tension_N, "
            "which the load at s.csv:3 needs");
  EXPECT_EQ(complaint("[campaign]\nname = 'x'\n[model.cable]\ndiameter_mm = 1\n"
                      "ultimate_tension_N = 100\n"),
            "c.toml:3:2: no table [model.sheath]; accepted: [model.sheath] with "
            "friction_coefficient, which the load at s.csv:3 needs");
}

}  // namespace
}  // namespace host_sim
