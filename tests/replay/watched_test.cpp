#include "host_sim/replay/watched.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "hal/files/input_file.hpp"
#include "hal/files/profile.hpp"
#include "host_sim/campaign/campaign_files.hpp"
#include "host_sim/extension/model_file.hpp"
#include "host_sim/recording/import.hpp"
#include "host_sim/replay/replay.hpp"
#include "host_sim/replay/results.hpp"
#include "host_sim/report/replay/report_data.hpp"
#include "tests/io/support.hpp"

namespace host_sim {
namespace {

using hal::files::memory_source;
using hal::files::ProfileReader;

namespace fs = std::filesystem;

const fs::path kExamples = EXAMPLES;

Model upper_arm() {
  return read_model(kExamples / "upper_arm.toml");
}

ReplayResult replayed(ProfileReader profile, const Model& model) {
  return replay(profile, model, "model.toml", {});
}
ReplayResult replayed_text(const std::string& text, const Model& model) {
  return replayed(ProfileReader(memory_source(text), "profile.csv"), model);
}

/// Slack below 5 N over 4 mm, broken at no more than 2 N over 20 mm; 100 Hz.
Model watched_model() {
  Model model = upper_arm();
  model.counting.sample_rate_Hz = 100;
  model.watch = Model::Watch{
      .minimum_tension_N = 5, .broken_tension_N = 2, .broken_travel_mm = 20, .slack_travel_mm = 4};
  return model;
}

/// Rows at 100 Hz: so many of a tension in N and a velocity in m/s, under two comment lines.
struct Stretch {
  int rows;
  double tension_N;
  double velocity_m_s;
};
std::string profile_of(const std::vector<Stretch>& stretches) {
  std::string text = "# made\n# by hand\ntime_s,input_tension_N,tendon_velocity_m_s\n";
  int row = 0;
  for (const Stretch& stretch : stretches) {
    for (int i = 0; i < stretch.rows; ++i, ++row) {
      text += fmt::format("{},{},{}\n", row / 100.0, stretch.tension_N, stretch.velocity_m_s);
    }
  }
  return text;
}

/// 0.457 mm over 270 deg are 2.1535 mm; a hysteresis of 0.2 N.
TEST(SuggestedWatch, FollowsFromTheModel) {
  Model model = upper_arm();
  Model::Watch watch = suggested_watch(model);
  EXPECT_DOUBLE_EQ(watch.broken_tension_N, 0.2);
  EXPECT_DOUBLE_EQ(watch.minimum_tension_N, 0.4);
  EXPECT_NEAR(watch.slack_travel_mm, 2.15356, 1e-5);
  EXPECT_NEAR(watch.broken_travel_mm, 21.5356, 1e-4);
  model.sheath.bend_angle_deg = 90;
  model.extensions = {{"friction_preload", {{"preload_N", {1.5}}}}};
  watch = suggested_watch(model);
  EXPECT_DOUBLE_EQ(watch.broken_tension_N, 1.7);
  EXPECT_DOUBLE_EQ(watch.minimum_tension_N, 3.4);
  EXPECT_DOUBLE_EQ(watch.slack_travel_mm, 1);
  EXPECT_DOUBLE_EQ(watch.broken_travel_mm, 10);
  model.counting.hysteresis_N = 90;
  EXPECT_EQ(suggested_watch(model), Model::Watch{});
}

/// 10 rows taut, then 1 mm a row: slack with the 4th row, which is line 17, at 0.13 s; broken with
/// the 20th, line 33, at 0.29 s.
TEST(WatchedReplay, FindsSlackAndABreakWithTheirLines) {
  const ReplayResult result =
      replayed_text(profile_of({{10, 60, 0.1}, {25, 1, 0.1}, {5, 100, 0}}), watched_model());
  const Watched& watched = result.watched;
  EXPECT_FALSE(watched.suggested);
  EXPECT_TRUE(watched.motion);
  EXPECT_TRUE(watched.broken);
  EXPECT_EQ(watched.slack_events, 1u);
  ASSERT_EQ(watched.found.size(), 2u);
  EXPECT_EQ(watched.found[0].event, WireEvent::slack);
  EXPECT_DOUBLE_EQ(watched.found[0].time_s, 0.13);
  EXPECT_EQ(watched.found[0].line, 17u);
  EXPECT_EQ(watched.found[1].event, WireEvent::broken);
  EXPECT_DOUBLE_EQ(watched.found[1].time_s, 0.29);
  EXPECT_EQ(watched.found[1].line, 33u);
  EXPECT_NEAR(watched.peak_ratio, 100 / 177.4, 1e-8);
  EXPECT_EQ(watched.above, (std::array<std::uint32_t, 3>{1, 0, 0}));
  EXPECT_NEAR(watched.below_minimum_s, 0.25, 1e-12);
  ReplayReport report;
  fill_report(report, result, watched_model());
  EXPECT_EQ(report.found,
            (std::vector<std::string>{"Loose at 0.13 s, line 17 of the profile.",
                                      "Broken: friction alone was left while it was pulled at 0.29 "
                                      "s, line 33 of the profile."}));
  EXPECT_EQ(found_in(result), (std::vector<std::string>{"tendon_broken", "tendon_slack"}));
  ASSERT_EQ(result.warnings.size(), 2u);
  EXPECT_EQ(result.warnings[0],
            "the wire is broken, found at 0.29 s, line 33: pulled over 20 mm at no more than 2 N");
  EXPECT_EQ(result.warnings[1],
            "the wire hangs loose 1 times, first found at 0.13 s, line 17: moved over 4 mm below "
            "5 N");
  const auto json = nlohmann::json::parse(replay_json(result));
  EXPECT_EQ(json["watch"]["events"],
            nlohmann::json::parse(R"([{"event": "slack", "time_s": 0.13, "line": 17},
                                      {"event": "broken", "time_s": 0.29, "line": 33}])"));
  EXPECT_EQ(json["watch"]["broken"], true);
  EXPECT_EQ(json["watch"]["above_50"], 1);
}

/// The angle of a motor on a spool of 12.5 mm behind a gear of 9: 0.72 rad are 1 mm.
TEST(WatchedReplay, TheAngleOfTheMotorTellsTheMotionToo) {
  std::string text = "time_s,input_tension_N,motor_angle_rad\n";
  for (int i = 0; i < 30; ++i) {
    text += fmt::format("{},{},{}\n", i / 100.0, i < 5 ? 60 : 1, 0.72 * i);
  }
  const Watched watched = replayed_text(text, watched_model()).watched;
  EXPECT_TRUE(watched.motion);
  ASSERT_EQ(watched.found.size(), 2u);
  EXPECT_DOUBLE_EQ(watched.found[1].time_s, 0.24);
  Model model = watched_model();
  model.drive.reset();
  EXPECT_FALSE(replayed_text(text, model).watched.motion);
}

TEST(WatchedReplay, WithoutMotionThereArePeaksAndTimeAlone) {
  std::string text = "time_s,input_tension_N\n";
  for (int i = 0; i < 1000; ++i) {
    text += fmt::format("{},{}\n", i / 100.0, i < 500 ? 90 : 1);
  }
  const ReplayResult result = replayed_text(text, watched_model());
  EXPECT_FALSE(result.watched.motion);
  EXPECT_FALSE(result.watched.broken);
  EXPECT_EQ(result.watched.slack_events, 0u);
  EXPECT_NEAR(result.watched.below_minimum_s, 5, 1e-12);
  EXPECT_EQ(result.watched.above[0], 1u);
  std::ostringstream summary;
  write_summary(summary, result, "a", "b");
  EXPECT_NE(summary.str().find("break         not watched: the profile tells no motion"),
            std::string::npos);
}

/// 10 N and 60 N in turn: after 9 rows 4 cycles, in the five-point sense 3 full and 2 halves.
/// Up to the break there is the half cycle down to 1 N besides.
TEST(SeenLife, EndsWithTheBreak) {
  std::vector<Stretch> stretches;
  for (int i = 0; i < 4; ++i) {
    stretches.push_back({1, 10, 0.1});
    stretches.push_back({1, 60, 0.1});
  }
  stretches.push_back({1, 10, 0.1});
  const ReplayResult whole = replayed_text(profile_of(stretches), watched_model());
  ASSERT_TRUE(whole.seen_life);
  EXPECT_FALSE(whole.seen_life->failed);
  EXPECT_DOUBLE_EQ(whole.seen_life->cycles, 4);
  // T_a 25 and T_m 35 of T_u 177.4.
  EXPECT_NEAR(whole.seen_life->effective_tension_N, 26.0125, 1e-3);

  stretches.push_back({25, 1, 0.1});
  const ReplayResult broken = replayed_text(profile_of(stretches), watched_model());
  stretches.push_back({1, 150, 0});
  stretches.push_back({1, 1, 0});
  const ReplayResult later = replayed_text(profile_of(stretches), watched_model());
  ASSERT_TRUE(broken.seen_life && later.seen_life);
  EXPECT_TRUE(later.seen_life->failed);
  EXPECT_DOUBLE_EQ(later.seen_life->cycles, 4);
  EXPECT_DOUBLE_EQ(later.seen_life->cycles, broken.seen_life->cycles);
  EXPECT_DOUBLE_EQ(later.seen_life->effective_tension_N, broken.seen_life->effective_tension_N);
}

/// Eight ranges, from 10 N up to 60 N and at last down to 1 N, are four cycles.
TEST(SeenLife, LeavesItsOpenHalfCyclesToTheEndOfTheReport) {
  std::vector<Stretch> stretches;
  for (int i = 0; i < 4; ++i) {
    stretches.push_back({1, 10, 0.1});
    stretches.push_back({1, 60, 0.1});
  }
  stretches.push_back({25, 1, 0.1});
  ReplayReport report;
  ReplayOptions options;
  options.report = &report;
  ProfileReader profile(memory_source(profile_of(stretches)), "profile.csv");
  EXPECT_TRUE(replay(profile, watched_model(), "model.toml", options).watched.broken);
  const auto& count = report.range_mean.count;
  EXPECT_DOUBLE_EQ(std::accumulate(count.begin(), count.end(), 0.0), 4);
}

TEST(SeenLife, IsARowThatCalibrateReads) {
  const std::string text = specimens_head() + specimen_row("a, b", {12.5, 33.25, true}) +
                           specimen_row("c", {7, 30, false});
  EXPECT_EQ(text,
            "specimen,lot,input_tension_mean_N,input_tension_amplitude_N,cycles,status\n"
            "\"a, b\",field,0,33.25,12.5,failed\n"
            "c,field,0,30,7,suspended\n");
  const auto rows = parse_specimens(memory_source(text), "specimens.csv");
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].cycles, 12.5);
  EXPECT_EQ(rows[0].specimen.status, Campaign::Status::failed);
  EXPECT_EQ(rows[1].specimen.status, Campaign::Status::suspended);
}

/// Rows of a profile of output tension and velocity.
struct Rows {
  std::string head;
  std::vector<hal::files::ProfileRow> rows;
};

Rows rows_of(const fs::path& path) {
  ProfileReader reader(path);
  Rows result{"time_s,output_tension_N,tendon_velocity_m_s,bend_angle_deg\n", {}};
  std::vector<hal::files::ProfileRow> rows(100'000);
  rows.resize(reader.read(rows));
  result.rows = std::move(rows);
  return result;
}

/// The shipped example with its wire cut at a random row: friction of up to 0.1 N is left. The
/// crank's stroke of 50 mm is longer than the suggested 21.5 mm of travel.
TEST(CutWire, IsFoundWithinTheStatedTravelAndNeverBefore) {
  const Model model = upper_arm();
  const Rows shipped = rows_of(kExamples / "upper_arm.csv");
  ASSERT_GT(shipped.rows.size(), 10'000u);
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    std::mt19937 random(seed);
    const auto count = static_cast<std::uint32_t>(shipped.rows.size());
    const std::size_t cut = 200 + random() % (count - 1400);
    std::uniform_real_distribution<double> friction_N(0, 0.1 / 1.83);
    std::string text = shipped.head;
    for (std::size_t i = 0; i < shipped.rows.size(); ++i) {
      const auto& row = shipped.rows[i];
      text += fmt::format("{},{},{},{}\n", row.time_s, i < cut ? row.value : friction_N(random),
                          row.tendon_velocity_m_s, row.bend_angle_deg);
    }
    const Watched watched = replayed_text(text, model).watched;
    ASSERT_TRUE(watched.suggested);
    ASSERT_TRUE(watched.broken) << seed;
    const auto found = std::find_if(watched.found.begin(), watched.found.end(),
                                    [](const auto& f) { return f.event == WireEvent::broken; });
    ASSERT_NE(found, watched.found.end());
    const std::size_t at = found->line - 2;  // behind the header
    ASSERT_GE(at, cut) << seed;
    for (const FoundInWire& event : watched.found) {
      EXPECT_GE(event.line - 2, cut) << seed;
    }
    // Pulled from where it was furthest released, in steps of up to 0.27 mm.
    double position_mm = 0;
    double released_mm = 0;
    for (std::size_t i = cut; i <= at; ++i) {
      const double velocity_m_s = shipped.rows[i].tendon_velocity_m_s;
      position_mm += std::fabs(velocity_m_s) > 1e-3 ? velocity_m_s * 5 : 0;
      released_mm = std::min(released_mm, position_mm);
    }
    EXPECT_GE(position_mm - released_mm, watched.limits.broken_travel_mm - 1e-3) << seed;
    EXPECT_LT(position_mm - released_mm, watched.limits.broken_travel_mm + 0.27) << seed;
  }
}

TEST(FalseAlarms, NoneInTheShippedExamples) {
  int profiles = 0;
  for (const auto& entry : fs::directory_iterator(kExamples)) {
    if (entry.path().extension() != ".csv") {
      continue;
    }
    ++profiles;
    const Watched watched = replayed(ProfileReader(entry.path()), upper_arm()).watched;
    EXPECT_TRUE(watched.motion) << entry.path();
    EXPECT_TRUE(watched.found.empty()) << entry.path();
    EXPECT_EQ(watched.below_minimum_s, 0) << entry.path();
  }
  EXPECT_GE(profiles, 1);
}

/// A wire of four times the strength of what was measured, with the paper's sheath, and a
/// thousandth of its strength as noise: how a recording that has no model would be watched.
Model model_for(const fs::path& recording) {
  ProfileReader reader(recording);
  std::vector<hal::files::ProfileRow> rows(100'000);
  rows.resize(reader.read(rows));
  double highest_N = 0;
  for (const auto& row : rows) {
    highest_N = std::max(highest_N, std::fabs(row.value));
  }
  Model model = upper_arm();
  model.cable.ultimate_tension_N = 4 * highest_N;
  model.counting.hysteresis_N = 1e-3 * model.cable.ultimate_tension_N;
  model.counting.sample_rate_Hz = 100;
  return model;
}

void expect_no_alarm(const fs::path& folder, std::size_t least) {
  std::size_t recordings = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".csv" || name == "sessions.csv" || name == "specimens.csv") {
      continue;
    }
    ++recordings;
    const Watched watched = replayed(ProfileReader(entry.path()), model_for(entry.path())).watched;
    EXPECT_TRUE(watched.motion) << name;
    EXPECT_FALSE(watched.broken) << name;
    EXPECT_EQ(watched.slack_events, 0u) << name;
  }
  EXPECT_GE(recordings, least);
}

TEST(FalseAlarms, NoneInTheRecordedScrewDrive) {
  const fs::path drive = TENDONLIFE_SHARED "/data/emps_drive";
  if (!fs::exists(drive)) {
    GTEST_SKIP() << "NOT CHECKED: there is no " << drive
                 << "; configure with -DTENDONLIFE_SHARED=<folder that holds data/>";
  }
  expect_no_alarm(drive, 12);
}

TEST(FalseAlarms, NoneInTheRecordedCableDrive) {
  const fs::path drive = TENDONLIFE_SHARED "/data/davinci_cable_torque/Tool_4_Maryland_L_4.csv";
  if (!fs::exists(drive)) {
    GTEST_SKIP() << "NOT CHECKED: there is no " << drive
                 << "; configure with -DTENDONLIFE_SHARED=<folder that holds data/>";
  }
  const test::TemporaryFolder folder;
  recording::write_campaign(
      recording::import_davinci(hal::files::open_source(drive, "a file"), "drive", {}),
      folder / "drive");
  expect_no_alarm(folder / "drive", 50);
}

}  // namespace
}  // namespace host_sim
