#include "host_sim/recording/import.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "hal/files/output_file.hpp"
#include "host_sim/campaign/campaign.hpp"
#include "host_sim/recording/recording.hpp"
#include "host_sim/recording/recording_files.hpp"
#include "tests/recording/support.hpp"

namespace host_sim::recording {

using enum hal::files::ProfileColumnId;
using hal::files::memory_source;
using hal::files::open_source;
using hal::files::OutputError;

namespace {

using testing::DoubleEq;
using testing::Each;
using testing::HasSubstr;

constexpr const char* kDavinciHeader =
    "freq_idx,torque_idx,t_s,drive_pos_rad,drive_vel_rad_s,drive_torque_Nm,jaw_torque_Nm\n";

/// Two sessions in turns: load 1 and load 0.
std::string measurements(int rows = 16) {
  std::string text = kDavinciHeader;
  for (int i = 0; i < rows; ++i) {
    const std::string time = std::to_string(i);
    text += "2,1," + time + ",0.5,-0.25,0.05,-0.02\n";
    text += "2,0," + time + ",0.75,0.5,-0.01,-0.01\n";
  }
  return text;
}

RecordedCampaign imported(const std::string& text, const DavinciOptions& options = {}) {
  return import_davinci(memory_source(text), "d.csv", options);
}

TEST(ImportDavinci, TurnsTorquesIntoTensionsOverThePulley) {
  const RecordedCampaign campaign = imported(measurements(), {.pulley_radius_mm = 10});
  ASSERT_EQ(campaign.recordings.size(), 2U);
  const Recording& let_go = campaign.recordings[0];
  const Recording& pulled = campaign.recordings[1];
  EXPECT_EQ(let_go.session, "frequency2_load00");
  EXPECT_EQ(pulled.session, "frequency2_load01");
  EXPECT_EQ(pulled.samples(), 16U);
  EXPECT_EQ(pulled[kTime].back(), 15);
  EXPECT_THAT(pulled[kInputTensionColumn], Each(DoubleEq(5)));
  EXPECT_THAT(pulled[kOutputTensionColumn], Each(DoubleEq(2)));
  EXPECT_THAT(pulled[kTendonVelocity], Each(DoubleEq(0.0025)));
  EXPECT_THAT(pulled[kMotorAngle], Each(DoubleEq(-0.5)));
  EXPECT_THAT(let_go[kInputTensionColumn], Each(DoubleEq(-1)));
  EXPECT_THAT(let_go[kTendonVelocity], Each(DoubleEq(-0.005)));
}

TEST(ImportDavinci, RefusesWhatItCannotTrust) {
  const auto complaint = [](const std::string& text) {
    return test::complaint_of([&] { imported(text); });
  };
  EXPECT_EQ(complaint(measurements() + "2,0,3,0,0,0,0\n"),
            "d.csv:34:5: time goes from 15 s to 3 s; accepted: time that increases within each "
            "pair of freq_idx and torque_idx");
  EXPECT_EQ(complaint(measurements(15)),
            "d.csv: 15 samples of freq_idx 2 and torque_idx 0; accepted: at least 16");
  EXPECT_EQ(complaint(measurements() + "0.5,0,3,0,0,0,0\n"),
            "d.csv:34:1: freq_idx is 0.5; accepted: a whole number");
  EXPECT_THAT(complaint(measurements() + "0,0,3,0,0,nan,0\n"),
              HasSubstr("d.csv:34:11: drive_torque_Nm is 'nan', not a finite number"));
  EXPECT_THAT(complaint("freq_idx,t_s\n0,0\n"), HasSubstr("d.csv:1:13: no column torque_idx"));
}

TEST(WriteCampaign, GivesAFolderThatIsReadAsItWasWritten) {
  const test::TemporaryFolder folder;
  const RecordedCampaign campaign = imported(measurements());
  write_campaign(campaign, folder / "new/campaign");
  const auto recordings = read_recordings(folder / "new/campaign");
  ASSERT_EQ(recordings.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(recordings[i].session, campaign.recordings[i].session);
    EXPECT_EQ(recordings[i].specimen, "cable");
    EXPECT_EQ(recordings[i].channels, campaign.recordings[i].channels);
  }
  const Campaign read = read_campaign(folder / "new/campaign");
  EXPECT_EQ(read.name, "da Vinci cable transmission");
  EXPECT_TRUE(read.specimens.empty());
  ASSERT_TRUE(read.nominal.drive);
  EXPECT_EQ(read.nominal.drive->spool_radius_mm, 5);
}

TEST(WriteCampaign, LeavesAFolderWithFilesAlone) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "mine.txt", "mine");
  EXPECT_THROW(write_campaign(imported(measurements()), folder / ""), OutputError);
  EXPECT_THROW(write_campaign(imported(measurements()), folder / "mine.txt"), OutputError);
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(ImportDavinci, ReadsTheMeasurements) {
  const std::filesystem::path file = std::filesystem::path(TENDONLIFE_SHARED) /
                                     "data/davinci_cable_torque/Tool_4_Maryland_L_4.csv";
  if (!std::filesystem::exists(file)) {
    GTEST_SKIP() << "no " << file << ": the measurements are not part of the project";
  }
  const RecordedCampaign campaign = import_davinci(open_source(file, "a file"), file.string(), {});
  EXPECT_EQ(campaign.recordings.size(), 50U);  // 5 frequencies, 10 loads
  std::size_t samples = 0;
  for (const Recording& recording : campaign.recordings) {
    samples += recording.samples();
    EXPECT_LT(*std::max_element(recording[kOutputTensionColumn].begin(),
                                recording[kOutputTensionColumn].end()),
              30);
    EXPECT_GT(*std::min_element(recording[kOutputTensionColumn].begin(),
                                recording[kOutputTensionColumn].end()),
              0);
  }
  EXPECT_EQ(samples, 99498U);
}

}  // namespace
}  // namespace host_sim::recording
