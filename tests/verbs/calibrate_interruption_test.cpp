#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <thread>
#include <vector>

#include "tests/verbs/campaign_program.hpp"

namespace {

using host_sim_test::CampaignProgram;
using host_sim_test::contents;
namespace fs = std::filesystem;

class InterruptedCalibration : public CampaignProgram {
 protected:
  /// Starts host_sim in the folder, asks it to stop when it is at work, and gives its status.
  int interrupted(std::vector<const char*> arguments) {
    arguments.insert(arguments.begin(), HOST_SIM);
    arguments.push_back(nullptr);
    const pid_t process = ::fork();
    if (process == 0) {
      const int error = ::open((folder_ / "err.txt").c_str(), O_WRONLY | O_CREAT, 0666);
      if (::chdir(folder_.c_str()) == 0 && ::dup2(error, STDERR_FILENO) >= 0) {
        ::execv(HOST_SIM, const_cast<char* const*>(arguments.data()));
      }
      ::_exit(99);
    }
    wait_for_partial();
    ::kill(process, SIGINT);
    int status = 0;
    ::waitpid(process, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  void wait_for_partial() const {
    for (int i = 0; i < 1000; ++i) {
      for (const std::string& name : files()) {
        if (name.find(".partial-") != std::string::npos) {
          return;
        }
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    FAIL() << "host_sim did not start to work";
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
