#include "host_sim/monitor/record/log_folder.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <optional>

#include "hal/files/output_file.hpp"
#include "host_sim/monitor/bus/frame_log.hpp"
#include "host_sim/monitor/record/recorder.hpp"

namespace host_sim::monitor {

using hal::files::OutputError;

namespace {

void add(LogFolder& logs, std::string_view lines) {
  logs.add(lines);
  EXPECT_EQ(lines, "");
}
void add(LogFolder&& logs, std::string_view lines) {
  add(logs, lines);
}

/// A limit of this process, while this lives.
class Limit {
 public:
  Limit(__rlimit_resource resource, rlim_t most) : resource_(resource) {
    EXPECT_EQ(::getrlimit(resource_, &before_), 0);
    const ::rlimit now{.rlim_cur = most, .rlim_max = before_.rlim_max};
    EXPECT_EQ(::setrlimit(resource_, &now), 0);
  }
  Limit(const Limit&) = delete;
  Limit& operator=(const Limit&) = delete;
  ~Limit() { ::setrlimit(resource_, &before_); }

 private:
  __rlimit_resource resource_;
  ::rlimit before_{};
};

/// No file can be opened.
Limit no_descriptor() {
  const int lowest = ::dup(0);
  ::close(lowest);
  return {RLIMIT_NOFILE, static_cast<rlim_t>(lowest)};
}

/// No file grows, as on a full disk.
Limit full_disk() {
  std::signal(SIGXFSZ, SIG_IGN);
  return {RLIMIT_FSIZE, 0};
}

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
  add(LogFolder(folder_ / "", {}), "one\n");
  LogFolder again(folder_, {});
  EXPECT_EQ(again.repaired(), "");
  add(again, "two\n");
  EXPECT_EQ(text_of(1), "one\ntwo\n");
  EXPECT_EQ(files(), 1u);
}

TEST_F(LogFolderTest, CutsATornLastLineAndTells) {
  add(LogFolder(folder_, {}), "whole\n");
  std::ofstream(path_of(1), std::ios::app) << "(16000000";
  LogFolder again(folder_, {});
  EXPECT_EQ(again.repaired(), path_of(1).string() + ": a torn last line of 9 bytes was cut off");
  add(again, "next\n");
  EXPECT_EQ(text_of(1), "whole\nnext\n");
}

TEST_F(LogFolderTest, CutsALineThatIsTheWholeLog) {
  std::filesystem::create_directories(folder_);
  std::ofstream(path_of(1)) << std::string(10'000, 'x');
  LogFolder again(folder_, {});
  add(again, "next\n");
  EXPECT_EQ(text_of(1), "next\n");
}

// Logs of 12 bytes hold two lines of 6.
TEST_F(LogFolderTest, BeginsTheNextLogAtALineAndRemovesTheOldest) {
  LogFolder logs(folder_, {.bytes = 12, .keep = 2});
  add(logs, "11111\n22222\n33333\n");
  add(logs, "44444\n");
  add(logs, "55555\n");
  EXPECT_FALSE(std::filesystem::exists(path_of(1)));
  EXPECT_EQ(text_of(2), "33333\n44444\n");
  EXPECT_EQ(text_of(3), "55555\n");
  EXPECT_EQ(files(), 2u);
  EXPECT_EQ(logs.current(), path_of(3));
}

TEST_F(LogFolderTest, ALineThatIsLargerThanALogHasOneOfItsOwn) {
  LogFolder logs(folder_, {.bytes = 4, .keep = 9});
  add(logs, "123456\n123456\nab\n");
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

TEST_F(LogFolderTest, GoesOnWhereTheNextLogCouldNotBeMade) {
  LogFolder logs(folder_, {.bytes = 12, .keep = 9});
  add(logs, "11111\n");
  std::string_view lines = "22222\n33333\n";
  for (int i = 0; i < 3; ++i) {
    const Limit limit = no_descriptor();
    EXPECT_THROW(logs.add(lines), OutputError);
    EXPECT_EQ(lines, "33333\n");
  }
  EXPECT_EQ(logs.current(), path_of(1));
  add(logs, lines);
  EXPECT_EQ(text_of(1), "11111\n22222\n");
  EXPECT_EQ(text_of(2), "33333\n");
}

// A line is 36 bytes.
TEST_F(LogFolderTest, TheRecorderLosesNothingWhereALogCouldNotBeMade) {
  Recorder recorder(folder_, {.bytes = 40, .keep = 9}, "can0");
  recorder.see({});
  recorder.sync();
  {
    const Limit limit = no_descriptor();
    recorder.see({});
    recorder.see({});
    recorder.sync();
    EXPECT_NE(recorder.trouble().find("Too many open files; 2 frames were not recorded"),
              std::string::npos)
        << recorder.trouble();
  }
  recorder.sync();
  EXPECT_EQ(recorder.trouble(), "");
  for (const int log : {1, 2, 3}) {
    EXPECT_EQ(text_of(log), log_line({}, "can0"));
  }
}

TEST_F(LogFolderTest, TheRecorderGoesOnWhenADiskHasRoomAgain) {
  Recorder recorder(folder_, {}, "can0");
  {
    const Limit limit = full_disk();
    recorder.see({});
    recorder.sync();
    recorder.see({});
    recorder.sync();
    EXPECT_NE(recorder.trouble().find("File too large; 2 frames were not recorded"),
              std::string::npos)
        << recorder.trouble();
  }
  recorder.sync();
  EXPECT_EQ(recorder.trouble(), "");
  EXPECT_EQ(text_of(1), log_line({}, "can0") + log_line({}, "can0"));
}

TEST_F(LogFolderTest, FollowsNoLink) {
  std::filesystem::create_directories(folder_);
  const std::filesystem::path other = folder_ / "other";
  std::ofstream(other) << "without a line end";
  std::filesystem::create_symlink(other, path_of(1));
  try {
    LogFolder logs(folder_, {});
    ADD_FAILURE();
  } catch (const OutputError& error) {
    EXPECT_EQ(error.what(), path_of(1).string() +
                                ": cannot be written: it is a symbolic link; accepted: a file of "
                                "this folder");
  }
  std::filesystem::remove(path_of(1));
  std::filesystem::create_hard_link(other, path_of(1));
  LogFolder logs(folder_, {.bytes = 6, .keep = 9});
  std::filesystem::create_symlink(other, path_of(3));
  std::filesystem::create_symlink(folder_ / "nothing", path_of(5));
  add(logs, "22222\n66666\n");
  EXPECT_EQ(text_of(1), "without a line end");
  EXPECT_EQ(text_of(2), "22222\n");
  EXPECT_EQ(text_of(6), "66666\n");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "nothing"));
  EXPECT_EQ(logs_in(folder_),
            (std::vector<std::filesystem::path>{path_of(1), path_of(2), path_of(6)}));
}

TEST_F(LogFolderTest, ItsNumbersNeverWrap) {
  std::filesystem::create_directories(folder_);
  for (const char* planted :
       {"frames-18446744073709551615.log", "frames-1000000000000.log", "frames-2.log",
        "frames-000000009.log", "frames-+0000007.log", "frames-.log"}) {
    std::ofstream(folder_ / planted) << "planted";
  }
  LogFolder logs(folder_, {.bytes = 6, .keep = 9});
  add(logs, "11111\n22222\n");
  EXPECT_EQ(text_of(1), "11111\n");
  EXPECT_EQ(text_of(2), "22222\n");
  EXPECT_EQ(files(), 8u);
  std::ofstream(folder_ / "frames-999999999999.log") << "33333\n";
  std::string_view more = "44444\n";
  EXPECT_THROW(logs.add(more), OutputError);
  EXPECT_EQ(more, "44444\n");
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
