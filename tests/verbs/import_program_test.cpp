#include <gtest/gtest.h>

#include "tests/verbs/campaign_program.hpp"

namespace {

using host_sim_test::contents;

/// With the log of a joint whose tensions change sign.
class ImportProgram : public host_sim_test::Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    std::string log = "t,motor,joint,position\n";
    for (int i = 0; i < 40; ++i) {
      log += std::to_string(0.01 * i) + "," + std::to_string(i - 20) + "," +
             std::to_string(i - 15) + "," + std::to_string(0.001 * i * i) + "\n";
    }
    write("joint.csv", log);
  }

  int import_to(const std::string& folder, const std::string& more) {
    return run("import columns --out " + folder +
               " --column t=time_s --column motor=input_tension_N --column joint=output_tension_N "
               "--column \"rate(position)=tendon_velocity_m_s\" joint.csv" +
               more);
  }
};

TEST_F(ImportProgram, WritesThatADriveWorksInBothDirections) {
  ASSERT_EQ(import_to("pulled", ""), 0) << err_;
  ASSERT_EQ(import_to("both", " --two-sided"), 0) << err_;
  const std::string both = contents(folder_ / "both/campaign.toml");
  EXPECT_NE(both.find("name = \"both\"\ntwo_sided = true\n"), std::string::npos) << both;
  EXPECT_EQ(contents(folder_ / "pulled/campaign.toml").find("two_sided"), std::string::npos);
  EXPECT_EQ(contents(folder_ / "pulled/joint.csv"), contents(folder_ / "both/joint.csv"));
}

TEST_F(ImportProgram, SaysWhatAModelThatIsWrittenNeedsBesides) {
  ASSERT_EQ(import_to("pulled", ""), 0) << err_;
  EXPECT_NE(contents(folder_ / "pulled/campaign.toml").find("add [model.cable], [model.counting]"),
            std::string::npos);
}

}  // namespace
