#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "hal/files/input_error.hpp"
#include "host_sim/campaign/campaign.hpp"
#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/effects/tension/tension_effect.hpp"
#include "host_sim/synth/campaign/make.hpp"

namespace host_sim::diagnose {

using hal::files::InputError;

namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Small {
  int sessions = 8;
  std::string ambients_C = "20.0, 45.0";
  std::string hidden = {};  ///< tables of what is hidden
};

std::string plan_text(const Small& small) {
  return fmt::format(R"(schema = 1
[campaign]
name = "small"
[model.cable]
diameter_mm = 0.457
ultimate_tension_N = 177.4
[model.sheath]
friction_coefficient = 0.128
bend_angle_deg = 270.0
[model.drive]
torque_constant_Nm_per_A = 0.0325
gear_ratio = 9.0
gear_efficiency = 0.88
spool_radius_mm = 12.5
current_offset_A = 0.0
[recordings]
design = "balanced"
sessions = {}
bend_angles_deg = [90.0, 450.0]
output_means_N = [20.0, 35.0]
output_amplitudes_N = [5.0, 15.0]
frequencies_Hz = [0.5, 1.0]
travels_mm = [20.0, 40.0]
sheath_ambients_C = [{}]
start_cycles = [0.0, 2000.0]
load_frequency_ratio = 1.3
sample_rate_Hz = 50.0
duration_s = 8.0
channels = ["motor_current_A", "output_tension_N", "tendon_velocity_m_s", "bend_angle_deg",
            "motor_angle_rad", "sheath_temperature_C"]
[noise]
log_tension_sd = 0.005
[scatter]
log_gain_sd = 0.01
friction_sd = 0.006
{})",
                     small.sessions, small.ambients_C, small.hidden);
}

const std::string kPreload = "[effects.friction_preload]\nforce_N = 4.0\n";
const std::string kCreep = "[outside.sheath_creep]\nshare = 0.4\ntime_constant_s = 2.0\n";

/// A campaign in a folder of its own, gone at the end.
class DiagnoseRecordings : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove_all(folder_); }

  Campaign make(const Small& small, std::uint64_t seed = 5) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    synth::MakeOptions options;
    options.seed = seed;
    synth::make_campaign(synth::parse_synth_plan(plan_text(small), "plan"), options, folder_);
    return read_campaign(folder_);
  }

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  /// Writes `value` into a column of each recording, by its name.
  void overwrite(const std::string& column, const std::string& value) const {
    for (const auto& file : std::filesystem::directory_iterator(folder_ / "recordings")) {
      std::ifstream in(file.path());
      std::string line;
      std::getline(in, line);
      std::ostringstream out;
      out << line << '\n';
      const std::vector<std::string> names = cells(line);
      const auto place = static_cast<std::size_t>(std::ranges::find(names, column) - names.begin());
      ASSERT_LT(place, names.size());
      while (std::getline(in, line)) {
        std::vector<std::string> values = cells(line);
        values[place] = value;
        out << fmt::format("{}\n", fmt::join(values, ","));
      }
      in.close();
      std::ofstream(file.path()) << out.str();
    }
  }

 private:
  static std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) {
      cells.push_back(cell);
    }
    return cells;
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() /
      fmt::format("tendonlife_{}_{}", ::getpid(),
                  ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

double probability_of(const Findings& findings, std::string_view id) {
  const auto found = std::ranges::find(findings.candidates, id, &Candidate::id);
  return found == findings.candidates.end() ? 0 : found->probability;
}

std::string why_invisible(const Findings& findings, std::string_view id) {
  const auto found = std::ranges::find(findings.invisible, id, &Invisible::id);
  return found == findings.invisible.end() ? "" : found->why;
}

std::string lag_of_current(double time_ms) {
  return fmt::format("[effects.filter_lag]\nsensor = \"motor_current\"\ntime_constant_ms = {}\n",
                     time_ms);
}

/// Where samples are 20 ms apart it shows at reversals alone.
TEST_F(DiagnoseRecordings, NamesALagThatIsShorterThanTheTimeBetweenSamples) {
  const Findings findings =
      diagnose_tension(make({.sessions = 16, .hidden = lag_of_current(8)}), {}).findings;
  ASSERT_EQ(findings.verdict, Verdict::named) << findings.prose;
  ASSERT_EQ(findings.effects.size(), 1U);
  EXPECT_EQ(findings.effects[0].id, "filter_lag");
  EXPECT_NEAR(findings.effects[0].parameters.at(0).value, -0.008, 0.0008);
}

/// Less than a tenth of that is seen, but not how a force turns in it.
TEST_F(DiagnoseRecordings, AShortLagMayAsWellBeADelay) {
  const Findings findings = diagnose_tension(make({.hidden = lag_of_current(1.5)}), {}).findings;
  EXPECT_EQ(findings.verdict, Verdict::ambiguous) << findings.prose;
  EXPECT_THAT(findings.equivalent_sets,
              ::testing::Contains(::testing::UnorderedElementsAre("filter_lag", "channel_delay")));
  EXPECT_THAT(findings.next_experiment, HasSubstr("a lag cuts peaks, a delay does not"));
}

TEST_F(DiagnoseRecordings, FindsNothingWhereNothingIsHidden) {
  const TensionDiagnosis diagnosis = diagnose_tension(make({}), {});
  const Findings& findings = diagnosis.findings;
  EXPECT_EQ(findings.verdict, Verdict::none);
  EXPECT_GT(probability_of(findings, "none"), 0.5);
  EXPECT_THAT(findings.effects, IsEmpty());
  EXPECT_THAT(findings.extensions, IsEmpty());
  EXPECT_EQ(diagnosis.damage_ratio, 1);
  EXPECT_NEAR(diagnosis.friction_coefficient, 0.128, 4 * 0.006);
  EXPECT_NEAR(diagnosis.log_gain, 0, 4 * 0.01);
  for (const Discrepancy& discrepancy : findings.discrepancies) {
    EXPECT_GT(discrepancy.p, 0.01) << discrepancy.covariate;
    EXPECT_EQ(discrepancy.p, discrepancy.p_after);
  }
  double sum = 0;
  for (const Candidate& candidate : findings.candidates) {
    sum += candidate.probability;
  }
  EXPECT_NEAR(sum, 1, 1e-9);
}

TEST_F(DiagnoseRecordings, NamesWhatIsHiddenAndMeasuresWhatMendingItGains) {
  const TensionDiagnosis diagnosis = diagnose_tension(make({.hidden = kPreload}), {});
  const Findings& findings = diagnosis.findings;
  ASSERT_EQ(findings.verdict, Verdict::named);
  ASSERT_EQ(findings.effects.size(), 1U);
  EXPECT_EQ(findings.effects[0].id, "friction_preload");
  EXPECT_GE(findings.effects[0].probability, 0.95);
  ASSERT_EQ(findings.effects[0].parameters.size(), 1U);
  EXPECT_NEAR(findings.effects[0].parameters[0].value, 4, 0.4);
  ASSERT_EQ(findings.extensions.size(), 1U);
  EXPECT_EQ(findings.extensions[0].id, "friction_preload");
  EXPECT_EQ(findings.gain.held_out_by, "session");
  ASSERT_FALSE(findings.gain.metrics.empty());
  EXPECT_EQ(findings.gain.metrics[0].name, "rmse_N");
  EXPECT_LT(findings.gain.metrics[0].after, 0.8 * findings.gain.metrics[0].before);
  EXPECT_NE(diagnosis.damage_ratio, 1);
  EXPECT_THAT(diagnosis.traces, ::testing::Not(IsEmpty()));
  EXPECT_THAT(diagnosis.remainders, ::testing::Not(IsEmpty()));
  EXPECT_THAT(findings.prose, HasSubstr("friction_preload"));
}

TEST_F(DiagnoseRecordings, CallsUnknownWhatTheCatalogueDoesNotHave) {
  const TensionDiagnosis diagnosis = diagnose_tension(make({.hidden = kCreep}), {});
  EXPECT_EQ(diagnosis.findings.verdict, Verdict::unknown) << diagnosis.findings.prose;
  EXPECT_THAT(diagnosis.findings.extensions, IsEmpty());
  EXPECT_EQ(diagnosis.findings.remainder.value().covariate, "time");
  EXPECT_THAT(diagnosis.findings.next_experiment, HasSubstr("with nothing changed"));
  EXPECT_FALSE(diagnosis.findings.steps.empty());
  EXPECT_THAT(diagnosis.findings.discrepancies, ::testing::Not(IsEmpty()));
  EXPECT_THAT(diagnosis.findings.invisible, ::testing::Not(IsEmpty()));
}

TEST_F(DiagnoseRecordings, CallsUnknownWhatIsTakenOutOfTheCatalogue) {
  DiagnoseOptions options;
  options.without = {"friction_preload"};
  const TensionDiagnosis diagnosis = diagnose_tension(make({.hidden = kPreload}), options);
  EXPECT_EQ(diagnosis.findings.verdict, Verdict::unknown) << diagnosis.findings.prose;
  EXPECT_EQ(probability_of(diagnosis.findings, "friction_preload"), 0);
  // Few sessions do not scatter by what no law takes up, which would lead the nominal model away.
  EXPECT_LT(diagnosis.findings.steps.front().input_rmse_N, 3.8);
}

/// Whatever is in it: elasticity and presliding turn friction over alike along such short strokes.
TEST_F(DiagnoseRecordings, SaysWhatTheCampaignCannotDistinguish) {
  const Findings findings = diagnose_tension(make({}), {}).findings;
  EXPECT_THAT(findings.equivalent_sets,
              ::testing::Contains(::testing::UnorderedElementsAre("compliance", "presliding")));
  EXPECT_EQ(findings.next_experiment, "");
}

TEST_F(DiagnoseRecordings, NamesNothingOfOneSession) {
  const TensionDiagnosis diagnosis =
      diagnose_tension(make({.sessions = 1, .hidden = kPreload}), {});
  EXPECT_NE(diagnosis.findings.verdict, Verdict::named);
  EXPECT_THAT(diagnosis.findings.extensions, IsEmpty());
  EXPECT_THAT(diagnosis.findings.prose,
              HasSubstr("It takes 4 sessions to name anything (here: 1)"));
}

TEST_F(DiagnoseRecordings, SaysThatNothingMoved) {
  make({});
  overwrite("tendon_velocity_m_s", "0");
  const TensionDiagnosis diagnosis = diagnose_tension(read_campaign(folder()), {});
  EXPECT_EQ(diagnosis.findings.verdict, Verdict::none);
  EXPECT_THAT(diagnosis.findings.prose, HasSubstr("nothing can be diagnosed"));
  EXPECT_EQ(diagnosis.findings.invisible.size(), effects::tension_effects().size());
}

TEST_F(DiagnoseRecordings, SaysWhyAConstantOrMissingChannelShowsNothing) {
  make({});
  overwrite("sheath_temperature_C", "21.5");
  const TensionDiagnosis diagnosis = diagnose_tension(read_campaign(folder()), {});
  EXPECT_EQ(diagnosis.findings.verdict, Verdict::none);
  EXPECT_THAT(why_invisible(diagnosis.findings, "friction_temperature"),
              HasSubstr("heat the sheath"));
  EXPECT_THAT(why_invisible(diagnosis.findings, "torque_gain"), HasSubstr("winding_temperature_C"));
}

TEST_F(DiagnoseRecordings, SaysThatAnOutputThatNeverChangesMayBeABrokenLoadCell) {
  make({.hidden = kPreload});
  overwrite("output_tension_N", "20");
  const TensionDiagnosis diagnosis = diagnose_tension(read_campaign(folder()), {});
  EXPECT_NE(diagnosis.findings.verdict, Verdict::named);
  EXPECT_THAT(diagnosis.faults, Contains(HasSubstr("a load cell that does not work")));
}

TEST_F(DiagnoseRecordings, AsksForTheNominalSheath) {
  Campaign campaign = make({.sessions = 2});
  campaign.nominal.sheath.reset();
  try {
    diagnose_tension(campaign, {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("campaign.toml"));
    EXPECT_THAT(error.what(), HasSubstr("[model.sheath]"));
  }
}

TEST_F(DiagnoseRecordings, IsTheSameForAnyNumberOfThreads) {
  const Campaign campaign = make({.sessions = 5, .hidden = kPreload});
  DiagnoseOptions options;
  options.threads = 1;
  const TensionDiagnosis one = diagnose_tension(campaign, options);
  options.threads = 3;
  const TensionDiagnosis three = diagnose_tension(campaign, options);
  ASSERT_EQ(one.findings.candidates.size(), three.findings.candidates.size());
  for (std::size_t i = 0; i < one.findings.candidates.size(); ++i) {
    EXPECT_EQ(one.findings.candidates[i].id, three.findings.candidates[i].id);
    EXPECT_EQ(one.findings.candidates[i].probability, three.findings.candidates[i].probability);
  }
  for (std::size_t i = 0; i < one.findings.discrepancies.size(); ++i) {
    EXPECT_EQ(one.findings.discrepancies[i].p, three.findings.discrepancies[i].p);
  }
  EXPECT_EQ(one.friction_coefficient, three.friction_coefficient);
}

}  // namespace
}  // namespace host_sim::diagnose
