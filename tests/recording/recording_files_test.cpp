#include "host_sim/recording/recording_files.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "host_sim/recording/recording.hpp"
#include "tests/io/support.hpp"
#include "tests/recording/support.hpp"

namespace host_sim::recording {

using enum hal::files::ProfileColumnId;
using hal::files::memory_source;

namespace {

constexpr std::string_view kSessionsHeader = "session,specimen,file,start_cycle\n";

std::vector<SessionRow> sessions_in(std::string_view text) {
  return parse_sessions(memory_source(text), "s.csv");
}

TEST(SessionsFile, IsReadRowByRow) {
  const auto rows = sessions_in(
      "# two\nfile,session,start_cycle,specimen\r\nr/b.csv,b,1.5e3,x\r\n\"a,1.csv\",a,0,\"y "
      "\"\"1\"\"\"\r\n");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].session, "b");
  EXPECT_EQ(rows[0].specimen, "x");
  EXPECT_EQ(rows[0].file, "r/b.csv");
  EXPECT_EQ(rows[0].start_cycle, 1500);
  EXPECT_EQ(rows[0].file_place.line, 3U);
  EXPECT_EQ(rows[1].file, "a,1.csv");
  EXPECT_EQ(rows[1].specimen, "y \"1\"");
  EXPECT_EQ(rows[1].start_cycle, 0);
}

struct BadSession {
  const char* name;
  const char* rows;  ///< after the header
  const char* complaint;
};

class BadSessions : public testing::TestWithParam<BadSession> {};

TEST_P(BadSessions, AreRefusedWithPlaceFoundAndAccepted) {
  const std::string text = std::string(kSessionsHeader) + GetParam().rows;
  EXPECT_EQ(test::complaint_of([&] { sessions_in(text); }),
            std::string("s.csv:") + GetParam().complaint);
}

INSTANTIATE_TEST_SUITE_P(
    Row, BadSessions,
    testing::Values(
        BadSession{"Twice", "a,x,a.csv,0\nb,x,b.csv,0\na,x,c.csv,0\n",
                   "4:1: session 'a' a second time, first in line 2; accepted: one row for each "
                   "session"},
        BadSession{"NoName", ",x,a.csv,0\n",
                   "2:1: session is empty; accepted: the name of a session"},
        BadSession{"NoSpecimen", "a,,a.csv,0\n",
                   "2:3: specimen is empty; accepted: the name of a specimen"},
        BadSession{"NoFile", "a,x,,0\n",
                   "2:5: file is empty; accepted: the path of a recording in the campaign folder"},
        BadSession{"Above", "a,x,../a.csv,0\n",
                   "2:5: file '../a.csv' leaves the campaign folder; accepted: a path within the "
                   "campaign folder"},
        BadSession{"AboveWithin", "a,x,r/../../a.csv,0\n",
                   "2:5: file 'r/../../a.csv' leaves the campaign folder; accepted: a path within "
                   "the campaign folder"},
        BadSession{"Absolute", "a,x,/tmp/a.csv,0\n",
                   "2:5: file '/tmp/a.csv' leaves the campaign folder; accepted: a path within the "
                   "campaign folder"},
        BadSession{"Negative", "a,x,a.csv,-1\n",
                   "2:11: start_cycle is '-1', out of range; accepted: 0..1e+18"},
        BadSession{"NotFinite", "a,x,a.csv,nan\n",
                   "2:11: start_cycle is 'nan', not a finite number; accepted: a finite decimal "
                   "number without spaces"},
        BadSession{"Empty", "a,x,a.csv,\n",
                   "2:11: start_cycle is empty; accepted: a finite decimal number without spaces"},
        BadSession{"Short", "a,x,a.csv\n",
                   "2:10: 3 fields only; accepted: 4 fields, as in the header"},
        BadSession{"NoRows", "", " no rows; accepted: at least one row after the header"}),
    [](const auto& refusal) { return std::string(refusal.param.name); });

TEST(SessionsFile, RefusesColumnsThatAreMissingOrUnknown) {
  EXPECT_EQ(test::complaint_of([] { sessions_in("session,specimen,file\na,x,a.csv\n"); }),
            "s.csv:1:22: no column start_cycle; accepted: session, specimen, file, start_cycle");
  EXPECT_EQ(test::complaint_of([] { sessions_in("session,specimen,file,start\na,x,a.csv,0\n"); }),
            "s.csv:1:23: unknown column 'start', nearest to start_cycle; accepted: session, "
            "specimen, file, start_cycle");
  EXPECT_EQ(test::complaint_of([] { sessions_in(""); }),
            "s.csv: the file is empty; accepted: a CSV file with session, specimen, file, "
            "start_cycle");
}

TEST(SessionsFile, AcceptsAWayThroughAFolderAndBack) {
  EXPECT_EQ(sessions_in(std::string(kSessionsHeader) + "a,x,r/../a..csv,0\n").at(0).file,
            "r/../a..csv");
}

std::string complaint_about(std::string_view text) {
  return test::complaint_of([&] { parse_recording(memory_source(text), "r.csv"); });
}

TEST(RecordingFile, GivesAllChannelsInTheirOwnPlaces) {
  std::string text =
      "# all\nwinding_temperature_C,tendon_velocity_m_s,motor_current_A,time_s,output_tension_N,"
      "input_tension_N,bend_angle_deg,motor_angle_rad,sheath_temperature_C\r\n";
  for (int i = 0; i < 16; ++i) {
    text += "41,-0.5,1.25," + std::to_string(i) + ",20.5,40,270,3," + std::to_string(20 + i) +
            "\r\n# a comment\r\n";
  }
  const Channels channels = parse_recording(memory_source(text), "r.csv").channels;
  const std::array<double, kProfileColumnCount> last{15, 40, 1.25, 20.5, -0.5, 270, 3, 35, 41};
  for (std::size_t id = 0; id < kProfileColumnCount; ++id) {
    ASSERT_EQ(channels[id].size(), 16U) << id;
    EXPECT_EQ(channels[id].back(), last[id]) << id;
  }
  EXPECT_EQ(channels[kTime].front(), 0);
  EXPECT_EQ(channels[kSheathTemperature][3], 23);
}

TEST(RecordingFile, LeavesChannelsEmptyThatItLacks) {
  const Channels channels =
      parse_recording(memory_source(test::recording_text()), "r.csv").channels;
  EXPECT_EQ(channels[kInputTensionColumn].size(), 16U);
  EXPECT_TRUE(channels[kMotorCurrentColumn].empty());
  EXPECT_TRUE(channels[kSheathTemperature].empty());
}

constexpr std::string_view kAccepted =
    "; accepted: time_s, output_tension_N, tendon_velocity_m_s, and input_tension_N or "
    "motor_current_A or both";

TEST(RecordingFile, RefusesAFileWithoutAnInputAnOutputOrAVelocity) {
  EXPECT_EQ(complaint_about("time_s,output_tension_N,tendon_velocity_m_s\n"),
            "r.csv:1:44: no column input_tension_N or motor_current_A" + std::string(kAccepted));
  EXPECT_EQ(complaint_about("time_s,motor_current_A,tendon_velocity_m_s\n"),
            "r.csv:1:43: no column output_tension_N" + std::string(kAccepted));
  EXPECT_EQ(complaint_about("time_s,motor_current_A,output_tension_N\n"),
            "r.csv:1:40: no column tendon_velocity_m_s" + std::string(kAccepted));
  EXPECT_EQ(complaint_about("motor_current_A,output_tension_N,tendon_velocity_m_s\n"),
            "r.csv:1:53: no column time_s" + std::string(kAccepted));
}

TEST(RecordingFile, RefusesColumnsThatItDoesNotKnow) {
  EXPECT_EQ(complaint_about("time_s,input_tension_kN\n"),
            "r.csv:1:8: other unit 'kN' of column 'input_tension_kN'; accepted: "
            "input_tension_N");
  EXPECT_EQ(complaint_about("time_ms\n"),
            "r.csv:1:1: other unit 'ms' of column 'time_ms'; accepted: time_s");
  EXPECT_EQ(complaint_about("time_s,sag_m\n").rfind("r.csv:1:8: unknown column 'sag_m'", 0), 0U);
}

TEST(RecordingFile, RefusesAFileThatIsEmptyOrTooShort) {
  EXPECT_EQ(complaint_about(""), "r.csv: the file is empty; accepted: a CSV file with " +
                                     std::string(kAccepted.substr(12)));
  EXPECT_EQ(complaint_about(test::kRecordingHeader),
            "r.csv: no rows; accepted: at least one row after the header");
  EXPECT_EQ(complaint_about(test::recording_text(15)),
            "r.csv:17: the file ends after 15 samples; accepted: at least 16 samples");
  EXPECT_EQ(complaint_about(test::recording_text(16)), "");
}

TEST(RecordingFile, RefusesRowsThatCannotBeTrusted) {
  const auto with = [](const char* row) { return complaint_about(test::recording_text() + row); };
  EXPECT_EQ(with("0.001,40,20,0.1\n"),
            "r.csv:18:1: time runs back from 0.075 s to 0.001 s; accepted: time that increases "
            "from row to row");
  EXPECT_EQ(with("1,nan,20,0.1\n"),
            "r.csv:18:3: input_tension_N is 'nan', not a finite number; accepted: a finite "
            "decimal number without spaces");
  EXPECT_EQ(with("1,40,20\n"), "r.csv:18:8: 3 fields only; accepted: 4 fields, as in the header");
  EXPECT_EQ(with("1,40,2e7,0.1\n"),
            "r.csv:18:6: output_tension_N is '2e7', out of range; accepted: -1000000..1000000 N");
}

namespace fs = std::filesystem;

class RecordingFolder : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "c/r");
    for (const char* const file : {"c/a.csv", "c/r/b.csv", "outside.csv"}) {
      test::write_text(folder_ / file, test::recording_text(file[2] == 'a' ? 16 : 20));
    }
  }

  void sessions(std::string_view rows) const {
    test::write_text(folder_ / "c/sessions.csv",
                     "session,specimen,file,start_cycle\n" + std::string(rows));
  }

  std::vector<Recording> read() const { return read_recordings(folder_ / "c"); }

  /// Behind the path of the folder.
  std::string complaint() const {
    const std::string words = test::complaint_of([&] { read(); });
    const std::string folder = (folder_ / "c/").string();
    EXPECT_EQ(words.rfind(folder, 0), words.empty() ? std::string::npos : 0U) << words;
    return words.empty() ? words : words.substr(folder.size());
  }

  test::TemporaryFolder folder_;
};

TEST_F(RecordingFolder, WithoutSessionsHasNone) {
  EXPECT_TRUE(read().empty());
}

TEST_F(RecordingFolder, GivesRecordingsInOrderOfTheirSessions) {
  sessions("s2,x,r/b.csv,100\ns1,y,./a.csv,0\n");
  const auto recordings = read();
  ASSERT_EQ(recordings.size(), 2U);
  EXPECT_EQ(recordings[0].session, "s1");
  EXPECT_EQ(recordings[0].specimen, "y");
  EXPECT_EQ(recordings[0].line, 3U);
  EXPECT_EQ(recordings[0].samples(), 16U);
  EXPECT_EQ(recordings[1].session, "s2");
  EXPECT_EQ(recordings[1].file, folder_ / "c/r/b.csv");
  EXPECT_EQ(recordings[1].start_cycle, 100);
  EXPECT_EQ(recordings[1].samples(), 20U);
  EXPECT_EQ(recordings[1][kInputTensionColumn].back(), 59);
  EXPECT_FALSE(recordings[1].has(kMotorCurrentColumn));
}

TEST_F(RecordingFolder, IsReadFromWithin) {
  sessions("s1,y,a.csv,0\n");
  const fs::path before = fs::current_path();
  fs::current_path(folder_ / "c");
  EXPECT_EQ(read_recordings("").size(), 1U);
  EXPECT_EQ(read_recordings(".").size(), 1U);
  fs::current_path(before);
}

TEST_F(RecordingFolder, IsRefusedForAFileThatIsNotThere) {
  sessions("s1,y,a.csv,0\ns2,y,none.csv,0\n");
  EXPECT_EQ(complaint(),
            "sessions.csv:3:6: file 'none.csv' cannot be opened: No such file or directory; "
            "accepted: the path of a recording");
  sessions("s1,y,r,0\n");
  EXPECT_EQ(complaint(),
            "sessions.csv:2:6: file 'r' is not a file; accepted: the path of a recording");
}

TEST_F(RecordingFolder, IsRefusedForAFileOutside) {
  sessions("s1,y,../outside.csv,0\n");
  EXPECT_EQ(complaint().rfind("sessions.csv:2:6: file '../outside.csv' leaves the campaign", 0),
            0U);
  fs::create_symlink(folder_ / "outside.csv", folder_ / "c/link.csv");
  sessions("s1,y,link.csv,0\n");
  EXPECT_EQ(complaint(),
            "sessions.csv:2:6: file 'link.csv' leaves the campaign folder through a link; "
            "accepted: a file within the campaign folder");
  fs::create_symlink(folder_ / "c/a.csv", folder_ / "c/within.csv");
  sessions("s1,y,within.csv,0\n");
  EXPECT_EQ(complaint(), "");
}

TEST_F(RecordingFolder, IsRefusedForOneRecordingInTwoSessions) {
  sessions("s1,y,a.csv,0\ns2,y,r/../a.csv,0\n");
  EXPECT_EQ(complaint(),
            "sessions.csv:3:6: file 'r/../a.csv' a second time, first in line 2; accepted: one "
            "recording for each session");
}

TEST_F(RecordingFolder, IsRefusedForARecordingThatCannotBeTrusted) {
  test::write_text(folder_ / "c/a.csv", test::recording_text() + "1,2\n");
  sessions("s1,y,a.csv,0\n");
  EXPECT_EQ(complaint(), "a.csv:18:4: 2 fields only; accepted: 4 fields, as in the header");
}

TEST_F(RecordingFolder, NamesSpecimensOfTheListWhereThereIsOne) {
  test::write_text(folder_ / "c/specimens.csv",
                   "specimen,lot,cycles,status,input_tension_mean_N,input_tension_amplitude_N\n"
                   "y,1,10,failed,25,25\n");
  sessions("s1,y,a.csv,0\n");
  EXPECT_EQ(complaint(), "");
  sessions("s1,y,a.csv,0\ns2,z,r/b.csv,0\n");
  EXPECT_EQ(complaint(),
            "sessions.csv:3:4: a session of 'z', which is no specimen; accepted: specimens of "
            "specimens.csv");
}

}  // namespace

}  // namespace host_sim::recording
