#include "host_sim/monitor/bus/frame_log.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "hal/files/input_error.hpp"
#include "host_sim/monitor/bus/frame_source.hpp"
#include "tests/monitor/bus/capture.hpp"

namespace host_sim::monitor {

using hal::files::InputError;
using hal::files::memory_source;

namespace {

using namespace std::chrono_literals;

class Folder {
 public:
  Folder()
      : path_(std::filesystem::temp_directory_path() / ("log_test." + std::to_string(::getpid()))) {
    std::filesystem::create_directory(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  [[nodiscard]] std::filesystem::path file(const std::string& bytes) const {
    std::ofstream(path_ / "log", std::ios::binary) << bytes;
    return path_ / "log";
  }

 private:
  std::filesystem::path path_;
};

std::unique_ptr<LogReader> candump(std::string_view text) {
  return std::make_unique<CandumpLogReader>(memory_source(text), "run.log");
}

TEST(CandumpLog, ReadsAllKindsOfFrames) {
  const auto reader = candump(
      "(1600000000.000001) can0 185#0102\n"
      "(1600000000.000002) can0 18DAF105#11 R\n"
      "(1600000000.000003) can1 123#R4 T\n"
      "(1600000000.000004) can0 123##1AABB\n"
      "(1600000000.000005) can0 20000044#0000000000008011\n");
  std::vector<SeenFrame> all;
  while (auto seen = reader->next()) {
    all.push_back(std::move(*seen));
  }
  ASSERT_EQ(all.size(), 5u);
  EXPECT_EQ(all[0].time_ns, 1'600'000'000'000'001'000);
  EXPECT_EQ(all[0].frame.id, 0x185u);
  EXPECT_TRUE(all[1].frame.extended);
  EXPECT_TRUE(all[2].remote_request);
  EXPECT_EQ(all[2].frame.length, 4);
  EXPECT_TRUE(all[3].flexible_data_rate);
  EXPECT_EQ(all[3].fd_data.size(), 2u);
  ASSERT_TRUE(all[4].error);
  EXPECT_TRUE(all[4].error->bus_off);
  EXPECT_EQ(all[4].error->transmit_errors, 0x80);
  EXPECT_EQ(all[4].error->receive_errors, 0x11);
}

TEST(CandumpLog, RefusesATimeThatHasNoRoom) {
  EXPECT_THROW((void)candump("(9000000001.000000) can0 185#01\n")->next(), InputError);
  EXPECT_TRUE(candump("(8999999999.999999) can0 185#01\n")->next());
}

TEST(OpenLog, KnowsAFormatByItsFirstBytes) {
  const Folder folder;
  const std::string packet = test::raw({0, 0, 1, 0x85, 1, 0, 0, 0, 7});
  for (const std::string& bytes :
       {std::string("(1.000000) can0 185#07\n"),
        std::string("# made by hand\n(1.000000) can0 185#07\n"),
        std::string("base hex timestamps absolute\n1.0 1 185 Rx d 1 07\n"),
        std::string("\xef\xbb\xbf"
                    "date today\nbase hex timestamps absolute\n1.0 1 185 Rx d 1 07\n"),
        test::pcap_head(227) + test::pcap_packet(1, 0, packet),
        test::pcapng(227, 1'000'000'000, packet)}) {
    const auto seen = open_log(folder.file(bytes))->next();
    ASSERT_TRUE(seen) << bytes;
    EXPECT_EQ(seen->frame.id, 0x185u);
    EXPECT_EQ(seen->frame.data[0], std::byte{7});
    EXPECT_EQ(seen->time_ns, 1'000'000'000);
  }
}

TEST(OpenLog, RefusesOtherFormatsOfCandump) {
  const Folder folder;
  for (const std::string bytes :
       {"  can0  185   [2]  01 02\n", " (1.000000)  can0  185   [2]  01 02\n"}) {
    try {
      (void)open_log(folder.file(bytes));
      FAIL() << bytes;
    } catch (const InputError& error) {
      EXPECT_NE(
          std::string(error.what()).find("output of candump in another format than that of -L"),
          std::string::npos);
    }
  }
  EXPECT_THROW((void)open_log(folder.file("hello\n")), InputError);
  EXPECT_THROW((void)open_log("/no/such/file"), InputError);
}

constexpr std::string_view kThree =
    "(10.000000) can0 185#01\n"
    "(10.100000) can0 185#02\n"
    "(10.050000) can0 185#03\n";

TEST(LogSource, GivesAllAtOnceAndEnds) {
  LogSource source(candump(kThree), "run.log", 0);
  std::vector<std::int64_t> times_ns;
  while (source.state() == FrameSource::State::running) {
    if (const auto seen = source.next(1ms)) {
      times_ns.push_back(seen->time_ns);
      EXPECT_EQ(source.now_ns(), seen->time_ns);
    }
  }
  EXPECT_EQ(times_ns, (std::vector<std::int64_t>{10'000'000'000, 10'100'000'000, 10'100'000'000}));
  EXPECT_EQ(source.description(), "run.log, at its end");
  EXPECT_FALSE(source.next(1ms));
  EXPECT_EQ(source.now_ns(), 10'100'000'000);
}

TEST(LogSource, KeepsThePaceOfTheRecord) {
  LogSource source(candump("(10.000000) can0 185#01\n(13.000000) can0 185#02\n"), "run.log", 10);
  const auto began = std::chrono::steady_clock::now();
  ASSERT_TRUE(source.next(10s));
  EXPECT_FALSE(source.next(50ms));
  EXPECT_EQ(source.state(), FrameSource::State::running);
  EXPECT_GE(source.now_ns(), 10'400'000'000);
  EXPECT_LE(source.now_ns(), 13'000'000'000);
  ASSERT_TRUE(source.next(10s));
  EXPECT_GE(std::chrono::steady_clock::now() - began, 290ms);
}

TEST(LogSource, AnEmptyLogIsAtItsEnd) {
  LogSource source(candump(""), "run.log", 1);
  EXPECT_FALSE(source.next(1ms));
  EXPECT_EQ(source.state(), FrameSource::State::ended);
}

TEST(LogSource, RefusesALineThatIsNoFrame) {
  LogSource source(candump("(10.000000) can0 185#01\n(10.0) hello\n"), "run.log", 0);
  EXPECT_THROW((void)source.next(1ms), InputError);
}

}  // namespace
}  // namespace host_sim::monitor
