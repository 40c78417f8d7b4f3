#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/replay/interrupted.hpp"
#include "tests/verbs/campaign_program.hpp"

namespace {

using host_sim_test::CampaignProgram;
using host_sim_test::contents;
namespace fs = std::filesystem;

class InterruptedCalibration : public CampaignProgram {
 protected:
  [[nodiscard]] int interrupted(std::vector<const char*> arguments) const {
    return host_sim_test::status_of_interrupted(folder_, std::move(arguments));
  }
};

TEST_F(InterruptedCalibration, LeavesNothingBehind) {
  const auto before = files();
  EXPECT_EQ(interrupted({"calibrate", "c", "--bootstraps", "20000", "--json", "r.json"}), 130);
  EXPECT_EQ(contents(folder_ / "err.txt"), "host_sim: interrupted; no output was written\n");
  fs::remove(folder_ / "err.txt");
  EXPECT_EQ(files(), before);
}

TEST_F(InterruptedCalibration, OfABatchLeavesNothingBehind) {
  for (int i = 0; i < 100; ++i) {
    write_campaign("all/" + std::to_string(i), specimens());
  }
  const auto before = files();
  EXPECT_EQ(
      interrupted({"calibrate", "all", "--batch", "--bootstraps", "2000", "--table", "t.csv"}),
      130);
  EXPECT_EQ(contents(folder_ / "err.txt"), "host_sim: interrupted; no output was written\n");
  fs::remove(folder_ / "err.txt");
  EXPECT_EQ(files(), before);
}

}  // namespace
