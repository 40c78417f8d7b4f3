#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "host_sim/recording/recording.hpp"
#include "tests/recording/support.hpp"

namespace host_sim::recording {
namespace {

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
