#include "host_sim/monitor/record/log_folder.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <iterator>

#include "host_sim/io/output_file.hpp"
#include "host_sim/monitor/record/log_line.hpp"
#include "host_sim/monitor/record/recorder.hpp"

namespace host_sim::monitor {
namespace {

class LogFolderTest : public testing::Test {
 protected:
  LogFolderTest() { std::filesystem::remove_all(folder_); }
  ~LogFolderTest() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string text_of(int number) const {
    std::ifstream file(path_of(number), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  [[nodiscard]] std::filesystem::path path_of(int number) const {
    return folder_ / ("frames-0000000" + std::to_string(number) + ".log");
  }
  [[nodiscard]] std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(folder_), {}));
  }

  const std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("log_folder_test." + std::to_string(::getpid()));
};

TEST_F(LogFolderTest, GoesOnWithTheLastLog) {
  LogFolder(folder_ / "", {}).add("one\n");
  LogFolder again(folder_, {});
  EXPECT_EQ(again.repaired(), "");
  again.add("two\n");
  EXPECT_EQ(text_of(1), "one\ntwo\n");
  EXPECT_EQ(files(), 1u);
}

TEST_F(LogFolderTest, CutsATornLastLineAndTells) {
  LogFolder(folder_, {}).add("whole\n");
  std::ofstream(path_of(1), std::ios::app) << "(16000000";
  LogFolder again(folder_, {});
  EXPECT_EQ(again.repaired(), path_of(1).string() + ": a torn last line of 9 bytes was cut off");
  again.add("next\n");
  EXPECT_EQ(text_of(1), "whole\nnext\n");
}

TEST_F(LogFolderTest, CutsALineThatIsTheWholeLog) {
  std::filesystem::create_directories(folder_);
  std::ofstream(path_of(1)) << std::string(10'000, 'x');
  LogFolder again(folder_, {});
  again.add("next\n");
  EXPECT_EQ(text_of(1), "next\n");
}

// Logs of 12 bytes hold two lines of 6.
TEST_F(LogFolderTest, BeginsTheNextLogAtALineAndRemovesTheOldest) {
  LogFolder logs(folder_, {.bytes = 12, .keep = 2});
  logs.add("11111\n22222\n33333\n");
  logs.add("44444\n");
  logs.add("55555\n");
  EXPECT_FALSE(std::filesystem::exists(path_of(1)));
  EXPECT_EQ(text_of(2), "33333\n44444\n");
  EXPECT_EQ(text_of(3), "55555\n");
  EXPECT_EQ(files(), 2u);
  EXPECT_EQ(logs.current(), path_of(3));
}

TEST_F(LogFolderTest, ALineThatIsLargerThanALogHasOneOfItsOwn) {
  LogFolder logs(folder_, {.bytes = 4, .keep = 9});
  logs.add("123456\n123456\nab\n");
  EXPECT_EQ(text_of(1), "123456\n");
  EXPECT_EQ(text_of(2), "123456\n");
  EXPECT_EQ(text_of(3), "ab\n");
}

TEST_F(LogFolderTest, OneProcessAtATime) {
  const LogFolder logs(folder_, {});
  EXPECT_THROW(LogFolder(folder_, {}), OutputError);
}

TEST_F(LogFolderTest, SaysWhereItCannotWrite) {
  EXPECT_THROW(LogFolder("/proc/no", {}), OutputError);
}

TEST_F(LogFolderTest, TheRecorderWritesWhatItSaw) {
  SeenFrame seen;
  seen.time_ns = 1'600'000'000'000'001'999;
  seen.frame = {.id = 0x185, .length = 2};
  seen.frame.data[1] = std::byte{0xab};
  {
    Recorder recorder(folder_, {}, "can0");
    recorder.see(seen);
    recorder.sync();
    EXPECT_EQ(text_of(1), "(1600000000.000001) can0 185#00AB\n");
    recorder.see(seen);
    EXPECT_EQ(recorder.trouble(), "");
  }
  EXPECT_EQ(text_of(1).size(), 2 * std::string("(1600000000.000001) can0 185#00AB\n").size());
}

TEST_F(LogFolderTest, WhatWasSeenCanBeReadAtOnce) {
  Recorder recorder(folder_, {}, "can0");
  std::string wanted;
  for (int i = 0; i < 5; ++i) {
    recorder.see({});
    wanted += log_line({}, "can0");
    recorder.flush();
    EXPECT_EQ(text_of(1), wanted);
  }
  EXPECT_EQ(recorder.trouble(), "");
}

// A full disk: /dev/full takes no byte.
TEST_F(LogFolderTest, CountsWhatADiskDidNotTake) {
  std::filesystem::create_directories(folder_);
  std::filesystem::create_symlink("/dev/full", path_of(1));
  Recorder recorder(folder_, {}, "can0");
  recorder.see({});
  recorder.sync();
  EXPECT_NE(recorder.trouble().find("No space left on device"), std::string::npos);
  EXPECT_NE(recorder.trouble().find("1 frames were not recorded"), std::string::npos);
}

TEST(LogLine, HasAllKindsOfFrames) {
  SeenFrame remote;
  remote.frame = {.id = 0x18daf105, .extended = true, .length = 8};
  remote.remote_request = true;
  EXPECT_EQ(log_line(remote, "can0"), "(0000000000.000000) can0 18DAF105#R8\n");
  SeenFrame flexible;
  flexible.frame.id = 0x7f;
  flexible.flexible_data_rate = true;
  flexible.fd_flags = 3;
  flexible.fd_data = {std::byte{1}, std::byte{0xfe}};
  EXPECT_EQ(log_line(flexible, "can0"), "(0000000000.000000) can0 07F##301FE\n");
  SeenFrame error;
  error.frame = {.id = 0x40, .length = 8};
  error.error.emplace();
  EXPECT_EQ(log_line(error, "can0"), "(0000000000.000000) can0 20000040#0000000000000000\n");
}

}  // namespace
}  // namespace host_sim::monitor
