#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "host_sim/diagnose/force/extended_model.hpp"
#include "host_sim/effects/tension/force_model.hpp"
#include "host_sim/extension/model_file.hpp"

namespace host_sim::diagnose {
namespace {

/// The values at x of the harmonics of 1.25 strokes of 0.2 m about 0.33 m are those of the table.
TEST(WrittenTerm, HarmonicsOfTheStrokeAreThoseAboutPositionZero) {
  const effects::ForceScales scales{.speed_m_s = 1,
                                    .stroke_m = 0.2,
                                    .position_m = 0.33,
                                    .force_N = 1,
                                    .turn_over_m_s = 0.1,
                                    .cycles = 1,
                                    .poses_rad = {}};
  const std::vector<double> harmonics{0.3, -0.2, 0.1, 0.05};
  const auto written = written_term(effects::ForceTerm::position, harmonics, scales);
  ASSERT_TRUE(written);
  EXPECT_EQ(written->id, "friction_position");
  EXPECT_DOUBLE_EQ(value_of(*written, "wavelength_m"), 0.25);
  EXPECT_EQ(value_of(*written, "position_sine_6"), 0);
  for (const double position_m : {0.0, 0.1, 0.27, 0.4}) {
    double table = 0;
    for (int harmonic = 1; harmonic <= 2; ++harmonic) {
      const double phase = 2 * std::numbers::pi * harmonic * position_m / 0.25;
      const std::string number = std::to_string(harmonic);
      table += value_of(*written, "position_sine_" + number) * std::sin(phase) +
               value_of(*written, "position_cosine_" + number) * std::cos(phase);
    }
    const double turn = 2 * std::numbers::pi * (position_m - 0.33) / 0.25;
    EXPECT_NEAR(table,
                0.3 * std::sin(turn) - 0.2 * std::cos(turn) + 0.1 * std::sin(2 * turn) +
                    0.05 * std::cos(2 * turn),
                1e-12);
  }
}

TEST(WrittenTerm, NamesAreThoseOfAModelFile) {
  const effects::ForceScales scales{.speed_m_s = 0.1,
                                    .stroke_m = 0.2,
                                    .position_m = 0,
                                    .force_N = 10,
                                    .turn_over_m_s = 0.01,
                                    .cycles = 1,
                                    .poses_rad = {}};
  const auto text = [&](effects::ForceTerm term, const std::vector<double>& values) {
    return toml_text(std::vector{*written_term(term, values, scales)});
  };
  EXPECT_EQ(text(effects::ForceTerm::zero, {1.5}), "[extension.load_cell_zero]\nzero_N = 1.5\n");
  EXPECT_EQ(text(effects::ForceTerm::presliding, {0.01}),
            "[extension.presliding]\npresliding_length_m = 0.01\n");
  EXPECT_EQ(text(effects::ForceTerm::velocity, {20, 0.5}),
            "[extension.friction_velocity]\nviscous_N_s_m = 20.0\nviscous_friction_s_m = 0.5\n");
  EXPECT_EQ(text(effects::ForceTerm::current_offset, {0.25}),
            "[extension.current_offset]\ncurrent_offset_A = 0.25\n");
  EXPECT_EQ(text(effects::ForceTerm::gear_asymmetry, {-0.125}),
            "[extension.gear_asymmetry]\ngear_asymmetry = -0.125\n");
  EXPECT_FALSE(written_term(effects::ForceTerm::slack, std::vector{0.01}, scales));
  EXPECT_FALSE(written_term(effects::ForceTerm::compliance, std::vector{0.01}, scales));
}

TEST(WrittenTerm, FrictionThatFallsWithTheLoadCountsFrom50Newtons) {
  const effects::ForceScales scales{.speed_m_s = 1,
                                    .stroke_m = 1,
                                    .position_m = 0,
                                    .force_N = 25,
                                    .turn_over_m_s = 1,
                                    .cycles = 1,
                                    .poses_rad = {}};
  const std::vector<Extension> load{
      *written_term(effects::ForceTerm::load, std::vector{0.2}, scales)};
  // 0.1 (T/25 N)^-0.2 is 0.0870551 (T/50 N)^-0.2.
  EXPECT_NEAR(written_friction(0.1, load, scales), 0.0870551, 1e-7);
  EXPECT_EQ(written_friction(0.1, {}, scales), 0.1);
}

}  // namespace
}  // namespace host_sim::diagnose
