#include <map>

#include "hal/files/output_file.hpp"
#include "host_sim/campaign/campaign_files.hpp"
#include "host_sim/synth/campaign/folder.hpp"
#include "host_sim/synth/campaign/make.hpp"
#include "tests/synth/support.hpp"

namespace host_sim::synth::test {

using hal::files::InputKind;
using enum hal::files::ProfileColumnId;
using hal::files::OutputError;

namespace {

namespace fs = std::filesystem;
using host_sim::test::TemporaryFolder;
using host_sim::test::text_of;
using host_sim::test::write_text;

const std::string kPlan =
    "[recordings]\nbend_angles_deg = [90, 270]\noutput_means_N = 30\noutput_amplitudes_N = 10\n"
    "frequencies_Hz = [0.5, 2]\ntravels_mm = 40\nsample_rate_Hz = 100\nduration_s = 1\n"
    "start_cycles = 1234.5\n[noise]\nlog_tension_sd = 0.01\nstudent_t_dof = 5\n"
    "[scatter]\nlog_gain_sd = 0.01\nfriction_sd = 0.006\n"
    "[effects.bend_angle]\nsd_deg = 10\n[outside.stick_slip]\nshare = 0.2\n"
    "bursts_per_min = 60\nburst_s = 0.2\nfrequency_Hz = 20\n"
    "[lives]\n[[lives.level]]\nbend_angle_deg = 90\noutput_tension_mean_N = 30\n"
    "output_tension_amplitude_N = 20\nspecimens = 5\n";

/// All files of a campaign by their names.
std::map<std::string, std::string> made(const MakeOptions& options) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "c");
  make_campaign(plan_of(kPlan), options, folder / "c");
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder / "c")) {
    if (entry.is_regular_file()) {
      files[fs::relative(entry.path(), folder / "c").string()] = text_of(entry.path());
    }
  }
  return files;
}

TEST(SynthCampaign, HasTheFilesOfACampaign) {
  const auto files = made({});
  std::vector<std::string> names;
  for (const auto& [name, text] : files) {
    names.push_back(name);
  }
  EXPECT_EQ(names,
            (std::vector<std::string>{"campaign.toml", "recordings/s001.csv", "recordings/s002.csv",
                                      "recordings/s003.csv", "recordings/s004.csv", "sessions.csv",
                                      "specimens.csv"}));
  EXPECT_EQ(files.at("sessions.csv"),
            "session,specimen,file,start_cycle\ns001,w0001,recordings/s001.csv,1234.5\n"
            "s002,w0001,recordings/s002.csv,1234.5\ns003,w0001,recordings/s003.csv,1234.5\n"
            "s004,w0001,recordings/s004.csv,1234.5\n");
}

TEST(SynthCampaign, RecordingsAreProfiles) {
  const auto files = made({});
  const auto rows = host_sim::test::rows_of(files.at("recordings/s002.csv"),
                                            {.input = InputKind::kOutputTension});
  ASSERT_EQ(rows.size(), 100U);
  EXPECT_EQ(rows[0].time_s, 0);
  EXPECT_EQ(rows[50].time_s, 0.5);
  EXPECT_NEAR(rows[0].value, 20, 2);
  EXPECT_EQ(rows[0].bend_angle_deg, 90);
}

TEST(SynthCampaign, TheFileHoldsWhatTheSensorsSay) {
  const Channels channels = session(kRecordings);
  const std::string text =
      recording_text({kTime, kInputTensionColumn, kOutputTensionColumn, kTendonVelocity}, channels);
  const auto in = host_sim::test::rows_of(text);
  ASSERT_EQ(in.size(), 800U);
  for (std::size_t i = 0; i < in.size(); ++i) {
    ASSERT_NEAR(in[i].value / channels[kInputTensionColumn][i], 1, 1e-9);
  }
}

TEST(SynthCampaign, IsTheSameForAnyNumberOfThreads) {
  const auto one = made({.seed = 3, .threads = 1});
  EXPECT_EQ(one, made({.seed = 3, .threads = 4}));
  EXPECT_NE(one, made({.seed = 4, .threads = 1}));
}

TEST(SynthCampaign, DoesNotTellWhatItHides) {
  for (const auto& [name, text] : made({})) {
    for (const char* const word : {"bend_angle\n", "stick", "slip", "effect", "outside", "seed",
                                   "truth", "scatter", "noise"}) {
      EXPECT_EQ(text.find(word), std::string::npos) << name << " holds " << word;
    }
  }
}

TEST(SynthCampaign, TheModelIsTheNominalOne) {
  const SynthPlan plan = plan_of(kPlan);
  const CampaignFile file = parse_campaign_file(campaign_text(plan), "campaign.toml");
  EXPECT_EQ(file.name, "small");
  EXPECT_EQ(file.nominal.sheath->friction_coefficient, 0.128);
  EXPECT_EQ(file.nominal.sheath->bend_angle_deg, 270);
  EXPECT_EQ(file.nominal.drive->gear_efficiency, 0.88);
  EXPECT_EQ(file.nominal.life->ipl_scale, 1.53e5);
  EXPECT_FALSE(file.nominal.counting);
}

TEST(SynthCampaign, NamesAreQuoted) {
  SynthPlan plan = plan_of(kPlan);
  plan.name = "a \"b\" \\ c";
  EXPECT_EQ(parse_campaign_file(campaign_text(plan), "c").name, plan.name);
}

TEST(SynthTruth, NamesWhatIsHiddenAndWhatWasDrawn) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "c");
  const SynthPlan plan = plan_of(kPlan);
  const Truth truth = make_campaign(plan, {.seed = 9}, folder / "c");
  const std::string text = truth_json(plan, 9, truth);
  for (const char* const part : {"\"bend_angle\"", "\"sd_deg\": 10.0", "\"stick_slip\"",
                                 "\"seed\": 9", "\"log_gain_sd\": 0.01", "\"bend_error_deg\""}) {
    EXPECT_NE(text.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(truth.bend_errors_deg.size(), 4U);
  EXPECT_EQ(truth.bend_errors_deg[0], truth.bend_errors_deg[1]) << "one pose, one error";
  EXPECT_NE(truth.bend_errors_deg[0], truth.bend_errors_deg[2]);
}

TEST(SynthTruth, Sha256IsThatOfTheStandard) {
  // FIPS 180-2, appendix B.1.
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(SynthFolder, AppearsWholeOrNotAtAll) {
  const TemporaryFolder folder;
  {
    const StagedFolder staged(folder / "c", false);
    write_text(staged.inside() / "campaign.toml", "x");
  }
  EXPECT_EQ(folder.file_count(), 0U);
  {
    StagedFolder staged(folder / "c/", false);
    write_text(staged.inside() / "campaign.toml", "x");
    EXPECT_FALSE(fs::exists(folder / "c"));
    staged.commit();
  }
  EXPECT_EQ(folder.file_count(), 1U);
  EXPECT_EQ(text_of(folder / "c/campaign.toml"), "x");
}

std::string refusal(const fs::path& path, bool replace) {
  try {
    StagedFolder staged(path, replace);
    staged.commit();
  } catch (const OutputError& error) {
    return error.reason();
  }
  return {};
}

TEST(SynthFolder, ReplacesACampaignOnlyWhereItMay) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "c");
  write_text(folder / "c/campaign.toml", "old");
  write_text(folder / "c/more.csv", "old");
  EXPECT_NE(refusal(folder / "c", false).find("--force"), std::string::npos);
  StagedFolder staged(folder / "c", true);
  write_text(staged.inside() / "campaign.toml", "new");
  staged.commit();
  EXPECT_EQ(text_of(folder / "c/campaign.toml"), "new");
  EXPECT_FALSE(fs::exists(folder / "c/more.csv"));
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(SynthFolder, NeverReplacesAnythingElse) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "letters");
  write_text(folder / "letters/dear.txt", "x");
  write_text(folder / "file", "x");
  EXPECT_NE(refusal(folder / "letters", true).find("no campaign"), std::string::npos);
  EXPECT_NE(refusal(folder / "file", true).find("no campaign"), std::string::npos);
  EXPECT_NE(refusal(folder / "nowhere/c", true), "");
  EXPECT_EQ(text_of(folder / "letters/dear.txt"), "x");
  EXPECT_EQ(folder.file_count(), 2U);
}

}  // namespace
}  // namespace host_sim::synth::test
