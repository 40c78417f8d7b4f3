#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "hal/files/input_file.hpp"
#include "hal/files/profile.hpp"
#include "host_sim/campaign/campaign.hpp"
#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/force/extended_model.hpp"
#include "host_sim/diagnose/output/extended_model.hpp"
#include "host_sim/effects/tension/force_model.hpp"
#include "host_sim/extension/acting.hpp"
#include "host_sim/extension/model_file.hpp"
#include "host_sim/recording/import.hpp"
#include "host_sim/recording/recording.hpp"
#include "host_sim/replay/constants.hpp"
#include "host_sim/replay/profile_input.hpp"
#include "lifemodel/pack/pack.hpp"
#include "tests/io/support.hpp"

namespace host_sim::diagnose {
namespace {

constexpr double kUltimate_N = 1000;  ///< of no consequence, but that all forces are below

/// The values at x of the harmonics of a stroke of 0.2 m about 0.3 m are those of the table at x.
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
  EXPECT_EQ(value_of(*written, "wavelength_m"), 0.2);
  EXPECT_EQ(value_of(*written, "position_sine_6"), 0);
  for (const double position_m : {0.0, 0.1, 0.27, 0.4}) {
    double table = 0;
    for (int harmonic = 1; harmonic <= 2; ++harmonic) {
      const double phase = 2 * std::numbers::pi * harmonic * position_m / 0.2;
      const std::string number = std::to_string(harmonic);
      table += value_of(*written, "position_sine_" + number) * std::sin(phase) +
               value_of(*written, "position_cosine_" + number) * std::cos(phase);
    }
    const double turn = 2 * std::numbers::pi * (position_m - 0.33) / 0.2;
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

/// What the fixed-point code of the target makes of the output of all recordings.
struct Replayed {
  std::vector<double> measured_N;
  std::vector<double> corrected_N;
};

Replayed replayed(const Campaign& campaign, const Model& model) {
  using hal::files::InputKind;
  Replayed all;
  for (const recording::Recording& recording : recording::read_recordings(campaign.folder)) {
    hal::files::ProfileReader profile(recording.file, {.input = InputKind::kOutputTension});
    const Acting acting = acting_extensions(model, InputKind::kOutputTension, profile.channels());
    EXPECT_TRUE(acting.others.empty());
    const lifemodel::ExtendedParameters parameters = extended_parameters_of(model, "m.toml");
    ProfileInput input(profile, model, parameters, 0);
    lifemodel::Flags flags;
    std::vector<hal::files::ProfileRow> rows(recording.samples());
    EXPECT_EQ(profile.read(rows), rows.size());
    for (const hal::files::ProfileRow& row : rows) {
      input.take(row, flags);
      const double fixed_N = kUltimate_N * lifemodel::pack::to_double(input.tension());
      EXPECT_NEAR(fixed_N, input.tension_N(), 1e-6 * std::abs(fixed_N) + 1e-6 * kUltimate_N);
      all.corrected_N.push_back(fixed_N);
    }
    EXPECT_FALSE(flags.has(lifemodel::Flag::saturated));
    const auto& measured_N = recording[hal::files::kInputTensionColumn];
    all.measured_N.insert(all.measured_N.end(), measured_N.begin(), measured_N.end());
  }
  return all;
}

/// A model of a load cell at the input has no place for the constant gain between both ends.
double rmse_N(const Replayed& replay, double gain) {
  double square_N2 = 0;
  for (std::size_t i = 0; i < replay.measured_N.size(); ++i) {
    square_N2 += std::pow(replay.measured_N[i] - gain * replay.corrected_N[i], 2);
  }
  return std::sqrt(square_N2 / static_cast<double>(replay.measured_N.size()));
}

/// The gain of least squares.
double best_gain(const Replayed& replay) {
  double product = 0;
  double square = 0;
  for (std::size_t i = 0; i < replay.measured_N.size(); ++i) {
    product += replay.measured_N[i] * replay.corrected_N[i];
    square += replay.corrected_N[i] * replay.corrected_N[i];
  }
  return product / square;
}

/// Capstan friction and a gain alone, each as well as they can be. A zero of nothing takes the
/// target through the same code.
double nominal_rmse_N(const Campaign& campaign, Model model) {
  model.extensions = {{"load_cell_zero", {{"zero_N", {0}}}}};
  double least_N = std::numeric_limits<double>::infinity();
  for (int step = 0; step <= 16; ++step) {
    model.sheath.friction_coefficient = 0.025 * step;
    const Replayed replay = replayed(campaign, model);
    least_N = std::min(least_N, rmse_N(replay, best_gain(replay)));
  }
  return least_N;
}

double metric(const Findings& findings, bool after) {
  for (const Metric& metric : findings.gain.metrics) {
    if (metric.name == "input_rmse_N") {
      return after ? metric.after : metric.before;
    }
  }
  return 0;
}

/// Diagnoses, writes, reads and replays.
void check_gain_of_diagnosis(Campaign campaign) {
  campaign.nominal.cable = Model::Cable{0.5, kUltimate_N};
  campaign.nominal.counting = Model::Counting{100, 0.2};
  campaign.nominal.life = Model::Life{Model::MeanStress::kGerber, 1.53e5, 1.38, 5.94};
  Diagnosis diagnosis;
  diagnosis.tension = diagnose_tension(campaign, {});
  const Findings& findings = diagnosis.tension->findings;
  ASSERT_EQ(findings.verdict, Verdict::named) << findings.prose;
  const std::string text = extended_model_text(campaign, diagnosis, InputFrom::load_cell, "1");
  const Model model = parse_extended_model(text, "extended.toml");
  EXPECT_EQ(model.extensions.size(), findings.extensions.size()) << text;
  for (const FoundEffect& effect : findings.effects) {
    EXPECT_NE(extension_of(model.extensions, effect.id), nullptr) << effect.id;
  }

  const double before_N = nominal_rmse_N(campaign, model);
  const double after_N = rmse_N(replayed(campaign, model), std::exp(-diagnosis.tension->log_gain));
  testing::Test::RecordProperty("before_N", fmt::format("{}", before_N));
  testing::Test::RecordProperty("after_N", fmt::format("{}", after_N));
  constexpr double kShare = 0.15;
  EXPECT_NEAR(before_N, metric(findings, false), kShare * metric(findings, false));
  EXPECT_NEAR(after_N, metric(findings, true), kShare * metric(findings, true));
}

class WrittenModel : public testing::Test {
 protected:
  static std::filesystem::path data(const char* name) {
    return std::filesystem::path(TENDONLIFE_SHARED) / "data" / name;
  }
};

TEST_F(WrittenModel, OfAScrewDriveBringsTheGainToTheTarget) {
  if (!std::filesystem::exists(data("emps_drive"))) {
    GTEST_SKIP() << "NOT CHECKED: no " << data("emps_drive")
                 << ": the measurements are not part of the project";
  }
  check_gain_of_diagnosis(read_campaign(data("emps_drive")));
}

TEST_F(WrittenModel, OfACableDriveBringsTheGainToTheTarget) {
  const std::filesystem::path file = data("davinci_cable_torque") / "Tool_4_Maryland_L_4.csv";
  if (!std::filesystem::exists(file)) {
    GTEST_SKIP() << "NOT CHECKED: no " << file << ": the measurements are not part of the project";
  }
  const test::TemporaryFolder folder;
  recording::write_campaign(
      recording::import_davinci(hal::files::open_source(file, "a file"), file.string(), {}),
      folder / "davinci");
  check_gain_of_diagnosis(read_campaign(folder / "davinci"));
}

}  // namespace
}  // namespace host_sim::diagnose
