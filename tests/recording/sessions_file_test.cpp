#include "host_sim/recording/sessions_file.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/io/support.hpp"

namespace host_sim::recording {
namespace {

constexpr std::string_view kHeader = "session,specimen,file,start_cycle\n";

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

struct Refusal {
  const char* name;
  const char* rows;  ///< after the header
  const char* complaint;
};

class BadSessions : public testing::TestWithParam<Refusal> {};

TEST_P(BadSessions, AreRefusedWithPlaceFoundAndAccepted) {
  const std::string text = std::string(kHeader) + GetParam().rows;
  EXPECT_EQ(test::complaint_of([&] { sessions_in(text); }),
            std::string("s.csv:") + GetParam().complaint);
}

INSTANTIATE_TEST_SUITE_P(
    Row, BadSessions,
    testing::Values(
        Refusal{"Twice", "a,x,a.csv,0\nb,x,b.csv,0\na,x,c.csv,0\n",
                "4:1: session 'a' a second time, first in line 2; accepted: one row for each "
                "session"},
        Refusal{"NoName", ",x,a.csv,0\n", "2:1: session is empty; accepted: the name of a session"},
        Refusal{"NoSpecimen", "a,,a.csv,0\n",
                "2:3: specimen is empty; accepted: the name of a specimen"},
        Refusal{"NoFile", "a,x,,0\n",
                "2:5: file is empty; accepted: the path of a recording in the campaign folder"},
        Refusal{"Above", "a,x,../a.csv,0\n",
                "2:5: file '../a.csv' leaves the campaign folder; accepted: a path within the "
                "campaign folder"},
        Refusal{"AboveWithin", "a,x,r/../../a.csv,0\n",
                "2:5: file 'r/../../a.csv' leaves the campaign folder; accepted: a path within "
                "the campaign folder"},
        Refusal{"Absolute", "a,x,/tmp/a.csv,0\n",
                "2:5: file '/tmp/a.csv' leaves the campaign folder; accepted: a path within the "
                "campaign folder"},
        Refusal{"Negative", "a,x,a.csv,-1\n",
                "2:11: start_cycle is '-1', out of range; accepted: 0..1e+18"},
        Refusal{"NotFinite", "a,x,a.csv,nan\n",
                "2:11: start_cycle is 'nan', not a finite number; accepted: a finite decimal "
                "number without spaces"},
        Refusal{"Empty", "a,x,a.csv,\n",
                "2:11: start_cycle is empty; accepted: a finite decimal number without spaces"},
        Refusal{"Short", "a,x,a.csv\n",
                "2:10: 3 fields only; accepted: 4 fields, as in the header"},
        Refusal{"NoRows", "", " no rows; accepted: at least one row after the header"}),
    [](const auto& refusal) { return std::string(refusal.param.name); });

TEST(SessionsFile, RefusesColumnsThatAreMissingOrUnknown) {
  EXPECT_EQ(test::complaint_of([] { sessions_in("session,specimen,file\na,x,a.csv\n"); }),
            "s.csv:1:22: no column start_cycle; accepted: session, specimen, file, start_cycle");
  EXPECT_EQ(test::complaint_of([] { sessions_in("session,specimen,file,start\na,x,a.csv,0\n"); }),
            "s.csv:1:23: unknown column 'start'; accepted: session, specimen, file, start_cycle");
  EXPECT_EQ(test::complaint_of([] { sessions_in(""); }),
            "s.csv: the file is empty; accepted: a CSV file with session, specimen, file, "
            "start_cycle");
}

TEST(SessionsFile, AcceptsAWayThroughAFolderAndBack) {
  EXPECT_EQ(sessions_in(std::string(kHeader) + "a,x,r/../a..csv,0\n").at(0).file, "r/../a..csv");
}

}  // namespace
}  // namespace host_sim::recording
