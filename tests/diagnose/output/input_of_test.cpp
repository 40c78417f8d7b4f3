#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "host_sim/diagnose/output/extended_model.hpp"

namespace host_sim::diagnose {
namespace {

namespace fs = std::filesystem;

/// A campaign folder with one recording.
class InputOf : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "input_of_XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    campaign_.folder = name;
  }
  void TearDown() override { fs::remove_all(campaign_.folder); }

  void record(const std::string& input) const {
    std::ofstream(campaign_.folder / "sessions.csv")
        << "session,specimen,file,start_cycle\ns1,a,s1.csv,0\n";
    std::ofstream file(campaign_.folder / "s1.csv");
    file << "time_s," << input << ",output_tension_N,tendon_velocity_m_s\n";
    for (int i = 0; i < 20; ++i) {
      file << 0.01 * i << ",1,1,0.1\n";
    }
  }

  Campaign campaign_;
};

TEST_F(InputOf, AMotorCurrentIsNoLoadCell) {
  record("motor_current_A");
  EXPECT_EQ(input_of(campaign_), InputFrom::current);
}

TEST_F(InputOf, ALoadCellIs) {
  record("input_tension_N");
  EXPECT_EQ(input_of(campaign_), InputFrom::load_cell);
}

TEST_F(InputOf, LivesAloneHaveNoCurrent) {
  EXPECT_EQ(input_of(campaign_), InputFrom::load_cell);
}

}  // namespace
}  // namespace host_sim::diagnose
