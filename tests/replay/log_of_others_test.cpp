#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/replay/program.hpp"

namespace {

using host_sim_test::contents;
using host_sim_test::Program;

/// good.csv as other programs write it.
class LogOfOthers : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    ASSERT_EQ(run("replay good.csv --model model.toml --json good.json"), 0) << err_;
    good_ = contents(folder_ / "good.json");
  }

  void expect_good(const std::string& arguments) {
    ASSERT_EQ(run("replay " + arguments + " --model model.toml --json other.json"), 0) << err_;
    EXPECT_EQ(contents(folder_ / "other.json"), good_) << arguments;
  }

  std::string good_;
};

TEST_F(LogOfOthers, IsReplayedByNamesUnitsAndWhatIsPassedOver) {
  write("log.csv",
        "Unnamed: 0;t;Force [kN];note\n0;0;0.01;a\n1;5;0.06;\"b;c\"\n2;10;0.01;\n"
        "3;15;0.06;d\n");
  expect_good(
      "log.csv --ignore-extra --column 't in ms=time_s' "
      "--column '\"Force [kN]\" in kN=input_tension_N'");
  write("blanks.csv", "time_s, force\n0,  10\n0.005,60\n0.01, 10\n0.015, 60\n");
  expect_good("blanks.csv --column force=input_tension_N");
}

TEST_F(LogOfOthers, WhatIsPassedOverAndNearlyOneOfOursIsAWarning) {
  write("log.csv",
        "time_s,input_tension_N,tendon_velocity_mm_s,motor_angel_rad,input_force_N,note\n"
        "0,10,0,0,10,1\n0.005,60,0,0,60,2\n0.01,10,0,0,10,3\n0.015,60,0,0,60,4\n");
  ASSERT_EQ(run("replay log.csv --model model.toml --ignore-extra --json other.json"), 0) << err_;
  EXPECT_NE(
      contents(folder_ / "other.json")
          .find("\"column 'tendon_velocity_mm_s' is passed over, which is nearly "
                "tendon_velocity_m_s; --column 'tendon_velocity_mm_s in "
                "mm/s=tendon_velocity_m_s' takes it\",\n    \"column 'motor_angel_rad' is passed "
                "over, which is nearly motor_angle_rad; --column motor_angel_rad=motor_angle_rad "
                "takes it\"\n"),
      std::string::npos)
      << contents(folder_ / "other.json");
}

TEST_F(LogOfOthers, IsReadAsGzipHasCompressedIt) {
  ASSERT_EQ(std::system(("gzip -k '" + (folder_ / "good.csv").string() + "'").c_str()), 0);
  expect_good("good.csv.gz");
  std::filesystem::rename(folder_ / "good.csv.gz", folder_ / "good.anything");
  expect_good("good.anything");
  ASSERT_EQ(run("replay . --model model.toml --table -"), 0) << err_;
  EXPECT_NE(err_.find("1 profiles replayed, 0 refused"), std::string::npos) << err_;
}

TEST_F(LogOfOthers, IsRefusedWithTheOptionsThatWouldMakeItWork) {
  write("log.csv", "time_s,force\n0,10\n1,60\n");
  EXPECT_EQ(run("replay log.csv --model model.toml --json other.json"), 1);
  EXPECT_NE(err_.find("log.csv:1:8: unknown column 'force'; accepted: time_s, "),
            std::string::npos);
  EXPECT_NE(err_.find("; --column force=COLUMN, or --ignore-extra to pass it over\n"),
            std::string::npos)
      << err_;
  EXPECT_EQ(run("replay log.csv --model model.toml --column force=input_tension"), 2);
  EXPECT_NE(err_.find("unknown channel 'input_tension'; accepted: input_tension_N\n"),
            std::string::npos);
  EXPECT_EQ(run("replay log.csv --model model.toml --column 'rate(force)=input_tension_N'"), 2);
  EXPECT_NE(err_.find("rate() is for host_sim import columns"), std::string::npos);
  for (const char* second : {"t=input_tension_N", "force=output_tension_N"}) {
    EXPECT_EQ(run("replay log.csv --model model.toml --column force=input_tension_N --column " +
                  std::string(second)),
              2);
    EXPECT_NE(err_.find("a second time; accepted: each channel and each column once"),
              std::string::npos);
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "other.json"));
}

}  // namespace
